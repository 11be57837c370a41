#!/usr/bin/env python3
"""Measures where the text of the scene profiles is, in the images that profiles.py measures: bytes of instructions by the folder of their
source. Inlined code counts for its own source, and constants are a row of their own.

usage: rooms.py [--build FOLDER]

Writes the table of docs/profiles.md.
"""
import argparse
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

import profiles
from profiles import DOCUMENT, SUBJECTS, TARGET, firmware, outfile, profile

ROOMS = {  # {folder: what its code does}
    "gl/api": "entry points, arguments",
    "gl/context": "state, queries, memory",
    "gl/vertex": "vertices, matrices, lights, clipping, primitives",
    "gl/texture": "textures",
    "gl/pixel": "fragment state, images, reading back",
    "gl/list": "display lists",
    "gl/egl": "EGL",
    "raster/numeric": "numbers, matrices",
    "raster/primitive": "set-up and rows of triangles, lines, points",
    "raster/ops": "fragments: texels, fog, blending, tests, stores",
    "raster/chain": "the chain",
    "raster/fused": "fused spans",
    "raster/compile": "from a state to a function",
    "raster/span": "planes and rows of spans",
    "raster": "surfaces, clears, formats, bands",
    "hal": "panel, bus, start-up",
    "boards": "the program",
}
CONSTANTS, OTHERS = "constants", "compiler's and C++ library"


def room_of(source):
    """Returns the first of ROOMS that a source file is in."""
    inside = firmware.source_of(source)
    return next((room for room in ROOMS if inside.startswith(room + "/")), OTHERS)


def instructions(image):
    """Returns {address: bytes} of an image's instructions."""
    listing = subprocess.run([firmware.TARGETS[TARGET].prefix + "objdump", "-d", str(image)], capture_output=True, text=True, check=True).stdout
    found = re.findall(r"^\s*([0-9a-f]+):\t([0-9a-f]+(?: [0-9a-f]+)*)\s*\t(?!\.)", listing, re.M)
    return {int(address, 16): len(code.replace(" ", "")) // 2 for address, code in found}


def measure(image):
    """Returns {room: bytes}."""
    sizes = instructions(image)
    said = subprocess.run([firmware.TARGETS[TARGET].prefix + "addr2line", "-e", str(image)], input="\n".join(map(hex, sizes)),
                          capture_output=True, text=True, check=True).stdout
    bytes_of = collections.Counter()
    for size, source in zip(sizes.values(), said.splitlines(), strict=True):
        bytes_of[room_of(re.sub(r":[\d?]+(?: \(.*\))?$", "", source))] += size
    bytes_of[CONSTANTS] = profiles.text_of(image) - sum(bytes_of.values())
    return bytes_of


def images(build):
    """Yields (name, image) of what profiles.py measures, built with debug information, which changes no instruction."""
    for name, subject in SUBJECTS.items():
        defines = [*(f"-D{definition}" for definition in profile.definitions(name)), "-g"]
        library = build.library(TARGET, defines, name, hot=profiles.HOT, lto=True)
        if name == "minimal":
            yield name, profiles.minimal(build, f"{name}_size", library, False, defines, lto=True)
        else:
            yield name, profiles.sized(build, name, library, defines, subject.later)


def table(measured):
    names = list(measured)
    rows = [(f"{room} | {what}", [measured[name][room] for name in names]) for room, what in ROOMS.items()]
    rows += [(f"{room} |", [measured[name][room] for name in names]) for room in (CONSTANTS, OTHERS)]
    head = f"| folder | | {' | '.join(names)} |\n|---|---|{'--:|' * len(names)}\n"
    return head + "".join(f"| {title} | {' | '.join(str(n) if n else '-' for n in cells)} |\n" for title, cells in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, help="where objects go, and stay")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        build = firmware.Build(arguments.build or folder)
        made = dict(images(build))
        build.run()
        measured = {name: measure(image) for name, image in made.items()}
    text = table(measured)
    print(text, end="")
    outfile.write(DOCUMENT, profiles.with_table(DOCUMENT.read_text(), "rooms", text))
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
