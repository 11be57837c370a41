#!/usr/bin/env python3
"""Draws a million random frames and the whole sweep of extreme numbers under ASan and UBSan. Goes on where it ended.

usage: ./dev nightly [--frames N] [--first N] [--jobs N] [--again] [--only-frames] [--build FOLDER]

Each frame is a function of its number alone. BUILD/nightly.json keeps which frames of these sources were drawn, so that a
run that was stopped goes on; --again begins anew. A frame that breaks something is printed with the command that draws it
alone, and the exit status is 1. The sweep of extreme numbers and a day of animation follow the frames.
"""
import argparse
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402

AT_ONCE = 500  # number of frames that one process draws
AFTERWARDS = (("the whole sweep of extreme numbers", "test_extreme_sweep", [], {"SPANGLE_SWEEP": "whole"}),
              ("a day of animation", "test_extremes", ["--gtest_filter=*Day*"], {"SPANGLE_HOURS": "24"}))
ENVIRONMENT = {**os.environ, "UBSAN_OPTIONS": "print_stacktrace=1"}


class Done:
    """Returns the chunks of one program's frames that went well."""

    def __init__(self, file, program):
        self.file, self.program = file, hashlib.sha256(program.read_bytes()).hexdigest()
        try:
            known = json.loads(file.read_text())
            self.chunks = set(known["chunks"]) if known["program"] == self.program and known["frames"] == AT_ONCE else set()
        except (OSError, ValueError, KeyError):
            self.chunks = set()

    def add(self, chunk):
        self.chunks.add(chunk)
        outfile.write(self.file, json.dumps({"program": self.program, "frames": AT_ONCE, "chunks": sorted(self.chunks)}) + "\n")


class Progress:
    """Reports progress: one line that is written over on a terminal, else a line a minute."""

    def __init__(self, of):
        self.of, self.count, self.begin, self.said = of, 0, time.monotonic(), 0

    def add(self, frames):
        self.count += frames
        now = time.monotonic()
        if now - self.said < (1 if sys.stdout.isatty() else 60) and self.count < self.of:
            return
        self.said = now
        rate = self.count / max(now - self.begin, 0.001)
        left = (self.of - self.count) / max(rate, 0.001) / 60
        print(f"{self.count:,} of {self.of:,} frames, {rate:.0f} a second, {left:.0f} min left", end="\r" if sys.stdout.isatty() else "\n", flush=True)


def failed(program, text, status):
    """Prints the frame in which a process ended, and the process's output."""
    frame = text.replace("\n", "\r").split("\r")
    last = [word for word in frame if word.isdigit()]
    print(f"\nnightly: a frame FAILED with status {status}")
    for line in text.splitlines():
        if "runtime error: " in line or "ERROR: " in line or "stream: " in line:
            print(f"  {line.split(chr(13))[-1]}")
    if last:
        print(f"  draw it: {program} {last[-1]} 1")


def draw(program, chunks, done, jobs):
    """Returns whether every frame of these chunks was drawn."""
    progress, running = Progress(len(chunks) * AT_ONCE), {}
    waiting = list(reversed(chunks))
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                chunk = waiting.pop()
                running[chunk] = subprocess.Popen([program, str(chunk * AT_ONCE), str(AT_ONCE)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                                  env=ENVIRONMENT)
            for chunk, process in list(running.items()):
                try:
                    text = process.communicate(timeout=0.2)[0].decode(errors="replace")
                except subprocess.TimeoutExpired:
                    continue
                del running[chunk]
                if process.returncode != 0:
                    failed(program, text, process.returncode)
                    return False
                done.add(chunk)
                progress.add(AT_ONCE)
    finally:
        for process in running.values():
            process.kill()
    return True


def build(folder, targets):
    done = subprocess.run(["cmake", "--build", folder, "-j", os.environ.get("JOBS", str(os.cpu_count() or 2)), "--target", *targets])
    if done.returncode != 0:
        sys.exit(f"nightly: the build failed; configure {folder} by ./dev nightly")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--frames", type=int, default=1_000_000, help="how many (1000000)")
    parser.add_argument("--first", type=int, default=0, help="the number of the first")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 2, help="processes at a time")
    parser.add_argument("--again", action="store_true", help="draw frames that were drawn, too")
    parser.add_argument("--only-frames", action="store_true", help="leave out the sweep and the day")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/sanitize")
    options = parser.parse_args()
    if options.frames < 1 or options.first < 0 or options.first + options.frames >= 1 << 31 or options.jobs < 1:
        parser.error("--frames and --jobs take 1 or more, --first 0 or more, all below 2^31")
    folder = options.build.resolve()
    build(folder, ["random_frames", *(program for _, program, _, _ in AFTERWARDS)])
    program = folder / "tests/system/nightly/random_frames"
    done = Done(folder / "nightly.json", program)
    chunks = range(options.first // AT_ONCE, (options.first + options.frames + AT_ONCE - 1) // AT_ONCE)
    left = [chunk for chunk in chunks if options.again or chunk not in done.chunks]
    if len(left) < len(chunks):
        print(f"{(len(chunks) - len(left)) * AT_ONCE:,} of {len(chunks) * AT_ONCE:,} frames were drawn by this program before; --again draws them anew")
    if not draw(program, left, done, options.jobs):
        return 1
    print(f"{len(chunks) * AT_ONCE:,} frames from number {chunks[0] * AT_ONCE} without a report")
    status = 0
    for title, name, arguments, environment in () if options.only_frames else AFTERWARDS:
        print(f"nightly: {title}", flush=True)
        status |= subprocess.run([folder / "tests" / name, "--gtest_brief=1", *arguments], env=ENVIRONMENT | environment).returncode
    return 1 if status else 0


if __name__ == "__main__":
    try:
        sys.exit(outfile.checked(main))
    except KeyboardInterrupt:
        sys.exit("\nnightly: stopped; the next run goes on from here")
