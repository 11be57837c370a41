#!/usr/bin/env python3
"""Builds the firmware that `spangle trade --targets` counts: OUT/TARGET/SCENE-TIER.elf.

usage: ./dev firmware [SCENE...] [--targets m0plus,m3,m4,rv32] [--tiers exact,balanced,fast] [--out DIR]

Each image holds one scene, and a library with one tier and nothing of the other two; without names every scene is built. Objects
stay in OUT/objects, so that the next run compiles what changed. Exit status 77 when a compiler is missing.
"""
import argparse
import pathlib
import shutil
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "boards/tools"))
import firmware  # noqa: E402
from firmware import outfile  # noqa: E402

# What is built, and for which board (host_sim/trade/targets.cpp runs it): the folder of its linker script, and the processor.
TARGETS = {"m0plus": ("mps2_an385", "cortex-m0plus"), "m3": ("mps2_an385", "cortex-m3"), "m4": ("mps2_an386", "cortex-m4"),
           "rv32": ("rv32_virt", "rv32imac")}
TIERS = ("exact", "balanced", "fast")  # in the order of raster::Tier


def words(known):
    """An option's type: some of these names, with commas between."""
    def read(text):
        names = text.split(",")
        unknown = [name for name in names if name not in known]
        if unknown:
            raise argparse.ArgumentTypeError(f"no {', '.join(unknown)}; there are {', '.join(known)}")
        return names
    return read


def add_images(build, target, scenes, tiers, defines):
    """{path below the folder: image}"""
    board, cpu = TARGETS[target]
    out = {}
    start = [build.compile(cpu, "-Os", path) for path in firmware.startup(cpu)]
    for tier in tiers:
        own = [f"-DSPANGLE_TIER_SET={1 << TIERS.index(tier)}", *defines]
        variant = "-".join(["trade", tier, *(define.partition("=")[2].strip('"').replace("/", "_") for define in defines)])
        library = [*build.library(cpu, own, variant), *start]
        for scene in scenes:
            name = f"{target}/{scene}-{tier}.elf"
            main = build.compile(cpu, "-Os", HERE / "trade_main.cpp",
                                 [*own, f"-DBENCH_SCENE={firmware.SCENES[scene]}", f"-DBENCH_PRECISION=EGL_PRECISION_{tier.upper()}_SPANGLE"],
                                 f"{variant}-{scene}")
            out[name] = build.image(cpu, [main, *library], ROOT / "boards" / board / "memory.ld", name)
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    parser.add_argument("--targets", type=words(TARGETS), default=list(TARGETS))
    parser.add_argument("--tiers", type=words(TIERS), default=list(TIERS))
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build/trade-firmware")
    parser.add_argument("--define", action="append", default=[], help="a definition of the library, as SPANGLE_FUSED=... (for tests)")
    arguments = parser.parse_args()
    scenes = arguments.scenes or list(firmware.SCENES)
    unknown = [scene for scene in scenes if scene not in firmware.SCENES]
    if unknown:
        parser.error(f"no scene {', '.join(unknown)}; there are {', '.join(firmware.SCENES)}")
    missing = sorted({firmware.TARGETS[TARGETS[target][1]].prefix + "g++" for target in arguments.targets})
    missing = [compiler for compiler in missing if shutil.which(compiler) is None]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs them)")
        return 77
    build = firmware.Build(arguments.out)
    images = {}
    for target in arguments.targets:
        images.update(add_images(build, target, scenes, arguments.tiers, [f"-D{define}" for define in arguments.define]))
    build.run()
    print(f"{len(images)} images in {build.folder}")
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
