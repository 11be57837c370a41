#!/usr/bin/env python3
"""Tests that traces of programs give Mesa's pictures.

usage: traces_test.py PAIR
"""
import pathlib
import sys

from harness import HERE, ORACLES, check, compare, failures, folder, mesa_environment, need, replay, spangle_environment, trim

PAIR = pathlib.Path(sys.argv[1])
FRAMES = 12  # frames of a trace that are replayed
SHOWN = 4  # frames that are compared: the first, the last, and some in between

need("eglretrace", "apitrace")


def sample(pictures):
    count = len(pictures)
    return [pictures[i * (count - 1) // max(SHOWN - 1, 1)] for i in range(min(SHOWN, count))]


for trace in sorted((HERE / "traces").glob("*.trace")):
    with folder(trace.stem) as place:
        short = place / trace.name
        trim(trace, FRAMES, short)
        ours, ended = replay(short, spangle_environment(PAIR), place / "spangle")
        check(ended.status == 0 and ours, f"{trace.stem}: {ended.words[-2000:]}")
        theirs = {oracle: replay(short, mesa_environment(oracle), place / oracle)[0] for oracle in ORACLES}
        names = [[p.name for p in pictures] for pictures in (ours, *theirs.values())]
        check(all(n == names[0] for n in names), f"{trace.stem}: not all replays have the same frames: {[len(n) for n in names]}")
        for picture in sample(ours):
            compare(f"{trace.stem} {int(picture.stem)}", picture, [place / o / picture.name for o in ORACLES])
sys.exit(1 if failures else 0)
