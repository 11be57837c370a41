#!/usr/bin/env python3
"""Tests that `./dev COMMAND --help` tells what the command does, for every command, and neither installs nor builds anything.

dev runs in a folder of its own, whose rooms are links to this tree. Programs on PATH that install, compile or test write down that they
were called, and fail.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/support"))
from checks import check, failures  # noqa: E402

ROOMS = ("boards", "gl", "hal", "host_sim", "raster", "tests")
FORBIDDEN = ("apt-get", "dpkg-query", "sudo", "cmake", "ninja", "ctest", "make", "c++", "g++", "git", "xargs", "clang-format-14",
             "clang-tidy-14", "curl", "wget")


class Clone:
    """A folder with dev and nothing built."""

    def __init__(self, folder):
        self.folder, self.called = folder, folder / "called"
        shutil.copy(ROOT / "dev", folder / "dev")
        for room in ROOMS:
            (folder / room).symlink_to(ROOT / room)
        (folder / "bin").mkdir()
        for name in FORBIDDEN:
            (folder / "bin" / name).write_text(f"#!/bin/sh\necho {name} >> {self.called}\nexit 7\n")
            (folder / "bin" / name).chmod(0o755)

    def dev(self, *words):
        environment = os.environ | {"PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}", "HOME": str(self.folder), "JOBS": "1"}
        return subprocess.run([str(self.folder / "dev"), *words], env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=60)

    def touched(self):
        """Returns what ran or appeared that must not."""
        called = self.called.read_text().split() if self.called.exists() else []
        self.called.unlink(missing_ok=True)
        return called + [path.name for path in self.folder.iterdir() if path.name not in ("dev", "bin", *ROOMS)]


def helps(clone, words, *expected):
    """Checks that these words show help which holds the expected texts, and that nothing else happens."""
    done = clone.dev(*words)
    name = f"./dev {' '.join(words)}"
    check(done.returncode == 0 and done.stderr == "", f"{name}: exit {done.returncode}, {done.stderr!r}")
    for text in expected:
        check(text in re.sub(r"\s+", " ", done.stdout), f"{name} does not say {text!r}: {done.stdout!r}")
    touched = clone.touched()
    check(not touched, f"{name} ran or left {touched}")
    return done.stdout


def check_all(clone):
    listed = helps(clone, ["help"])
    check(all(helps(clone, words) == listed for words in (["--help"], ["-h"], [])), "dev --help is not dev help")
    commands = re.findall(r"^  ([a-z]+) +(\S.*)$", listed, re.M)
    check(len(commands) >= 20, f"only {len(commands)} commands are listed")
    for name, does in commands:
        forms = [[name, "--help"]] if name != "lint" else [[name, "--help"], [name, "-h"], ["help", name], [name, "--part", "--help"]]
        for words in forms:
            helps(clone, words, f"usage: ./dev {name} [WORDS...]", re.sub(r"\s+", " ", does))
    programs = dict(re.findall(r"^    \['?([a-z ]+)'?\]=(\S+\.py)$", (ROOT / "dev").read_text(), re.M))
    check(len(programs) >= 12, f"only {len(programs)} programs of commands were found: {programs}")
    for name, program in programs.items():
        check((ROOT / program).is_file(), f"{program}, the program of {name}, is not there")
        helps(clone, [*name.split(), "--help"], f"usage: ./dev {name} [WORDS...]", f"The words go to {program}.", "show this help message")
    helps(clone, ["bench", "states", "--help"], "--seed SEED")
    helps(clone, ["demo", "--help"], "is there after ./dev build")


def check_refusals(clone):
    for words in (["nonsense", "--help"], ["help", "nonsense"], ["nonsense"]):
        done = clone.dev(*words)
        check(done.returncode == 2 and "no command 'nonsense'" in done.stderr and done.stdout == "", f"./dev {' '.join(words)}: {done}")
    # What stands behind -- belongs to another program: the command runs, up to the first program that is missing here.
    done = clone.dev("build", "--", "--help")
    check(done.returncode != 0 and clone.touched() != [], f"./dev build -- --help only showed help: {done}")


def main():
    with tempfile.TemporaryDirectory() as name:
        clone = Clone(pathlib.Path(name))
        check_all(clone)
        check_refusals(clone)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
