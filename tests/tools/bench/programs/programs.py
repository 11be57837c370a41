#!/usr/bin/env python3
"""Measures programs that draw with GL 1.x: what their frames take on Spangle, beside Mesa's llvmpipe.

usage: ./dev bench programs [--only NAME]... [--again] [--rounds N] [--record] [--json FILE]

Games, SDL2's testsprite2, Dear ImGui's demo, screen savers and two programs of clients.c are recorded by apitrace over Mesa, once: the
traces stay in build/programs, and --again records them anew. eglretrace then replays each trace over Spangle's drop-in pair (balanced and
exact) and over llvmpipe, one right after the other in each round, on pbuffers with eight bits a component, 24 of depth and 8 of stencil.
Counted is the processor time of the last frame, drawn 60 times, with one thread each; start-up and compilation are left out, and what the
replayer itself takes is taken off both sides. docs/programs-speed.md says more; --record keeps the figures there.
"""
import argparse
import json
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
import json_option  # noqa: E402
import recorded  # noqa: E402
import replayed  # noqa: E402
import speeds  # noqa: E402
from json_option import outfile  # noqa: E402
from recorded import gallery  # noqa: E402
from spread import RUNS  # noqa: E402

ROOT = HERE.parents[3]
TRACES = ROOT / "build/programs"
PAGE, MEASURED = ROOT / "docs/programs-speed.md", HERE / "measured.json"
BEGIN, END = "<!-- table: programs -->\n", "\n<!-- end -->"


def page_with(rows):
    """Returns docs/programs-speed.md with these figures."""
    before, _, rest = PAGE.read_text().partition(BEGIN)
    return before + BEGIN + speeds.markdown(rows) + END + rest.partition(END)[2]


def record_page(rows):
    """Keeps these rows, and the rows of programs that were not measured now."""
    kept = {of["program"]: of for of in json.loads(MEASURED.read_text())} if MEASURED.exists() else {}
    rows = list((kept | {of["program"]: of for of in rows}).values())
    outfile.write(MEASURED, json.dumps(rows, indent=1) + "\n")
    outfile.write(PAGE, page_with(rows))
    print("\nwrote tests/tools/bench/programs/measured.json and docs/programs-speed.md")


def record(programs, again):
    """Records the programs that have no trace yet. Returns the programs that have a trace then."""
    missing = [program for program in programs if again or not trace_of(program).exists()]
    if missing:
        with recorded.harness.xvfb() as display:
            for program in missing:
                wrong = recorded.record(program, display, trace_of(program))
                print(f"{program.name}: " + (wrong or f"{recorded.frames_of(trace_of(program))} frames recorded"), flush=True)
    return [program for program in programs if trace_of(program).exists()]


def trace_of(program):
    return TRACES / f"{program.name}.trace"


def measure(programs, pair, library, rounds):
    rows = []
    for program in programs:
        try:
            measured = replayed.rounds(trace_of(program), pair, library, rounds)
            rows.append(speeds.row(program.name, program.kind, recorded.frames_of(trace_of(program)), measured))
            print("  ".join(speeds.cells(rows[-1])), flush=True)
        except (RuntimeError, ValueError) as wrong:
            print(f"{program.name} is not measured: {wrong}", flush=True)
    return rows


def enough(text):
    if not text.isdigit() or int(text) < RUNS:
        raise argparse.ArgumentTypeError(f"'{text}' is no number from {RUNS} on")
    return int(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--only", metavar="NAME", action="append", help="this program alone; may be given again")
    parser.add_argument("--again", action="store_true", help="record the programs anew")
    parser.add_argument("--rounds", type=enough, default=RUNS, help=f"rounds of replays ({RUNS})")
    parser.add_argument("--record", action="store_true", help="keep the figures in docs/programs-speed.md")
    json_option.add(parser)
    arguments = parser.parse_args()
    json_option.check(parser, arguments.json)
    recorded.harness.need("Xvfb", "apitrace", "eglretrace", "xdotool")
    pair = (arguments.build / "dropin").resolve()
    if not (pair / "libEGL.so.1").exists():
        sys.exit(f"there is no drop-in pair in {arguments.build}")
    TRACES.mkdir(parents=True, exist_ok=True)
    gallery.build("same_run.c", "-shared", "-fPIC")
    programs = recorded.every(gallery.build(HERE / "clients.c", "-lEGL", "-lOpenGL", "-lm"), gallery.build_imgui())
    unknown = set(arguments.only or []) - {program.name for program in programs}
    if unknown:
        parser.error(f"--only: {', '.join(sorted(unknown))} not installed; there are {', '.join(p.name for p in programs)}")
    if arguments.only:
        programs = [program for program in programs if program.name in arguments.only]
    with json_option.tables(arguments.json):
        rows = measure(record(programs, arguments.again), pair, gallery.build(HERE / "frame_times.c", "-shared", "-fPIC"), arguments.rounds)
        print("\nProcessor time of a frame; times as fast as llvmpipe, median of the rounds and quartiles; a star where a goal is missed.")
        print("\n".join([*speeds.table(rows), "", *speeds.verdict(rows)]))
        if arguments.record:
            record_page(rows)
    json_option.write(arguments.json, {"rows": rows})
    return 0


if __name__ == "__main__":
    os.environ.setdefault("PYTHONUNBUFFERED", "1")
    sys.exit(outfile.checked(main))
