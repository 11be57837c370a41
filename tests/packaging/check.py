#!/usr/bin/env python3
"""Builds and runs a project outside the tree against Spangle, both ways a user would take.

usage: check.py find_package|fetch_content BUILD_DIR

find_package: installs BUILD_DIR into a temporary prefix and looks it up there. fetch_content: hands the source tree to
FetchContent. The project links every exported library, draws a triangle on a simulated board and checks the glass.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HELLO = pathlib.Path(__file__).with_name("hello")


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        print(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
        sys.exit(1)
    return done.stdout


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("find_package", "fetch_content"):
        print(__doc__.strip())
        return 2
    way, build = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        outside = pathlib.Path(folder)
        project = shutil.copytree(HELLO, outside / "hello")
        if way == "find_package":
            run("cmake", "--install", build, "--prefix", outside / "prefix")
            options = [f"-DCMAKE_PREFIX_PATH={outside / 'prefix'}"]
        else:
            options = [f"-DHELLO_SPANGLE_SOURCE={ROOT}"]
        run("cmake", "-S", project, "-B", outside / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *options)
        run("cmake", "--build", outside / "build", "-j", os.cpu_count() or 2)
        print(run(outside / "build/hello"), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
