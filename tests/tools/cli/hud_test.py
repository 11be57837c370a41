#!/usr/bin/env python3
"""Tests that the dashboard can be read on every board: its number stands on the glass, pixel by pixel as the font has it.

usage: hud_test.py SPANGLE
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "host_sim/tools"), str(ROOT / "tests/support")]
import png  # noqa: E402
from checks import check, failures  # noqa: E402

NUMBER, FRAMES = "058", 30  # what the gauge shows in the last of so many frames


def glyphs():
    source = (ROOT / "boards/scenes/font.cpp").read_text()
    characters = re.search(r'characters = "([^"]+)"', source).group(1)
    shapes = re.findall(r'"([.#]{35})"', source)
    return {c: [shape[5 * row:5 * row + 5] for row in range(7)] for c, shape in zip(characters, shapes)}


def text(letters, scale):
    """Returns the rows of a text, with a 1 for each lit pixel. `scale` pixels show one pixel of the font."""
    font = glyphs()
    rows = [".".join(font[c][row] for c in letters) for row in range(7)]
    return ["".join(("1" if c == "#" else "0") * scale for c in row) for row in rows for _ in range(scale)]


def stands(rows, wanted):
    """Returns whether these rows stand somewhere in the picture, one below the other."""
    for top in range(len(rows) - len(wanted) + 1):
        at = rows[top].find(wanted[0])
        while at >= 0:
            if all(rows[top + y][at:at + len(line)] == line for y, line in enumerate(wanted)):
                return True
            at = rows[top].find(wanted[0], at + 1)
    return False


def scale_of(path):
    """Returns the scale of the number in the picture; 0 if the number is nowhere."""
    picture = png.read(path.read_bytes())[2]
    rows = ["".join("1" if r + 2 * g + b > 640 else "0" for r, g, b in row) for row in picture]
    return next((scale for scale in range(8, 0, -1) if stands(rows, text(NUMBER, scale))), 0)


def main():
    if len(sys.argv) != 2:
        print(__doc__.strip())
        return 2
    boards = [line.split()[0] for line in subprocess.run([sys.argv[1], "boards"], capture_output=True, text=True).stdout.splitlines()]
    check(len(boards) > 20, "the boards are listed")
    with tempfile.TemporaryDirectory() as folder:
        for board in boards:
            shot = pathlib.Path(folder) / "hud.png"
            done = subprocess.run([sys.argv[1], "run", "HUD", "--frames", str(FRAMES), "--board", board, "--shot", str(shot)], capture_output=True, text=True)
            check(done.returncode == 0, f"{board}: {done.stderr}")
            scale = scale_of(shot)
            print(f"{board:<18}{NUMBER} in letters of {7 * scale} pixels")
            check(scale > 0, f"{board}: {NUMBER} cannot be read")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
