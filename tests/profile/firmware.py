#!/usr/bin/env python3
"""Builds programs as firmware for an emulated Cortex-M4, with the whole library and in their recorded profiles: both draw the same bytes,
and the profile takes less of everything.

usage: firmware.py PROFILE_OF PROGRAM...

Exit status 77 (skipped) where a compiler or the emulator is missing.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT / "boards/tools"), str(ROOT / "tests")]
import firmware  # noqa: E402
from checks import check, failures  # noqa: E402

TOOL = ROOT / "host_sim/profile/firmware/measure.py"
TIER, SKIPPED = "balanced", 77


def words_of(name):
    """What names the program to measure.py."""
    if name in firmware.SCENES:
        return ["--scene", name]
    sources = [path for path in sorted((HERE / "programs").glob("*.cpp")) if path.name == "ball.cpp" or re.search(rf"const Program {name}\{{", path.read_text())]
    return ["--program", f"spangle::programs::{name}", "--header", "tests/profile/programs/program.hpp", "--source", *map(str, sources)]


def measure(tool, name, folder):
    path = folder / f"{name}.cmake"
    done = subprocess.run([tool, name, TIER, str(path)], capture_output=True, text=True)
    check(done.returncode == 0, f"{name} is not recorded: {done.stdout}{done.stderr}")
    if done.returncode != 0:
        return
    done = subprocess.run([sys.executable, str(TOOL), str(path), "--tier", TIER, "--first", "1", "--end", "4", *words_of(name)], capture_output=True, text=True)
    check(done.returncode == 0, f"{name} is not measured: {done.stderr[-3000:]}")
    if done.returncode != 0:
        return
    told = json.loads(done.stdout)
    whole, profiled, lines = told["whole"], told["profiled"], told["lines"]
    print(f"{name}: flash {whole['flash']} to {profiled['flash']}, RAM {whole['ram']} to {profiled['ram']}, "
          f"instructions {whole['instructions']} to {profiled['instructions']}; dearest: {lines[0] if lines else None}", flush=True)
    check(told["same_bytes"], f"{name}: the profile draws {profiled['frames']}, the whole library {whole['frames']}")
    check(profiled["flash"] < whole["flash"] and profiled["ram"] < whole["ram"], f"{name}: the profile takes no less")
    check(profiled["instructions"] < whole["instructions"] * 1.02, f"{name}: the profile is slower")
    check(sum(profiled["flash_of"].values()) == profiled["flash"], f"{name}: the folders do not add up")
    # What lines cost is nearly all of the frame; the rest is the program's own.
    share = sum(line["instructions"] for line in lines) / profiled["instructions"]
    check(0.5 < share < 1.02, f"{name}: its lines cost {share:.2f} of the frame")
    check(all(re.search(r"\.(cpp|hpp):\d+$", line["line"]) and line["command"].startswith("gl") for line in lines), f"{name}: {lines[:5]}")


def main():
    if len(sys.argv) < 3:
        print(__doc__.strip())
        return 2
    missing = firmware.missing(["cortex-m4"])
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs them)")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        for name in sys.argv[2:]:
            measure(sys.argv[1], name, pathlib.Path(folder))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
