#!/usr/bin/env python3
"""Runs firmware that goes wrong on purpose on every board: it must end, or go on, as it should.

usage: provoke.py --build FOLDER [BOARD...]

Exit status 77 (skipped) when a compiler or emulator is missing.
"""
import argparse
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "boards/tools"))
import boards  # noqa: E402
import firmware  # noqa: E402

FAULTS = {"stack": r"panic: stack overflow at ", "instruction": r"panic: fault at [0-9a-f]*[1-9a-f]", "address": r"panic: fault at [0-9a-f]*[1-9a-f]"}
# QEMU's machines that answer a read of any address with 0, without a bus error.
NO_BUS_ERRORS = ("lm3s6965evb", "lm3s811evb", "vexpress_a9")
# Boards on which memory runs out: with whole frames and with bands, with much memory and with little.
SHORT = ("mps2_an386", "lm3s6965evb", "netduinoplus2")
SHORTAGE = """a panel that does not answer: eglInitialize
the board's own: shown
GL_OUT_OF_MEMORY after some textures
without memory: shown
the same picture: yes"""


def faults(board, image):
    """Returns lines that say what is wrong."""
    wrong = []
    for word, said in FAULTS.items():
        if word == "address" and board.name in NO_BUS_ERRORS:
            continue
        try:
            text = firmware.emulate(board.machine, image, (word,), status=3, timeout=30)
        except RuntimeError as error:
            wrong.append(f"{board.name}: {word}: {error}")
            continue
        if not re.search(said, text):
            wrong.append(f"{board.name}: {word}: said '{text.strip()}'")
    return wrong


def add_shortage(build, board):
    """Adds firmware of a board that runs out of memory, with the board's own library."""
    variant = board.name if board.defines else ""
    paths = [HERE / "shortage.cpp", ROOT / "boards/demo/demo.cpp", board.folder / "board.cpp", *firmware.startup(board.target)]
    objects = [*(build.compile(board.target, "-Os", path, board.defines, board.name) for path in paths), *build.library(board.target, board.defines, variant)]
    return build.image(board.target, dict.fromkeys(objects), board.folder / "memory.ld", f"{board.name}.shortage.elf")


def shortage(board, image):
    """Returns lines that say what is wrong."""
    try:
        text = firmware.emulate(board.machine, image)
    except RuntimeError as error:
        return [f"{board.name}: shortage: {error}"]
    return [] if text.strip() == SHORTAGE else [f"{board.name}: shortage: said\n{text}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("boards", nargs="*", metavar="BOARD")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/provoke")
    arguments = parser.parse_args()
    chosen = [board for name, board in boards.discover().items() if not arguments.boards or name in arguments.boards]
    if firmware.missing({board.target for board in chosen}):
        print("skipped: no compiler or emulator (./dev setup --all installs them)")
        return 77
    build, images = firmware.Build(arguments.build), {}
    for board in chosen:
        objects = [build.compile(board.target, "-Os", path) for path in (HERE / "faults.cpp", *firmware.startup(board.target))]
        images[board.name] = build.image(board.target, objects, board.folder / "memory.ld", f"{board.name}.faults.elf")
    short = {board.name: add_shortage(build, board) for board in chosen if board.name in SHORT}
    build.run()
    wrong = [line for board in chosen for line in faults(board, images[board.name])]
    wrong += [line for board in chosen if board.name in short for line in shortage(board, short[board.name])]
    print("\n".join(wrong) if wrong else f"{len(chosen)} boards end as they should")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
