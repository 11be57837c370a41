#!/usr/bin/env python3
"""Counts the instructions and the text of S2, S4r, S5, S6 and S8 on Cortex-M and holds them against what they were.

usage: icount.py [--update]

More than 3 % above tests/bench/golden.json fails; more than 3 % below asks for --update, which writes the file anew.
Prints the goals of tests/bench/goals.json beside the counts. Exit status 77 (skipped) when the compiler or QEMU is missing.
"""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import mcu  # noqa: E402

GOLDEN = HERE / "golden.json"
SCENES = ("S2", "S4r", "S5", "S6", "S8")
TIERS = ("exact", "balanced")
BOARDS = ("m4", "m3")
SLACK = 1.03


def measure():
    """{"m4 S2 exact": {"instructions": n, "text": n}}, and the pictures of each scene and tier."""
    counts, pictures = {}, {}
    for board in BOARDS:
        for (scene, tier), result in mcu.measure(board, SCENES, TIERS).items():
            counts[f"{board} {scene} {tier}"] = {"instructions": result.instructions, "text": result.text}
            pictures.setdefault((scene, tier), set()).add(result.picture)
    return counts, pictures


def write(counts):
    lines = [f"  {json.dumps(name)}: {json.dumps(counts[name])}" for name in counts]
    GOLDEN.write_text("{\n" + ",\n".join(lines) + "\n}\n")
    print(f"wrote {GOLDEN.relative_to(mcu.ROOT)}")


def goal_of(goals, name):
    board, scene, tier = name.split()
    goal = goals[scene][tier].get("m4")
    return None if goal is None else goal * 1e6 * (1.15 if board == "m3" else 1.0)


def compare(counts, golden, goals):
    """True when nothing grew."""
    good, better = True, False
    print(f"{'board scene tier':<20}{'instructions':>14}{'was':>14}{'goal':>14}{'of goal':>9}{'text':>10}{'was':>10}")
    for name, now in counts.items():
        was, goal, verdict = golden.get(name), goal_of(goals, name), ""
        if was is None:
            good, was, verdict = False, {"instructions": 0, "text": 0}, "  NOT IN golden.json"
        else:
            grown = [kind for kind in now if now[kind] > was[kind] * SLACK]
            good = good and not grown
            better = better or any(now[kind] * SLACK < was[kind] for kind in now)
            verdict = f"  MORE {' AND '.join(grown).upper()}" if grown else ""
        print(f"{name:<20}{now['instructions']:>14,}{was['instructions']:>14,}{goal:>14,.0f}{now['instructions'] / goal:>8.2f}x"
              f"{now['text']:>10,}{was['text']:>10,}{verdict}")
    if not good:
        print("worse than tests/bench/golden.json by more than 3 %: repair it, or, when it is worth it, ./dev bench --update-golden and say why")
    elif better:
        print("better than tests/bench/golden.json by more than 3 %: ./dev bench --update-golden keeps it so")
    return good


def main():
    if not mcu.available():
        print("skipped: arm-none-eabi-g++ or qemu-system-arm is not installed (./dev setup --all installs them)")
        return 77
    counts, pictures = measure()
    if "--update" in sys.argv[1:]:
        write(counts)
    golden = json.loads(GOLDEN.read_text()) if GOLDEN.exists() else {}
    good = compare(counts, golden, json.loads((HERE / "goals.json").read_text()))
    for (scene, tier), found in pictures.items():
        if len(found) > 1:
            print(f"{scene} {tier}: the boards draw different pictures: {', '.join(sorted(found))}")
            good = False
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
