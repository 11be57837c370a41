#!/usr/bin/env python3
"""Counts what a change of one thing costs: x86 instructions of the change and of a triangle of a few pixels after it.

usage: ./dev bench changes [--json FILE]
       ./dev bench changes --update-golden    writes tests/tools/bench/changes.json and its table in docs/speed.md

The instructions are counted by callgrind, and are the same in each run of one compiler's program. tests/tools/bench/changes.cpp has the changes.
Each is drawn without lights and textures, with one light, and with one texture. More than 3 % above tests/tools/bench/changes.json fails. Exit
status 77 (skipped) when valgrind is missing.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE / "states"), str(HERE.parent / "readme")]
import json_option  # noqa: E402
import measure  # noqa: E402
import tables  # noqa: E402
from json_option import outfile  # noqa: E402

GOLDEN = HERE / "changes.json"
SLACK = 1.03


def count(program):
    """Returns {change: {how: instructions of the change and the triangle}}."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(["valgrind", "--tool=callgrind", "--dump-before=mark", "--compress-strings=no", "--compress-pos=no", "--dump-line=no",
                               f"--callgrind-out-file={folder}/out", str(program)],
                              capture_output=True, text=True, env=measure.environment("host-base"))
        if done.returncode != 0:
            raise SystemExit(f"{program} ends with {done.returncode}\n{done.stderr[-2000:]}")
        found = {}
        for case, line in enumerate(done.stdout.splitlines()):
            name, repetitions = line.rsplit(": ", 1)
            change, how = name.rsplit(", ", 1)
            dump = pathlib.Path(f"{folder}/out.{2 * case + 2}").read_text()
            found.setdefault(change, {})[how] = round(sum(measure.functions(dump).values()) / int(repetitions))
    return found


def compare(now, was):
    """Returns (lines about what is wrong, lines about what is better)."""
    bad, better = [], []
    if now.keys() != was.keys():
        bad.append(f"other changes than in changes.json: {', '.join(sorted(now.keys() ^ was.keys()))}")
    for change in now.keys() & was.keys():
        for how, instructions in now[change].items():
            before = was[change].get(how, 0)
            text = f"{change}, {how}: {instructions:,} instructions, and took {before:,}"
            if instructions > before * SLACK:
                bad.append(text)
            elif instructions * SLACK < before:
                better.append(text)
    return bad, better


def write(counts):
    lines = [f" {json.dumps(change)}: {json.dumps(of)}" for change, of in counts.items()]
    outfile.write(GOLDEN, "{\n" + ",\n".join(lines) + "\n}\n")
    tables.write({"changes": tables.changes()})
    print("wrote tests/tools/bench/changes.json and its table in docs/speed.md")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, help="folder of the build that has tests/tools/bench/bench_changes")
    parser.add_argument("--program", type=pathlib.Path, help="this program instead")
    parser.add_argument("--update-golden", action="store_true", help="write the counts that ./dev test --all guards, and their table")
    json_option.add(parser)
    arguments = parser.parse_args()
    json_option.check(parser, arguments.json)
    if arguments.update_golden and arguments.json is not None:
        parser.error("--update-golden writes its counts to tests/tools/bench/changes.json, and no others: without --json")
    program = arguments.program or (arguments.build / "tests/tools/bench/bench_changes" if arguments.build else None)
    if program is None:
        parser.error("--build or --program is needed")
    if shutil.which("valgrind") is None:
        print("skipped: valgrind is not installed (./dev setup --all installs it)")
        return 77
    counts = count(program)
    if arguments.update_golden:
        write(counts)
        return 0
    bad, better = compare(counts, json.loads(GOLDEN.read_text()) if GOLDEN.exists() else {})
    with json_option.tables(arguments.json):
        for change, of in counts.items():
            print(f"{change:<55}" + "".join(f"{instructions:>10,} {how}" for how, instructions in of.items()))
        print("\n".join(bad + better))
        print(f"{len(bad)} worse than changes.json or other, {len(better)} better by more than 3 %")
        if bad or better:
            print("what is worth it is kept by ./dev bench changes --update-golden; say why")
    json_option.write(arguments.json, {"changes": counts})
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
