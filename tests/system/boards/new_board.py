#!/usr/bin/env python3
"""Follows docs/new-board.md: makes the folder of its board from the page alone, builds it and runs it.

usage: new_board.py --host SPANGLE_TWIN --build FOLDER

The board has the display of mps2_an505: its frames must be that twin's. Exit status 77 (skipped) when a compiler or
emulator is missing.
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "boards/tools"))
import boards  # noqa: E402
import firmware  # noqa: E402
import twin  # noqa: E402

FRAMES = 3
LIKE = "mps2_an505"


def blocks(text):
    """Returns {file: content} of the page's code in the section about firmware."""
    section = text.partition("## 4. Firmware")[2].partition("\n## ")[0]
    files = {}
    for language, code in re.findall(r"^```(\w+)\n(.*?)^```", section, re.M | re.S):
        named = re.match(r"(?://|/\*) boards/my_board/(\S+)", code)
        files[named.group(1) if named else f"board.{language}"] = code
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--host", required=True, type=pathlib.Path)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    arguments = parser.parse_args()
    folder = arguments.build.resolve() / "my_board"
    folder.mkdir(parents=True, exist_ok=True)
    for name, code in blocks((ROOT / "docs/new-board.md").read_text()).items():
        (folder / name).write_text(code)
    board = boards.read_board(folder / "board.json")
    if firmware.missing([board.target]):
        print("skipped: no compiler or emulator (./dev setup --all installs them)")
        return 77
    build = firmware.Build(arguments.build)
    image = boards.add_image(build, board, "semihosting")
    build.run()
    run = boards.read_run(firmware.emulate(board.machine, image, (str(FRAMES),)))
    like = boards.discover()[LIKE]
    expected = twin.play(arguments.host, boards.dataclasses.replace(like, scenes=board.scenes), FRAMES)
    for scene in board.scenes:
        ours, theirs = [f.hash for f in run.scenes.get(scene, [])], [f.hash for f in expected[scene]]
        if ours != theirs:
            print(f"{scene}: {ours} instead of {theirs}", *run.problems, sep="\n")
            return 1
    print(f"the board of docs/new-board.md draws {FRAMES} frames of {', '.join(board.scenes)} as {LIKE} does")
    return 0


if __name__ == "__main__":
    sys.exit(main())
