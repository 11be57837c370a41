#!/usr/bin/env python3
"""Tests profiles on a host: the command line builds with what a profile has, without a warning, and draws in the first tier there is.

usage: host.py FOLDER [CMAKE OPTIONS...]

FOLDER keeps the builds, so that the next run uses them.
"""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/support"))
from checks import check, failures  # noqa: E402

# The first tier of each profile, a scene that the profile draws, and a scene that it does not, with what the profile lacks for it.
PROFILES = {"minimal": ("fast", "S1", "S5", "SPANGLE_FULL_LIGHTING"), "first_slice": ("balanced", "BAKED", "S5", "SPANGLE_FEATURE_LISTS")}


def build(folder, profile, options):
    configured = subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja", "-DSPANGLE_TESTS=OFF", f"-DSPANGLE_PROFILE={profile}", *options], capture_output=True, text=True)
    check(configured.returncode == 0, f"{profile}: {configured.stderr}")
    built = subprocess.run(["cmake", "--build", str(folder), "--target", "spangle", "-j", "2"], capture_output=True, text=True)
    check(built.returncode == 0, f"{profile} does not build: {built.stdout[-2000:]}")
    return folder / "spangle"


def main():
    if len(sys.argv) < 2:
        print(__doc__.strip())
        return 2
    for profile, (tier, drawn, refused, lacks) in PROFILES.items():
        spangle = build(pathlib.Path(sys.argv[1]) / profile, profile, sys.argv[2:])
        if not spangle.exists():
            continue
        for where in ((), ("--size", "320x240")):
            done = subprocess.run([spangle, "run", drawn, *where, "--frames", "2", "--json"], capture_output=True, text=True)
            check(done.returncode == 0 and json.loads(done.stdout)["precision"] == tier, f"{profile} {where}: {done.stdout}{done.stderr}")
        asked = subprocess.run([spangle, "run", drawn, "--precision", "exact"], capture_output=True, text=True)
        check(asked.returncode == 2 and "no such precision" in asked.stderr, f"{profile}: a tier that was asked for is not another: {asked.stderr}")
        missing = subprocess.run([spangle, "run", refused], capture_output=True, text=True)
        check(missing.returncode == 2 and lacks in missing.stderr, f"{profile}: {missing.stderr!r} names {lacks}")
        timed = subprocess.run([spangle, "bench", "--json"], capture_output=True, text=True)
        scenes = json.loads(timed.stdout)["scenes"]
        check(drawn in scenes and refused not in scenes and list(scenes[drawn]) == [tier], f"{profile}: only what it draws is timed: {list(scenes)}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
