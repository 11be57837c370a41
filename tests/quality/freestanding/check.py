#!/usr/bin/env python3
"""Compiles gl/, raster/ and hal/ freestanding for small cores and fails on anything they must not need.

usage: check.py [--keep DIR]

For each target: every source compiles with the warnings of the host build; the undefined symbols of all objects
together are mem* and libgcc's integer helpers only; hard-float objects hold no VFP arithmetic. Prints text sizes.
Exit status 77 (skipped) when a cross compiler is missing.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "boards/tools"))
import firmware  # noqa: E402

ROOMS = ["raster/numeric", "raster/surface", "raster/compile", "raster/ops", "raster/chain", "raster/fused",
         "raster/primitive", "raster/band", "hal/bus", "hal/panel", "hal/display",
         "gl/api", "gl/api/generated", "gl/context", "gl/vertex", "gl/pixel", "gl/texture", "gl/list", "gl/egl"]
COMMON = ["-std=c++20", "-Os", "-ffreestanding", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics",
          "-ffunction-sections", "-fdata-sections", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-DSPANGLE_FIRMWARE=1", *firmware.SOUND_CALLS,
          f"-I{ROOT}", f"-I{ROOT}/raster/format/include", f"-I{ROOT}/raster/include", f"-I{ROOT}/hal/include",
          f"-I{ROOT}/gl/include"]
# RISC-V uses the C++ headers of the Arm package: both compilers have the same version, and only headers are taken.
RISCV_HEADERS = ["-isystem", "/usr/include/newlib/c++/12.2.1", "-isystem",
                 "/usr/include/newlib/c++/12.2.1/arm-none-eabi", "-isystem",
                 "/usr/lib/picolibc/riscv64-unknown-elf/include"]
TARGETS = {
    "cortex-m0plus": ("arm-none-eabi-", ["-mcpu=cortex-m0plus", "-mthumb"]),
    "cortex-m4f": ("arm-none-eabi-", ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]),
    "rv32imac": ("riscv64-unknown-elf-", ["-march=rv32imac", "-mabi=ilp32", *RISCV_HEADERS]),
}
ALLOWED = re.compile(
    r"^(mem(cpy|set|move|cmp)|__aeabi_mem\w+"
    r"|__aeabi_(l|u|i|ul|ui)(mul|divmod|div|ldivmod|idiv|idivmod|lsl|lsr|asr|cmp)|__aeabi_(u?ldivmod|u?idiv(mod)?|lmul|llsl|llsr|lasr|u?lcmp)"
    r"|__gnu_thumb1_case_\w+|__(u?div|u?mod|mul|ashl|ashr|lshr|clz|ctz|ffs|popcount|bswap|cmp|ucmp)[sd]i[0-9]?)$")
VFP = re.compile(r"\t(v(add|sub|mul|div|sqrt|cvt|cmp|fma|fms|mla|mls|neg|abs)\w*\.f\S*)")


def compile_one(job):
    compiler, flags, source, target = job
    done = subprocess.run([compiler, *COMMON, *flags, "-c", str(source), "-o", str(target)], capture_output=True, text=True)
    return source, done.returncode, done.stderr


def sources():
    for room in ROOMS:
        for path in sorted((ROOT / room).glob("*.cpp")):
            if not path.name.endswith("_reference.cpp"):
                yield room, path


def text_size(size_tool, objects):
    out = subprocess.run([size_tool, *map(str, objects)], capture_output=True, text=True, check=True).stdout
    return sum(int(line.split()[0]) for line in out.splitlines()[1:])


def check(name, prefix, flags, folder):
    compiler = shutil.which(prefix + "g++")
    objects, jobs = {}, []
    for room, path in sources():
        target = folder / (str(path.relative_to(ROOT)).replace("/", "_") + ".o")
        objects.setdefault(room, []).append(target)
        jobs.append((compiler, flags, path, target))
    good = True
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for source, status, message in pool.map(compile_one, jobs):
            if status != 0:
                good = False
                print(f"{name}: {source.relative_to(ROOT)} does not compile\n{message}")
    if not good:
        return False
    everything = [o for group in objects.values() for o in group]
    linked = folder / "all.o"
    subprocess.run([prefix + "ld", *(["-melf32lriscv"] if "rv32" in name else []), "-r", "-o", str(linked), *map(str, everything)],
                   check=True)
    undefined = subprocess.run([prefix + "nm", "-u", str(linked)], capture_output=True, text=True, check=True).stdout
    bad = sorted({line.split()[-1] for line in undefined.splitlines() if line and not ALLOWED.match(line.split()[-1])})
    if bad:
        good = False
        for symbol in bad:
            users = [o.name for o in everything
                     if re.search(rf" U {re.escape(symbol)}$", subprocess.run([prefix + "nm", str(o)], capture_output=True, text=True).stdout, re.M)]
            print(f"{name}: undefined {symbol}, used by {', '.join(users)}")
    if "hard" in " ".join(flags):
        listing = subprocess.run([prefix + "objdump", "-d", str(linked)], capture_output=True, text=True, check=True).stdout
        found = sorted(set(m.group(1) for m in VFP.finditer(listing)))
        if found:
            good = False
            print(f"{name}: floating-point arithmetic in the core: {', '.join(found)}")
    sizes = {room: text_size(prefix + "size", group) for room, group in objects.items()}
    print(f"{name}: text {sum(sizes.values())} bytes  " + "  ".join(f"{room} {size}" for room, size in sizes.items()))
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--target", action="append", choices=sorted(TARGETS), help="only this one")
    arguments = parser.parse_args()
    good = True
    for name in arguments.target or TARGETS:
        prefix, flags = TARGETS[name]
        if shutil.which(prefix + "g++") is None:
            print(f"skipped: {prefix}g++ is not installed (./dev setup --all installs it)")
            return 77
        with tempfile.TemporaryDirectory() as folder:
            good = check(name, prefix, flags, pathlib.Path(folder)) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
