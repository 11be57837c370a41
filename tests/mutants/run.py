#!/usr/bin/env python3
"""Seeds each small defect of tests/mutants/*.txt into a copy of the tree and shows that the tests catch it.

usage: ./dev mutants [--only TEXT] [--new | --since COMMIT] [--workers N] [--list] [--write]

A mutant is one replaced line. It is caught when its test program fails (or no longer ends); a mutant that does not
compile, whose line is not found exactly once, or whose row does not exist, is an error of the list. --write records
the outcome in tests/mutants/caught.txt, from which the feature matrix takes its "works"; what was not tried keeps its
record. --new tries those that are not recorded, --since also those whose file or tests have changed since that commit.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import queue
import shlex
import shutil
import subprocess
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = ROOT / "tests/mutants"
ROWS = {row["id"] for row in json.loads((ROOT / "gl/api/commands/rows.json").read_text())} | {"-"}
TIMEOUT = 240  # seconds one test program may run; a mutant that loops for ever is caught


class Mutant:
    def __init__(self, source, fields):
        self.source = source
        for key in ("id", "file", "find", "replace", "test"):
            if key not in fields:
                raise SystemExit(f"{source}: a mutant has no '{key}': {fields}")
        self.id, self.file, self.test = fields["id"], fields["file"], shlex.split(fields["test"])
        self.find, self.replace = fields["find"], fields["replace"]
        self.row = fields.get("row", "-")

    def problem(self):
        """Why this entry cannot be used, or None."""
        path = ROOT / self.file
        if not path.is_file():
            return f"no file {self.file}"
        if self.row not in ROWS:
            return f"the feature matrix has no row {self.row}"
        count = path.read_text().count(self.find)
        return None if count == 1 else f"'{self.find}' stands {count} times in {self.file}"


def read_lists():
    mutants, seen = [], set()
    for path in sorted(HERE.glob("*.txt")):
        if path.name in ("caught.txt", "CMakeLists.txt"):
            continue
        for block in path.read_text().split("\n\n"):
            fields = {}
            for line in block.splitlines():
                if line.startswith("#") or not line.strip():
                    continue
                key, _, value = line.partition(":")
                fields[key.strip()] = value.strip()
            if fields:
                mutant = Mutant(path.name, fields)
                if mutant.id in seen:
                    raise SystemExit(f"{path.name}: two mutants are called {mutant.id}")
                seen.add(mutant.id)
                mutants.append(mutant)
    return mutants


class Worker:
    """One copy of the tree with its own build folder; mutants are tried in it one after the other."""

    def __init__(self, number, jobs):
        self.tree = ROOT / f"build/mutants/tree{number}"
        self.build = ROOT / f"build/mutants/build{number}"
        self.jobs = jobs
        self.tree.mkdir(parents=True, exist_ok=True)
        # Without times: a file that a mutant left restored must look newer than what was built from the mutant.
        subprocess.run(["rsync", "-rlp", "--delete", "--checksum", "--exclude=/build", "--exclude=/.git", f"{ROOT}/", f"{self.tree}/"], check=True)
        self.quiet(["cmake", "-S", str(self.tree), "-B", str(self.build), "-G", "Ninja", "-DSPANGLE_TESTS=ON",
                    "-DSPANGLE_WERROR=OFF", "-DCMAKE_CXX_FLAGS_RELEASE=-O1"])

    def quiet(self, command):
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(command)}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")

    def make(self, target):
        return subprocess.run(["cmake", "--build", str(self.build), "-j", str(self.jobs), "--target", target],
                              capture_output=True, text=True)

    def run(self, words):
        try:
            done = subprocess.run([str(self.build / "tests" / words[0]), "--gtest_brief=1", *words[1:]],
                                  cwd=self.build / "tests", capture_output=True, text=True, timeout=TIMEOUT)
            return done.returncode, done.stdout
        except subprocess.TimeoutExpired:
            return 1, "timeout"

    def baseline(self, words):
        built = self.make(words[0])
        if built.returncode != 0:
            raise SystemExit(f"{words[0]} does not build\n{built.stdout[-3000:]}")
        status, output = self.run(words)
        if status != 0:
            raise SystemExit(f"{shlex.join(words)} fails without any mutant\n{output[-2000:]}")

    def attempt(self, mutant):
        path = self.tree / mutant.file
        original = path.read_text()
        path.write_text(original.replace(mutant.find, mutant.replace))
        try:
            if self.make(mutant.test[0]).returncode != 0:
                return "does not compile"
            return "caught" if self.run(mutant.test)[0] != 0 else "SURVIVED"
        finally:
            path.write_text(original)


def recorded():
    path = HERE / "caught.txt"
    lines = path.read_text().splitlines() if path.exists() else []
    return {line.split()[0] for line in lines if line and line[0] != "#"}


def record(every, outcome):
    """What was caught now, and what was before and has not been tried."""
    known = recorded()
    lines = [f"{m.id} {m.row}" for m in every if (outcome[m.id] == "caught" if m.id in outcome else m.id in known)]
    (HERE / "caught.txt").write_text("# Written by ./dev mutants --write: each mutant that the tests caught, and its row.\n" + "\n".join(lines) + "\n")


def touched_since(commit, mutants):
    changed = subprocess.run(["git", "diff", "--name-only", commit], cwd=ROOT, capture_output=True, text=True, check=True)
    files = changed.stdout.split()
    areas = {"test_" + file.split("/")[1] for file in files if file.startswith("tests/")}
    known = recorded()
    return [m for m in mutants if m.id not in known or m.file in files or m.test[0] in areas]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="mutants whose id contains this text")
    parser.add_argument("--since", metavar="COMMIT", help="mutants not recorded as caught, or touched since then")
    parser.add_argument("--new", action="store_true", help="mutants not recorded as caught")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--list", action="store_true", help="check the lists, run nothing")
    parser.add_argument("--write", action="store_true", help="record the outcome in tests/mutants/caught.txt")
    arguments = parser.parse_args()
    every = read_lists()
    mutants = touched_since(arguments.since, every) if arguments.since else every
    known = recorded() if arguments.new else ()
    mutants = [m for m in mutants if arguments.only in m.id and m.id not in known]
    bad = [(m, m.problem()) for m in mutants if m.problem()]
    for mutant, problem in bad:
        print(f"{mutant.source}: {mutant.id}: {problem}")
    if arguments.list or bad:
        print(f"{len(mutants)} mutants, {len(bad)} unusable")
        return 1 if bad else 0
    if shutil.which("rsync") is None:
        raise SystemExit("mutants: rsync is missing: apt-get install rsync")
    workers = queue.Queue()
    jobs = max(1, (os.cpu_count() or 2) // arguments.workers)
    pool = [Worker(n, jobs) for n in range(arguments.workers)]
    for words in {tuple(m.test) for m in mutants}:
        pool[0].baseline(list(words))
    for worker in pool:
        workers.put(worker)
    outcome, writing, start = {}, threading.Lock(), time.time()

    def attempt(mutant):
        worker = workers.get()
        try:
            result = worker.attempt(mutant)
        finally:
            workers.put(worker)
        with writing:
            outcome[mutant.id] = result
            if arguments.write:  # each at once: a run that is ended early has not been for nothing
                record(every, outcome)
        print(f"[{len(outcome)}/{len(mutants)} {time.time() - start:.0f} s] {mutant.id} ({mutant.row}): {result}", flush=True)

    with concurrent.futures.ThreadPoolExecutor(arguments.workers) as executor:
        # Same test program after each other: less to rebuild.
        list(executor.map(attempt, sorted(mutants, key=lambda m: (m.test[0], m.file))))
    survivors = [m.id for m in mutants if outcome[m.id] != "caught"]
    print(f"{len(mutants) - len(survivors)} of {len(mutants)} caught" + (": not " + ", ".join(survivors) if survivors else ""))
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
