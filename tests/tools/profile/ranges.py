#!/usr/bin/env python3
"""Tests that a Debug build takes the ranges of its profile, as does any build that asks for them. A Release is compiled as if there were
none.

usage: ranges.py
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "boards/tools"), str(ROOT / "host_sim/tools"), str(ROOT / "tests/support")]
import outfile  # noqa: E402
import profile  # noqa: E402
from checks import check, failures  # noqa: E402

SETTINGS = "set(SPANGLE_PROFILE_FEATURES FOG)\nset(SPANGLE_RANGES LINE_WIDTH=3 CUTS=0)\n"
TOLD = {"SPANGLE_CHECK_RANGES=1", "SPANGLE_RANGE_LINE_WIDTH=3", "SPANGLE_RANGE_CUTS=0"}


def configure(folder, path, *options):
    """Returns (what CMake says, the definitions about ranges)."""
    done = subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja", f"-DSPANGLE_PROFILE={path}", "-DSPANGLE_HOST=OFF", "-DSPANGLE_TESTS=OFF",
                           "-DSPANGLE_LINUX=OFF", *options], capture_output=True, text=True)
    if done.returncode != 0:
        return done.stderr, None
    return "", set(re.findall(r"-D(SPANGLE_(?:CHECK_RANGES|RANGE_\w+)\S*)", (folder / "build.ninja").read_text()))


def main():
    if len(sys.argv) != 1:
        print(__doc__.strip())
        return 2
    with tempfile.TemporaryDirectory() as name:
        folder, path = pathlib.Path(name), pathlib.Path(name) / "some.cmake"
        outfile.write(path, SETTINGS)
        for options, told in ((("-DCMAKE_BUILD_TYPE=Debug",), TOLD), (("-DCMAKE_BUILD_TYPE=Release",), set()),
                              (("-DCMAKE_BUILD_TYPE=Release", "-DSPANGLE_CHECK_RANGES=ON"), TOLD)):
            problem, got = configure(folder / "build", path, *options)
            check(got == told, f"{options}: {got} {problem}")
        check(TOLD <= set(profile.definitions(str(path), checks=True)), "profile.py with --check-ranges")
        check(not any("RANGE" in word for word in profile.definitions(str(path))), "profile.py without it")
        outfile.write(path, SETTINGS.replace("CUTS", "DEPTHS"))
        problem, got = configure(folder / "other", path, "-DCMAKE_BUILD_TYPE=Debug")
        check(got is None and "DEPTHS=0" in problem, f"an unknown range: {problem}")
        try:
            profile.definitions(str(path))
            check(False, "profile.py takes an unknown range")
        except SystemExit as refusal:
            check("DEPTHS" in str(refusal), f"profile.py: {refusal}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
