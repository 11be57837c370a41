#!/usr/bin/env python3
"""Seeds each small defect of tests/quality/mutants/*.txt into a copy of the tree and shows that the tests catch it.

usage: ./dev mutants [--only TEXT] [--new | --stale] [--count N] [--minutes M] [--turn N] [--workers N] [--list] [--write]

A mutant is one replaced line. It is caught when its test program fails (or no longer ends); a mutant that does not
compile, whose line is not found exactly once, or whose row does not exist, is an error of the list. --write records
the outcome in tests/quality/mutants/caught.txt, from which the feature matrix takes its "works"; what was not tried keeps its
record. --new tries those that are not recorded, --stale those whose file or tests have changed since, oldest first.
--count and --minutes bound a run. --turn N begins with that of the oldest that follows from N, and goes on with those of
the same test program, so that only one is built. .ci/run takes N from the commit.
"""
import argparse
import concurrent.futures
import datetime
import fcntl
import os
import queue
import shlex
import shutil
import subprocess
import sys
import threading
import time

from lists import HERE, ROOT, Hashes, outfile, read_lists, record, recorded, stale

TIMEOUT = 240  # seconds one test program may run; a mutant that loops for ever is caught


UNTRIED = "its test is skipped here"
SKIPPED = 77  # exit status of a test program that cannot run on this machine


class OutOfTime(Exception):
    pass


class Worker:
    """A copy of the tree with a build folder of its own, in which mutants are tried one after the other."""

    def __init__(self, number, jobs, end):
        # The lock belongs to the copy of the tree, so that two runs do not use one copy. It ends with the process.
        (ROOT / "build/mutants").mkdir(parents=True, exist_ok=True)
        while not self.locks(number):
            number += 1
        self.tree = ROOT / f"build/mutants/tree{number}"
        # The build folder lies in its tree as build/test does, with the same flags, so that ccache serves both.
        self.build = self.tree / "build/test"
        self.environment = os.environ | {"CCACHE_BASEDIR": str(self.tree), "CCACHE_SLOPPINESS": "pch_defines,time_macros"}
        self.jobs = jobs
        self.end = end
        self.baselines = {}
        self.build.mkdir(parents=True, exist_ok=True)
        # The times of files are not copied: a file that is restored after a mutant must look newer than what was built from the mutant.
        subprocess.run(["rsync", "-rlp", "--delete", "--checksum", "--exclude=/build", "--exclude=/.git", f"{ROOT}/", f"{self.tree}/"], check=True)
        self.hashes = Hashes(self.tree)
        launcher = [str(HERE / "compile.sh"), *filter(None, [shutil.which("ccache")])]
        self.quiet(["cmake", "-S", str(self.tree), "-B", str(self.build), "-G", "Ninja", "-DSPANGLE_TESTS=ON",
                    f"-DCMAKE_CXX_COMPILER_LAUNCHER={';'.join(launcher)}"])

    def locks(self, number):
        self.lock = open(ROOT / f"build/mutants/tree{number}.lock", "w")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True

    def quiet(self, command):
        done = subprocess.run(command, capture_output=True, text=True, env=self.environment)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(command)}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")

    def left(self):
        """Returns the seconds that the run may still take; None: there is no limit."""
        return max(1, self.end - time.time()) if self.end else None

    def make(self, target):
        command = ["cmake", "--build", str(self.build), "-j", str(self.jobs), "--target", target]
        # After a polite signal, ninja ends its compilers, too.
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              env=self.environment) as process:
            try:
                output, _ = process.communicate(timeout=self.left())
            except subprocess.TimeoutExpired:
                process.terminate()
                process.communicate()
                raise OutOfTime from None
        return process.returncode, output

    def run(self, words):
        try:
            done = subprocess.run([str(self.build / "tests" / words[0]), "--gtest_brief=1", *words[1:]],
                                  cwd=self.build / "tests", capture_output=True, text=True, timeout=min(TIMEOUT, self.left() or TIMEOUT))
            return done.returncode, done.stdout
        except subprocess.TimeoutExpired:
            if self.end and time.time() > self.end:
                raise OutOfTime from None
            return 1, "timeout"

    def baseline(self, words):
        """Runs the test in the tree as it is, where it must pass. Returns whether some of it is skipped here."""
        status, output = self.make(words[0])
        if status != 0:
            raise SystemExit(f"{words[0]} does not build\n{output[-3000:]}")
        status, output = self.run(words)
        if status not in (0, SKIPPED):
            raise SystemExit(f"{shlex.join(words)} fails without any mutant\n{output[-2000:]}")
        return "[  SKIPPED ]" in output or status == SKIPPED

    def attempt(self, mutant):
        words = tuple(mutant.test)
        if words not in self.baselines:
            self.baselines[words] = self.baseline(mutant.test)
        path = self.tree / mutant.file
        original = path.read_text()
        outfile.write(path, mutant.seeded(self.tree))
        try:
            if self.make(mutant.test[0])[0] != 0:
                return "does not compile"
            if self.run(mutant.test)[0] not in (0, SKIPPED):
                return "caught"
            return UNTRIED if self.baselines[words] else "SURVIVED"
        finally:
            outfile.write(path, original)


