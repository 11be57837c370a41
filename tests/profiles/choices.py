#!/usr/bin/env python3
"""Measures what each choice of a profile costs: the text of the whole profile's image with one choice made otherwise.

usage: choices.py [--only TEXT] [--build FOLDER]

Writes choices.json, of which docs/profiles.md is made (python3 tests/profiles/choices.py --table rewrites that table alone).
"""
import argparse
import json
import pathlib
import sys
import tempfile

import profiles
from profiles import DOCUMENT, ROOT, TARGET, firmware, profile

RECORD = profiles.HERE / "choices.json"


def choices():
    """{text: definitions that replace those of the profile; None takes one away}. Features are measured by tests/bench/features.py."""
    out = {
        "all fused spans instead of six": {"SPANGLE_FUSED": None},
        "without the chain": {"SPANGLE_CHAIN": "0"},
        "exact instead of balanced": {"SPANGLE_TIER_SET": "1"},
        "fast instead of balanced": {"SPANGLE_TIER_SET": "4"},
        "balanced and exact": {"SPANGLE_TIER_SET": "3"},
        "16-bit depth only": {"SPANGLE_DEPTH_FORMATS": "3"},
        "textures of rgb565 only": {"SPANGLE_TEXTURE_FORMATS": "16"},
        "textures of 8-bit and 565 texels only": {"SPANGLE_TEXTURE_FORMATS": "127"},
        "one texture unit": {"SPANGLE_TEXTURE_UNITS": "1"},
    }
    surfaces = ("rgb565_le", "rgb888", "rgba8888", "rgb666", "rgb444", "rgb332", "grey4", "mono")
    for bit, surface in enumerate(surfaces, 1):
        out[f"{surface} surfaces, too"] = {"SPANGLE_COLOR_FORMATS": str(1 + (1 << bit))}
    return out


def definitions(changes):
    """Of the whole profile, with these."""
    says = dict(definition.split("=", 1) for definition in profile.definitions("whole"))
    says.update(changes)
    return [f"-D{name}={value}" for name, value in says.items() if value is not None]


def measure(changes, folder, name):
    build = firmware.Build(folder)
    defines = definitions(changes)
    image = profiles.sized(build, name, build.library(TARGET, defines, name, hot=profiles.HOT, lto=True), defines, later=True)
    build.run()
    return profiles.text_of(image)


def table(record):
    whole = record["whole"]
    rows = "".join(f"| {name} | {text - whole:+} |\n" for name, text in record.items() if name != "whole")
    return f"| choice | bytes of text |\n|---|--:|\n| the whole profile | {whole} |\n{rows}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="choices whose text holds this")
    parser.add_argument("--build", type=pathlib.Path, help="where objects go, and stay")
    parser.add_argument("--table", action="store_true", help="measures nothing")
    arguments = parser.parse_args()
    record = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    wanted = {"whole": {}, **choices()}
    if not arguments.table:
        with tempfile.TemporaryDirectory() as folder:
            for number, (name, changes) in enumerate(wanted.items()):
                if arguments.only in name or name == "whole":
                    record[name] = measure(changes, arguments.build or folder, f"choice{number}")
                    print(f"{record[name] - record['whole']:>+8} {name}", flush=True)
                    RECORD.write_text(json.dumps(record, indent=1) + "\n")
        record = {name: record[name] for name in wanted if name in record}
        RECORD.write_text(json.dumps(record, indent=1) + "\n")
    DOCUMENT.write_text(profiles.with_table(DOCUMENT.read_text(), "choices", table(record)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
