#!/usr/bin/env python3
"""Extracts the first triangle from README.md and runs it as a reader would: at most 10 lines of shell, 25 of C++."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    section = (ROOT / "README.md").read_text().split("## A first triangle")[1].split("\n## ")[0]
    shell = re.search(r"```sh\n(.*?)```", section, re.S).group(1)
    program = re.search(r"```cpp\n(.*?)```", section, re.S).group(1)
    for text, most, what in ((shell, 10, "shell"), (program, 25, "C++")):
        if len(text.splitlines()) > most:
            print(f"README: {len(text.splitlines())} lines of {what}, at most {most} were promised")
            return 1
    with tempfile.TemporaryDirectory() as folder:
        hello = pathlib.Path(folder) / "hello"
        hello.mkdir()
        (hello / "hello.cpp").write_text(program)
        done = subprocess.run(["bash", "-euc", shell], cwd=folder, env={**os.environ, "SPANGLE": str(ROOT)}, capture_output=True, text=True)
        if done.returncode != 0:
            print(done.stdout[-3000:] + done.stderr[-3000:])
            return 1
        picture = hello / "hello.png"
        if not picture.is_file() or picture.stat().st_size < 500:
            print("README: no picture came out")
            return 1
    print("the README's first triangle works")
    return 0


if __name__ == "__main__":
    sys.exit(main())
