#!/usr/bin/env python3
"""Measures every scene, and compares it with Mesa's llvmpipe and the goals.

usage: ./dev bench [--quick] [--scenes S2,S5] [--no-wall] [--no-mcu] [--no-callgrind] [--no-chain] [--json FILE]
       ./dev bench --record            also keeps speed and memory in tests/tools/bench/measured.json, docs/speed.md and docs/memory.md
       ./dev bench --update-golden     writes tests/tools/bench/golden.json, which ./dev test --all compares the counts with

Wall time is a ratio within one run: the two programs take turns scene by scene, eleven times (--quick: five). The median of the ratios
counts, and the quartiles stand beside it. --json keeps all figures, and - is standard output. callgrind counts x86 instructions, and QEMU's
-icount counts Cortex-M instructions; both counts are repeatable. The goals are in tests/tools/bench/goals.json. Every timed picture is
compared with that of a program of its own, and with the emulated board's; a difference is a failure.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import goals  # noqa: E402
import icount  # noqa: E402
import json_option  # noqa: E402
import mcu  # noqa: E402
from spread import RUNS, scatter, spread, text  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "readme"))
import tables  # noqa: E402
from tables import outfile  # noqa: E402

HERE = pathlib.Path(__file__).parent
TIERS = ("exact", "balanced", "fast")
SIZES = ("320x240", "800x480")


def google(program, pattern, seconds):
    with tempfile.NamedTemporaryFile() as out:
        subprocess.run([str(program), f"--benchmark_filter={pattern}", f"--benchmark_min_time={seconds}", f"--benchmark_out={out.name}",
                        "--benchmark_out_format=json"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       env={"LP_NUM_THREADS": "0", "PATH": "/usr/bin:/bin"})
        report = json.load(open(out.name))
    for entry in report["benchmarks"]:
        if entry.get("error_occurred"):
            raise SystemExit(f"{entry['name']}: {entry['error_message']}")
    return {entry["name"]: entry for entry in report["benchmarks"]}


class Walls:
    """Microseconds of a frame. Both programs draw one scene right after each other, many times. Other work of the machine changes from
    second to second, so a ratio of neighbours in time is nearly free of it.
    """

    def __init__(self, build, scenes, rounds, seconds):
        self.times, self.hashes = {}, {}
        for _ in range(rounds):
            for scene in scenes:
                for size in SIZES:
                    self.take(build / "bench_mesa", f"{scene}/{size}", seconds, "mesa/")
                    self.take(build / "bench_spangle", f"{scene}/{size}", seconds)

    def take(self, program, name, seconds, prefix=""):
        for found, entry in google(program, f"^{name}(/|$)", seconds).items():
            self.times.setdefault(prefix + found, []).append(entry["cpu_time"])
            if not prefix:
                self.hashes.setdefault(found, set()).add(f"{int(entry['hash']):08x}")

    def microseconds(self, name):
        return spread(self.times[name])

    def ratios(self, name, other):
        """Returns in every round how many times as long this program took as the other."""
        return spread([a / b for a, b in zip(self.times[name], self.times[other])])

    def speed(self, scene, size, tier):
        """Returns how many times as fast as llvmpipe this program is."""
        return self.ratios(f"mesa/{scene}/{size}", f"{scene}/{size}/{tier}")

    def dithering(self, scene, size):
        """Returns how many times as long a dithered frame takes."""
        return self.ratios(f"{scene}/{size}/balanced/dither", f"{scene}/{size}/balanced")

    def figures(self, scene, size):
        """Returns the figures of one scene for --json, each with its spread over the rounds."""
        return {"llvmpipe_us": self.microseconds(f"mesa/{scene}/{size}"), "dithered": self.dithering(scene, size),
                **{tier: {"us": self.microseconds(f"{scene}/{size}/{tier}"), "times_llvmpipe": self.speed(scene, size, tier)} for tier in TIERS}}


def frames_program(build, scene, size, tier, dither, frames):
    return [str(build / "frames"), scene, *size.split("x"), tier, "dither" if dither else "plain", str(frames)]


def callgrind(build, scene, tier):
    """Returns the instructions of one frame: the difference of a long and a short run."""
    def total(frames):
        with tempfile.TemporaryDirectory() as folder:
            out = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out",
                                  *frames_program(build, scene, SIZES[0], tier, False, frames)], capture_output=True, text=True, check=True).stderr
        return int(next(line for line in out.splitlines() if "Collected" in line).split()[-1])
    return (total(7) - total(3)) // 4


def check_pictures(build, hashes):
    """Checks that every timed picture is the one that a program draws which times nothing."""
    bad = []
    for name, found in hashes.items():
        scene, size, tier, *dither = name.split("/")
        alone = subprocess.run(frames_program(build, scene, size, tier, bool(dither), 3), capture_output=True, text=True, check=True).stdout.strip()
        if found != {alone}:
            bad.append(f"{name}: timed {', '.join(sorted(found))}, alone {alone}")
    print(f"\npictures of the timed frames: {len(hashes) - len(bad)} of {len(hashes)} are those of a program that times nothing")
    if bad:
        raise SystemExit("\n".join(bad))


def memory_table(build, scenes):
    """Measures each scene's memory in a process that draws only this scene, under the same harness. Prints the figures and returns them."""
    found = {}
    print("\nMemory, balanced tier, bytes of spangle::memory: context; surface (colour and 16-bit depth); most in all, textures and lists included."
          "\nProcesses: largest resident size of the benchmark program, ours and llvmpipe's.")
    print(f"{'scene':<6}{'size':<9}" + "".join(f"{kind:>12}" for kind in ("context", "surface", "peak", "process MB", "llvmpipe MB")))
    for scene in scenes:
        for size in SIZES:
            ours = google(build / "bench_spangle", f"^{scene}/{size}/balanced$", 0.01)[f"{scene}/{size}/balanced"]
            mesa = google(build / "bench_mesa", f"^{scene}/{size}$", 0.01)[f"{scene}/{size}"]
            print(f"{scene:<6}{size:<9}" + "".join(f"{int(ours[kind]):>12,}" for kind in ("context", "surface", "peak"))
                  + f"{ours['process'] / 1e6:>12.1f}{mesa['process'] / 1e6:>12.1f}", flush=True)
            found[scene, size] = {kind: int(ours[kind]) for kind in ("context", "surface", "peak", "process")} | {"llvmpipe_process": int(mesa["process"])}
    return found


