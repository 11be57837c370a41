#!/usr/bin/env python3
"""Checks that sources name their numbers: floating-point numbers in hexadecimal, float words, and commands of panels.

usage: numbers.py [ROOT]

Such a number stands in a definition (constexpr or static constexpr), whose name or comment says where it comes from. The commands
that panels share (MIPI DCS) have names, those of the drivers in hal/ and those of the controller models in host_sim/. Models and
drivers share no definition, so that one cannot hide a fault of the other.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
ROOMS = ("raster", "gl", "hal", "host_sim")
HEX_FLOAT = re.compile(r"\b0x[0-9A-Fa-f.]+p[+-]?\d+")
# A float from 2^-5 to 2^10 or its negative, in braces as a Real, or compared with bits.
FLOAT_WORD = re.compile(r"\{0x[3BC][C-F4][0-9A-Fa-f]{6}\}|\{0x4[0-4][0-9A-Fa-f]{6}\}|bits == 0x[34BC][0-9A-Fa-f]{7}\b")


def unnamed(text):
    """Yields the statements of a source that hold such a number and define no constant."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/|\"[^\"\n]*\"", "", text, flags=re.S)
    for statement in re.split(r"[;]|\n\s*\n", text):
        if (HEX_FLOAT.search(statement) or FLOAT_WORD.search(statement)) and "constexpr" not in statement:
            yield " ".join(statement.split())[-120:]


def raw_commands(root):
    """Yields (file, what is wrong) of commands of panels."""
    for path in sorted([*(root / "host_sim/controller").glob("dcs_*"), root / "host_sim/bus/pins.cpp"]):
        text = path.read_text()
        if path.name != "dcs_commands.hpp":
            yield from ((path, found) for found in re.findall(r"case 0x\w+|command_? [=!<>]+ 0x\w+|madctl_ & \w+\b(?<!dcs)(?!::)", text))
        yield from ((path, found) for found in re.findall(r"#include .*hal/dcs\.hpp.*", text))
    # Commands below 60h are those of DCS; the makers' own begin there.
    for path in sorted((root / "hal/include/spangle/panels").glob("*.hpp")):
        text = path.read_text()
        if "CommandSet" not in text:  # families with commands of their own have other numbers
            yield from ((path, found) for found in re.findall(r"\bcmd\(0x[0-5]\w\b", text))


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT
    wrong = 0
    for room in ROOMS:
        for path in sorted((root / room).rglob("*.[ch]pp")):
            for statement in unnamed(path.read_text()):
                print(f"{path.relative_to(root)}: a number without a name: {statement}")
                wrong += 1
    for path, found in raw_commands(root):
        print(f"{path.relative_to(root)}: a command without a name of its own: {found}")
        wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
