#!/usr/bin/env python3
"""Writes the tables of docs/choose.md: accuracy as the command line measures it, instructions and sizes from the golden files.

usage: choose.py SPANGLE [--update]

Without --update the exit status is 1 if the document shows other tables.
"""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402

PAGE = ROOT / "docs/choose.md"
SCENES = {"S3": "shaded quads", "S4r": "a rolled plane, NEAREST", "S6": "a lit torus", "S7": "200 blended sprites", "S9": "a lit, textured torus in fog"}
TIERS = ("exact", "balanced", "fast")


def drawn(spangle, scene, tier):
    done = subprocess.run([spangle, "run", scene, "--precision", tier, "--size", "320x240", "--compare", "--json"], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def accuracy(spangle):
    counts = json.loads((ROOT / "tests/tools/bench/golden.json").read_text())
    rows = [f"| program | {' | '.join(TIERS)} |", "|---|" + "--:|" * len(TIERS)]
    for scene, title in SCENES.items():
        cells = []
        for tier in TIERS:
            report = drawn(spangle, scene, tier)
            cells.append(f"{report['identical_565_percent']:.2f} %, {report['max_lsb']}, {counts[f'm4 {scene} {tier}']['instructions'] / 1e6:.1f} M")
        rows.append(f"| {title} ({scene}) | {' | '.join(cells)} |")
    return "\n".join(rows) + "\n"


def sizes():
    golden = json.loads((ROOT / "tests/tools/profiles/golden.json").read_text())
    titles = {"minimal": "one lit, textured model in a parallel projection, the fast tier", "first_slice": "lit and textured models, sprites and lines; no lists",
              "gl13": "all of GL 1.3", "whole": "everything that Spangle has, the balanced tier"}
    rows = ["| build | flash | RAM beside the buffers |", "|---|--:|--:|"]
    rows += [f"| {titles[name]} (`{name}`) | {golden[name]['text'] / 1024:.0f} KB | {golden[name]['ram'] / 1024:.0f} KB |" for name in titles]
    return "\n".join(rows) + "\n"


def with_table(text, name, table):
    before, rest = text.split(f"<!-- table: {name} -->\n")
    return f"{before}<!-- table: {name} -->\n{table}<!-- end -->" + rest.split("<!-- end -->", 1)[1]


def main():
    if len(sys.argv) not in (2, 3):
        print(__doc__.strip())
        return 2
    old = PAGE.read_text()
    new = with_table(with_table(old, "accuracy", accuracy(sys.argv[1])), "sizes", sizes())
    if "--update" in sys.argv[2:]:
        outfile.write(PAGE, new)
    elif new != old:
        print("docs/choose.md does not show what is measured; tests/tools/readme/choose.py SPANGLE --update writes it")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
