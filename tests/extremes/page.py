#!/usr/bin/env python3
"""Writes docs/extremes.md from what the tests of extreme cases print.

usage: tests/extremes/page.py [PROGRAM]     PROGRAM: the built test_extremes; default build/test/tests/test_extremes
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402

HEAD = """# Extremes

What is drawn at the ends of every range: numbers of all bits, no numbers, planes, slivers, empty sizes. Each case goes through the exact, the balanced and the fast
tier, and through the float, double, fixed and int forms of its commands where they exist. A formula of the specification or brute force judges it, never a picture of
our own. "Wrong" fragments are counted over all tiers and forms; where a judge works in real numbers, it leaves out centres within 1/128 to 1/32 pixel of an edge, because
vertices are snapped to 1/256 pixel.

`tests/extremes/page.py` writes this table from what `test_extremes` prints. A test holds the names of its rows. ASan and UBSan run the program, too.
Repeats of a texture up to 10^6 are in `Unsnapped.AMillionRepeatsAreAsExactAsFloatsAre`. `SPANGLE_ROTATIONS=1000000 test_extremes --gtest_filter='*26*'` turns a
matrix a million times, in about two seconds.

| case | required | judged by | observed |
|---|---|---|---|
"""


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build/test/tests/test_extremes")
    printed = subprocess.run([program, "--gtest_filter=Extreme.*", "--gtest_brief=1"], check=True, capture_output=True, text=True).stdout
    rows = sorted(line for line in printed.splitlines() if re.match(r"\| \d\d_", line))
    outfile.write(ROOT / "docs/extremes.md", HEAD + "".join(row + "\n" for row in rows))


if __name__ == "__main__":
    main()
