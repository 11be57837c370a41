#!/usr/bin/env python3
"""Measures what each optional system costs: compares the library without it with the library that has everything.

usage: features.py [--only FEATURE] [--missing]

The figures are bytes of code and constants of all of gl/, and bytes of a context with its pipeline. They are for x86-64 (-O2), Cortex-M0+
and Cortex-M4 (as in firmware: hot rooms -O2, the others -Os, no messages). Writes tests/tools/bench/features.json, of which
`./dev tables` makes a table. If a compiler is missing its columns stay as they were.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

import mcu
from firmware import outfile

ROOT = mcu.ROOT
RECORD = pathlib.Path(__file__).with_name("features.json")
FEATURES = re.findall(r"^spangle_feature\((\w+) \"(.*)\"\)", (ROOT / "cmake/Features.cmake").read_text(), re.M)
HOST = ["-std=c++20", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", "-ffunction-sections", "-fdata-sections",
        *mcu.firmware.SOUND_CALLS, *mcu.INCLUDES]
TARGETS = {  # compiler prefix, flags, and whether hot rooms have another optimization than the others
    "x86-64": ("", HOST, False),
    "Cortex-M0+": ("arm-none-eabi-", [*mcu.FLAGS, "-mcpu=cortex-m0plus"], True),
    "Cortex-M4": ("arm-none-eabi-", [*mcu.FLAGS, "-mcpu=cortex-m4"], True),
}
# Arrays as long as a context's parts, so that nm can print their sizes.
SIZES = """#include "gl/vertex/engine_fixed.cpp"
namespace spangle::gl {
char context_bytes[sizeof(Context)], pipeline_bytes[sizeof(FixedPipeline)];
}
"""


def compile_one(prefix, flags, optimize, defines, source, target):
    subprocess.run([*mcu.CCACHE, prefix + "g++", *flags, optimize, *defines, "-c", str(source), "-o", str(target)], check=True)
    return target


def measure(name, defines, folder, pool):
    """Returns the bytes of code and constants, and the bytes of a context."""
    prefix, flags, by_room = TARGETS[name]
    sizes = folder / "sizes.cpp"
    sizes.write_text(SIZES)
    jobs = [(path, "-O2" if not by_room or room in mcu.HOT else "-Os") for room, path in mcu.sources() if room.startswith("gl/")]
    objects = [pool.submit(compile_one, prefix, flags, optimize, defines, path, folder / (str(path.relative_to(ROOT)).replace("/", "_") + ".o"))
               for path, optimize in jobs]
    of_sizes = pool.submit(compile_one, prefix, flags, "-Os", defines, sizes, folder / "sizes.o")
    listing = subprocess.run([prefix + "size", *(str(o.result()) for o in objects)], capture_output=True, text=True, check=True).stdout
    text = sum(int(line.split()[0]) for line in listing.splitlines()[1:])
    symbols = subprocess.run([prefix + "nm", "-S", "-C", str(of_sizes.result())], capture_output=True, text=True, check=True).stdout
    return {"text": text, "context": sum(int(size, 16) for size in re.findall(r"^\w+ (\w+) \w spangle::gl::(?:context|pipeline)_bytes$", symbols, re.M))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", help="this feature and the whole library only")
    parser.add_argument("--missing", action="store_true", help="only features that have no record yet")
    arguments = parser.parse_args()
    record = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    known = {feature for feature, _ in FEATURES}
    chosen = [feature for feature, _ in FEATURES if arguments.only in (None, feature)]
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", os.cpu_count()))) as pool:
        for target, (prefix, _, _) in TARGETS.items():
            if shutil.which(prefix + "g++") is None:
                print(f"{target}: no {prefix}g++, its columns stay")
                continue
            column = {feature: cost for feature, cost in record.get(target, {}).items() if feature in known}
            wanted = [feature for feature in chosen if not (arguments.missing and feature in column)]
            whole = measure(target, [], pathlib.Path(folder), pool)
            column["everything"] = whole
            for feature in wanted:
                without = measure(target, [f"-DSPANGLE_FEATURE_{feature}=0"], pathlib.Path(folder), pool)
                column[feature] = {key: whole[key] - without[key] for key in whole}
                print(f"{target} {feature}: {column[feature]['text']} bytes of code, {column[feature]['context']} of a context", flush=True)
                record[target] = column
                outfile.write(RECORD, json.dumps(record, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    raise SystemExit(outfile.checked(main))
