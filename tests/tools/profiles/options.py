#!/usr/bin/env python3
"""Tests the options of a build, and writes their table in docs/options.md.

usage: options.py [--write]

Compares the numbers of cmake/Limits.cmake with those of the three headers, the names with the bits in gl/context/limits.hpp, and
docs/options.md with the options. Configures builds with bad values, whose errors must say what is valid. --write only writes the table.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "boards/tools"), str(ROOT / "host_sim/tools")]
import outfile  # noqa: E402
import profile  # noqa: E402
from checks import check, failures  # noqa: E402

DOCUMENT = ROOT / "docs/options.md"
HEADERS = ("raster/include/spangle/raster/limits.hpp", "raster/numeric/machine.hpp", "gl/context/limits.hpp")
BITS = {"has_points": ("PRIMITIVES", "points"), "has_lines": ("PRIMITIVES", "lines"), "has_polygons": ("PRIMITIVES", "polygons"),
        "has_specular": ("LIGHT_KINDS", "specular"), "has_local_lights": ("LIGHT_KINDS", "local"), "has_color_material": ("LIGHT_KINDS", "color_material"),
        "define SPANGLE_TWO_SIDES": ("LIGHT_KINDS", "two_sided")}
FIRMWARE, LINUX, PC, OURS = "firmware engineers", "Raspberry Pi users", "PC tests", "us"
EVERYONE = f"{FIRMWARE}, {LINUX}, {PC}"
# Options that are no limits, and who sets them.
READERS = {"SPANGLE_HOST": PC, "SPANGLE_CLI": PC, "SPANGLE_LINUX": LINUX, "SPANGLE_USB": LINUX, "SPANGLE_TESTS": OURS, "SPANGLE_BENCH": OURS,
           "SPANGLE_FUZZ": OURS, "SPANGLE_WERROR": OURS, "SPANGLE_CHECK_RANGES": FIRMWARE, "SPANGLE_PROFILE": EVERYONE,
           "BUILD_SHARED_LIBS": LINUX, "SPANGLE_PROFILE_FEATURES": EVERYONE, "SPANGLE_OPTIMIZE": FIRMWARE}
# Options that are wrong, and what CMake must say.
REFUSED = ((["COLOR_FORMATS=rgb565 pink"], 'names "pink"', "rgb565_le"), (["COLOR_FORMATS=129"], 'write -DSPANGLE_COLOR_FORMATS="rgb565 grey4"'),
           (["DEPTH_FORMATS=1"], 'DEPTH_FORMATS="none"'), (["TIER_SET=none"], 'names "none"'), (["TIER_SET=all fast"], "stand alone"),
           (["TEXTURE_FORMATS="], "is empty"), (["LIGHTS=9"], "must be 1 to 8"), (["LIGHTS=many"], "must be 1 to 8"),
           (["ARENA_LOG2=3"], "must be 0 or 7 to 37"), (["PACKET=3"], "must be 2, 4, 8 or 16"), (["LIST_NESTING=1"], "must be 2 or more"),
           (["OPTIMIZE=small"], "must be speed or size"), (["LINE_BATCH=3"], "even number"), (["CHAIN=0"], "drawn by the chain"),
           (["CHAIN=0", "FUSED_SPANS=0"], "nothing could be drawn"), (["PERSPECTIVE=0"], "needs SPANGLE_CLIPPING=0"),
           (["PERSPECTIVE=0", "CLIPPING=0", "AFFINE_TEXTURES=0"], "needs SPANGLE_AFFINE_TEXTURES=1"),
           (["FULL_LIGHTING=0"], "color_material"), (["COLOR_FORMATS=mono", "FEATURE_NARROW_SURFACES=OFF"], "need NARROW_SURFACES"),
           (["PROFILE_FEATURES=FOG MIST"], "MIST", "LIGHTING"))
INTRODUCTION = """# The options of a build

