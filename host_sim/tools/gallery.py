#!/usr/bin/env python3
"""Writes docs/gallery.md and its pictures: what each wrong setting of a panel looks like on the glass, and what mends it.

usage: gallery.py SPANGLE [--check]

Each picture is the simulated glass with the test card, drawn by a driver that has one setting wrong. --check writes nothing,
and fails when the page or a picture is not what this build gives.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import outfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE, FOLDER = ROOT / "docs/gallery.md", ROOT / "docs/gallery"
BOARD = "st7789-240x280"
SEEN = {
    "": "as it should be: a white frame on the very edge, an F that reads as one, R red, G green, B blue, on black",
    "order": "R is blue, B is red",
    "inversion": "a negative: white where it should be black",
    "mirrored": "left and right are exchanged",
    "upside-down": "everything stands on its head",
    "turned": "lies on its side; what the picture does not reach keeps what was there before",
    "offset": "shifted: an edge is missing, on the other side a strip keeps noise or what was there before",
    "size": "too small: a strip of the glass is never drawn",
    "bytes": "black and white are right, pure colours are not",
    "bits": "squeezed together and psychedelic, three bytes read where two were sent",
    "data-command": "nothing: the light is on, the glass stays dark",
    "clock": "sheared from some row on, with colours that change where a byte was lost",
}
HEAD = """# What is wrong with this picture?

The test card (`spangle card`) on the simulated glass of a 240x280 ST7789, and what it looks like with one setting wrong. `spangle wizard` asks about the same card,
corrects one thing after the other and prints the board's definition; `spangle probe` asks the controller who it is, where its data output is wired. All three also
drive real panels: `--spidev /dev/spidev0.0 --dc gpiochip0:24 --reset gpiochip0:25`, or `--ftdi`.

This page and its pictures are made by `./dev gallery`.

| setting | the glass | what you see | what mends it |
|---|---|---|---|
"""


def run(*words):
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("spangle")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    spangle, check = options.spangle, options.check
    fixes = {"": "nothing"} | dict(line.split("\t") for line in run(spangle, "card", "--list-wrong").splitlines())
    if set(fixes) != set(SEEN):
        print(f"the page does not describe {set(fixes) ^ set(SEEN)}")
        return 1
    page, stale = HEAD, []
    with tempfile.TemporaryDirectory() as folder:
        for name, fix in fixes.items():
            title = name or "right"
            made, kept = pathlib.Path(folder) / f"{title}.png", FOLDER / f"{title}.png"
            run(spangle, "card", "--board", BOARD, "--shot", str(made), *(["--wrong", name] if name else []))
            page += f"| {title} | ![{title}](gallery/{title}.png) | {SEEN[name]} | {fix} |\n"
            if not kept.is_file() or kept.read_bytes() != made.read_bytes():
                stale.append(kept.name)
                if not check:
                    FOLDER.mkdir(exist_ok=True)
                    outfile.write(kept, made.read_bytes())
    if not PAGE.is_file() or PAGE.read_text() != page:
        stale.append(PAGE.name)
        if not check:
            outfile.write(PAGE, page)
    if check and stale:
        print(f"not what this build gives, run ./dev gallery: {', '.join(stale)}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
