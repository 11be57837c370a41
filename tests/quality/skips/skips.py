#!/usr/bin/env python3
"""Fails when ctest skipped a test that tests/quality/skips/skips.txt does not list with its reason.

usage: skips.py CTEST_OUTPUT
"""
import pathlib
import re
import sys

LISTED = pathlib.Path(__file__).with_name("skips.txt")


def main():
    listed = {}
    for line in LISTED.read_text().splitlines():
        if line and not line.startswith("#"):
            name, _, reason = line.partition(" ")
            listed[name] = reason.strip()
    skipped = set(re.findall(r"Test\s+#\d+:\s+(\S+)(?:\s+# GetParam\(\).*?)?\s*\.*\*\*\*Skipped", pathlib.Path(sys.argv[1]).read_text()))
    unlisted = sorted(name for name in skipped if not listed.get(name))
    for name in sorted(skipped):
        print(f"skipped: {name}: {listed.get(name) or 'NOT LISTED in tests/quality/skips/skips.txt'}")
    return 1 if unlisted else 0


if __name__ == "__main__":
    sys.exit(main())
