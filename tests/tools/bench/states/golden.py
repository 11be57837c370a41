#!/usr/bin/env python3
"""Counts the instructions of a fixed slice of random states, and compares them with golden.json.

usage: golden.py host-base RUNNER
       golden.py m4

RUNNER is bench_states of the build that is tested. A state that takes more than 3 % more instructions than before fails, and so does a
state whose number of fragments changed. A state that takes more than 3 % less asks for `./dev bench states --update-golden`. Exit status 77
when valgrind, the compiler or QEMU is missing.
"""
import json
import pathlib
import shutil
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
import measure  # noqa: E402
from json_option import outfile  # noqa: E402

GOLDEN = HERE / "golden.json"
SEED = 1
SLICES = {"host-base": 24, "m4": 24}  # number of keys in the slice of each target
SLACK = 1.03


def slice_numbers(keys):
    """Returns the number of one state for each key, with the variants in turn. Both keys of a pair have the same variant."""
    return [6 * key + key // 2 % 6 for key in range(keys)]


def measure_slice(target, runner):
    """Returns {"number": [instructions, fragments]}."""
    with tempfile.TemporaryDirectory() as folder:
        counts = measure.count(target, runner, SEED, slice_numbers(SLICES[target]), pathlib.Path(folder))
    return {str(number): [of["instructions"], of["fragments"]] for number, of in counts.items()}


def write(tables):
    known = json.loads(GOLDEN.read_text()) if GOLDEN.exists() else {}
    lines = [f" {json.dumps(target)}: {{\n" + ",\n".join(f"  {json.dumps(n)}: {json.dumps(of)}" for n, of in table.items()) + "\n }"
             for target, table in (known | tables).items()]
    outfile.write(GOLDEN, "{\n" + ",\n".join(lines) + "\n}\n")
    print(f"wrote {GOLDEN.relative_to(measure.mcu.ROOT)}")


def compare(now, was):
    """Returns (lines about what is wrong, lines about what is better)."""
    bad, better = [], []
    for number in sorted(now.keys() | was.keys(), key=int):
        if number not in was or number not in now:
            bad.append(f"state {number} is {'not in golden.json' if number not in was else 'no longer drawn'}")
        elif now[number][1] != was[number][1]:
            bad.append(f"state {number} covers {now[number][1]} fragments, and had {was[number][1]}")
        elif now[number][0] > was[number][0] * SLACK:
            bad.append(f"state {number} takes {now[number][0]:,} instructions, and took {was[number][0]:,}: {now[number][0] / was[number][0] - 1:+.1%}")
        elif now[number][0] * SLACK < was[number][0]:
            better.append(f"state {number} takes {now[number][0]:,} instructions, and took {was[number][0]:,}: {now[number][0] / was[number][0] - 1:+.1%}")
    return bad, better


def main():
    target = sys.argv[1]
    needs = [] if target not in measure.HOSTS or shutil.which("valgrind") else ["valgrind"]
    needs += measure.mcu.firmware.missing(["cortex-m4"]) if target not in measure.HOSTS else []
    if needs:
        print(f"skipped: {', '.join(needs)} not installed (./dev setup --all installs them)")
        return 77
    now = measure_slice(target, pathlib.Path(sys.argv[2]) if target in measure.HOSTS else None)
    bad, better = compare(now, json.loads(GOLDEN.read_text()).get(target, {}))
    print("\n".join(bad + better))
    print(f"{target}: {len(now)} states, {len(bad)} worse than golden.json or other, {len(better)} better by more than 3 %")
    if bad or better:
        print("what is worth it is kept by ./dev bench states --update-golden; say why")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
