#!/usr/bin/env python3
"""Checks that every profile and every list of spans in cmake/profiles is used, and that CMake has no presets beside ./dev.

usage: named.py

A profile is measured by profiles.py and described in docs/profiles.md. A list of spans is that of a profile or of a test.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROFILES = ROOT / "cmake/profiles"


def dead():
    """Yields what nothing uses."""
    measured = (ROOT / "tests/tools/profiles/profiles.py").read_text()
    described = (ROOT / "docs/profiles.md").read_text()
    for path in sorted(PROFILES.glob("*.cmake")):
        if f'"{path.stem}": Subject(' not in measured:
            yield f"{path.relative_to(ROOT)}: tests/tools/profiles/profiles.py does not measure it"
        if not re.search(rf"^\| {path.stem} \|", described, re.M):
            yield f"{path.relative_to(ROOT)}: docs/profiles.md does not describe it"
    users = "".join(path.read_text() for path in [*PROFILES.glob("*.cmake"), *(ROOT / "tests").rglob("*.py")])
    for path in sorted((PROFILES / "spans").iterdir()):
        if not re.search(rf"SPANGLE_FUSED {path.stem}\)|spans/{re.escape(path.name)}", users):
            yield f"{path.relative_to(ROOT)}: no profile and no test has this list"
    if (ROOT / "CMakePresets.json").exists():
        yield "CMakePresets.json: ./dev configures all builds, and a second list of their options becomes another build"


def main():
    found = list(dead())
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
