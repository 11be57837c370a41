#!/usr/bin/env python3
"""Writes docs/trade-boards.md, which shows what each tier costs on each board, from the figures in tests/tools/trade/boards.

usage: boards.py SPANGLE check|write|measure

measure: builds images of PROGRAMS for every target, in the library's tiers and in one composed tier, runs them, and keeps the two tables
that `spangle trade` wrote. The first run takes an hour of a processor. write: writes the document's tables from the kept figures. check:
fails if the document has other tables, or if the kept figures no longer agree with other tests: with the accuracy of
tests/tools/trade/golden*.csv and, to within 5 %, with the instructions of tests/tools/bench/golden.json, whose library has all tiers.
"""
import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402

PAGE, KEPT = ROOT / "docs/trade-boards.md", HERE / "boards"
MODELS = pathlib.Path("/usr/share/assimp/models")
SCENES = ["S3", "S4r", "S7", "S9"]
TITLES = {"S3": "shaded quads", "S4r": "a rolled plane, NEAREST", "S7": "200 blended sprites",
          "S9": "a lit, textured torus in fog", "duck.dae": "a lit model with a LINEAR texture"}
MODEL_FILES = [MODELS / "Collada/duck.dae"]
OWN = ["fine=balanced,texel_bits=4,affine_texel_bits=4"]
TARGETS = ["m0plus", "m3", "m4", "rv32"]
TABLES = ("accuracy.csv", "cost.csv")
CORES = {"m0plus": "m0+", "m3": "m3", "m4": "m4"}  # the names in tests/tools/bench/golden.json
NEAR = 0.05


def fail(what):
    sys.exit(f"boards: {what}")


def measure(spangle):
    out = ROOT / "build/trade-boards"
    models, own = [word for file in MODEL_FILES for word in ("--model", str(file))], [word for tier in OWN for word in ("--tier", tier)]
    subprocess.run([sys.executable, ROOT / "tests/tools/bench/trade_firmware.py", *SCENES, *models, "--targets", ",".join(TARGETS), "--tiers", "exact,balanced,fast",
                    *own, "--used-spans", "--spangle", spangle, "--out", out / "images"], check=True, env={"JOBS": str(os.cpu_count()), **os.environ})
    subprocess.run([spangle, "trade", *SCENES, *models, *own, "--targets", ",".join(TARGETS), "--firmware", out / "images", "--no-times", "--frames", "2",
                    "--out", out / "trade"], check=True)
    KEPT.mkdir(exist_ok=True)
    for name in TABLES:
        outfile.write(KEPT / name, (out / "trade" / name).read_text())


def rows(path):
    with path.open() as file:
        return list(csv.DictReader(file))


def accuracy_rows():
    """Returns the kept rows of accuracy, with current figures from other tests in place of those that they hold."""
    held = {(row["scene"], row["tier"], row["format"]): row for name in ("golden.csv", "golden_models.csv") for row in rows(HERE / name)}
    own = ("job", "jobs", "frames", "dither", "size")
    return [row | {k: v for k, v in held.get((row["scene"], row["tier"], row["format"]), {}).items() if k in row and k not in own}
            for row in rows(KEPT / TABLES[0])]


def kept():
    """Returns [(row of accuracy.csv, row of cost.csv)]."""
    accuracy, cost = accuracy_rows(), rows(KEPT / TABLES[1])
    if [(row["scene"], row["tier"]) for row in accuracy] != [(row["scene"], row["tier"]) for row in cost]:
        fail(f"the tables of {KEPT} are not of one measurement")
    return list(zip(accuracy, cost))


def table(heads, lines, words=1):
    """Returns a table whose first `words` columns hold words and whose other columns hold numbers."""
    text = ["| " + " | ".join(heads) + " |", "|" + "---|" * words + "--:|" * (len(heads) - words)]
    return "\n".join(text + ["| " + " | ".join(line) + " |" for line in lines]) + "\n"


def instructions(found):
    return table(["program", "tier", "identical", "dB", *TARGETS],
                 [[a["scene"], a["tier"], f"{float(a['identical']):.2f} %", f"{float(a['psnr_565']):.1f}",
                   *(f"{float(c[f'{target}_per_pixel']):.1f}" for target in TARGETS)] for a, c in found], words=2)


def memory(found):
    return table(["program", "tier", *TARGETS],
                 [[c["scene"], c["tier"], *(f"{int(c[f'{target}_flash']) / 1024:.0f}, {int(c[f'{target}_ram']) / 1024:.1f}" for target in TARGETS)]
                  for _, c in found], words=2)


def programs(found):
    def of(scene):
        c = next(c for _, c in found if c["scene"] == scene)
        return [scene, TITLES[scene], f"{float(c['triangles']):,.0f}", f"{float(c['fragments']):,.0f}"]
    return table(["program", "what it draws", "triangles", "pixels"], [of(scene) for scene in dict.fromkeys(a["scene"] for a, _ in found)], words=2)


def advice(spangle):
    """Returns what `spangle trade` says of these figures. Pictures are not kept, so it draws no page."""
    with tempfile.TemporaryDirectory() as folder:
        part = pathlib.Path(folder) / "part"
        (part / "pictures").mkdir(parents=True)
        found = accuracy_rows()
        outfile.write_table(part / TABLES[0], [list(found[0]), *(list(row.values()) for row in found)])
        outfile.write(part / TABLES[1], (KEPT / TABLES[1]).read_text())
        said = subprocess.run([spangle, "trade", "merge", part, "--out", pathlib.Path(folder) / "out"], capture_output=True, text=True).stdout
    found = re.findall(r"^(\S+) +565 +take (\S+)\. (.*)$", said, re.M)
    if len(found) != len({row["scene"] for row in rows(KEPT / TABLES[0])}):
        fail(f"there is no advice: {said}")
    return table(["program", "take", "why"], found, words=3)


def document(spangle):
    found, text = kept(), PAGE.read_text()
    for name, made in {"programs": programs(found), "advice": advice(spangle), "instructions": instructions(found), "memory": memory(found)}.items():
        start, end = f"<!-- table: {name} -->\n", "<!-- end -->"
        before, there, after = text.partition(start)
        if not there:
            fail(f"{PAGE.name} has no table {name}")
        text = before + start + made + end + after.partition(end)[2]
    return text


def hold():
    """Checks that the kept counts are near those that other tests hold."""
    counts = json.loads((ROOT / "tests/tools/bench/golden.json").read_text())
    checked = 0
    for _, c in kept():
        for target, core in CORES.items():
            golden = counts.get(f"{core} {c['scene']} {c['tier']}")
            if golden is None:
                continue
            now, then = golden["instructions"], int(c[f"{target}_instructions"])
            checked += 1
            if abs(then - now) > NEAR * now:
                fail(f"{c['scene']}, {c['tier']} on {target}: {then} instructions when boards were measured, {now} now; `boards.py SPANGLE measure` measures anew")
    if checked < 3 * len(SCENES):
        fail(f"only {checked} counts are held")


def main():
    if len(sys.argv) != 3 or sys.argv[2] not in ("check", "write", "measure"):
        print(__doc__.strip())
        return 2
    spangle = pathlib.Path(sys.argv[1]).resolve()
    if sys.argv[2] == "measure":
        measure(spangle)
    text = document(spangle)
    if sys.argv[2] != "check":
        outfile.write(PAGE, text)
        return 0
    hold()
    if text != PAGE.read_text():
        fail(f"{PAGE.name} shows other figures than {KEPT.name}; `boards.py SPANGLE write` writes it anew")
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
