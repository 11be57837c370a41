#!/usr/bin/env python3
"""Builds programs as firmware for an emulated Cortex-M4, with the whole library and in their recorded profiles. Both must draw the same
bytes, and the profile must take less of everything. The figures are recorded in measured.json, of which docs/profiles.md has a table.

usage: firmware.py PROFILE_OF SPANGLE [--record] [--build FOLDER] PROGRAM...
       firmware.py --page

PROGRAM is one of programs/, a scene, or a trace. With --record the figures are recorded; otherwise the recorded figures must still be true.
--page measures nothing, and compares the table of the page with the record. Exit status 77 (skipped) when a compiler, the emulator or
apitrace is missing.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path[:0] = [str(ROOT / "boards/tools"), str(ROOT / "tests/support"), str(ROOT / "tests/tools/profiles")]
import firmware  # noqa: E402
from checks import check, failures  # noqa: E402
from firmware import outfile  # noqa: E402

TOOL, RECORD, DOCUMENT = ROOT / "host_sim/profile/firmware/measure.py", HERE / "measured.json", ROOT / "docs/profiles.md"
TIER, SKIPPED = "balanced", 77
FIRST, END = 1, 5  # the frames of programs that are counted; profile_of records the same
TRACES = {"imgui": ROOT / "tests/system/programs/traces/imgui.trace", "xs-gears": ROOT / "tests/system/programs/traces/xs-gears.trace", "cage": HERE / "traces/cage.trace"}
# What the page says of the ten programs that it names.
TEN = {"gouraud_cube": "a cube with a colour in each corner", "sprites_only": "sprites, blended", "lit_parallel": "lit, without textures, in parallel",
       "lit_perspective": "lit, without textures, in perspective", "HUD": "needles, numbers and lines", "terrain_fog": "terrain in fog",
       "particles": "particles that add up", "imgui": "a page of Dear ImGui (trace)", "xs-gears": "gears of xscreensaver (trace)", "cage": "cage of xscreensaver (trace)"}
FIGURES = ("flash", "ram", "instructions")
DRIFT = 0.03  # share of a figure by which other changes may move it before it is recorded again


def words_of(name):
    """Returns the words that name the program to measure.py."""
    if name in TRACES:
        return ["--trace", str(TRACES[name]), "--first", "1", "--end", "4"]
    if name in firmware.SCENES:
        named = ["--scene", name]
    else:
        sources = [path for path in sorted((HERE / "programs").glob("*.cpp")) if path.name == "ball.cpp" or re.search(rf"const Program {name}\{{", path.read_text())]
        named = ["--program", f"spangle::programs::{name}", "--header", "tests/tools/profile/programs/program.hpp", "--source", *map(str, sources)]
    return [*named, "--first", str(FIRST), "--end", str(END)]


def record_words(tools, name, path):
    if name in TRACES:
        return [tools.spangle, "profile", "--trace", str(TRACES[name]), "--frames", "4", "--tiers", TIER, "--out", str(path)]
    return [tools.profile_of, name, TIER, str(path)]


def holds_host(name, said, told):
    """Checks that firmware draws what this machine draws, and counts for each state key what was recorded here."""
    frames = re.findall(r"^frame ([0-9A-F]+)$", said, re.M)
    check([int(frame, 16) for frame in told["profiled"]["frames"][1:]] == [int(frame, 16) for frame in frames],
          f"{name}: the board draws {told['profiled']['frames']}, this machine {frames} from the second on")
    pixels = {}
    for count, key in re.findall(r"^key ([0-9]+) (.+)$", said, re.M):
        if int(count) != 0:
            pixels[key] = pixels.get(key, 0) + int(count)
    for build in ("whole", "profiled"):
        counted = {key: one["pixels"] * (END - FIRST) for key, one in told[build]["keys"].items()}
        check(set(counted) == set(pixels) and all(abs(counted[key] - count) <= END - FIRST for key, count in pixels.items()),
              f"{name}, {build}: pixels of state keys are {counted}, recorded were {pixels}")


def holds(name, told):
    whole, profiled, lines = told["whole"], told["profiled"], told["lines"]
    check(told["same_bytes"], f"{name}: the profile draws {profiled['frames']}, the whole library {whole['frames']}")
    check(profiled["flash"] < whole["flash"] and profiled["ram"] < whole["ram"], f"{name}: the profile takes no less")
    check(profiled["instructions"] < whole["instructions"] * 1.02, f"{name}: the profile is slower")
    # The lines take nearly all of the frame; the rest belongs to the program itself.
    share = sum(line["instructions"] for line in lines) / profiled["instructions"]
    check(0.5 < share < 1.02, f"{name}: its lines cost {share:.2f} of the frame")
    place = rf"^{re.escape(TRACES[name].name)}:\d+$" if name in TRACES else r"\.(cpp|hpp):\d+$"
    strange = [line for line in lines if not re.search(place, line["line"]) or not line["command"].startswith("gl")]
    check(not strange, f"{name}: {strange[:5]}")
    if name not in TRACES:
        check(sum(profiled["flash_of"].values()) == profiled["flash"], f"{name}: the folders do not add up")
    spent = sum(key["pixels"] * key["instructions_a_pixel"] for key in profiled["keys"].values())
    check(0 < spent < profiled["instructions"], f"{name}: pixels take {spent:.0f} of {profiled['instructions']} instructions")


def row_of(told):
    return {build: {figure: told[build][figure] for figure in FIGURES} for build in ("whole", "profiled")} | {"same_bytes": told["same_bytes"]}


def holds_record(name, row):
    written = json.loads(RECORD.read_text()).get(name)
    if written is None:
        return
    moved = [f"{build} {figure} {written[build][figure]} to {row[build][figure]}" for build in ("whole", "profiled") for figure in FIGURES
             if abs(row[build][figure] - written[build][figure]) > DRIFT * written[build][figure]]
    check(not moved, f"{name}: recorded figures moved: {'; '.join(moved)}; firmware.py --record {name} writes them anew")


def table(record):
    rows = "".join(f"| {text} | {' | '.join(f'{record[name][build][figure]:,}' for build in ('whole', 'profiled') for figure in FIGURES)} | "
                   f"{'yes' if record[name]['same_bytes'] else 'NO'} |\n" for name, text in TEN.items())
    return ("| program | flash, whole | RAM | instructions | flash, profile | RAM | instructions | same bytes |\n|---|--:|--:|--:|--:|--:|--:|---|\n" + rows)


def page():
    record = json.loads(RECORD.read_text())
    check(set(TEN) <= set(record), f"measured.json lacks {set(TEN) - set(record)}")
    if set(TEN) <= set(record):
        check(f"<!-- table: ten -->\n{table(record)}<!-- end -->" in DOCUMENT.read_text(), "the table of docs/profiles.md is not that of measured.json")
        check(all(record[name]["same_bytes"] for name in TEN), "some profile draws other bytes")
    return 1 if failures else 0


def write(rows):
    record = (json.loads(RECORD.read_text()) if RECORD.is_file() else {}) | rows
    outfile.write(RECORD, json.dumps(dict(sorted(record.items())), indent=1) + "\n")
    if set(TEN) <= set(record):
        import profiles  # noqa: PLC0415
        outfile.write(DOCUMENT, profiles.with_table(DOCUMENT.read_text(), "ten", table(record)))


def measure(tools, name, folder):
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{name}.cmake"
    recorded = subprocess.run(record_words(tools, name, path), capture_output=True, text=True)
    check(recorded.returncode == 0, f"{name} is not recorded: {recorded.stdout}{recorded.stderr}")
    if recorded.returncode != 0:
        return
    built = ["--build", str(folder / f"{name}_build")] if tools.build else []
    done = subprocess.run([sys.executable, str(TOOL), str(path), "--tier", TIER, *words_of(name), *built], capture_output=True, text=True)
    check(done.returncode == 0, f"{name} is not measured: {done.stderr[-3000:]}")
    if done.returncode != 0:
        return
    told = json.loads(done.stdout)
    row = row_of(told)
    print(f"{name}: {row}; dearest: {told['lines'][:1]}", flush=True)
    before = len(failures)
    holds(name, told)
    if name not in TRACES:
        holds_host(name, recorded.stdout, told)
    if not tools.record:
        holds_record(name, row)
    elif len(failures) == before:
        write({name: row})


def main():
    if sys.argv[1:] == ["--page"]:
        return page()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("profile_of")
    parser.add_argument("spangle")
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--build", type=pathlib.Path, help="where profiles and objects go, and stay")
    parser.add_argument("programs", nargs="+", metavar="PROGRAM")
    tools = parser.parse_args()
    missing = firmware.missing(["cortex-m4"]) + [tool for tool in ("apitrace", "eglretrace") if set(tools.programs) & set(TRACES) and shutil.which(tool) is None]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs them)")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        for name in tools.programs:
            measure(tools, name, tools.build or pathlib.Path(folder))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
