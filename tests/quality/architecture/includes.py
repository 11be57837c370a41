#!/usr/bin/env python3
"""Checks which folder of the tree includes which, by the rules of docs/architecture.md.

usage: includes.py BUILD_DIR

The tool reads the compiler's own dependency records of a Ninja build (`ninja -t deps`), so macros and generated includes count. It
also reads the include lines of headers, because a header without a source file of its own room is compiled for another room only.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]

NUMERIC, FORMAT = {"raster/numeric"}, {"raster/format"}
SURFACE = NUMERIC | FORMAT | {"raster/surface", "raster/include"}
SPAN = SURFACE | {"raster/span"}
OPS = SPAN | {"raster/ops"}
CHAIN, FUSED = OPS | {"raster/chain"}, OPS | {"raster/fused"}  # neither may include the other, so that fused spans can be deleted
COMPILE = CHAIN | FUSED | {"raster/compile"}
REFERENCE = CHAIN | {"raster/reference"}
PRIMITIVE = OPS | {"raster/reference", "raster/primitive"}  # the room's files *_reference.hpp, *_double.hpp and *_shadow.hpp are for hosts
RASTER = PRIMITIVE | {"raster/band"}
HAL_BUS = FORMAT | {"hal/bus"}
HAL_PANEL = HAL_BUS | {"hal/panel"}
HAL_DISPLAY = HAL_PANEL | {"hal/display"}
HAL = HAL_DISPLAY | {"hal/include"}
GL = RASTER | {"gl/api", "gl/context", "gl/vertex", "gl/pixel", "gl/texture", "gl/list", "gl/include"}
PUBLIC = {"gl/include", "hal/include", "raster/include", "raster/format", "hal/bus", "hal/panel", "hal/display",
          "hal/linux", "hal/usb", "hal/mcu"}
EVERYTHING = COMPILE | REFERENCE | GL | HAL | {"hal/linux", "hal/usb", "gl/egl", "boards", "boards/scenes", "hal/mcu", "host_sim"}

MAY_INCLUDE = {
    "raster/numeric": NUMERIC,
    "raster/format": FORMAT,
    "raster/surface": SURFACE,
    "raster/span": SPAN,
    "raster/ops": OPS,
    "raster/chain": CHAIN,
    "raster/fused": FUSED,
    "raster/compile": COMPILE,
    "raster/reference": REFERENCE,
    "raster/primitive": PRIMITIVE,
    "raster/band": RASTER,
    "hal/bus": HAL_BUS | {"hal/include"},
    "hal/panel": HAL_PANEL | {"hal/include"},
    "hal/display": HAL,
    "hal/linux": HAL | {"hal/linux"},
    "hal/mcu": HAL,
    "hal/usb": HAL | {"hal/linux", "hal/usb"},
    "gl/api": GL, "gl/context": GL, "gl/vertex": GL, "gl/pixel": GL, "gl/texture": GL, "gl/list": GL,
    "gl/egl": GL | {"gl/egl", "hal/bus", "hal/panel", "hal/display", "hal/include"},
    "boards/scenes": PUBLIC | {"boards/scenes"},
    "boards/examples": PUBLIC | {"boards", "boards/scenes"},
    "boards": PUBLIC | {"boards", "boards/scenes"},
    "host_sim": EVERYTHING,
}


def room_of(path):
    """Returns the longest known room that holds this repository path, or None for files of no room (tests, system)."""
    parts = path.split("/")
    for n in range(len(parts) - 1, 0, -1):
        room = "/".join(parts[:n])
        if room in MAY_INCLUDE or room in {"raster/include", "gl/include", "hal/include"}:
            return room
    return None


def records(build):
    out = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    for block in out.split("\n\n"):
        lines = [line.strip() for line in block.splitlines()]
        if lines and ": #deps" in lines[0]:
            inside = []
            for line in lines[1:]:
                path = pathlib.Path(line)
                path = path if path.is_absolute() else pathlib.Path(build) / path
                try:
                    inside.append(str(path.resolve().relative_to(ROOT)))
                except ValueError:
                    pass  # a system header belongs to no room
            yield lines[0].split(": #deps")[0], inside


def named_by_headers():
    """Yields each header of a room with each file of the tree that it includes by its path."""
    for room in MAY_INCLUDE:
        for header in sorted((ROOT / room).glob("**/*.hpp")):
            path = str(header.relative_to(ROOT))
            if room_of(path) == room:
                for used in re.findall(r'^#include "(\w+/[^"]+)"', header.read_text(), re.M):
                    yield path, used


def main():
    if len(sys.argv) != 2:
        print(__doc__.strip())
        return 2
    bad, checked = set(), 0
    for target, files in records(sys.argv[1]):
        source = next((f for f in files if re.search(r"\.(cpp|c)$", f)), None)
        room = room_of(source) if source else None
        if room is None or source.startswith("tests/") or source.startswith("build/"):
            continue
        checked += 1
        for used in files:
            other = room_of(used)
            if other is not None and other != room and other not in MAY_INCLUDE[room]:
                bad.add(f"{source} ({room}) may not include {used} ({other})")
    for header, used in named_by_headers():
        room, other = room_of(header), room_of(used)
        if other is not None and other != room and other not in MAY_INCLUDE[room]:
            bad.add(f"{header} ({room}) may not include {used} ({other})")
    for line in sorted(bad):
        print(line)
    print(f"{checked} compilations checked, {len(bad)} forbidden includes")
    return 1 if bad or checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
