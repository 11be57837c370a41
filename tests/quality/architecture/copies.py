#!/usr/bin/env python3
"""Checks that no two files of boards are copies of each other but for names.

usage: copies.py [ROOT]

What boards have in common stands in one file that each of them includes. A few lines, which say what a board is, may be alike.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
FILES = ("board.cpp", "display.hpp", "memory.ld")
ALIKE = 4  # lines that two boards may have in common: the names of a wiring and of its blocks


def code(path):
    """Returns the lines of a file that do something, without comments, and with all names of boards and processors made equal."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", path.read_text(), flags=re.S)
    text = re.sub(re.escape(path.parent.name) + r"|Cortex-\w+|\bMPS\d\+?", "NAME", text)
    lines = (line.strip() for line in text.splitlines())
    return [line for line in lines if len(line) > 1 and not line.startswith(("#", "namespace", "} //", "INCLUDE"))]


def copies(boards):
    """Returns pairs of files whose code is the same."""
    found = []
    for name in FILES:
        paths = sorted(boards.glob(f"*/{name}"))
        for i, path in enumerate(paths):
            lines = code(path)
            found += [(path, other) for other in paths[:i] if len(lines) > ALIKE and code(other) == lines]
    return found


def main():
    boards = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT) / "boards"
    found = copies(boards)
    for path, other in found:
        print(f"{path.relative_to(boards)} is a copy of {other.relative_to(boards)} but for names")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
