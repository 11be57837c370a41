#!/usr/bin/env python3
"""Holds the picture hashes of every scene and tier against those of other builds of the same sources.

usage: hashes.py BUILD PICTURE_HASHES

PICTURE_HASHES is the host's own build. BUILD is another one, which is made and run. gcc_O0 and so on are this host's with
that compiler and optimization; clang_native has every instruction of this processor. cortex_m4,
cortex_m3 and cortex_m0plus run in QEMU.
The other words are builds for that processor's Linux, which run in QEMU's user mode: s390x has its bytes in the other
order, i686 has words of 32 bits and runs here. Prints a table; any hash that differs fails. Exit status 77 (skipped) when
a compiler or the emulator is missing.
"""
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests/bench"))
import mcu  # noqa: E402

HOST_BUILDS = {f"{name}_{level}": (compiler, f"-{level}") for name, compiler in (("gcc", "g++"), ("clang", "clang++-14"))
               for level in ("O0", "O2", "O3")} | {"clang_native": ("clang++-14", "-O3 -march=native")}
HOST_FLAGS = ["-std=c++20", "-Wno-psabi", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", *mcu.INCLUDES]
# {processor: (compiler, what runs its programs here)}
MACHINES = {"s390x": ("s390x-linux-gnu-g++", ["qemu-s390x"]), "aarch64": ("aarch64-linux-gnu-g++", ["qemu-aarch64"]),
            "riscv64": ("riscv64-linux-gnu-g++", ["qemu-riscv64"]), "i686": ("i686-linux-gnu-g++", [])}
BOARDS = {cpu.replace("-", "_"): board for board, (_, cpu) in mcu.BOARDS.items()}
MAIN = HERE / "picture_hashes.cpp"


def read(text):
    """{(scene, tier): hash} of a program's output."""
    return {tuple(line.split()[:2]): line.split()[2] for line in text.splitlines() if len(line.split()) == 3}


def hashes_of_host(compiler, flags, link=(), runner=()):
    sources = [path for _, path in mcu.sources()] + sorted((ROOT / "boards/scenes").glob("*.cpp")) + [MAIN]
    sound = mcu.firmware.sound_calls(compiler)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def compile_one(path):
            target = folder / (str(path.relative_to(ROOT)).replace("/", "_") + ".o")
            subprocess.run([*mcu.CCACHE, compiler, *HOST_FLAGS, *sound, *mcu.firmware.source_flags(path) * bool(sound), *flags.split(), "-c", str(path), "-o", str(target)], check=True)
            return str(target)

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            objects = list(pool.map(compile_one, sources))
        subprocess.run([compiler, *link, *objects, "-o", str(folder / "hashes")], check=True)
        return read(subprocess.run([*runner, str(folder / "hashes")], capture_output=True, text=True, check=True).stdout)


def hashes_of_board(board):
    with tempfile.TemporaryDirectory() as folder:
        programs = mcu.Programs(board, folder)
        image = programs.add("hashes", MAIN)
        programs.build.run()
        return read(programs.run(image))


def table(builds):
    """Prints what differs, or how much agreed. True when all is equal."""
    wanted_by, wanted = next(iter(builds.items()))
    good = True
    for name, got in builds.items():
        wrong = [key for key in wanted if got.get(key) != wanted[key]]
        print(f"{name:<32}{len(wanted) - len(wrong)} of {len(wanted)} pictures equal")
        good = good and not wrong and got.keys() == wanted.keys()
    for scene, tier in wanted:
        row = {name: got.get((scene, tier), "missing") for name, got in builds.items()}
        if len(set(row.values())) > 1:
            print(f"{scene:<6}{tier:<10}" + "  ".join(f"{name}: {value}" for name, value in row.items()))
    return good


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in (*HOST_BUILDS, *BOARDS, *MACHINES):
        print(__doc__.strip())
        return 2
    host = read(subprocess.run([sys.argv[2]], capture_output=True, text=True, check=True).stdout)
    if not host:
        print("the host's build draws nothing")
        return 1
    builds = {"this build": host}
    if sys.argv[1] in HOST_BUILDS:
        compiler, flags = HOST_BUILDS[sys.argv[1]]
        if shutil.which(compiler) is None:
            print(f"skipped: {compiler} is not installed (./dev setup --all installs it)")
            return 77
        builds[f"{compiler} {flags}"] = hashes_of_host(compiler, flags)
    elif sys.argv[1] in MACHINES:
        compiler, runner = MACHINES[sys.argv[1]]
        missing = [program for program in (compiler, *runner) if shutil.which(program) is None]
        if missing:
            print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs it)")
            return 77
        builds[f"{compiler} -O1"] = hashes_of_host(compiler, "-O1", ("-static",), runner)
    else:
        if not mcu.available():
            print("skipped: arm-none-eabi-g++ or qemu-system-arm is not installed (./dev setup --all installs them)")
            return 77
        board = BOARDS[sys.argv[1]]
        builds[f"{mcu.BOARDS[board][1]} in QEMU"] = hashes_of_board(board)
    return 0 if table(builds) else 1


if __name__ == "__main__":
    sys.exit(main())