def record(build, walls, memory, scenes):
    """Returns what docs/speed.md and docs/memory.md show, and on which machine it was measured."""
    model = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    found = {scene: {size: {"llvmpipe_us": round(walls.microseconds(f"mesa/{scene}/{size}")["median"], 1),
                      "scatter": round(scatter(walls.speed(scene, size, "balanced")), 3), "dither": round(walls.dithering(scene, size)["median"], 2)}
                     | {tier: round(walls.speed(scene, size, tier)["median"], 2) for tier in TIERS} | memory[scene, size]
                     for size in SIZES} for scene in scenes}
    kept = {"host": f"On {model.group(1) if model else 'this machine'}, {compiler_of(build)}:", "scenes": found}
    outfile.write(HERE / "measured.json", json.dumps(kept, indent=1) + "\n")
    tables.write(tables.recorded())
    print("\nwrote tests/tools/bench/measured.json and the tables of docs/speed.md and docs/memory.md")


def wall_table(walls, scenes):
    print("\nTimes as fast as llvmpipe, dithering off, beside the goal, and what dithering costs in the balanced tier: the median of the rounds and its quartiles.")
    print(f"{'scene':<6}{'size':<9}{'llvmpipe us':>26}" + "".join(f"{t:>24} x  goal" for t in TIERS) + f"{'dithered':>24} x")
    for scene in scenes:
        for size in SIZES:
            row = f"{scene:<6}{size:<9}{text(walls.microseconds(f'mesa/{scene}/{size}'), 1):>26}"
            for tier in TIERS:
                goal = goals.speed(scene, tier) if size == SIZES[0] else None
                row += f"{text(walls.speed(scene, size, tier)):>24} {'-' if goal is None else goal:>7}"
            print(row + f"{text(walls.dithering(scene, size)):>24}")


