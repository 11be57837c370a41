#!/usr/bin/env python3
"""Runs programs of piglit that must pass, and a part of all programs, which must do what piglit_table.csv says.

usage: piglit_test.py PAIR
"""
import pathlib
import sys

import piglit as suite
from harness import PIGLIT, check, failures, need, piglit, turn

PAIR = pathlib.Path(sys.argv[1]).resolve()
SECONDS = 30  # seconds for the part of all programs
SAMPLE = ["gl-1.0-readpixsanity", "gl-1.0-no-op-paths", "gl-1.0-scissor-clear", "gl-1.0-edgeflag", "gl-1.0-texgen",
          "gl-1.0-textured-triangle", "gl-1.1-xor", "depthfunc", "fog-modes", "linestipple", "polygon-mode", "gl-1.3-texture-env"]

need(PIGLIT / SAMPLE[0])
for name in SAMPLE:
    result, words = piglit(name, PAIR)
    print(f"{name}: {result}")
    check(result == "pass", f"{name}: {result}\n{words[-2000:]}")
suite.sample(PAIR, SECONDS, turn())
sys.exit(1 if failures else 0)
