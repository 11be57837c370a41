#!/usr/bin/env python3
"""Checks that no other object can call what is compiled for AVX2, because the linker keeps only one of the functions of a name.

usage: instruction_sets.py OBJECT    which is the one of raster/chain/chain_avx2.cpp
"""
import re
import subprocess
import sys

SPACE = "spangle::raster::avx2::"
MANGLED = "7spangle6raster4avx2"  # how the namespace stands in names that nm cannot demangle


def functions(listing):
    """Returns the functions in the output of nm -C that other objects see: strong or weak symbols of text."""
    return re.findall(r"^[0-9a-f]+ [TWi] (.+)$", listing, re.M)


def main():
    if len(sys.argv) != 2:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    found = functions(subprocess.run(["nm", "-C", sys.argv[1]], check=True, capture_output=True, text=True).stdout)
    shared = [name for name in found if SPACE not in name and MANGLED not in name]
    for name in shared:
        print(f"{name} is compiled for AVX2, and its name is that of the function of every processor: force it inline or move it to {SPACE}")
    if not any(name.startswith(f"{SPACE}assemble_chain(") for name in found):
        print("the object has no chain")
        return 1
    print(f"{len(found)} functions, {len(shared)} that others may call by mistake")
    return 1 if shared else 0


if __name__ == "__main__":
    sys.exit(main())
