#!/usr/bin/env python3
"""Runs each line of the shell blocks of README.md and docs that calls the command line, as it is written, in a folder of its own.

usage: commands.py SPANGLE

A line that names a real bus fails here as it does for a reader without that device: with one line that names the device.
Files that a line names behind --shot and --vcd are there afterwards.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
REAL = re.compile(r"--(spidev|i2c|ftdi|gud)\b")
# An environment without a screen, as on a server: --window says so, and the run goes on.
BARE = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR")} | {"SDL_VIDEODRIVER": "dummy"}


def lines():
    """Returns (page, line) of each line that calls the command line."""
    for page in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        for language, block in re.findall(r"^```(\w*)\n(.*?)^```", page.read_text(), re.S | re.M):
            for line in block.splitlines():
                if language in ("", "sh", "bash") and re.match(r"(build/host/)?spangle \w+", line):
                    yield page.relative_to(ROOT), line


def wrong(spangle, line, folder):
    """Returns what is not as the reader expects, or None."""
    (folder / "build/host").mkdir(parents=True)
    (folder / "build/host/spangle").symlink_to(spangle)
    for name in ("boards", "docs"):
        (folder / name).symlink_to(ROOT / name)
    environment = BARE | {"PATH": f"{folder / 'build/host'}:{os.environ['PATH']}"}
    done = subprocess.run(["bash", "-euc", line], cwd=folder, env=environment, capture_output=True, text=True, timeout=600)
    said = done.stderr.strip().splitlines()
    if REAL.search(line):
        return "" if done.returncode in (1, 2) and len(said) == 1 else f"exit {done.returncode}, {done.stderr!r}: no such device is here"
    if done.returncode != 0:
        return f"exit {done.returncode}: {done.stderr}"
    missing = [name for name in re.findall(r"(?:--shot|--vcd|-o) (\S+)", line) if not (folder / name).is_file()]
    return f"{missing} not written" if missing else ""


def main():
    if len(sys.argv) != 2:
        print(__doc__.strip())
        return 2
    spangle, failed, count = pathlib.Path(sys.argv[1]).resolve(), 0, 0
    for page, line in lines():
        with tempfile.TemporaryDirectory() as folder:
            problem = wrong(spangle, line, pathlib.Path(folder))
        count += 1
        if problem:
            failed += 1
            print(f"{page}: {line}\n  {problem}")
    print(f"{count} commands, {failed} do not work")
    return 1 if failed or count < 8 else 0


if __name__ == "__main__":
    sys.exit(main())
