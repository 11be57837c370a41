#!/usr/bin/env python3
"""Checks that SPANGLE_OPTIMIZE chooses between files, not between lines of a function.

usage: ways.py [ROOT]

Where a build for speed and one for size differ, a room has two headers of one name, speed/NAME.hpp and size/NAME.hpp, which define the same
functions. The header NAME.hpp above both includes one of them and holds nothing else. No other file includes one of the two.

LEFT counts the lines that still name the choice elsewhere. These numbers may only become smaller.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
ROOMS = ("gl", "raster", "hal", "boards", "host_sim")
SUFFIXES = {".h", ".hpp", ".c", ".cpp", ".inc"}
CHOICE = re.compile(r"\bhas_shortcuts\b|\bSPANGLE_SHORTCUTS\b")
WAYS = ("speed", "size")
SELECTOR = """// {text}
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "{room}/speed/{name}"
#else
#include "{room}/size/{name}"
#endif
"""
DEFINED = {"raster/include/spangle/raster/limits.hpp": 3}  # the option itself
LEFT = {
    "gl/pixel/row_fields.hpp": 1,  # rows of pixels are converted by lanes, on hosts
    "raster/primitive/setup_texture.cpp": 1,  # the two ways may round differently where a build has levels of detail
}


def selector(room, name, text):
    """Returns the text of the header that chooses. Its first line says what it chooses."""
    return SELECTOR.format(room=room, name=name, text=text.partition("\n")[0].removeprefix("// "))


def sources(root):
    for room in ROOMS:
        for path in sorted((root / room).rglob("*")):
            if path.suffix in SUFFIXES:
                yield str(path.relative_to(root)), path.read_text()


def faults(root, left):
    """Yields what is wrong, a line each. `left` is {file: lines that may name the choice}."""
    texts = dict(sources(root))
    selectors = set()
    for path in texts:
        folder, _, name = path.rpartition("/")
        room, _, way = folder.rpartition("/")
        if way not in WAYS:
            continue
        other = f"{room}/{WAYS[1 - WAYS.index(way)]}/{name}"
        if other not in texts:
            yield f"{path} has no counterpart {other}"
        chooses = f"{room}/{name}"
        if chooses not in selectors and texts.get(chooses) != selector(room, name, texts.get(chooses, "")):
            yield f"{chooses} must choose between {room}/speed and {room}/size, and hold nothing else"
        selectors.add(chooses)
    for path, text in texts.items():
        for used in re.findall(r'^#include "([^"]+/(?:speed|size)/[^"]+)"', text, re.M):
            if path not in selectors:
                yield f"{path} may not include {used}, but the header that chooses"
        found, allowed = sum(1 for line in text.splitlines() if CHOICE.search(line)), left.get(path, 0)
        if found > allowed and path not in selectors:
            yield f"{path} names the choice between speed and size in {found} lines, not {allowed}: make a pair of files"
        if found < allowed:
            yield f"{path} names the choice in {found} lines: LEFT in ways.py says {allowed}, and must become smaller"
    for path in left:
        if path not in texts:
            yield f"LEFT in ways.py names {path}, which is no source"


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT
    found = list(faults(root, DEFINED | LEFT if root == ROOT else {}))
    print("\n".join([*found, f"{len(found)} faults; {sum(LEFT.values())} lines are left"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
