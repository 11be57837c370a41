#!/usr/bin/env python3
"""Tests `spangle profile --report`: its text, its JSON, and its page in a headless Chromium.

usage: page_test.py SPANGLE figures|scene|program [PAIR]

figures: a script here takes the place of the measurement, and its figures are known. scene, program: real images run in QEMU, of one of
Spangle's scenes and of glxgears under Xvfb on the drop-in pair PAIR. All: CMake and the tools of boards read the profile that was written,
and agree. Exit status 77 (skipped) when Chromium, or what builds and runs the images, is missing.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path[:0] = [str(ROOT / folder) for folder in ("boards/tools", "tests/support", "tests/tools/page", "tests/system/programs")]
import firmware  # noqa: E402
import profile  # noqa: E402
from checks import check, failures  # noqa: E402
from chromium import Page  # noqa: E402

SKIPPED = 77
# A script in place of measure.py. One key has figures in both builds, and each line and folder has a figure of its own.
FIGURES = """import json, sys
path = sys.argv[sys.argv.index("--out") + 1]
assert sys.argv[sys.argv.index("--size") + 1] == "96x64", sys.argv
key = {"pixels": 10, "instructions_a_pixel": 12.5}
build = lambda n: {"flash": 4000001 * n, "flash_of": {"raster/compile": 3000 * n, f"only/{n}": 7}, "ram": 20001 * n, "instructions": 900001 * n,
                   "ram_of": {"variables": 11 * n, "arena": 12 * n, "stack": 13 * n}, "frames": ["0a"], "keys": {}}
