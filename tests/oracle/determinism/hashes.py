#!/usr/bin/env python3
"""Holds the picture hashes of every scene and tier in golden.json against those of a build of these sources.

usage: hashes.py BUILD PICTURE_HASHES
       hashes.py --update PICTURE_HASHES     makes golden.json what this program prints

PICTURE_HASHES is the host's own build, which BUILD `host` means. Other builds are made and run. gcc_O0 and so on are this
host's with that compiler and optimization; clang_native has every instruction of this processor. Names of boards'
processors run in QEMU: cortex_m0plus (v6-M), cortex_m3 (v7-M), cortex_m4 (v7E-M), cortex_m33 (v8-M), rv32imac.
The other words are builds for that processor's Linux, which run in QEMU's user mode: s390x has its bytes in the other
order, i686 has words of 32 bits and runs here. Prints a table; any hash that differs fails. Exit status 77 (skipped) when
a compiler or the emulator is missing.
"""
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
GOLDEN = HERE / "golden.json"
sys.path.insert(0, str(ROOT / "boards/tools"))
import firmware  # noqa: E402

HOST_BUILDS = {f"{name}_{level}": (compiler, f"-{level}") for name, compiler in (("gcc", "g++"), ("clang", "clang++-14"))
               for level in ("O0", "O1", "O2", "O3", "Os")} | {"clang_native": ("clang++-14", "-O3 -march=native")}
HOST_FLAGS = ["-std=c++20", "-Wno-psabi", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", *firmware.INCLUDES]
# {processor: (compiler, emulator that runs its programs here)}
MACHINES = {"s390x": ("s390x-linux-gnu-g++", ["qemu-s390x"]), "aarch64": ("aarch64-linux-gnu-g++", ["qemu-aarch64"]),
            "riscv64": ("riscv64-linux-gnu-g++", ["qemu-riscv64"]), "i686": ("i686-linux-gnu-g++", [])}
# {processor: (board whose machine runs its code, linker script)}. No emulated M0+ board has enough memory, so its code runs on the M3,
# whose instructions include the M0+'s.
BOARDS = {"cortex_m0plus": ("mps2_an385", "boards/mps2_an385/memory.ld"), "cortex_m3": ("mps2_an385", "boards/mps2_an385/memory.ld"),
          "cortex_m4": ("mps2_an386", "boards/mps2_an386/memory.ld"),
          "cortex_m33": ("mps2_an505", "tests/oracle/determinism/mps2_an505.ld"),
          "rv32imac": ("rv32_virt", "boards/rv32_virt/memory.ld")}
MAIN = HERE / "picture_hashes.cpp"


def read(text):
    """Returns {(scene, tier): hash} of a program's output."""
    return {tuple(line.split()[:2]): line.split()[2] for line in text.splitlines() if len(line.split()) == 3}


def hashes_of_host(compiler, flags, link=(), runner=()):
    sources = [path for _, path in firmware.sources()] + sorted((ROOT / "boards/scenes").glob("*.cpp")) + [MAIN]
    sound = firmware.sound_calls(compiler)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def compile_one(path):
            target = folder / (str(path.relative_to(ROOT)).replace("/", "_") + ".o")
            subprocess.run([*firmware.CCACHE, compiler, *HOST_FLAGS, *sound, *firmware.source_flags(path) * bool(sound), *flags.split(), "-c", str(path), "-o", str(target)], check=True)
            return str(target)

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            objects = list(pool.map(compile_one, sources))
        subprocess.run([compiler, *link, *objects, "-o", str(folder / "hashes")], check=True)
        return read(subprocess.run([*runner, str(folder / "hashes")], capture_output=True, text=True, check=True).stdout)


def hashes_of_board(target, board, script):
    machine = json.loads((ROOT / "boards" / board / "board.json").read_text())["machine"]
    with tempfile.TemporaryDirectory() as folder:
        build = firmware.Build(folder)
        objects = [build.compile(target, "-Os", MAIN), *build.library(target), *(build.compile(target, "-Os", path) for path in firmware.startup(target))]
        image = build.image(target, objects, ROOT / script, "hashes.elf")
        build.run()
        return read(firmware.emulate(machine, image, timeout=1200))


def table(builds):
    """Prints the differences, or how many hashes agreed. Returns whether all are equal."""
    wanted_by, wanted = next(iter(builds.items()))
    good = True
    for name, got in builds.items():
        wrong = [key for key in wanted if got.get(key) != wanted[key]]
        print(f"{name:<32}{len(wanted) - len(wrong)} of {len(wanted)} pictures equal")
        good = good and not wrong and got.keys() == wanted.keys()
    for scene, tier in wanted:
        row = {name: got.get((scene, tier), "missing") for name, got in builds.items()}
        if len(set(row.values())) > 1:
            print(f"{scene:<6}{tier:<10}" + "  ".join(f"{name}: {value}" for name, value in row.items()))
    return good


def other_build(name):
    """Returns (title, hashes) of a build that is made here, or (None, None) if something for it is not installed."""
    if name in HOST_BUILDS:
        compiler, flags = HOST_BUILDS[name]
        missing = [compiler] * (shutil.which(compiler) is None)
        title, make = f"{compiler} {flags}", lambda: hashes_of_host(compiler, flags)
    elif name in MACHINES:
        compiler, runner = MACHINES[name]
        missing = [program for program in (compiler, *runner) if shutil.which(program) is None]
        title, make = f"{compiler} -O1", lambda: hashes_of_host(compiler, "-O1", ("-static",), runner)
    else:
        target = name.replace("_", "-")
        missing = firmware.missing([target])
        title, make = f"{target} in QEMU", lambda: hashes_of_board(target, *BOARDS[name])
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs it)")
        return None, None
    return title, make()


def main():
    names = ("--update", "host", *HOST_BUILDS, *BOARDS, *MACHINES)
    if len(sys.argv) != 3 or sys.argv[1] not in names:
        print(__doc__.strip() + f"\n\nBUILD is one of {', '.join(names[1:])}")
        return 2
    host = read(subprocess.run([sys.argv[2]], capture_output=True, text=True, check=True).stdout)
    if not host:
        print("the host's build draws nothing")
        return 1
    if sys.argv[1] == "--update":
        firmware.outfile.write(GOLDEN, json.dumps({" ".join(key): value for key, value in host.items()}, indent=1) + "\n")
        return 0
    golden = {tuple(key.split()): value for key, value in json.loads(GOLDEN.read_text()).items()}
    builds = {"golden.json": golden, "this build": host}
    if sys.argv[1] != "host":
        title, hashes = other_build(sys.argv[1])
        if title is None:
            return 77
        builds[title] = hashes
    if table(builds):
        return 0
    if host != golden:
        print("pictures of this build are not those of golden.json; where they are meant to change: hashes.py --update PICTURE_HASHES")
    return 1


if __name__ == "__main__":
    sys.exit(firmware.outfile.checked(main))
