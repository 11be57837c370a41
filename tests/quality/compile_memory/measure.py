#!/usr/bin/env python3
"""Compiles every translation unit of a build again and holds the most memory that any of them takes.

usage: measure.py BUILD_FOLDER [--most MEGABYTES] [--only TEXT] [--table]

A first build on a small machine compiles several units at once, so one that takes gigabytes stops it. Each source is
compiled once, with the command of the first target that has it, without ccache, and its output is thrown away. What counts
is the largest resident size of the compiler, as /usr/bin/time -v says it.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time


def commands(build):
    """Returns {source: (the words that compile it, its folder)}, from the first target of each source."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        if os.path.basename(words[0]) == "ccache":
            words = words[1:]
        found.setdefault(entry["file"], (words, entry["directory"]))
    return found


def compiled(source, words, directory, scratch):
    """Returns (megabytes, seconds) of one unit, and deletes its object file."""
    place = words.index("-o") + 1
    with tempfile.NamedTemporaryFile(dir=scratch, suffix=".o") as output:
        began = time.monotonic()
        compiler = subprocess.Popen([*words[:place], output.name, *words[place + 1:]], cwd=directory, stderr=subprocess.PIPE)
        said = compiler.stderr.read()
        _, status, usage = os.wait4(compiler.pid, 0)
        compiler.returncode = os.waitstatus_to_exitcode(status)
        if compiler.returncode != 0:
            raise SystemExit(f"{source} does not compile:\n{said.decode()[:3000]}")
    return usage.ru_maxrss / 1024, time.monotonic() - began


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--most", type=float, default=1024, help="megabytes that a unit may take (1024)")
    parser.add_argument("--only", default="", help="only sources whose path holds this text")
    parser.add_argument("--table", action="store_true", help="print every unit, the largest first")
    options = parser.parse_args()
    units = {source: how for source, how in commands(options.build).items() if options.only in source}
    if not units:
        print(f"compile memory: no unit of {options.build} has '{options.only}' in its path")
        return 2
    jobs = int(os.environ.get("JOBS", os.cpu_count() or 2))
    with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        running = {pool.submit(compiled, source, *how, scratch): source for source, how in units.items()}
        sizes = sorted(((*job.result(), running[job]) for job in concurrent.futures.as_completed(running)), reverse=True)
    for megabytes, seconds, source in sizes if options.table else sizes[:10]:
        print(f"{megabytes:7.0f} MB {seconds:6.1f} s  {source}")
    above = [source for megabytes, _, source in sizes if megabytes > options.most]
    print(f"{len(sizes)} units, {len(above)} above {options.most:.0f} MB")
    return 1 if above else 0


if __name__ == "__main__":
    sys.exit(main())
