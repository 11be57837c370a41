#!/usr/bin/env python3
"""Tests the files of boards/packages as other build systems read them.

usage: packages_test.py fresh|metadata|cmake|exported COMPILER
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGES = ROOT / "boards/packages"
sys.path[:0] = [str(PACKAGES), str(ROOT / "tests/support")]
import generate  # noqa: E402
from checks import check, failures  # noqa: E402


def fresh():
    """Nothing was changed by hand, the version is the project's, and every room and folder that a package names exists."""
    done = subprocess.run([sys.executable, PACKAGES / "generate.py", "--check"], capture_output=True, text=True)
    check(done.returncode == 0, done.stdout)
    for folder in generate.ABOUT["rooms"] + generate.ABOUT["includes"]:
        check((ROOT / folder).is_dir(), f"there is no {folder}")
    with_sources = {str(path.parent.relative_to(ROOT)) for room in ("raster", "gl") for path in (ROOT / room).rglob("*.cpp")} | {"hal/bus", "hal/panel", "hal/display"}
    check(with_sources <= set(generate.ABOUT["rooms"]), f"rooms that the packages leave out: {with_sources - set(generate.ABOUT['rooms'])}")


def yaml(path):
    """Parses the small part of YAML that the files use: maps of maps of words."""
    out, stack = {}, [(-1, None)]
    stack[0] = (-1, out)
    for line in path.read_text().splitlines():
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        match = re.fullmatch(r'( *)([\w-]+):(?: ("[^"\n]*"|[^\s"#][^#"]*))?', line)
        check(match is not None, f"{path.name}: not a line of a map: {line!r}")
        indent, key, value = len(match.group(1)), match.group(2), match.group(3)
        while stack[-1][0] >= indent:
            stack.pop()
        inner = {} if value is None else value.strip('"')
        stack[-1][1][key] = inner
        if value is None:
            stack.append((indent, inner))
    return out


def metadata():
    library = json.loads((PACKAGES / "platformio/library.json").read_text())
    check({"name", "version", "description", "keywords", "license", "build"} <= set(library) and library["version"] == generate.VERSION, f"library.json: {library}")
    lines = [line.split("=", 1) for line in (PACKAGES / "arduino/library.properties").read_text().splitlines()]
    check(all(len(line) == 2 and line[1] for line in lines), f"library.properties: {lines}")
    properties = dict(lines)
    check({"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures", "includes"} <= set(properties), f"library.properties: {properties}")
    check(re.fullmatch(r"\d+\.\d+\.\d+", properties["version"]), "a version of three numbers")
    manifest, module = yaml(PACKAGES / "esp-idf/idf_component.yml"), yaml(PACKAGES / "zephyr/module.yml")
    check(manifest["version"] == generate.VERSION and manifest["dependencies"] == {"idf": ">=5.1"}, f"idf_component.yml: {manifest}")
    check(module["build"] == {"cmake": ".", "kconfig": "Kconfig"} and (PACKAGES / "zephyr/Kconfig").is_file(), f"module.yml: {module}")
    kconfig = (PACKAGES / "zephyr/Kconfig").read_text()
    check(re.search(r'^config SPANGLE\n\tbool "[^"]+"\n(\tdepends on \w+\n)+\thelp\n\t  \S', kconfig, re.M), "Kconfig")
    for header in generate.ABOUT["headers"]:
        check(any((ROOT / folder / header).is_file() for folder in generate.ABOUT["includes"]), f"there is no {header}")


IDF = """function(idf_component_register)
    add_library(component INTERFACE)
    set(COMPONENT_LIB component PARENT_SCOPE)
endfunction()
add_subdirectory({packages}/esp-idf component)
get_target_property(linked component INTERFACE_LINK_LIBRARIES)
if(NOT "Spangle::gl" IN_LIST linked)
    message(FATAL_ERROR "the component hands on ${{linked}}")
endif()
"""
PICO = """include({packages}/pico-sdk/spangle.cmake)
if(NOT TARGET Spangle::gl)
    message(FATAL_ERROR "no Spangle::gl")
endif()
"""
ZEPHYR = """set(CONFIG_SPANGLE y)
macro(zephyr_library_named name)
    add_library(${{name}} STATIC)
    set(ZEPHYR_CURRENT_LIBRARY ${{name}})
endmacro()
function(zephyr_library_sources)
    target_sources(${{ZEPHYR_CURRENT_LIBRARY}} PRIVATE ${{ARGV}})
endfunction()
function(zephyr_library_include_directories)
    target_include_directories(${{ZEPHYR_CURRENT_LIBRARY}} PRIVATE ${{ARGV}})
endfunction()
function(zephyr_library_compile_options)
    target_compile_options(${{ZEPHYR_CURRENT_LIBRARY}} PRIVATE ${{ARGV}})
endfunction()
function(zephyr_compile_definitions)
    add_compile_definitions(${{ARGV}})
endfunction()
function(zephyr_include_directories)
    target_include_directories(${{ZEPHYR_CURRENT_LIBRARY}} PUBLIC ${{ARGV}})
endfunction()
add_subdirectory({packages}/zephyr module)
"""


