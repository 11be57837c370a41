#!/usr/bin/env python3
"""Measures what SPANGLE_SHORTCUTS 0 costs on an emulated Cortex-M4. For each profile with this setting it compares the setting with 1:
instructions of a frame, and the text of the scene's image.

usage: shortcuts.py [--build FOLDER] [--table]

Writes shortcuts.json, of which docs/profiles.md is made (--table rewrites that table alone).
"""
import argparse
import json
import pathlib
import sys
import tempfile

import profiles
from profiles import DOCUMENT, ROOT, SUBJECTS, TARGET, firmware, outfile, profile

sys.path.insert(0, str(ROOT / "tests/tools/bench"))
import mcu  # noqa: E402

RECORD = profiles.HERE / "shortcuts.json"
SCENES = {"first_slice": ("S3", "S6", "S7", "S9"), "whole": ("S3", "S5", "S6", "S9")}


class Programs(mcu.Programs):
    """The images of the bench, in a profile with this setting of SPANGLE_SHORTCUTS."""

    def __init__(self, name, shortcuts, folder):
        board, self.cpu = mcu.BOARDS["m4"]
        self.machine = ["qemu-system-arm", "-M", board.replace("_", "-")]
        self.script = ROOT / "boards" / board / "memory.ld"
        self.build = firmware.Build(folder)
        self.subject = SUBJECTS[name]
        says = dict(definition.split("=", 1) for definition in profile.definitions(name))
        self.defines = [f"-D{key}={value}" for key, value in (says | {"SPANGLE_SHORTCUTS": str(shortcuts)}).items()]
        self.library = [*self.build.library(TARGET, self.defines, "library", hot=profiles.HOT, lto=True),
                        *(self.build.compile(self.cpu, "-Os", path, lto=True) for path in firmware.startup(self.cpu))]

    def scene(self, scene):
        defines = [*self.defines, f"-DBENCH_SCENE={mcu.SCENES[scene]}", f"-DBENCH_PRECISION=EGL_PRECISION_{self.subject.precision}_SPANGLE", "-DBENCH_DITHERS=false"]
        own = self.build.compile(self.cpu, "-Os", ROOT / "tests/tools/bench/mcu_main.cpp", defines, scene, lto=True)
        return self.build.image(self.cpu, [own, *self.library], self.script, f"{scene}.elf", lto=True)


def measure(name, shortcuts, folder):
    """Returns {scene: Result}."""
    programs = Programs(name, shortcuts, folder / f"{name}_{shortcuts}")
    images = {scene: programs.scene(scene) for scene in SCENES[name]}
    programs.build.run()
    return {scene: mcu.count(programs, image) for scene, image in images.items()}


def table(record):
    rows = "".join(f"| {name} | {scene} | {with_:,} | {without:,} | {100 * (without - with_) / with_:+.1f} % | {less:+,} |\n"
                   for name, scene, with_, without, less in record)
    return "| profile | scene | instructions with shortcuts | without | difference | bytes of text |\n|---|---|--:|--:|--:|--:|\n" + rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, help="where objects go, and stay")
    parser.add_argument("--table", action="store_true", help="measures nothing")
    arguments = parser.parse_args()
    bad = []
    if not arguments.table:
        record = []
        with tempfile.TemporaryDirectory() as folder:
            for name in SCENES:
                without, with_ = (measure(name, setting, arguments.build or pathlib.Path(folder)) for setting in (0, 1))
                for scene, result in without.items():
                    other = with_[scene]
                    record.append((name, scene, other.instructions, result.instructions, result.text - other.text))
                    if other.picture != result.picture:
                        bad.append(f"{name}: {scene} is another picture without shortcuts")
        outfile.write(RECORD, json.dumps(record, indent=1) + "\n")
    outfile.write(DOCUMENT, profiles.with_table(DOCUMENT.read_text(), "shortcuts", table(json.loads(RECORD.read_text()))))
    print("\n".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
