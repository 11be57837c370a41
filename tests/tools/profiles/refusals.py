#!/usr/bin/env python3
"""Builds the library for this host in each profile and runs refusals.cpp on it. Compares CMake's definitions with those of profile.py.

usage: refusals.py COMPILER
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "boards/tools"))
import firmware  # noqa: E402
import profile  # noqa: E402

FLAGS = ["-std=c++20", "-O1", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-fno-exceptions", "-fno-rtti", *firmware.INCLUDES]


def build_and_run(compiler, name, folder):
    """Returns what the program prints, or how the build fails."""
    defines = [f"-D{definition}" for definition in profile.definitions(name)]
    sources, sound = [path for _, path in firmware.sources()] + [HERE / "refusals.cpp"], firmware.sound_calls(compiler)

    def compile_one(source):
        target = folder / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")
        done = subprocess.run([*firmware.CCACHE, compiler, *FLAGS, *sound, *defines, "-c", str(source), "-o", str(target)], capture_output=True, text=True)
        return str(target), done.stderr

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(compile_one, sources))
    errors = "".join(text for _, text in objects)
    if errors:
        return errors[:3000]
    program = folder / "refusals"
    subprocess.run([compiler, *(target for target, _ in objects), "-o", str(program)], check=True)
    done = subprocess.run([str(program)], capture_output=True, text=True)
    return "" if done.returncode == 0 else f"exit {done.returncode}: {done.stdout}{done.stderr}"


def cmake_definitions(name, folder):
    """Returns CMake's definitions of a source that the definitions of all rooms reach."""
    subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja", f"-DSPANGLE_PROFILE={name}", "-DSPANGLE_TESTS=OFF", "-DSPANGLE_HOST=OFF"],
                   check=True, capture_output=True)
    for entry in json.loads((folder / "compile_commands.json").read_text()):
        if entry["file"].endswith("raster/fused/part_0.cpp"):
            found = re.findall(r'-D(SPANGLE_[^\s]+)', entry["command"].replace('\\"', '"'))
            usual = {f"SPANGLE_{limit}={value}" for limit, value in profile.limits().items()}
            return {d for d in found if not re.fullmatch(r"SPANGLE_FEATURE_\w+=1", d)} - usual
    return set()


def main():
    if len(sys.argv) != 2:
        print(__doc__.strip())
        return 2
    bad = []
    for name in sorted(path.stem for path in profile.PROFILES.glob("*.cmake")):
        with tempfile.TemporaryDirectory() as folder:
            problem = build_and_run(sys.argv[1], name, pathlib.Path(folder))
            if problem:
                bad.append(f"{name}: {problem}")
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = set(profile.definitions(name)), cmake_definitions(name, pathlib.Path(folder))
            if ours != theirs:
                bad.append(f"{name}: CMake and profile.py differ in {sorted(ours ^ theirs)}")
    print("\n".join(bad) or "every profile draws what it holds and refuses the rest")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
