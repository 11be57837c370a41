#!/usr/bin/env python3
"""Writes the package files of PlatformIO, Arduino, ESP-IDF, Zephyr and the Pico SDK from package.json and the version in CMakeLists.txt.

usage: generate.py [--check] [--export FOLDER]

--check changes nothing: it fails if a package file is not what would be written. --export lays the library out as Arduino and PlatformIO
want it: everything is in FOLDER/src, with library.properties and library.json beside it.
"""
import argparse
import json
import pathlib
import re
import shutil
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402
ABOUT = json.loads((HERE / "package.json").read_text())
VERSION = re.search(r"project\(Spangle VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
WRITTEN = "Written by boards/packages/generate.py: change package.json or that, not this."


def rows(words, indent, end=""):
    return "\n".join(" " * indent + word + end for word in words)


def platformio():
    return json.dumps({
        "name": ABOUT["name"], "version": VERSION, "description": ABOUT["description"], "keywords": ABOUT["keywords"], "license": ABOUT["license"],
        "homepage": ABOUT["url"], "authors": [{"name": ABOUT["maintainer"], "maintainer": True}], "headers": ABOUT["headers"], "frameworks": "*", "platforms": "*",
        "build": {"flags": ["-std=gnu++20", *ABOUT["flags"], *(f"-D{d}" for d in ABOUT["definitions"])], "unflags": ["-std=gnu++11", "-std=gnu++14", "-std=gnu++17"],
                  "srcDir": "src", "includeDir": "src", "libArchive": True}}, indent=2) + "\n"


def arduino():
    fields = {"name": ABOUT["name"], "version": VERSION, "author": ABOUT["maintainer"], "maintainer": ABOUT["maintainer"], "sentence": ABOUT["description"],
              "paragraph": ABOUT["paragraph"], "category": "Display", "url": ABOUT["url"], "architectures": "*", "includes": ",".join(ABOUT["headers"])}
    return "".join(f"{key}={value}\n" for key, value in fields.items())


def as_subdirectory():
    """Returns the lines that add the library to another CMake project."""
    return f"""set(SPANGLE_HOST OFF)
set(SPANGLE_TESTS OFF)
set(SPANGLE_LINUX OFF)
add_subdirectory(${{CMAKE_CURRENT_LIST_DIR}}/../../.. ${{CMAKE_CURRENT_BINARY_DIR}}/spangle)
foreach(part spangle_raster spangle_hal spangle_gl)
    target_compile_definitions(${{part}} PUBLIC {' '.join(ABOUT["definitions"])})
endforeach()"""


def esp_idf():
    return f"""# {WRITTEN}
# The library is a CMake project of its own; the component hands it on.
idf_component_register(REQUIRES esp_lcd)
{as_subdirectory()}
target_link_libraries(${{COMPONENT_LIB}} INTERFACE Spangle::gl Spangle::hal)
target_include_directories(${{COMPONENT_LIB}} INTERFACE ${{CMAKE_CURRENT_LIST_DIR}}/../../include)
"""


def idf_manifest():
    return f"""# {WRITTEN}
version: "{VERSION}"
description: "{ABOUT["description"]}"
url: "{ABOUT["url"]}"
license: "{ABOUT["license"]}"
dependencies:
  idf: ">=5.1"
"""


def zephyr_module():
    return f"""# {WRITTEN}
# Zephyr looks for this file at zephyr/module.yml of a module: copy it there, or name this folder in ZEPHYR_EXTRA_MODULES.
name: spangle
build:
  cmake: .
  kconfig: Kconfig
"""


def zephyr_cmake():
    return f"""# {WRITTEN}
if(CONFIG_SPANGLE)
    set(root ${{CMAKE_CURRENT_LIST_DIR}}/../../..)
    zephyr_library_named(spangle)
    foreach(room
{rows(ABOUT["rooms"], 12)})
        file(GLOB sources ${{root}}/${{room}}/*.cpp)
        list(FILTER sources EXCLUDE REGEX "_reference\\\\.cpp$")
        zephyr_library_sources(${{sources}})
    endforeach()
    zephyr_library_include_directories(${{root}})
    zephyr_library_compile_options(-std=gnu++20 {' '.join(ABOUT["flags"])}
        "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:{";".join(ABOUT["gcc_flags"])}>")
    file(GLOB spans ${{root}}/raster/fused/part_*.cpp)
    set_source_files_properties(${{spans}} PROPERTIES COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-fipa-modref>)
    zephyr_compile_definitions({' '.join(ABOUT["definitions"])})
    foreach(folder
{rows(ABOUT["includes"], 12)})
        zephyr_include_directories(${{root}}/${{folder}})
    endforeach()
endif()
"""


def zephyr_kconfig():
    return f"""# {WRITTEN}
config SPANGLE
	bool "{ABOUT["name"]}: {ABOUT["description"]}"
	depends on CPP
	depends on STD_CPP20
	help
	  {ABOUT["paragraph"]}
"""


def pico_sdk():
    return f"""# {WRITTEN}
# In a project of the Pico SDK, behind pico_sdk_init(): include(boards/packages/pico-sdk/spangle.cmake), then link Spangle::gl.
{as_subdirectory()}
target_include_directories(spangle_hal PUBLIC ${{CMAKE_CURRENT_LIST_DIR}}/../../include)
"""


FILES = {"platformio/library.json": platformio, "arduino/library.properties": arduino, "esp-idf/CMakeLists.txt": esp_idf,
         "esp-idf/idf_component.yml": idf_manifest, "zephyr/module.yml": zephyr_module, "zephyr/CMakeLists.txt": zephyr_cmake,
         "zephyr/Kconfig": zephyr_kconfig, "pico-sdk/spangle.cmake": pico_sdk}


def pragma():
    """Returns the gcc_flags as a pragma of a source, because Arduino has no place for flags, and PlatformIO's compiler may not be a GCC."""
    options = ", ".join(f'"{flag.removeprefix("-f")}"' for flag in ABOUT["gcc_flags"])
    return f"#if defined(__GNUC__) && !defined(__clang__)\n#pragma GCC optimize({options})\n#endif\n"


def export(folder):
    """Fills src/ with every room under its own name and the public headers under spangle/, so that src is the only include path."""
    source = folder / "src"
    for room in (room + way for room in ABOUT["rooms"] for way in ("", "/speed", "/size")):
        if not (ROOT / room).is_dir():
            continue
        (source / room).mkdir(parents=True, exist_ok=True)
        for path in (ROOT / room).iterdir():
            if path.suffix in (".cpp", ".hpp", ".h", ".inc") and not path.name.endswith("_reference.cpp"):
                # The parts of the table of fused spans keep the pass modref; raster/CMakeLists.txt says why.
                before = pragma() if path.suffix == ".cpp" else ""
                if path.match("raster/fused/part_*.cpp"):
                    before = before.replace(', "no-ipa-modref"', "")
                outfile.write(source / room / path.name, before + path.read_text())
    for public in ABOUT["includes"]:
        shutil.copytree(ROOT / public, source, dirs_exist_ok=True)
    outfile.write(folder / "library.properties", arduino())
    outfile.write(folder / "library.json", platformio())
    outfile.write(folder / "LICENSE", (ROOT / "LICENSE").read_bytes())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--export", type=pathlib.Path)
    arguments = parser.parse_args()
    stale = []
    for name, write in FILES.items():
        path = HERE / name
        if arguments.check:
            if not path.exists() or path.read_text() != write():
                stale.append(name)
        else:
            path.parent.mkdir(exist_ok=True)
            outfile.write(path, write())
    if arguments.export:
        export(arguments.export)
    if stale:
        print(f"{', '.join(stale)}: not what generate.py writes; run python3 boards/packages/generate.py")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