def by_turn(mutants, known, turn):
    """Returns the mutants of one test program in their order. The turn chooses with which of the oldest mutants to begin."""
    if not mutants:
        return []
    age = known.get(mutants[0].id, ())[2:]
    oldest = [m for m in mutants if known.get(m.id, ())[2:] == age]
    begin = turn % len(oldest)
    ordered = oldest[begin:] + oldest[:begin] + mutants[len(oldest):]
    return [m for m in ordered if m.test[0] == ordered[0].test[0]]


def try_all(mutants, arguments):
    """Returns the outcome of each mutant that there was time for."""
    end = time.time() + 60 * arguments.minutes if arguments.minutes else None
    workers = queue.Queue()
    jobs = max(1, (os.cpu_count() or 2) // arguments.workers)
    for number in range(arguments.workers):
        workers.put(Worker(number, jobs, end))
    outcome, writing, start = {}, threading.Lock(), time.time()
    today = datetime.date.today().isoformat()

    def attempt(mutant):
        if end and time.time() > end:
            return
        worker = workers.get()
        try:
            result = worker.attempt(mutant)
            hashes = worker.hashes.of(mutant)
        except OutOfTime:
            return
        finally:
            workers.put(worker)
        with writing:
            outcome[mutant.id] = result
            if arguments.write and result != UNTRIED:  # written after each mutant, so that a run that ends early is not lost
                record({mutant.id: (*hashes, today) if result == "caught" else None})
            print(f"[{len(outcome)}/{len(mutants)} {time.time() - start:.0f} s] {mutant.id} ({mutant.row}): {result}", flush=True)

    with concurrent.futures.ThreadPoolExecutor(arguments.workers) as executor:
        list(executor.map(attempt, mutants))
    return outcome


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="mutants whose id contains this text")
    parser.add_argument("--new", action="store_true", help="mutants not recorded as caught")
    parser.add_argument("--stale", action="store_true", help="mutants whose file or tests have changed since they were caught")
    parser.add_argument("--count", type=int, help="at most so many")
    parser.add_argument("--minutes", type=float, help="begin and build nothing after so many minutes")
    parser.add_argument("--turn", type=int, metavar="N", help="mutants of one test program, which follows from N")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--list", action="store_true", help="check the lists and tell what is stale, run nothing")
    parser.add_argument("--write", action="store_true", help="record the outcome in tests/quality/mutants/caught.txt")
    arguments = parser.parse_args()
    every, known = read_lists(), recorded()
    mutants = [m for m in every if arguments.only in m.id and not (arguments.new and m.id in known)]
    bad = [(m, m.problem()) for m in mutants if m.problem()]
    for mutant, problem in bad:
        print(f"{mutant.source}: {mutant.id}: {problem}")
    old = [] if bad else stale(mutants, known)
    if arguments.list or bad:
        if arguments.stale:
            print("\n".join(m.id for m in old))
        new = sum(m.id not in known for m in mutants)
        print(f"{len(mutants)} mutants, {len(bad)} unusable, {new} not yet caught, {len(old)} caught in another state of their file or test")
        gone = sorted(set(known) - {m.id for m in every})
        if gone:
            print("recorded as caught, but in no list: " + ", ".join(gone))
        return 1 if bad or gone else 0
    if shutil.which("rsync") is None:
        raise SystemExit("mutants: rsync is missing: apt-get install rsync")
    if arguments.stale:
        mutants = old
    if arguments.turn is not None:
        mutants = by_turn(mutants, known, arguments.turn)
    mutants = mutants[:arguments.count]
    if arguments.turn is None and not arguments.minutes:
        # Mutants of one test program follow each other, so that less is rebuilt.
        mutants.sort(key=lambda m: (m.test[0], m.file))
    outcome = try_all(mutants, arguments)
    outcome = {id: result for id, result in outcome.items() if result != UNTRIED}
    survivors = [id for id, result in outcome.items() if result != "caught"]
    untried = len(mutants) - len(outcome)
    print(f"{len(outcome) - len(survivors)} of {len(outcome)} caught" + (": not " + ", ".join(survivors) if survivors else "")
          + (f"; {untried} more were not tried" if untried else ""))
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
