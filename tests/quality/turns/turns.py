#!/usr/bin/env python3
"""Which slow tests a commit runs: their seconds decide, so that no turn of CI takes much longer than another.

usage: turns.py BUILD --turn N --leave-out
       turns.py BUILD --turn N --labels
       turns.py BUILD --loads
       turns.py BUILD --check

Each row of turns.csv is a regular expression that slow tests' whole names match, the seconds of such a test beside another one on a
machine with two cores, and how many turns pass until it runs again: 1 (each commit runs it), 2, 4, 8, 16, 32 or 64. Tests whose names have
the same text in the expression's first parentheses go together, and the seconds are those of all of them. The longest tests choose
their turn first; each takes that which has the least to do. A slow test without a row runs with each commit. BUILD is a build folder,
whose tests CTest lists.

--leave-out prints the regular expression, for ctest -E, of the slow tests that turn N does not run. --labels prints the labels of those
that it runs. --loads prints what each turn has to do. --check fails where a row names no test, or a turn has more to do than it may.
"""
import argparse
import collections
import csv
import json
import pathlib
import re
import subprocess
import sys

TABLE = pathlib.Path(__file__).with_name("turns.csv")
TURNS = 64
MOST_SECONDS = 2400  # most seconds of the tests of one turn, of which two run at a time

Row = collections.namedtuple("Row", "pattern seconds every")
Test = collections.namedtuple("Test", "name labels serial")


class Group:
    """Tests that go together, and the turns that run them."""
    def __init__(self, row):
        self.row, self.tests = row, []

    def seconds(self):
        """The seconds of a machine with two cores. A test that runs alone takes both cores."""
        return self.row.seconds * (2 if any(test.serial for test in self.tests) else 1)


def rows_of(text):
    rows = [Row(re.compile(row["tests"]), int(row["seconds"]), int(row["every"])) for row in csv.DictReader(text.splitlines())]
    wrong = [row for row in rows if row.every < 1 or TURNS % row.every != 0 or row.seconds < 0]
    if wrong:
        raise ValueError(f"{wrong[0].pattern.pattern}: {wrong[0].every} turns and {wrong[0].seconds} seconds make no sense; "
                         f"{TURNS} is a multiple of the turns")
    return rows


def slow_tests(listed):
    """Returns the slow tests in what `ctest --show-only=json-v1` prints."""
    tests = []
    for test in listed["tests"]:
        properties = {p["name"]: p["value"] for p in test["properties"]}
        labels = set(properties.get("LABELS", []))
        if "slow" in labels:
            tests.append(Test(test["name"], labels, bool(properties.get("RUN_SERIAL", False))))
    return tests


def grouped(rows, tests):
    """Returns groups of tests by their rows, in the table's order. A test belongs to the first row that matches it."""
    groups = {}
    for test in tests:
        for at, row in enumerate(rows):
            match = row.pattern.fullmatch(test.name)
            if match:
                together = match.group(1) if row.pattern.groups else test.name
                groups.setdefault((at, together), Group(row)).tests.append(test)
                break
    return [groups[key] for key in sorted(groups)]


def turns_of(groups):
    """Returns the groups of each turn. The longest groups choose first, and each chooses the turn that has the least to do so far."""
    loads, turns = [0] * TURNS, [[] for _ in range(TURNS)]
    for group in sorted(groups, key=lambda g: (g.row.every, -g.seconds())):
        every = group.row.every
        first = min(range(every), key=lambda at: (max(loads[at::every]), sum(loads[at::every])))
        for turn in range(first, TURNS, every):
            loads[turn] += group.seconds()
            turns[turn].append(group)
    return turns


def left_out(groups, turn):
    """Returns the names of the tests that a turn does not run."""
    runs = {id(group) for group in turns_of(groups)[turn % TURNS]}
    return [test.name for group in groups if id(group) not in runs for test in group.tests]


def labels_of(groups, turn):
    return sorted(set().union(*(test.labels for group in turns_of(groups)[turn % TURNS] for test in group.tests)))


def expression(names):
    """Returns the regular expression that matches these names and no others, in CMake's grammar."""
    if not names:
        return "^$"
    return "^(" + "|".join(re.sub(r"([][.*+?()|^$\\])", r"\\\1", name) for name in names) + ")$"


def faults(rows, groups):
    """Returns sentences about what is wrong with a table."""
    named = {id(group.row) for group in groups}
    said = [f"the row {row.pattern.pattern} names no slow test" for row in rows if id(row) not in named]
    for turn, of_turn in enumerate(turns_of(groups)):
        seconds = sum(group.seconds() for group in of_turn)
        if seconds > MOST_SECONDS:
            said.append(f"turn {turn} takes {seconds} s of tests; {MOST_SECONDS} s are the most")
    return said


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--turn", type=int, default=0)
    what = parser.add_mutually_exclusive_group(required=True)
    for name in ("leave-out", "labels", "loads", "check"):
        what.add_argument("--" + name, action="store_true")
    options = parser.parse_args()
    listed = subprocess.run(["ctest", "--test-dir", options.build, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    rows = rows_of(TABLE.read_text())
    groups = grouped(rows, slow_tests(json.loads(listed.stdout)))
    if options.leave_out:
        print(expression(left_out(groups, options.turn)))
    elif options.labels:
        print(*labels_of(groups, options.turn))
    elif options.loads:
        for turn, of_turn in enumerate(turns_of(groups)):
            print(f"{turn:2} {sum(group.seconds() for group in of_turn):5} s", *(group.tests[0].name for group in of_turn if group.row.every > 1))
    else:
        wrong = faults(rows, groups)
        for sentence in wrong:
            print(sentence)
        return 1 if wrong else 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
