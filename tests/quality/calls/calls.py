#!/usr/bin/env python3
"""Tests that calls keep their effects: GCC 12 dropped some (cmake/SpangleTargets.cmake).

usage: calls.py recipes|spans|pure|boards COMPILER BUILD_DIR

recipes: every way to build the library has the flags: the build in BUILD_DIR, firmware, packages, scripts that call a compiler, and C++ of
a project that links the library; C of that project has none.
spans: the sources that keep the pass ipa-modref pass no structure by value from memory, which the pass forgets.
pure: GCC takes no function for pure that has something to write through.
boards: the cases of calls.hpp on emulated Cortex-M3, M4 and RV32, at -O2, at -Os, and optimized as one program.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path[:0] = [str(ROOT / "boards/tools"), str(ROOT / "boards/packages"), str(ROOT / "tests/support")]
import firmware  # noqa: E402
import generate  # noqa: E402
from checks import check, failures  # noqa: E402

SPANS = sorted((ROOT / "raster/fused").glob("part_*.cpp"))
# Scripts may call a compiler with flags of their own if they name the list of flags, or if they compile nothing to code.
NAMES_THE_LIST = re.compile(r"SOUND_CALLS|sound_calls|gcc_flags|firmware\.FLAGS|-fsyntax-only")
USER = """cmake_minimum_required(VERSION 3.22)
project(user C CXX)
set(SPANGLE_HOST OFF)
set(SPANGLE_TESTS OFF)
add_subdirectory({root} spangle)
add_executable(program main.c draw.cpp)
target_link_libraries(program PRIVATE {library})
"""


def flags_missing(command):
    return [flag for flag in firmware.SOUND_CALLS if flag not in command.split()]


def built(folder):
    return json.loads((folder / "compile_commands.json").read_text())


def recipes(compiler, build):
    gcc = bool(firmware.sound_calls(compiler))
    for entry in built(build):
        if gcc and not entry["file"].endswith(".c"):
            check(not flags_missing(entry["command"]), f"{entry['file']} is compiled without {flags_missing(entry['command'])}")
    in_cmake = set(re.findall(r":(-fno-[\w-]+)>", (ROOT / "cmake/SpangleTargets.cmake").read_text()))
    check(in_cmake == set(firmware.SOUND_CALLS) == set(generate.ABOUT["gcc_flags"]), "CMake, firmware.py and package.json name the same flags")
    check(set(firmware.SOUND_CALLS) <= set(firmware.FLAGS), "firmware has them")
    scripts = [path for folder in ("boards", "tests", "host_sim") for path in (ROOT / folder).rglob("*.py")]
    for path in scripts:
        text = path.read_text()
        if path != pathlib.Path(__file__).resolve() and re.search(r'"-std=(c|gnu)\+\+20', text):
            check(NAMES_THE_LIST.search(text), f"{path.relative_to(ROOT)} compiles without SOUND_CALLS")
    c_compiler = shutil.which("clang-14") or shutil.which("cc")
    for library in ("Spangle::gl", "Spangle::raster", "Spangle::hal", "Spangle::mcu", "Spangle::format"):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "CMakeLists.txt").write_text(USER.format(root=ROOT, library=library))
            (folder / "main.c").write_text("int main(void) { return 0; }\n")
            (folder / "draw.cpp").write_text("")
            done = subprocess.run(["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", f"-DCMAKE_C_COMPILER={c_compiler}", f"-DCMAKE_CXX_COMPILER={compiler}",
                                   "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"], capture_output=True, text=True)
            check(done.returncode == 0, done.stderr[-2000:])
            commands = {pathlib.Path(entry["file"]).name: entry["command"] for entry in built(folder / "build")}
            check(not gcc or not flags_missing(commands["draw.cpp"]), f"C++ that links {library} is compiled without {flags_missing(commands['draw.cpp'])}")
            check(len(flags_missing(commands["main.c"])) == len(firmware.SOUND_CALLS), f"C that links {library} has flags of C++: {commands['main.c']}")
            for source in SPANS:
                kept = commands[source.name].split()
                check(not gcc or ("-fipa-modref" in kept and kept.index("-fipa-modref") > kept.index("-fno-ipa-modref")), f"{source.name} keeps the pass")


def arm(source, *more):
    """Compiles a source of the core for a Cortex-M4, and returns what the compiler says."""
    target = firmware.TARGETS["cortex-m4"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        done = subprocess.run([target.prefix + "g++", *firmware.FLAGS, *firmware.source_flags(source), *target.machine, *more, "-c", str(source), "-o", str(folder / "x.o"),
                               "-dumpdir", f"{folder}/"], capture_output=True, text=True)
        check(done.returncode == 0, f"{source.name}: {done.stderr[:1500]}")
        return done.stderr, "".join(path.read_text() for path in folder.glob("*.modref"))


def from_memory(call):
    """Returns the arguments of a call in a dump that are neither values, constants nor addresses."""
    arguments = call[call.rindex("(", 0, len(call) if not call.endswith("(D));") else len(call) - 5) + 1:]
    words = [word.strip(" );") for word in arguments.replace("(D)", "").split(",")]
    return [word for word in words if word and not re.fullmatch(r"[\w$.]*_\d+|-?\d+|&.*|0x[0-9a-f]+|[\w$]+", word)]


def spans(compiler, build):
    check(SPANS != [], "the table of fused spans has parts")
    for flag in ("-O2", "-Os"):
        seen = 0
        for source in SPANS:
            dump = arm(source, flag, "-fdump-ipa-modref")[1]
            calls = set(re.findall(r"\(indirect\).* in call (.*)", dump))
            check(dump != "", f"the compiler tells what the pass found in {source.name}")
            for call in calls:
                check(not from_memory(call), f"{source.name} {flag}: a structure is passed by value from memory: {call}")
            seen += len(calls)
        print(f"{flag}: {seen} calls hand on what they loaded, none of them from memory itself")


def writes(signature):
    """Returns whether a function has something to write through: a pointer or reference without const, or no result."""
    arguments = re.sub(r"const [\w:<>, ]*?(\(?[&*]\)?)", "", signature.partition("(")[2])
    return signature.startswith("void ") or "&" in arguments or "*" in arguments


def pure(compiler, build):
    sources = [*sorted((ROOT / "raster/numeric").glob("*.cpp")), ROOT / "gl/vertex/transform.cpp", ROOT / "gl/vertex/lights.cpp", ROOT / "gl/vertex/fixed_lighting.cpp",
               ROOT / "gl/vertex/engine_fixed.cpp", HERE / "board.cpp"]
    seen = 0
    for source in sources:
        for flag in ("-O2", "-Os"):
            text = arm(source, flag, "-DSPANGLE_KERNELS_INLINE=0", "-Wsuggest-attribute=pure", "-Wsuggest-attribute=const")[0]
            signature = ""
            for line in text.splitlines():
                found = re.search(r"In (?:member )?function [‘'](.*)[’']:", line)
                signature = found.group(1) if found else signature
                if "candidate for attribute" in line:
                    seen += 1
                    check(not writes(signature), f"{source.name} {flag}: GCC takes for pure what writes: {signature}: {line}")
    check(seen > 0, "GCC tells which functions it takes for pure")
    print(f"{seen} functions are pure; none has something to write through")


def boards(compiler, build):
    chosen = {"cortex-m3": "mps2_an385", "cortex-m4": "mps2_an386", "rv32imac": "rv32_virt"}
    with tempfile.TemporaryDirectory() as name:
        work, images = firmware.Build(name), {}
        for target, board in chosen.items():
            start = [work.compile(target, "-Os", path) for path in firmware.startup(target)]
            for optimize in ("-O2", "-Os"):
                for lto in (False, True):
                    variant = f"{target}{optimize}{'-lto' if lto else ''}"
                    own = work.compile(target, optimize, HERE / "board.cpp", ["-DSPANGLE_KERNELS_INLINE=0"], variant, lto)
                    images[variant] = board, work.image(target, [own, *start], ROOT / "boards" / board / "memory.ld", f"{variant}.elf", lto)
        work.run()
        for variant, (board, image) in images.items():
            machine = json.loads((ROOT / "boards" / board / "board.json").read_text())["machine"]
            said = firmware.emulate(machine, image).strip()
            check(said == "wrong 0", f"{variant}: {said}")
            print(f"{variant}: {said}")


def main():
    parts = {"recipes": recipes, "spans": spans, "pure": pure, "boards": boards}
    if len(sys.argv) != 4 or sys.argv[1] not in parts:
        print(__doc__.strip())
        return 2
    if sys.argv[1] != "recipes":
        missing = firmware.missing(["cortex-m3", "rv32imac"])
        if missing:
            print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs them)")
            return 77
    parts[sys.argv[1]](sys.argv[2], pathlib.Path(sys.argv[3]))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
