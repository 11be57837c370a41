#!/usr/bin/env python3
"""Draws the pictures of the documents, docs/pictures/*.png, with the command line.

usage: pictures.py SPANGLE [--check]

hero.png moves: hero.py says what is on its glasses. --check writes nothing, and fails when a picture is not, pixel by pixel and
frame by frame, the one that this build draws. Other files of the folder
come from other tools and are not checked: tests/system/programs/gallery.py draws programs.png, tests/tools/page/page_test.py --picture
page.png, tests/tools/trade/trade_test.py SPANGLE picture trade.png.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import hero
import outfile
import png

PICTURES = pathlib.Path(__file__).resolve().parents[2] / "docs/pictures"
MODEL = pathlib.Path("/usr/share/assimp/models/Collada/duck.dae")
DRAWN_BY = {
    "gears": ["run", "S5", "--frames", "30"],
    "torus": ["run", "S9", "--frames", "20"],
    "dashboard": ["run", "HUD", "--frames", "20"],
    "duck": ["run", "--model", str(MODEL)],
    "formats": ["formats"],
    "samples": ["samples"],
    **{f"choose_{tier}": ["run", "S4r", "--precision", tier, "--size", "160x120"] for tier in ("exact", "balanced", "fast")},
    "baked": ["run", "BAKED", "--frames", "12"],
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("spangle")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if not MODEL.exists():
        print(f"pictures: there is no {MODEL}; install assimp-testmodels", file=sys.stderr)
        return 2
    stale = []
    with tempfile.TemporaryDirectory() as folder:
        for name, words in DRAWN_BY.items():
            shot, kept = pathlib.Path(folder) / f"{name}.png", PICTURES / f"{name}.png"
            subprocess.run([options.spangle, *words, "--shot", str(shot)], check=True, stdout=subprocess.DEVNULL)
            if not options.check:
                outfile.write(kept, shot.read_bytes())
            elif not kept.exists() or png.read(kept.read_bytes()) != png.read(shot.read_bytes()):
                stale.append(str(kept.relative_to(PICTURES.parents[1])))
    kept = PICTURES / "hero.png"
    if not options.check:
        outfile.write(kept, hero.made(options.spangle))
    elif not kept.exists() or not hero.is_fresh(options.spangle, kept.read_bytes()):
        stale.append(str(kept.relative_to(PICTURES.parents[1])))
    if stale:
        print(f"{', '.join(stale)}: not what this build draws; run ./dev pictures")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
