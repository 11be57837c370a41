#!/usr/bin/env python3
"""Measures every scene against Mesa's llvmpipe and the goals.

usage: ./dev bench [--quick] [--scenes S2,S5] [--no-mcu] [--no-callgrind]

Wall time as a ratio in one run: the two programs take turns, medians count. x86 instructions by callgrind, Cortex-M
instructions by QEMU's -icount: both repeatable. Goals: tests/bench/goals.json.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import mcu  # noqa: E402

HERE = pathlib.Path(__file__).parent
TIERS = ("exact", "balanced", "fast")


def google(program, pattern, seconds):
    with tempfile.NamedTemporaryFile() as out:
        subprocess.run([str(program), f"--benchmark_filter={pattern}", f"--benchmark_min_time={seconds}", f"--benchmark_out={out.name}",
                        "--benchmark_out_format=json"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       env={"LP_NUM_THREADS": "0", "PATH": "/usr/bin:/bin"})
        report = json.load(open(out.name))
    for entry in report["benchmarks"]:
        if entry.get("error_occurred"):
            raise SystemExit(f"{entry['name']}: {entry['error_message']}")
    return {entry["name"]: (entry["cpu_time"], int(entry.get("hash", 0))) for entry in report["benchmarks"]}


def wall(build, scenes, rounds, seconds):
    """{name: (median microseconds, {hashes})}; both programs in turns."""
    pattern = "^(" + "|".join(scenes) + ")/"
    times, hashes = {}, {}
    for _ in range(rounds):
        for program, prefix in ((build / "bench_mesa", "mesa/"), (build / "bench_spangle", "")):
            for name, (time, picture) in google(program, pattern, seconds).items():
                times.setdefault(prefix + name, []).append(time)
                hashes.setdefault(prefix + name, set()).add(picture)
    return {name: (statistics.median(values), hashes[name]) for name, values in times.items()}


def callgrind(build, scene, tier):
    """Instructions of one frame: the difference of a long and a short run."""
    def total(frames):
        with tempfile.TemporaryDirectory() as folder:
            out = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", str(build / "frames"), scene, "320", "240",
                                  tier, str(frames)], capture_output=True, text=True, check=True).stderr
        return int(next(line for line in out.splitlines() if "Collected" in line).split()[-1])
    return (total(6) - total(2)) // 4


def wall_table(results, scenes, goals):
    print(f"\n{'scene':<6}{'size':<9}{'llvmpipe us':>12}" + "".join(f"{t:>10} x  goal" for t in TIERS) + "   dither costs")
    for scene in scenes:
        for size in ("320x240", "800x480"):
            mesa = results[f"mesa/{scene}/{size}"][0]
            row = f"{scene:<6}{size:<9}{mesa:>12.1f}"
            for tier in TIERS:
                ours = results[f"{scene}/{size}/{tier}"][0]
                goal = goals.get(scene, {}).get(tier, {}).get("x86") if size == "320x240" else None
                row += f"{mesa / ours:>10.2f} {'-' if goal is None else goal:>6}"
            plain, dithered = results[f"{scene}/{size}/balanced"][0], results[f"{scene}/{size}/balanced/dither"][0]
            print(row + f"{dithered / plain:>14.2f}x")
    changing = [name for name, (_, pictures) in results.items() if len(pictures) > 1]
    if changing:
        raise SystemExit(f"pictures differ between runs: {', '.join(changing)}")


def instruction_table(build, scenes, goals, boards, with_callgrind):
    counts = {board: mcu.measure(board, scenes, ("exact", "balanced")) for board in boards}
    print(f"\n{'scene':<6}{'tier':<10}" + ("x86 instr" if with_callgrind else "").rjust(12) + "".join(f"{b + ' instr':>14}{'of goal':>9}" for b in boards) + f"{'text':>10}  picture")
    for scene in scenes:
        for tier in ("exact", "balanced"):
            row = f"{scene:<6}{tier:<10}" + (f"{callgrind(build, scene, tier):>12,}" if with_callgrind else " " * 12)
            for board in boards:
                n, picture, text = counts[board][scene, tier]
                goal = goals.get(scene, {}).get(tier, {}).get("m4")
                limit = None if goal is None else goal * 1e6 * (1.15 if board == "m3" else 1.0)
                row += f"{n:>14,}" + (f"{n / limit:>8.2f}x" if limit else f"{'-':>9}")
            print(row + (f"{text:>10,}  {picture}" if boards else ""), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--scenes", default="S1,S2,S3,S4,S4b,S4r,S5,S6,S7,S8,S9,HUD")
    parser.add_argument("--quick", action="store_true", help="one short round")
    parser.add_argument("--no-wall", action="store_true")
    parser.add_argument("--no-mcu", action="store_true")
    parser.add_argument("--no-callgrind", action="store_true")
    arguments = parser.parse_args()
    goals = json.loads((HERE / "goals.json").read_text())
    scenes = arguments.scenes.split(",")
    build = arguments.build / "tests/bench"
    print("Ratios to llvmpipe (LP_NUM_THREADS=0), RGB565, 16-bit depth, dithering off unless said; -O2, baseline instruction set.")
    if not arguments.no_wall:
        wall_table(wall(build, scenes, 1 if arguments.quick else 5, 0.05 if arguments.quick else 0.2), scenes, goals)
    boards = [] if arguments.no_mcu or not mcu.available() else ["m4", "m3"]
    if boards or not arguments.no_callgrind:
        instruction_table(build, scenes, goals, boards, not arguments.no_callgrind)
    return 0


if __name__ == "__main__":
    sys.exit(main())
