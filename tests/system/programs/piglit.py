#!/usr/bin/env python3
"""Runs every program of Debian's piglit that an OpenGL 1.5 has to run, on Spangle and on Mesa's two rasterizers.

usage: piglit.py PAIR --all [--jobs N] [--state FILE] [--only TEXT] [--spangle-only] [--write]
       piglit.py PAIR --sample SECONDS [--turn NUMBER]

--all runs all of them. Results of an earlier run in FILE (build/piglit.jsonl) are kept, so that a run may be stopped and continued. --write
makes piglit_table.csv from the results. --sample runs as many programs as fit into the time, another part for each turn, and compares what
Spangle does with the table. The lists of programs are piglit's own (opengl.xml.gz).
"""
import argparse
import ast
import collections
import concurrent.futures
import csv
import fnmatch
import gzip
import json
import pathlib
import random
import re
import signal
import sys
import threading
import time
import xml.etree.ElementTree

from harness import HERE, ORACLES, PIGLIT, check, failures, mesa_environment, need, outfile, run, spangle_environment, xvfb

LISTS = PIGLIT.parent / "tests" / "opengl.xml.gz"
TABLE, REASONS = HERE / "piglit_table.csv", HERE / "piglit_reasons.csv"
DRIVERS = ("spangle", *ORACLES)
SECONDS = 120
# Groups of programs that are tested beside those of the extensions that Spangle names.
GROUPS = ["spec@!opengl 1.[0-5]", "object namespace pollution", "security", "glx", "spec@egl 1.4", "spec@egl_khr_create_context",
          "spec@egl_ext_client_extensions", "spec@egl_mesa_platform_surfaceless", "spec@mesa_pack_invert"]
BAD = ("fail", "crash", "timeout", "warn")


class Program:
    """One program with its arguments, as piglit's list has it."""
    def __init__(self, node):
        options = {o.get("name"): o.get("value") for o in node}
        self.name = node.get("name")
        self.command = [str(w) for w in ast.literal_eval(options["command"])]
        platforms = ast.literal_eval(options.get("require_platforms", "[]"))
        self.window = "glx" in platforms


def extensions(pair):
    """Returns the groups of the extensions that Spangle names."""
    ended = run(["wflinfo", "-p", "surfaceless_egl", "-a", "gl", "-v"], spangle_environment(pair))
    words = re.search(r"^OpenGL extensions: (.*)$", ended.words, re.M)
    if words is None:
        sys.exit(f"wflinfo does not start: {ended.words[-500:]}")
    return ["spec@" + word[3:].lower() for word in words[1].split()]


def programs(pair):
    """Returns the programs of OpenGL 1.0 to 1.5, of the extensions, and of the window systems. A few programs of the list are not in the
    package.
    """
    groups = GROUPS + extensions(pair)
    found = [Program(node) for node in xml.etree.ElementTree.fromstring(gzip.decompress(LISTS.read_bytes()))]
    return [p for p in found if (PIGLIT / p.command[0]).exists() and any(fnmatch.fnmatchcase(p.name.rpartition("@")[0] or p.name, g)
                                    or fnmatch.fnmatchcase("@".join(p.name.split("@")[:2]), g)
                                    or fnmatch.fnmatchcase(p.name.split("@")[0], g) for g in groups)]


def result(words, status):
    """Returns what the program reports: the result, and the parts of it that do not pass."""
    parts, last = {}, None
    for line in words.splitlines():
        if not line.startswith("PIGLIT: "):
            continue
        try:
            said = json.loads(line[8:])
        except ValueError:
            continue
        parts.update(said.get("subtest", {}))
        last = said.get("result", last)
    if status is None:
        last = "timeout"
    elif status < 0 or last is None:
        last = "crash"
    return last, sorted(name for name, what in parts.items() if what in BAD)


def environment_of(driver, pair):
    if driver == "spangle":
        return spangle_environment(pair)
    return mesa_environment(driver, "1.5")


def execute(program, driver, pair, display):
    """Runs one program with one GL. piglit aborts if a program needs a window and has none, so such a program is run again with a window.
    """
    environment = environment_of(driver, pair) | {"PIGLIT_SOURCE_DIR": str(PIGLIT.parent)}
    command = [PIGLIT / program.command[0], *program.command[1:], "-auto"]
    for window in ((True,) if program.window else (False, True)):
        more = ({"DISPLAY": display, "PIGLIT_PLATFORM": "glx"} if window
                else {"PIGLIT_NO_WINDOW": "1", "PIGLIT_PLATFORM": "surfaceless_egl"})
        ended = run(command, environment | more, SECONDS, PIGLIT.parent)
        if ended.status != -signal.SIGABRT:
            break
    return *result(ended.words, ended.status), ended.words