def verdict(walls, scenes):
    """Returns how fast the balanced tier is as a whole, against its goal."""
    shares = {}
    slower = []
    for scene in scenes:
        ratio = walls.speed(scene, SIZES[0], "balanced")["median"]
        goal = goals.speed(scene, "balanced")
        if goal is not None:
            shares[scene] = ratio / goal
        if ratio < 1.0:
            slower.append(scene)
    at_goal = [scene for scene in shares if shares[scene] >= 1.0]
    below = [scene for scene in shares if shares[scene] < 0.6]
    print(f"\nbalanced, {SIZES[0]}: {len(at_goal)} of {len(shares)} scenes at their goal ({', '.join(at_goal) or 'none'}); "
          f"below 60 % of it: {', '.join(below) or 'none'}; slower than llvmpipe: {', '.join(slower) or 'none'}")


def instruction_table(build, scenes, boards, with_callgrind, hashes):
    counts = {board: mcu.measure(board, scenes, TIERS, (False, True)) for board in boards}
    print("\nInstructions of a frame, 320x240, dithering off, and what it takes more for each stored fragment; text, memory and stack of the"
          " Cortex-M4 image. Goals: tests/tools/bench/goals.json.")
    print(f"{'scene':<6}{'tier':<10}" + ("x86" if with_callgrind else "").rjust(12) + "".join(f"{board:>13}{'of goal':>9}{'dither':>8}" for board in boards)
          + ("".join(f"{kind:>10}" for kind in ("text", "context", "surface", "peak", "static", "stack")) + "  picture" if boards else ""))
    bad, found = [], {}
    for scene in scenes:
        for tier in TIERS:
            figures = found.setdefault(scene, {}).setdefault(tier, {})
            if with_callgrind:
                figures["x86"] = callgrind(build, scene, tier)
            row = f"{scene:<6}{tier:<10}" + (f"{figures['x86']:>12,}" if with_callgrind else " " * 12)
            for board in boards:
                limit = goals.instructions(board, scene, tier)
                n, dithered = counts[board][scene, tier, False].instructions, counts[board][scene, tier, True]
                figures[board] = {"instructions": n, "dithered": dithered.instructions, "fragments": dithered.fragments}
                more = goals.dithering(figures[board])
                row += f"{n:>13,}" + (f"{n / limit:>8.2f}x" if limit else f"{'-':>9}") + f"{more:>+8.1f}"
            if boards:
                result = counts[boards[0]][scene, tier, False]
                row += "".join(f"{getattr(result, kind):>10,}" for kind in ("text", "context", "surface", "peak", "static", "stack")) + f"  {result.picture}"
                pictures = {counts[board][scene, tier, False].picture for board in boards} | hashes.get(f"{scene}/{SIZES[0]}/{tier}", set())
                if len(pictures) > 1:
                    bad.append(f"{scene} {tier}: the builds draw different pictures: {', '.join(sorted(pictures))}")
            print(row, flush=True)
    if bad:
        raise SystemExit("\n".join(bad))
    return found


def chain_table(build):
    """Prints what every fused span saves: instructions of its fragments, without set-up, beside one lane of it and the chain."""
    with tempfile.TemporaryDirectory() as folder:
        names = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", "--dump-before=mark", str(build / "bench_chain")],
                               capture_output=True, text=True, check=True).stdout.splitlines()
        dumps = [int(re.search(r"^(?:summary|totals): (\d+)", pathlib.Path(f"{folder}/out.{i + 1}").read_text(), re.M).group(1))
                 for i in range(8 * len(names))]
    print("\nx86 instructions of the fragments of the same triangles: fused, one lane of it, and in the chain, which takes at most three times as many.")
    print(f"{'state':<62}{'fused':>12}{'one lane':>12}{'chain':>12}{'chain/fused':>13}")
    ratios, found = {}, {}
    for i, name in enumerate(names):
        setup, *rest = dumps[8 * i + 1:8 * i + 8:2]
        fused, narrow, chain = (n - setup for n in rest)
        ratios[name] = chain / fused
        found[name] = {"fused": fused, "one_lane": narrow, "chain": chain}
        print(f"{name:<62}{fused:>12,}{narrow:>12,}{chain:>12,}{ratios[name]:>12.2f}x")
    slow = [name for name, ratio in ratios.items() if ratio > 3]
    print(f"within three times: {len(ratios) - len(slow)} of {len(ratios)}; most: {max(ratios.values()):.1f}x")
    return found