lines = [{"line": f"a&b.cpp:{n}", "command": "glEnd", "calls": n + 0.5, "instructions": 1000 * n} for n in (3, 2)]
json.dump({"board": "none", "whole": build(2), "profiled": build(1), "lines": lines, "same_bytes": True}, open(path, "w"))
"""
ROWS = """[...document.querySelectorAll("table")].map(table => [...table.rows].map(row => [...row.cells].map(cell => cell.textContent.trim())))"""


def missing(part):
    """Returns what is not installed."""
    wanted = ["chromium"] + (["Xvfb", "glxgears", "apitrace", "eglretrace"] if part == "program" else [])
    return [name for name in wanted if shutil.which(name) is None] + (firmware.missing(["cortex-m4"]) if part != "figures" else [])


def grouped(number):
    return f"{number:,}"


def figures_of(told):
    """Returns (what, whole, profiled) of each row that compares the two builds."""
    whole, profiled = told["firmware"]["whole"], told["firmware"]["profiled"]
    rows = [("flash, bytes", whole["flash"], profiled["flash"]), ("RAM beside the buffers, bytes", whole["ram"], profiled["ram"])]
    rows += [(f"of it {part}", whole["ram_of"][part], profiled["ram_of"][part]) for part in ("variables", "arena", "stack")]
    return [*rows, ("instructions of a frame", whole["instructions"], profiled["instructions"])]


def hold_page(page, folder, told):
    """Checks that a reader of the page sees what was measured."""
    html = page.read_text()
    check(not re.search(r"(src|href)=\"(?!data:)", html), "the page needs another file")
    with Page(shutil.which("chromium"), folder / "browser", 1000, 900) as browser:
        browser.open(page.as_uri())
        tables = browser.ask(ROWS)
        words = browser.ask("document.body.textContent")
        wide = browser.ask("document.querySelectorAll('.bar').length && Math.max(...[...document.querySelectorAll('.bar')].map(bar => bar.offsetWidth))")
        browser.screenshot(folder / "page.png")
        check(not browser.complaints, f"the page complains: {browser.complaints}")
    check((folder / "page.png").stat().st_size > 10000, "the picture of the page is empty")
    check(wide > 20, f"no bar is to be seen: {wide}")
    builds, folders, tiers, keys, lines = tables[:5]
    change = {what: f"{100 * (profiled - whole) / whole if whole else 0:+.1f} %" for what, whole, profiled in figures_of(told)}
    want = [[what, grouped(whole), grouped(profiled), change[what]] for what, whole, profiled in figures_of(told)]
    check(builds[1:] == want, f"builds are {builds[1:]}, measured were {want}")
    both = told["firmware"]["whole"]["flash_of"], told["firmware"]["profiled"]["flash_of"]
    want = [[room, *(grouped(flash.get(room, 0)) for flash in both)] for room in sorted(set(both[0]) | set(both[1]))]
    check([row[:3] for row in folders[1:]] == want, f"folders are {folders[1:]}, measured were {want}")
    check([row[0] for row in tiers[1:]] == [tier for tier in ("exact", "balanced", "fast") if tier in told["tiers"]], f"tiers are {tiers}")
    shown = [key for key in told["keys"] if key["pixels"] != 0 or key["fused"]]
    want = [[key["key"], grouped(key["pixels"]), "a loop of its own" if key["fused"] else "the chain"] for key in shown]
    check([[row[0], row[1], row[3]] for row in keys[1:]] == want, f"keys are {keys[1:]}, recorded were {want}")
    want = [[line["line"], line["command"], grouped(line["instructions"])] for line in told["firmware"]["lines"]]
    check([[row[0], row[1], row[3]] for row in lines[1:]] == want != [], f"lines are {lines[1:]}, measured were {want}")
    check("Both draw the same bytes." in words, "the page does not say that both draw the same bytes")
    check(all(feature in words for feature in told["features"]), f"systems are not all named: {told['features']}")
    ranges = {row[0]: row[1] for row in tables[-1][1:]}
    check(ranges == {name: str(most) for name, most in told["ranges"].items()}, f"ranges are {ranges}, reached were {told['ranges']}")


def hold_text(text, told):
    check("Both draw the same bytes." in text, f"the text does not say that both draw the same bytes: {text}")
    for what, whole, profiled in figures_of(told)[:1]:
        check(re.search(rf"\b{whole}\b.*\b{profiled}\b", text), f"the text has not {what}: {text}")


def hold_cmake(path, folder):
    """Checks that CMake takes the file, and builds with the definitions that the tools of boards read in it."""
    done = subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder / "cmake"), "-G", "Ninja", f"-DSPANGLE_PROFILE={path}", "-DSPANGLE_TESTS=OFF",
                           "-DSPANGLE_HOST=OFF", "-DSPANGLE_CLI=OFF", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"], capture_output=True, text=True)
    check(done.returncode == 0, f"CMake does not take the profile: {done.stderr[-2000:]}")
    if done.returncode != 0:
        return
    commands = {pathlib.Path(one["file"]).name: one["command"] for one in json.loads((folder / "cmake/compile_commands.json").read_text())}
    words = re.sub(r'[\\"]', "", commands["fragment_setup.cpp"]).replace("=//", "=/").split()
    lacking = [one for one in profile.definitions(str(path)) if "-D" + one.replace('"', "") not in words]
    check(not lacking, f"CMake builds without {lacking}: {words}")


def report(spangle, folder, words, environment):
    """Returns the report of one program as JSON. The page and the profile lie in the folder."""
    command = [spangle, "profile", "--tiers", "balanced", "--out", str(folder / "own.cmake"), "--report", str(folder / "page.html")]
    done = subprocess.run([*command, "--json", *words], capture_output=True, text=True, env=os.environ | environment)
    check(done.returncode == 0, f"{words} is not reported: {done.stdout[-1000:]}{done.stderr[-2000:]}")
    if done.returncode != 0:
        return None
    told = json.loads(done.stdout[done.stdout.index("{"):])
    check(told["firmware"]["same_bytes"], f"{words}: the profile draws other bytes: {told['firmware']}")
    hold_page(folder / "page.html", folder, told)
    hold_cmake(folder / "own.cmake", folder)
    return told


def figures(spangle, folder, _):
    stub = folder / "sources/host_sim/profile/firmware/measure.py"
    stub.parent.mkdir(parents=True)
    stub.write_text(FIGURES)
    words, environment = ["HUD", "--size", "96x64"], {"SPANGLE_SOURCES": str(folder / "sources")}
    told = report(spangle, folder, words, environment)
    if told is not None:
        check(any(not key["fused"] for key in told["keys"]), "no key is the chain's")
        done = subprocess.run([spangle, "profile", *words, "--tiers", "balanced", "--out", str(folder / "own.cmake"), "--report", str(folder / "page.html")],
                              capture_output=True, text=True, env=os.environ | environment)
        hold_text(done.stdout, told)


def cheaper(told):
    """Checks that a real profile makes the image smaller and faster."""
    whole, profiled = told["firmware"]["whole"], told["firmware"]["profiled"]
    check(profiled["flash"] < whole["flash"] / 2 and profiled["ram"] < whole["ram"], f"the profile saves little: {whole} {profiled}")
    check(len(told["firmware"]["lines"]) > 2, f"lines are missing: {told['firmware']['lines']}")


def scene(spangle, folder, _):
    told = report(spangle, folder, ["S3", "--frames", "2"], {})
    if told is not None:
        cheaper(told)


def program(spangle, folder, pair):
    from harness import spangle_environment, xvfb  # noqa: PLC0415
    with xvfb() as display:
        told = report(spangle, folder, ["--frames", "4", "--", "glxgears"], spangle_environment(pathlib.Path(pair), DISPLAY=display))
    if told is not None:
        cheaper(told)
        sides = told["ranges"]["SURFACE_WIDTH"], told["ranges"]["SURFACE_HEIGHT"]
        check(sides == (300, 300), f"the window of glxgears has {sides} pixels")
        check(told["firmware"]["profiled"]["buffers"] >= 300 * 300 * 4, f"the images draw on less: {told['firmware']['profiled']['buffers']} bytes")


def main():
    parts = {"figures": figures, "scene": scene, "program": program}
    if len(sys.argv) not in (3, 4) or sys.argv[2] not in parts:
        sys.exit(__doc__.strip())
    if absent := missing(sys.argv[2]):
        print(f"skipped: {', '.join(absent)} not installed (./dev setup --all, --programs and --page install them)")
        return SKIPPED
    with tempfile.TemporaryDirectory() as name:
        parts[sys.argv[2]](sys.argv[1], pathlib.Path(name), sys.argv[3] if len(sys.argv) == 4 else "")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
