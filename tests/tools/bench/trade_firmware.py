#!/usr/bin/env python3
"""Builds the firmware that `spangle trade --targets` counts: OUT/TARGET/PROGRAM-TIER.elf.

usage: ./dev firmware [SCENE...] [--model FILE] [--targets m0plus,m3,m4,rv32] [--tiers exact,balanced,fast]
                      [--tier NAME=BASE,KNOB=VALUE,...] [--used-spans] [--out DIR]

Each image holds one scene or one baked model, and a library with one tier and nothing of the others. Without names every scene is
built. The knobs of a tier of one's own are constants of its library. With --used-spans the library holds the fused spans that these
programs draw with, and no others: it is smaller, and built sooner. Objects stay in OUT/objects, so that the next run compiles what
changed. Exit status 77 when a compiler is missing.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "boards/tools"))
import firmware  # noqa: E402
from firmware import outfile  # noqa: E402

# {target: (board whose linker script serves, processor)}; host_sim/trade/targets.cpp runs the images.
TARGETS = {"m0plus": ("mps2_an385", "cortex-m0plus"), "m3": ("mps2_an385", "cortex-m3"), "m4": ("mps2_an386", "cortex-m4"),
           "rv32": ("rv32_virt", "rv32imac")}
TIERS = ("exact", "balanced", "fast")  # in the order of raster::Tier
FRAMES = 5  # frames that `spangle trade` draws on boards
# C++ names for the words of `spangle trade --knobs`.
WORDS = {"off": "false", "on": "true", "never": "Knobs::never", "always": "0", "straight": "Runs::straight", "cubic": "Runs::cubic"}


class Refused(Exception):
    """A sentence about why what was asked for cannot be built."""


def words(known):
    """Returns an option's type: some of these names, with commas between."""
    def read(text):
        names = text.split(",")
        unknown = [name for name in names if name not in known]
        if unknown:
            raise argparse.ArgumentTypeError(f"no {', '.join(unknown)}; there are {', '.join(known)}")
        return names
    return read


def ask(spangle, *question):
    """Returns what the command line of this tree prints."""
    if not spangle.is_file():
        raise Refused(f"{spangle} is not there; `./dev build` makes it, or --spangle names another one")
    done = subprocess.run([spangle, *question], capture_output=True, text=True)
    if done.returncode != 0:
        raise Refused(done.stderr.strip().removeprefix("spangle: "))
    return done.stdout


def tier_set(knobs):
    """Returns the tiers whose code draws with these knobs. raster::tiers_for() checks the library for the same."""
    exact = knobs["color_bits"] == "20" or knobs["runs"] == "cubic" or knobs["unsnapped"] == "on"
    other = knobs["color_bits"] == "8" or knobs["runs"] == "straight"
    return [tier for tier, there in zip(TIERS, (exact, other and knobs["coarse_blend"] == "off", other and knobs["coarse_blend"] == "on")) if there]


def definitions(tiers, knobs=None):
    """Returns the library's definitions for a build with these tiers, or with one set of knobs."""
    out = [f"-DSPANGLE_TIER_SET={sum(1 << TIERS.index(tier) for tier in tiers)}"]
    if knobs is not None:
        out.append("-DSPANGLE_KNOBS=" + ",".join(f".{knob}={WORDS.get(value, value)}" for knob, value in knobs.items()))
    return out


def composed(spangle, asked):
    """Returns {name: (a tier of the library, definitions)} of tiers as the option --tier describes them."""
    if not asked:
        return {}
    table = [re.split(r"  +", line.strip()) for line in ask(spangle, "trade", "--knobs", *(word for tier in asked for word in ("--tier", tier))).splitlines()]
    out = {}
    for column in range(table[0].index(TIERS[-1]) + 1, len(table[0]) - 1):
        knobs = {row[0]: row[column] for row in table[1:]}
        tiers = tier_set(knobs)
        out[table[0][column]] = (tiers[0], definitions(tiers, knobs))
    return out


