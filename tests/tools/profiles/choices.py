#!/usr/bin/env python3
"""Measures what each choice of a profile costs: the text of an image of `whole` and of `minimal` with one choice changed.

usage: choices.py [--only TEXT] [--build FOLDER]

Writes choices.json, of which docs/profiles.md is made (python3 tests/tools/profiles/choices.py --table rewrites that table alone).
"""
import argparse
import json
import pathlib
import sys
import tempfile

import profiles
from profiles import DOCUMENT, ROOT, TARGET, firmware, outfile, profile

RECORD = profiles.HERE / "choices.json"


def choices_of_whole():
    out = {
        "all fused spans instead of six": {"SPANGLE_FUSED": None},
        "without the chain": {"SPANGLE_CHAIN": "0"},
        "exact instead of balanced": {"SPANGLE_TIER_SET": "exact"},
        "fast instead of balanced": {"SPANGLE_TIER_SET": "fast"},
        "balanced and exact": {"SPANGLE_TIER_SET": "exact balanced"},
        "16-bit depth only": {"SPANGLE_DEPTH_FORMATS": "z16"},
        "textures of rgb565 only": {"SPANGLE_TEXTURE_FORMATS": "rgb565"},
        "textures of 8-bit and 565 texels only": {"SPANGLE_TEXTURE_FORMATS": "a8 l8 i8 la88 rgb565 rgb888 rgba8888"},
        "one texture unit": {"SPANGLE_TEXTURE_UNITS": "1"},
    }
    surfaces = ("rgb565_le", "rgb888", "rgba8888", "rgb666", "rgb444", "rgb332", "grey4", "mono")
    for surface in surfaces:
        out[f"{surface} surfaces, too"] = {"SPANGLE_COLOR_FORMATS": f"rgb565 {surface}"}
    return out


def choices_of_minimal():
    perspective = {"SPANGLE_PERSPECTIVE": None, "SPANGLE_FUSED": f'"{profile.PROFILES}/spans/lit_textured.inc"'}
    return {
        "perspective": perspective,
        "perspective, and what its planes cut": {**perspective, "SPANGLE_CLIPPING": None},
        "quads and polygons": {"SPANGLE_PRIMITIVES": "polygons"},
        "points and lines": {"SPANGLE_PRIMITIVES": "points lines"},
        "lights that shine": {"SPANGLE_LIGHT_KINDS": "specular"},
        "normals of any length, and bright lights": {"SPANGLE_FULL_LIGHTING": None},
        "memory that is given out again": {"SPANGLE_ARENA_REUSE": None},
        "surfaces that tell what was drawn": {"SPANGLE_EXTENTS": None},
        "the chain": {"SPANGLE_CHAIN": None},
    }


def choices():
    """Returns {profile: {text: definitions that replace the profile's own; None takes one away}}. tests/tools/bench/features.py measures
    features.
    """
    return {"whole": {"": {}, **choices_of_whole()}, "minimal": {"": {}, **choices_of_minimal()}}


def definitions(name, changes):
    """Returns the definitions of a profile with these changes."""
    says = dict(definition.split("=", 1) for definition in profile.definitions(name))
    lists = profile.named_lists()
    for key, value in changes.items():
        limit = key.removeprefix("SPANGLE_")
        says[key] = str(profile.sum_of(limit, value)) if limit in lists and value is not None else value
    return [f"-D{key}={value}" for key, value in says.items() if value is not None]


def measure(name, changes, folder, variant):
    build = firmware.Build(folder)
    defines = definitions(name, changes)
    library = build.library(TARGET, defines, variant, hot=profiles.HOT, lto=True)
    if name == "minimal":
        image = profiles.minimal(build, variant, library, False, defines, lto=True)
    else:
        image = profiles.sized(build, variant, library, defines, later=True)
    build.run()
    return profiles.text_of(image)


def table(record):
    rows = ""
    for name, texts in record.items():
        rows += f"| **{name}** | **{texts['']}** |\n" + "".join(f"| {choice} | {text - texts['']:+} |\n" for choice, text in texts.items() if choice)
    return f"| choice | bytes of text |\n|---|--:|\n{rows}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="choices whose text holds this")
    parser.add_argument("--build", type=pathlib.Path, help="where objects go, and stay")
    parser.add_argument("--table", action="store_true", help="measures nothing")
    arguments = parser.parse_args()
    record = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    wanted = choices()
    if not arguments.table:
        with tempfile.TemporaryDirectory() as folder:
            for name, of in wanted.items():
                known = record.setdefault(name, {})
                for number, (choice, changes) in enumerate(of.items()):
                    if choice and arguments.only not in choice:
                        continue
                    known[choice] = measure(name, changes, arguments.build or folder, f"{name}{number}")
                    print(f"{known[choice] - known['']:>+8} {name} {choice}", flush=True)
                    outfile.write(RECORD, json.dumps(record, indent=1) + "\n")
    record = {name: {choice: record[name][choice] for choice in of if choice in record[name]} for name, of in wanted.items()}
    outfile.write(RECORD, json.dumps(record, indent=1) + "\n")
    outfile.write(DOCUMENT, profiles.with_table(DOCUMENT.read_text(), "choices", table(record)))
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