def run_all(options, pair):
    """Runs the programs that have no result yet."""
    options.state.parent.mkdir(parents=True, exist_ok=True)
    state = {}
    if options.state.exists():
        for line in options.state.read_text().splitlines():
            entry = json.loads(line)
            state[entry["driver"], entry["test"]] = entry
    wanted = [p for p in programs(pair) if options.only is None or re.search(options.only, p.name)]
    drivers = DRIVERS[:1] if options.spangle_only else DRIVERS
    jobs = [(p, d) for p in wanted for d in drivers if options.again and d == "spangle" or (d, p.name) not in state]
    print(f"{len(wanted)} programs, {len(jobs)} runs to do", flush=True)
    with xvfb("1024x768x24") as display, options.state.open("a") as out, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        def one(job):
            begin = time.monotonic()
            what, parts, words = execute(*job, pair, display)
            return job, {"driver": job[1], "test": job[0].name, "result": what, "parts": parts,
                         "seconds": round(time.monotonic() - begin, 2), "words": words[-1500:] if what != "pass" else ""}
        for (program, driver), entry in pool.map(one, jobs):
            state[driver, program.name] = entry
            out.write(json.dumps(entry) + "\n")
            out.flush()
            if driver == "spangle" and entry["result"] in BAD:
                print(f"{program.name}: {entry['result']} {entry['parts'][:4]}", flush=True)
    return wanted, state


def why_skipped(words):
    """Returns what a program that skips asks for, in its own words."""
    for pattern, sentence in ((r"Test requires (\w+)", "asks for {}, which is no part of OpenGL 1.5"),
                              (r'Function "(\w+)" not supported', "calls {} of a later version"),
                              (r"(GL_EXT_texture_swizzle) is required", "asks for {}, which is no part of OpenGL 1.5"),
                              (r"Failed to create any GL (context)", "asks for a {} of OpenGL ES")):
        found = re.search(pattern, words)
        if found:
            return sentence.format(found[1])
    return ""


def reason_of(test, entries, reasons):
    """Returns why Spangle's result is not the better of Mesa's two results; empty if it is."""
    if not differs(entries):
        return ""
    for pattern, reason in reasons:
        if fnmatch.fnmatchcase(test, pattern):
            return reason
    return why_skipped(entries["spangle"]["words"]) if entries["spangle"]["result"] == "skip" else ""


def differs(entries):
    ours, theirs = entries["spangle"]["result"], [entries[o]["result"] for o in ORACLES]
    return ours in ("fail", "crash", "timeout") or (ours != "pass" and "pass" in theirs)


def write_table(wanted, state):
    """Makes the table. A difference without a reason is a failure."""
    with REASONS.open(newline="") as lines:
        reasons = [(row["test"], row["reason"]) for row in csv.DictReader(lines)]
    rows = [["test", *DRIVERS, "reason"]]
    for name in sorted({p.name for p in wanted}):
        entries = {d: state[d, name] for d in DRIVERS}
        reason = reason_of(name, entries, reasons)
        check(reason or not differs(entries), f"{name}: {entries['spangle']['result']}, and no reason is known")
        rows.append([name, *(entries[d]["result"] for d in DRIVERS), reason])
    outfile.write_table(TABLE, rows)


def read_table():
    with TABLE.open(newline="") as lines:
        return {row["test"]: row for row in csv.DictReader(lines)}


def print_counts():
    table = read_table()
    for driver in DRIVERS:
        count = collections.Counter(row[driver] for row in table.values())
        print(f"{driver}: " + ", ".join(f"{n} {what}" for what, n in count.most_common()))
    theirs = [row for row in table.values() if any(row[o] == "pass" for o in ORACLES)]
    print(f"of {len(theirs)} that one of Mesa's passes, Spangle passes {sum(row['spangle'] == 'pass' for row in theirs)}")


def sample(pair, seconds, turn):
    """Runs as many programs as fit into so many seconds, from another place on for each turn. Spangle must do what the table says."""
    table = read_table()
    every = [p for p in programs(pair) if table.get(p.name, {}).get("spangle") not in ("timeout", None)]
    random.Random(1).shuffle(every)
    begin = turn % len(every)
    queue, end, done = iter(every[begin:] + every[:begin]), time.monotonic() + seconds, []
    lock = threading.Lock()

    def work():
        while time.monotonic() < end:
            with lock:
                program = next(queue, None)
            if program is None:
                return
            done.append((program, *execute(program, "spangle", pair, display)))

    with xvfb("1024x768x24") as display, concurrent.futures.ThreadPoolExecutor(2) as pool:
        for job in [pool.submit(work) for _ in range(2)]:
            job.result()
        # Some programs wait for a window, and give up on a busy machine. They are tried once more, alone.
        for i, (program, what, *_) in enumerate(done):
            if what != table[program.name]["spangle"]:
                print(f"{program.name}: {what} at first")
                done[i] = (program, *execute(program, "spangle", pair, display))
    for program, what, _, words in done:
        expected = table[program.name]["spangle"]
        check(what == expected, f"{program.name}: {what}; the table says {expected}\n{words[-1500:]}")
    print(f"{len(done)} programs of {len(every)}, from number {begin} on, do what the table says" if not failures else "")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pair", type=pathlib.Path, help="folder of the drop-in pair")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--state", type=pathlib.Path, default=pathlib.Path("build/piglit.jsonl"))
    parser.add_argument("--only", help="programs whose names this regular expression finds")
    parser.add_argument("--again", action="store_true", help="Spangle's results in the state do not count")
    parser.add_argument("--spangle-only", action="store_true")
    parser.add_argument("--sample", type=float, metavar="SECONDS")
    parser.add_argument("--turn", type=int, default=0)
    options = parser.parse_args()
    need(PIGLIT / "gl-1.0-readpixsanity", "wflinfo", "Xvfb")
    pair = options.pair.resolve()
    if options.all:
        wanted, state = run_all(options, pair)
        if options.write:
            write_table(wanted, state)
            print_counts()
    if options.sample:
        sample(pair, options.sample, options.turn)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