def write_changed(path, text):
    """Writes a file only if its text changes, so that nothing is compiled again for it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.is_file() or path.read_text() != text:
        outfile.write(path, text)


def bake(spangle, model, folder):
    """Returns (name of the image, definitions of its program)."""
    name = re.sub(r"[^A-Za-z0-9]", "_", "model_" + model.name)
    header = folder / f"{name}.hpp"
    text = ask(spangle, "bake", str(model), "-o", "-", "--name", name)
    write_changed(header, text)
    return re.sub(rb"[^A-Za-z0-9.-]", b"_", os.fsencode(model.name)).decode(), [f"-DBENCH_MODEL={name}", f'-DBENCH_MODEL_HEADER="{header}"']


def used_spans(spangle, programs, tier, dither, folder):
    """Returns the list of the fused spans that programs (words of `spangle profile`) draw with in a tier of the library."""
    spans = {}
    for number, program in enumerate(programs):
        profile = folder / f"{tier}{number}.cmake"
        ask(spangle, "profile", *program, "--tiers", tier, "--frames", str(FRAMES), "--dither", dither, "--out", str(profile))
        spans.update(dict.fromkeys(re.findall(r"^(?://[^\n]*\n)?\[\] \{\n.*?^\}\(\),\n", profile.with_suffix(".inc").read_text(), re.M | re.S)))
    write_changed(folder / f"{tier}.inc", f"// Fused spans of the programs for the {tier} tier.\n" + "".join(sorted(spans)))
    return f'-DSPANGLE_FUSED="{folder / tier}.inc"'


def add_images(build, target, programs, tiers):
    """Adds TARGET/PROGRAM-TIER.elf of each of {program: definitions} and {tier: (a tier of the library, definitions)}."""
    board, cpu = TARGETS[target]
    start = [build.compile(cpu, "-Os", path) for path in firmware.startup(cpu)]
    for tier, (base, own) in tiers.items():
        variant = f"trade-{tier}"
        library = [*build.library(cpu, own, variant), *start]
        for program, what in programs.items():
            main = build.compile(cpu, "-Os", HERE / "trade_main.cpp",
                                 [*own, *what, f"-DBENCH_PRECISION=EGL_PRECISION_{base.upper()}_SPANGLE"], f"{variant}-{program}")
            build.image(cpu, [main, *library], ROOT / "boards" / board / "memory.ld", f"{target}/{program}-{tier}.elf")
    return len(tiers) * len(programs)


def read_arguments():
    parser = argparse.ArgumentParser(prog="./dev firmware", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    parser.add_argument("--model", type=pathlib.Path, action="append", default=[], metavar="FILE", help="a model file, baked into an image; may be repeated")
    parser.add_argument("--targets", type=words(TARGETS), default=list(TARGETS))
    parser.add_argument("--tiers", type=words(TIERS), default=None, help="those of the library; all of them, unless --tier is there")
    parser.add_argument("--tier", action="append", default=[], metavar="NAME=BASE,KNOB=VALUE,...", help="a tier of your own; may be repeated")
    parser.add_argument("--used-spans", action="store_true", help="only the fused spans that these programs draw with")
    parser.add_argument("--dither", choices=("on", "off"), default="off", help="GL_DITHER, for --used-spans: as for `spangle trade`")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build/trade-firmware")
    parser.add_argument("--spangle", type=pathlib.Path, default=ROOT / "build/host/spangle", help="the command line that bakes models and reads tiers")
    arguments = parser.parse_args()
    if arguments.tiers is None:
        arguments.tiers = [] if arguments.tier else list(TIERS)
    if not arguments.scenes and not arguments.model:
        arguments.scenes = list(firmware.SCENES)
    unknown = [scene for scene in arguments.scenes if scene not in firmware.SCENES]
    if unknown:
        parser.error(f"no scene {', '.join(unknown)}; there are {', '.join(firmware.SCENES)}")
    return arguments


def main():
    arguments = read_arguments()
    missing = sorted({firmware.TARGETS[TARGETS[target][1]].prefix + "g++" for target in arguments.targets})
    missing = [compiler for compiler in missing if shutil.which(compiler) is None]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs them)")
        return 77
    build = firmware.Build(arguments.out)
    try:
        tiers = {tier: (tier, definitions([tier])) for tier in arguments.tiers}
        tiers.update(composed(arguments.spangle, arguments.tier))
        programs = {scene: [f"-DBENCH_SCENE={firmware.SCENES[scene]}"] for scene in arguments.scenes}
        for model in arguments.model:
            name, what = bake(arguments.spangle, model, build.folder / "models")
            if name in programs:
                raise Refused(f"two programs would be called '{name}'; give the model's file another name")
            programs[name] = what
        if arguments.used_spans:
            drawn = [[scene] for scene in arguments.scenes] + [["--model", str(model)] for model in arguments.model]
            (build.folder / "spans").mkdir(parents=True, exist_ok=True)
            lists = {base: used_spans(arguments.spangle, drawn, base, arguments.dither, build.folder / "spans") for base in {base for base, _ in tiers.values()}}
            tiers = {tier: (base, [*own, lists[base]]) for tier, (base, own) in tiers.items()}
    except Refused as problem:
        print(f"./dev firmware: {problem}", file=sys.stderr)
        return 2
    count = sum(add_images(build, target, programs, tiers) for target in arguments.targets)
    build.run()
    print(f"{count} images in {build.folder}")
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
