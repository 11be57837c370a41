#!/usr/bin/env python3
"""Counts the instructions and the text of S1 to S9 in every tier on Cortex-M, plain and dithered, and compares them with the recorded
counts.

usage: icount.py [--update]

More than 3 % above tests/tools/bench/golden.json fails. More than 3 % below asks for --update, which writes the file and its tables anew.
Prints the goals of tests/tools/bench/goals.json beside the counts, and what dithering takes more for each fragment. A count above its goal
is reported, and does not fail. Exit status 77 (skipped) when the compiler or QEMU is missing.
"""
import itertools
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import goals  # noqa: E402
import mcu  # noqa: E402

sys.path.insert(0, str(HERE.parent / "readme"))
import tables  # noqa: E402
from tables import outfile  # noqa: E402

GOLDEN = HERE / "golden.json"
TIERS = ("exact", "balanced", "fast")
SLACK = 1.03


def measure():
    """Returns {"m4 S2 exact": {"instructions": n, "text": n, "dithered": n, "fragments": n}}, and the pictures of each scene and tier."""
    counts, pictures = {}, {}
    for board in mcu.BOARDS:
        results = mcu.measure(board, goals.SCENES, TIERS, (False, True))
        for scene, tier, dithers in results:
            pictures.setdefault((scene, tier, "dithered" if dithers else "plain"), set()).add(results[scene, tier, dithers].picture)
        for scene, tier in itertools.product(goals.SCENES, TIERS):
            plain, dithered = results[scene, tier, False], results[scene, tier, True]
            counts[f"{board} {scene} {tier}"] = {"instructions": plain.instructions, "text": plain.text, "dithered": dithered.instructions,
                                                 "fragments": dithered.fragments}
    return counts, pictures


def write(counts):
    lines = [f"  {json.dumps(name)}: {json.dumps(counts[name])}" for name in counts]
    outfile.write(GOLDEN, "{\n" + ",\n".join(lines) + "\n}\n")
    tables.write({"instructions": tables.instructions(), "goals": tables.goals_met(), "dithering": tables.dithering()})
    print(f"wrote {GOLDEN.relative_to(mcu.ROOT)} and its tables")


def compare(counts, golden):
    """Returns whether nothing grew."""
    good, better = True, False
    print(f"{'board scene tier':<20}{'instructions':>14}{'was':>14}{'goal':>14}{'of goal':>9}{'text':>10}{'was':>10}{'dithered':>14}{'was':>14}{'+/fragment':>12}{'goal':>6}")
    for name, now in counts.items():
        was, goal, verdict = golden.get(name), goals.instructions(*name.split()), ""
        if was is None or was.keys() != now.keys():
            good, was, verdict = False, dict.fromkeys(now, 0), "  NOT IN golden.json"
        else:
            grown = [kind for kind in now if now[kind] > was[kind] * SLACK]
            good = good and not grown
            better = better or any(now[kind] * SLACK < was[kind] for kind in now)
            verdict = f"  MORE {' AND '.join(grown).upper()}" if grown else ""
        print(f"{name:<20}{now['instructions']:>14,}{was['instructions']:>14,}"
              + (f"{goal:>14,.0f}{now['instructions'] / goal:>8.2f}x" if goal else f"{'-':>14}{'-':>9}") +
              f"{now['text']:>10,}{was['text']:>10,}{now['dithered']:>14,}{was['dithered']:>14,}{goals.dithering(now):>12.1f}"
              f"{goals.ALL['dither'][name.split()[0]]:>6}{verdict}")
    if not good:
        print("worse than tests/tools/bench/golden.json by more than 3 %: repair it, or, when it is worth it, ./dev bench --update-golden and say why")
    elif better:
        print("better than tests/tools/bench/golden.json by more than 3 %: ./dev bench --update-golden keeps it so")
    return good


def main():
    if not mcu.available():
        print("skipped: arm-none-eabi-g++ or qemu-system-arm is not installed (./dev setup --all installs them)")
        return 77
    counts, pictures = measure()
    if "--update" in sys.argv[1:]:
        write(counts)
    golden = json.loads(GOLDEN.read_text()) if GOLDEN.exists() else {}
    good = compare(counts, golden)
    for (scene, tier, how), found in pictures.items():
        if len(found) > 1:
            print(f"{scene} {tier} {how}: the boards draw different pictures: {', '.join(sorted(found))}")
            good = False
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