def compiler_of(build):
    cache = dict(line.split("=", 1) for line in (build / "CMakeCache.txt").read_text().splitlines() if "=" in line and not line.startswith(("#", "//")))
    compiler = cache.get("CMAKE_CXX_COMPILER:STRING") or cache.get("CMAKE_CXX_COMPILER:FILEPATH") or "c++"
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
    kind = cache.get("CMAKE_BUILD_TYPE:STRING", "")
    flags = " ".join(filter(None, (cache.get("CMAKE_CXX_FLAGS:STRING"), cache.get(f"CMAKE_CXX_FLAGS_{kind.upper()}:STRING"))))
    return f"{version}, {flags}"


def print_flags(build):
    print(f"host: {compiler_of(build)}, baseline instruction set; RGB565 in the panel's byte order, 16-bit depth")
    print("peer: Mesa's llvmpipe through OSMesa, RGB565, 16-bit depth, GL_DITHER off, LP_NUM_THREADS=0")
    if mcu.available():
        arm = subprocess.run(["arm-none-eabi-g++", "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
        print(f"boards: {arm}, -Os, {', '.join(mcu.HOT)} -O2; QEMU -icount shift=0, three frames, no FPU instructions")


def measure(arguments, scenes):
    """Prints the tables and returns their figures."""
    build, hashes, figures = arguments.build / "tests/tools/bench", {}, {"host": compiler_of(arguments.build)}
    print_flags(arguments.build)
    if not arguments.no_wall:
        walls = Walls(build, scenes, RUNS if arguments.quick else 11, 0.01 if arguments.quick else 0.1)
        hashes = walls.hashes
        wall_table(walls, scenes)
        verdict(walls, scenes)
        check_pictures(build, hashes)
        memory = memory_table(build, scenes)
        figures["scenes"] = {scene: {size: walls.figures(scene, size) | {"memory": memory[scene, size]} for size in SIZES} for scene in scenes}
        if arguments.record:
            record(arguments.build, walls, memory, scenes)
    boards = [] if arguments.no_mcu or not mcu.available() else list(mcu.BOARDS)
    if boards or not arguments.no_callgrind:
        figures["instructions"] = instruction_table(build, scenes, boards, not arguments.no_callgrind, hashes)
    if not (arguments.no_chain or arguments.no_callgrind):
        figures["fused_spans"] = chain_table(build)
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--scenes", default=",".join(mcu.SCENES))
    parser.add_argument("--quick", action="store_true", help="five short rounds")
    parser.add_argument("--no-wall", action="store_true")
    parser.add_argument("--no-mcu", action="store_true")
    parser.add_argument("--no-callgrind", action="store_true")
    parser.add_argument("--no-chain", action="store_true", help="without the table of fused spans and their chains")
    parser.add_argument("--record", action="store_true", help="keep speed and memory for the documents")
    parser.add_argument("--update-golden", action="store_true", help="measure the counts that ./dev test --all guards, write them, and stop")
    json_option.add(parser)
    arguments = parser.parse_args()
    if arguments.record and (arguments.quick or arguments.no_wall or arguments.scenes != ",".join(mcu.SCENES)):
        parser.error("--record keeps whole measurements: without --quick, --no-wall and --scenes")
    if arguments.update_golden and arguments.json is not None:
        parser.error("--update-golden writes its counts to tests/tools/bench/golden.json, and no others: without --json")
    if arguments.update_golden:
        icount.write(icount.measure()[0])
        return 0
    scenes = arguments.scenes.split(",")
    unknown = [scene for scene in scenes if scene not in mcu.SCENES]
    if unknown:
        parser.error(f"no scene {', '.join(unknown)}; there are {', '.join(mcu.SCENES)}")
    json_option.check(parser, arguments.json)
    with json_option.tables(arguments.json):
        figures = measure(arguments, scenes)
    json_option.write(arguments.json, figures)
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
