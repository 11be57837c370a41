#!/usr/bin/env python3
"""Checks that the op which docs/architecture/ops.md shows is the one that tests/unit/span/example_op.cpp runs."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE, TEST = ROOT / "docs/architecture/ops.md", ROOT / "tests/unit/span/example_op.cpp"

shown = re.search(r"^```cpp\n(.*?)^```", PAGE.read_text(), re.M | re.S)
run = re.search(r"^// The example begins\.\n(.*?)^// The example ends\.", TEST.read_text(), re.M | re.S)
if shown is None or run is None or shown.group(1) != run.group(1):
    print(f"{PAGE.relative_to(ROOT)} and {TEST.relative_to(ROOT)} have different examples. Copy the code of the test into the page.")
    sys.exit(1)