def cmake():
    """Each package for CMake configures beside stand-ins for its framework. Zephyr's package names every source of the core."""
    for name, text in (("esp-idf", IDF), ("pico-sdk", PICO), ("zephyr", ZEPHYR)):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.22)\nproject(user CXX)\n" + text.format(packages=PACKAGES))
            done = subprocess.run(["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"], capture_output=True, text=True)
            check(done.returncode == 0, f"{name}: {done.stderr[-2000:]}")
            if done.returncode != 0:
                continue
            built = json.loads((folder / "build/compile_commands.json").read_text())
            sources = {pathlib.Path(entry["file"]).resolve() for entry in built}
            wanted = {path for room in generate.ABOUT["rooms"] for path in (ROOT / room).glob("*.cpp") if not path.name.endswith("_reference.cpp")}
            check(wanted <= sources, f"{name} leaves out {sorted(path.name for path in wanted - sources)[:5]}")
            for path in wanted:
                command = next(entry["command"] for entry in built if pathlib.Path(entry["file"]).resolve() == path)
                missing = [flag for flag in generate.ABOUT["gcc_flags"] if flag not in command.split()]
                check(not missing, f"{name}: {path.name} is compiled without {missing}")
            gl = next(entry for entry in built if entry["file"].endswith("gl/vertex/lights.cpp"))["command"]
            check("SPANGLE_FIRMWARE=1" in gl and "-fno-exceptions" in gl and "++20" in gl, f"{name}: {gl}")


def exported():
    """The layout of Arduino and PlatformIO holds all sources, and src is the only include path that they need."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        subprocess.run([sys.executable, PACKAGES / "generate.py", "--check", "--export", folder], check=True)
        source = folder / "src"
        ours = {str(path.relative_to(ROOT)) for room in generate.ABOUT["rooms"] for path in (ROOT / room).glob("*.[ch]pp") if not path.name.endswith("_reference.cpp")}
        check(all((source / name).is_file() for name in ours), "every source is there")
        check(not list(source.rglob("*_reference.cpp")), "no double arithmetic")
        for path in source.rglob("*.cpp"):
            options = path.read_text().partition("#endif")[0]
            missing = [flag for flag in generate.ABOUT["gcc_flags"] if f'"{flag[2:]}"' not in options]
            check(not missing or (path.match("raster/fused/part_*.cpp") and missing == ["-fno-ipa-modref"]), f"{path.name} does not ask for {missing}")
        check((folder / "library.properties").is_file() and json.loads((folder / "library.json").read_text())["build"]["srcDir"] == "src", "metadata")
        flags = ["-std=gnu++20", *generate.ABOUT["flags"], *(f"-D{d}" for d in generate.ABOUT["definitions"]), f"-I{source}", "-fsyntax-only"]
        sketch = folder / "sketch.cpp"
        sketch.write_text("".join(f"#include <{header}>\n" for header in generate.ABOUT["headers"]) + "int main() { return spangle::memory_use().used != 0; }\n")
        for path in (sketch, source / "gl/egl/surfaces.cpp", source / "raster/surface/clear.cpp", source / "hal/display/panel_display.cpp", source / "gl/api/generated/state.cpp"):
            done = subprocess.run([sys.argv[2], *flags, str(path)], capture_output=True, text=True)
            check(done.returncode == 0, f"{path.name}: {done.stderr[:1500]}")


def main():
    parts = {"fresh": fresh, "metadata": metadata, "cmake": cmake, "exported": exported}
    if len(sys.argv) != 3 or sys.argv[1] not in parts:
        print(__doc__.strip())
        return 2
    parts[sys.argv[1]]()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
