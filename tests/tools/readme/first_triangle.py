#!/usr/bin/env python3
"""Runs the first triangle of README.md as it is written there, from this folder, with an empty home.

The example has at most 10 lines of shell beside the two files that it writes, which have at most 10 lines of CMake and 25 of C++. The
library must be compiled for speed, although the project chooses no build type. Only targets that are linked are compiled.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]


def lengths(block):
    """Returns the number of lines of shell, of CMake, and of C++."""
    files = dict(re.findall(r"^cat > (\S+) <<'EOF'\n(.*?)^EOF\n", block, re.S | re.M))
    shell = re.sub(r"^cat > (\S+) <<'EOF'\n(.*?)^EOF\n", r"cat > \1\n", block, flags=re.S | re.M)
    return [len(text.splitlines()) for text in (shell, files["CMakeLists.txt"], files["hello.cpp"])]


def main():
    section = (ROOT / "README.md").read_text().split("## A first triangle")[1].split("\n## ")[0]
    block = re.search(r"```sh\n(.*?)```", section, re.S).group(1)
    for length, most, what in zip(lengths(block), (10, 10, 25), ("shell", "CMake", "C++")):
        if length > most:
            print(f"README: {length} lines of {what}, at most {most} were promised")
            return 1
    with tempfile.TemporaryDirectory() as home:
        environment = {name: value for name, value in os.environ.items() if name not in ("CXXFLAGS", "CMAKE_BUILD_TYPE")}
        environment |= {"HOME": home, "CCACHE_DIR": os.environ.get("CCACHE_DIR", str(pathlib.Path.home() / ".cache/ccache"))}
        if shutil.which("ccache"):
            environment["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
        done = subprocess.run(["bash", "-euc", block], cwd=ROOT, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            print(done.stdout[-3000:] + done.stderr[-3000:])
            return 1
        hello = pathlib.Path(home) / "hello"
        picture = hello / "hello.png"
        if not picture.is_file() or picture.stat().st_size < 500:
            print("README: no picture came out")
            return 1
        if " -O2 " not in (hello / "build/build.ninja").read_text().replace("\n", " "):
            print("README: the library is not compiled for speed")
            return 1
        unneeded = [path for path in (hello / "build").rglob("*.o") if re.search(r"_reference\.cpp|/usb/|/cli/", str(path))]
        if unneeded:
            print(f"README: compiled, but not linked: {unneeded[:5]}")
            return 1
    print("the README's first triangle works")
    return 0


if __name__ == "__main__":
    sys.exit(main())
