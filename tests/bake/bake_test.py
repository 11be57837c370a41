#!/usr/bin/env python3
"""Tests `spangle bake` as a user meets it.

usage: bake_test.py SPANGLE fresh
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODELS = ROOT / "boards/scenes/models"
SPANGLE = sys.argv[1] if len(sys.argv) == 3 else ""
failures = []


def check(condition, text):
    if not condition:
        failures.append(text)
        print("FAILED: " + text)


def run(*words, cwd=None):
    return subprocess.run([SPANGLE, *words], capture_output=True, text=True, cwd=cwd)


def fresh():
    """The headers of the scenes are what their first line writes, and the model is what its program makes."""
    headers = sorted(MODELS.glob("*.hpp"))
    check(headers, "there are baked models")
    with tempfile.TemporaryDirectory() as folder:
        for header in headers:
            words = re.search(r"Written by `spangle (bake .*)`", header.read_text()).group(1).split()
            words[1] = str(MODELS / words[1])
            done = run(*words, cwd=folder)
            check(done.returncode == 0, f"{header.name}: {done.stderr.strip()}")
            check((pathlib.Path(folder) / header.name).read_text() == header.read_text(), f"{header.name} is not what `spangle {' '.join(words)}` writes")
        kept = {path: path.read_bytes() for path in MODELS.glob("rocket.*") if path.suffix != ".hpp"}
        program = pathlib.Path(folder) / "boards/scenes/models/rocket.py"
        program.parent.mkdir(parents=True)
        program.write_bytes(kept[MODELS / "rocket.py"])
        (pathlib.Path(folder) / "host_sim").symlink_to(ROOT / "host_sim")
        subprocess.run([sys.executable, program], check=True)
        for path, content in kept.items():
            check((program.parent / path.name).read_bytes() == content, f"{path.name} is not what rocket.py makes")


def main():
    parts = {"fresh": fresh}
    if len(sys.argv) != 3 or sys.argv[2] not in parts:
        print(__doc__.strip())
        return 2
    parts[sys.argv[2]]()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
