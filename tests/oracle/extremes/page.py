#!/usr/bin/env python3
"""Writes docs/extremes.md from what the tests of extreme cases print, and from what the same cases print with Mesa.

usage: tests/oracle/extremes/page.py [--check] [PROGRAM [MESA]]

PROGRAM is the built test_extremes, MESA mesa_extremes; without them those of build/test. --check writes nothing and fails
where the page has other figures of ours. Mesa's own depend on the processor: only which cases it has is looked at.
"""
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402

PAGE = ROOT / "docs/extremes.md"
BUILT = ROOT / "build/test/tests"
ENVIRONMENT = {**os.environ, "SPANGLE_HOURS": "24"}  # the page shows the error of a whole day
HEAD = """# Extremes

What is drawn at the ends of every range: numbers of all bits, no numbers, planes, slivers, empty sizes. Each case goes through the exact, the balanced and the fast
tier, and through the float, double, fixed and int forms of its commands where they exist. A formula of the specification or brute force judges it, never a picture of
our own. "Wrong" fragments are counted over all tiers and forms; where a judge works in real numbers, it leaves out centres within 1/128 to 1/32 pixel of an edge, because
vertices are snapped to 1/256 pixel.

The last column is what Mesa prints for the same sources under the same judges: OSMesa of Mesa {mesa}, in floats, with one tier in place of three. Its numbers are no
errors of Mesa where the specification leaves an outcome open: a judge asks for what we promise, which is more than GL requires.

`tests/oracle/extremes/page.py` writes this table from what `test_extremes` and `mesa_extremes` print; `extremes.page`, a slow test, draws all of it again. ASan and UBSan run
the program, too. Repeats of a texture up to 10^6 are in `Unsnapped.AMillionRepeatsAreAsExactAsFloatsAre`. `SPANGLE_ROTATIONS=1000000 test_extremes
--gtest_filter='*26*'` turns a matrix a million times, in about two seconds.

`test_extreme_sweep` puts INT_MIN, INT_MAX, 0, neighbours of 1, denormals, infinities, NaN and 10^38 at every number of every entry point of the command table: outside
glBegin and glEnd, between them, in a display list, in each tier. A call raises no error but one that GL allows, and then changes nothing. State stays finite, and a
picture drawn afterwards is that of a new context. `./dev nightly` does all of it under the sanitizers, after a million random frames.

What a program sums for a day stays within the bounds of rows 35 and 36. Matrices are not made orthogonal again: a turn adds 2^-31 at most. A sum that only grows may
lose 2^-31 of itself in each frame; one that turns back, or that the program wraps, stays exact. An angle or a coordinate from a clock is as good as the float that holds
it (row 37); doubles become floats, so that `glRotated` of 8 million degrees is a quarter of a degree off.

| case | required | judged by | observed | Mesa |
|---|---|---|---|---|
"""


def rows(program, *options):
    """Returns {name: [required, judged by, observed]} of what was printed; a case that fails prints its row, too."""
    printed = subprocess.run([program, *options, "--gtest_brief=1"], capture_output=True, text=True, env=ENVIRONMENT)
    found = {}
    for line in printed.stdout.splitlines():
        if re.match(r"\| \d\d_", line):
            name, *cells = line.strip("| ").split(" | ")
            found[name] = cells
    return found, printed.returncode


def of_mesa(program, names):
    """Returns {name: figure}. Each case has a process of its own, so that a case that ends Mesa does not end the others."""
    figures = {}
    for name in names:
        found, status = rows(program, f"--gtest_filter=Extreme.{name}")
        figures[name] = found[name][-1] if name in found else f"ended by signal {-status}" if status < 0 else "stopped: an assertion failed"
    return figures


def main():
    arguments = sys.argv[1:]
    check = arguments[:1] == ["--check"]
    programs = arguments[check:]
    if len(programs) > 2 or any(word.startswith("-") for word in programs):
        print(__doc__.strip())
        return 2
    ours = programs[0] if programs else str(BUILT / "test_extremes")
    mesa = programs[1] if len(programs) > 1 else str(BUILT / "oracle/extremes/mesa_extremes")
    found, status = rows(ours, "--gtest_filter=Extreme.*")
    if status != 0:
        print("a case fails; test_extremes says which")
        return 1
    if check:
        text = PAGE.read_text()
        stale = [name for name, cells in found.items() if f"| {name} | {' | '.join(cells)} | " not in text]
        print(f"{len(found) - len(stale)} of {len(found)} rows of docs/extremes.md hold what was drawn" + "".join(f"\n  other now: {name}" for name in stale))
        return 1 if stale else 0
    figures = of_mesa(mesa, sorted(found))
    version = subprocess.run(["dpkg-query", "-W", "-f", "${source:Upstream-Version}", "libosmesa6"], capture_output=True, text=True)
    lines = [f"| {name} | {' | '.join(found[name])} | {figures[name]} |\n" for name in sorted(found)]
    outfile.write(PAGE, HEAD.format(mesa=version.stdout.strip()) + "".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