A build is changed by `cmake -DSPANGLE_NAME=VALUE`, or by a [profile](profiles.md), which sets many options at once. Lists of names
are separated by spaces; `all` stands for every name. CMake refuses other values, and says which ones there are. The tables are
written by `python3 tests/tools/profiles/options.py --write`.
"""


def switches():
    """Returns {option: (usual value, text)} of the options that are no limits."""
    out = {}
    for path in ("CMakeLists.txt", "cmake/Profile.cmake", "cmake/Features.cmake", "cmake/Limits.cmake"):
        text = (ROOT / path).read_text()
        out.update({name: (usual, what) for name, what, usual in re.findall(r'^option\((\w+) "([^"]*)" ([^)]+)\)', text, re.M)})
        out.update({name: (usual, what) for name, usual, what in re.findall(r'^set\((SPANGLE_\w+) (\S+) CACHE STRING "([^"]*)"\)', text, re.M)})
    return out


def values_of(values):
    return re.sub(r"\.\.$", " or more", values).replace("..", " to ").replace("|", ", ")


def table(rows):
    return "| option | default | values | for | text |\n|---|---|---|---|---|\n" + "".join(f"| {' | '.join(row)} |\n" for row in rows)


def document():
    usual_of = {"${SPANGLE_TOP_LEVEL}": "ON, within another project OFF", "${SPANGLE_ON_LINUX}": "ON on Linux", "${SPANGLE_LINUX}": "as SPANGLE_LINUX", '""': "empty"}
    kinds = {"SPANGLE_PROFILE": "a name or a path", "SPANGLE_PROFILE_FEATURES": "names of features, or `all`", "SPANGLE_OPTIMIZE": "speed, size"}
    general = [(f"`{name}`", usual_of.get(usual, usual), kinds.get(name, "ON, OFF"), READERS[name], text.rstrip(".") + ".")
               for name, (usual, text) in switches().items()]
    lists = [(f"`SPANGLE_{name}`", "all", ("none, " if empty != "-" else "") + ", ".join(one for one in names if one != "-"), FIRMWARE, text)
             for name, empty, text, *names in profile.rows("spangle_names")]
    host = {"HOST_MEMORY_MB": f"{LINUX}, {PC}"}
    limits = [(f"`SPANGLE_{name}`", usual, values_of(values), host.get(name, FIRMWARE), text) for name, usual, values, text in profile.rows("spangle_limit")]
    ways = [(f"`SPANGLE_{name}`", f"auto: {speed} for speed, {size} for size", "auto, " + values_of(values), OURS, text)
            for name, speed, size, values, text in profile.rows("spangle_ways")]
    features = re.findall(r'^spangle_feature\((\w+) "([^"]*)"', (ROOT / "cmake/Features.cmake").read_text(), re.M)
    return (f"{INTRODUCTION}\n## What is built\n\n{table(general)}\n## Lists of names\n\n{table(lists)}\n## Numbers\n\n{table(limits)}\n"
            "## Features\n\nSPANGLE_PROFILE_FEATURES names the features that a build has. `-DSPANGLE_FEATURE_NAME=ON` or `OFF` overrides the list for one of\n"
            "them; `ccmake` shows these options as advanced ones.\n\n| feature | text |\n|---|---|\n"
            + "".join(f"| `{name}` | {text}. |\n" for name, text in features)
            + f"\n## For measurements of ours\n\nSPANGLE_OPTIMIZE chooses these options. Each value draws the same bytes.\n\n{table(ways)}")


def check_headers():
    found = {}
    for header in HEADERS:
        found.update(re.findall(r"^#ifndef SPANGLE_\w+\n(?://[^\n]*\n)*#define SPANGLE_(\w+) (\d+)\b[^\n]*$", (ROOT / header).read_text(), re.M))
    usual = profile.limits()
    check(found == usual, f"headers and cmake/Limits.cmake differ in {sorted(set(found.items()) ^ set(usual.items()))}")
    text = (ROOT / HEADERS[2]).read_text()
    for constant, (limit, name) in BITS.items():
        bit = re.search(rf"\b{constant}\b[^;]*?SPANGLE_{limit} & (\d+)", text)
        check(bit and int(bit[1]) == 1 << profile.named_lists()[limit][1].index(name), f"{constant} is the bit of {name} in SPANGLE_{limit}")


def check_refusals(folder):
    def configure(options):
        (folder / "CMakeCache.txt").unlink(missing_ok=True)
        done = subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja", *(f"-DSPANGLE_{name}=OFF" for name in ("HOST", "TESTS", "LINUX")),
                               *(f"-DSPANGLE_{option}" for option in options)], capture_output=True, text=True)
        return done.returncode, re.sub(r"\s+", " ", done.stderr)

    for options, *says in REFUSED:
        status, said = configure(options)
        check(status != 0 and all(word in said for word in says), f"{options}: {said}")
    status, said = configure(["COLOR_FORMATS=rgb565;grey4", "DEPTH_FORMATS=z16", "OPTIMIZE=size", "KERNELS_INLINE=1"])
    built = (folder / "build.ninja").read_text()
    for definition in ("COLOR_FORMATS=129", "DEPTH_FORMATS=3", "SHORTCUTS=0", "KERNELS_INLINE=1", "LINE_BATCH=2"):
        check(status == 0 and f"-DSPANGLE_{definition} " in built, f"{definition}: {said}")
    status, said = configure(["COLOR_FORMATS=1023"])
    check(status == 0, f"a cache of an older version, where nobody chose: {said}")
    for wrong in ({"COLOR_FORMATS": "129"}, {"OPTIMIZE": "small"}, {"TIER_SET": "all fast"}):
        try:
            profile.numbers(wrong)
            check(False, f"profile.py takes {wrong}")
        except SystemExit:
            pass


def main():
    if sys.argv[1:] == ["--write"]:
        outfile.write(DOCUMENT, document())
        return 0
    if len(sys.argv) != 1:
        print(__doc__.strip())
        return 2
    check_headers()
    check(DOCUMENT.read_text() == document(), "docs/options.md is not current: run python3 tests/tools/profiles/options.py --write")
    with tempfile.TemporaryDirectory() as folder:
        check_refusals(pathlib.Path(folder))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
