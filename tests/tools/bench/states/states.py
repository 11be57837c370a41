#!/usr/bin/env python3
"""Measures random states of fragments: what each costs, beside its neighbours and beside Mesa's llvmpipe.

usage: ./dev bench states [--seed N] [--count N] [--target host|host-base|m4|m3|m0plus] [--rounds N] [--no-time] [--json FILE]
       ./dev bench states --record            also keeps the figures of this target in docs/states.md
       ./dev bench states --update-golden     writes the counts of all targets that ./dev test --all holds this tree against

A seed names a list of states: what is drawn (triangles, small ones, lines, points, sprites) and every word of state that
reaches fragments, from texture formats to logic operations. Each is drawn on two surfaces in three tiers. Keys come in
pairs that differ in one word. docs/states.md says how to read what is printed:

  1. percentiles of the instructions per fragment, and of the times as fast as llvmpipe, for each shape, surface and tier;
  2. the ten dearest states with the functions that take most;
  3. neighbours that are more than 2 times apart; inversions, where less work costs more than 5 % more.

The target host is this machine with all instructions that Spangle chooses at run time; host-base is the same machine with those of
every processor of its kind. Instructions are counted by callgrind on the host and by QEMU's -icount on the boards, and are the same in each run.
Times are taken on the host alone: in each round both programs draw a state right after each other, one thread each, and
the median of the rounds counts. A run of 576 states takes some minutes.
"""
import argparse
import json
import os
import pathlib
import shutil
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
import golden  # noqa: E402
import json_option  # noqa: E402
import measure  # noqa: E402
import report  # noqa: E402
from json_option import outfile  # noqa: E402

PAIR = 12  # number of states of two neighbouring keys
PAGE = measure.mcu.ROOT / "docs/states.md"
MEASURED = HERE / "measured.json"
BEGIN, END = "<!-- table: states -->\n", "\n<!-- end -->"


def page_with(recorded):
    """Returns docs/states.md with these figures."""
    before, _, rest = PAGE.read_text().partition(BEGIN)
    return before + BEGIN + report.markdown(recorded) + END + rest.partition(END)[2]


def record(target, seed, states, table, worst, pairs):
    recorded = json.loads(MEASURED.read_text()) if MEASURED.exists() else {}
    recorded[target] = {"seed": seed, "states": len(states), "rows": table, "pairs": pairs, "worst": worst}
    recorded = {name: recorded[name] for name in measure.TARGETS if name in recorded}
    outfile.write(MEASURED, json.dumps(recorded, indent=1) + "\n")
    outfile.write(PAGE, page_with(recorded))
    print("\nwrote tests/tools/bench/states/measured.json and docs/states.md")


def positive(text):
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"'{text}' is no number above 0")
    return int(text)


def missing(target):
    """Returns the missing programs that this target needs."""
    return measure.mcu.firmware.missing(["cortex-m4"]) if target not in measure.HOSTS else [] if shutil.which("valgrind") else ["valgrind"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--seed", type=positive, default=1, help="which list of states (1)")
    parser.add_argument("--count", type=positive, default=576, help="how many states, rounded up to whole pairs of keys, 12 states each (576)")
    parser.add_argument("--target", choices=list(measure.TARGETS), default="host")
    parser.add_argument("--rounds", type=positive, default=5, help="rounds of timing (5)")
    parser.add_argument("--no-time", action="store_true", help="count instructions only")
    parser.add_argument("--record", action="store_true", help="keep the figures in docs/states.md")
    parser.add_argument("--update-golden", action="store_true", help="write tests/tools/bench/states/golden.json, and stop")
    json_option.add(parser)
    arguments = parser.parse_args()
    json_option.check(parser, arguments.json)
    if arguments.update_golden and (arguments.json or arguments.record):
        parser.error("--update-golden writes its counts, and no others: leave out --json and --record")
    if needs := missing(arguments.target):
        print(f"states.py: {', '.join(needs)} not installed; ./dev setup --all installs what is measured with", file=sys.stderr)
        return 1
    build = (arguments.build / "tests/tools/bench").resolve()
    if arguments.update_golden:
        golden.write({target: golden.measure_slice(target, build / "bench_states") for target in golden.SLICES})
        return 0
    numbers = list(range(-(-arguments.count // PAIR) * PAIR))
    with json_option.tables(arguments.json):
        states = measure.listed(build / "bench_states", arguments.seed, numbers)
        counts = measure.count(arguments.target, build / "bench_states", arguments.seed, numbers, arguments.build / f"states-{arguments.target}")
        timed = arguments.target in measure.HOSTS and not arguments.no_time
        ratios = measure.time(arguments.target, build, arguments.seed, states, arguments.rounds) if timed else {}
        cost = report.cost_of(counts)
        table, worst = report.rows(states, cost, ratios), report.worst_states(states, counts)
        print(f"{arguments.target}, seed {arguments.seed}: {len(states)} states of {len(states) // 6} keys"
              + (f"; {len(states) - len(counts)} cannot be drawn there" if len(counts) < len(states) else ""))
        report.print_rows(table)
        report.print_worst(worst)
        pairs = report.print_pairs(states, cost)
    if arguments.record:
        record(arguments.target, arguments.seed, states, table, worst, pairs)
    json_option.write(arguments.json, {"target": arguments.target, "seed": arguments.seed, "rows": table, "worst": worst, "pairs": pairs,
                                       "states": [s | counts.get(s["number"], {}) | {"times_llvmpipe": ratios.get(s["number"])} for s in states]})
    return 0


if __name__ == "__main__":
    os.environ.setdefault("PYTHONUNBUFFERED", "1")
    sys.exit(outfile.checked(main))
