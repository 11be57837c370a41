#!/usr/bin/env python3
"""Writes the tables of docs/accuracy.md, speed.md, memory.md, bands.md, boards.md and linux.md from what was measured, so that no number in them is
copied by hand.

usage: tables.py [--check] [--spangle PROGRAM]

Each table stands between <!-- table: NAME --> and <!-- end -->. accuracy, stages and bands are measured anew by the command line
(PROGRAM; without it they stay as they are), instructions come from tests/tools/bench/golden.json, speed and memory from
tests/tools/bench/measured.json, which `./dev bench --record` writes, optional systems from tests/tools/bench/features.json (tests/tools/bench/features.py). --check changes nothing and fails where a table claims more
than was measured: of errors by a factor of 2, of pixels by 0.05 %, of instructions by 0.1 million, of bytes of bands by 2 %; speed and memory must be the recorded ones.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/tools/bench"))
import goals  # noqa: E402

sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402

# The page of each table.
PAGES = {name: ROOT / "docs" / f"{page}.md" for page, names in {"accuracy": ("accuracy", "stages"), "speed": ("speed", "instructions", "changes"),
                                                               "memory": ("memory", "features"), "linux": ("transports",), "bands": ("bands",),
                                                               "boards": ("goals", "dithering")}.items() for name in names}
BENCH = ROOT / "tests/tools/bench"
TIERS = ("exact", "balanced", "fast")
FRAMES = 10
HEIGHTS = (1, 3, 8, 16, 240)  # heights of bands in rows; the last is the picture's


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|---" + "|--:" * (len(heads) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


class CommandLine:
    def __init__(self, program):
        self.program = str(pathlib.Path(program).resolve())

    def scenes(self):
        listed = subprocess.run([self.program, "scenes"], capture_output=True, text=True, check=True).stdout
        return [line.split()[0] for line in listed.splitlines()]

    def run(self, scene, precision, *words, where=("--size", "320x240"), dither="off"):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([self.program, "run", scene, "--precision", precision, "--dither", dither, "--frames", str(FRAMES), *where, "--json", *words],
                                  capture_output=True, text=True, check=True, cwd=folder)
        return json.loads(done.stdout)

    def bands(self, scene, height, how):
        """Returns the bytes of buffers, of depth and of the longest record, and the pictures."""
        found = self.run(scene, "balanced", "--band-height", str(height), "--bands", how, where=("--board", "ili9341"))
        return found["bands"], found["picture_hash"]


def accuracy(cli):
    """Measures every tier without GL_DITHER and with it, which is how GL begins."""
    rows = []
    for scene in cli.scenes():
        found = {(tier, dither): cli.run(scene, tier, "--compare", dither=dither) for tier in TIERS for dither in ("off", "on")}
        exact = found["exact", "off"]
        rows.append([scene, *(f"{r['identical_565_percent']:.4f} % ({r['max_lsb']})" for r in found.values()),
                     exact["coverage_mismatches"], f"{exact['coverage_unsnapped']} ({exact['coverage_snapping']})"])
    heads = [head for tier in TIERS for head in (tier, f"{tier}, dithered")]
    return table(["scene", *heads, "off brute force", "off unsnapped (by n.8 alone)"], rows)


def stages(cli):
    """Measures the stages over all scenes: the largest error, and the RMS of all values together."""
    total = {}
    for scene in cli.scenes():
        for tier, precision in zip(TIERS, ("shadow", "shadow-balanced", "shadow-fast")):
            for s in cli.run(scene, precision).get("stages", []):
                t = total.setdefault(s["stage"], {"unit": s["unit"]}).setdefault(tier, {"count": 0, "max": 0.0, "squares": 0.0})
                t["count"] += s["count"]
                t["max"] = max(t["max"], s["max"])
                t["squares"] += s["rms"] ** 2 * s["count"]
    order = [s["stage"] for s in cli.run("S9", "shadow")["stages"]]
    names = order + [name for name in total if name not in order]

    def cell(name, tier):
        t = total[name].get(tier)
        return "-" if t is None else f"{number(t['max'])}, {number(math.sqrt(t['squares'] / t['count']))}"

    def number(v):
        return f"{v:g}" if v == 0 or v >= 1 else f"2^{math.log2(v):.1f}"
    return table(["stage", "unit", *TIERS], [[name, total[name]["unit"], *(cell(name, tier) for tier in TIERS)] for name in names])


def bands(cli):
    """Measures for each height what every scene takes, and what its record takes beside. Every picture must be the same at all heights."""
    plain, rows = {}, []
    for scene in cli.scenes():
        records, pictures = set(), set()
        for height in HEIGHTS:
            for how in ("redraw", "record"):
                found, picture = cli.bands(scene, height, how)
                pictures.add((how, picture))
                plain.setdefault((how, height), set()).add((found["buffers"], found["planes"]))
                if how == "record":
                    records.add(found["record"])
        if len({picture for _, picture in pictures}) != 1 or len(records) != 1:
            raise SystemExit(f"{scene}: bands differ: {pictures}, records {records}")
        rows.append([scene, records.pop()])
    if any(len(found) != 1 for found in plain.values()):
        raise SystemExit(f"memory of bands depends on the scene: {plain}")
    sizes = {key: next(iter(found)) for key, found in plain.items()}
    of_height = [[h, *(f"{bytes_of:,}" for bytes_of in sizes["redraw", h]), f"{sum(sizes['redraw', h]):,}"] for h in HEIGHTS]
    of_scene = [[scene, f"{record:,}", *(f"{sum(sizes['record', h]) + record:,}" for h in HEIGHTS)] for scene, record in rows]
    return (table(["rows of a band", "colours", "depth", "redraw, any scene"], of_height) + "\n\n"
            + table(["scene", "its record", *(f"record, {h} rows" for h in HEIGHTS)], of_scene))


CORES = ("m4", "m3", "m0+")


def golden():
    """Returns {(core, scene, tier): what was counted}."""
    return {tuple(name.split()): entry for name, entry in json.loads((BENCH / "golden.json").read_text()).items()}


def counted():
    """Returns {(core, scene, tier): instructions of a frame}."""
    return {name: entry["instructions"] for name, entry in golden().items()}


def times(count, goal):
    return "-" if goal is None else f"{count / goal:.2f} x"


def instructions():
    """Returns the short table of the balanced tier's instructions."""
    counts = counted()
    rows = []
    for scene in goals.SCENES:
        cells = [f"{counts[core, scene, 'balanced'] / 1e6:.2f} ({times(counts[core, scene, 'balanced'], goals.instructions(core, scene, 'balanced'))})" for core in CORES]
        rows.append([scene, *cells])
    return table(["scene, balanced", "M4", "M3", "M0+"], rows)


def goals_met():
    """Returns every count with its goal and with the best other GL, and says which counts are above their goal."""
    counts, rows, above, slower = counted(), [], [], []
    wanted = 0
    for scene in goals.SCENES:
        for tier in TIERS:
            row = [f"{scene} {tier}"]
            for core in CORES:
                count, goal = counts[core, scene, tier], goals.instructions(core, scene, tier)
                row += [f"{count / 1e6:.3f}", "-" if goal is None else f"{goal / 1e6:.3f}", times(count, goal)]
                wanted += goal is not None
                if goal is not None and count > goals.WITHIN * goal:
                    above.append(f"{scene} {tier} on {core.upper()} ({times(count, goal)})")
            peer = goals.peer(scene, tier)
            row += ["-" if peer is None else f"{peer / 1e6:.3f}", times(counts["m3", scene, tier], peer)]
            if peer is not None and counts["m3", scene, tier] > peer:
                slower.append(f"{scene} {tier}")
            rows.append(row)
    heads = [head for core in CORES for head in (core.upper(), "goal", "of it")]
    said = (f"{wanted - len(above)} of {wanted} within {goals.WITHIN} of their goals; above: {', '.join(above) or 'none'}. "
            f"Above the best peer without an FPU: {', '.join(slower) or 'none'}.")
    return table(["scene, tier", *heads, "peer, M3", "of it"], rows) + "\n\n" + said


def dithering():
    """Returns what GL_DITHER takes more for each stored fragment. For clears and flat fills it is the whole frame and its goal."""
    counts, budget, rows, above = golden(), goals.ALL["dither"], [], []
    for scene in goals.SCENES:
        for tier in TIERS:
            row = [f"{scene} {tier}", f"{counts['m4', scene, tier]['fragments']:,}"]
            for core in CORES:
                entry, goal = counts[core, scene, tier], goals.instructions(core, scene, tier)
                if scene in goals.FLAT:
                    row.append(f"{entry['dithered'] / 1e6:.3f} M, {times(entry['dithered'], goal)}")
                    continue
                more = goals.dithering(entry)
                row.append(f"{more:+.1f}")
                if more > budget[core]:
                    above.append(f"{scene} {tier} on {core.upper()} ({more:+.1f})")
            rows.append(row)
    heads = [f"{core.upper()}, at most +{budget[core]}" for core in CORES]
    return table(["scene, tier", "fragments", *heads], rows) + f"\n\nAbove: {', '.join(above) or 'none'}."


def measured():
    path = BENCH / "measured.json"
    return json.loads(path.read_text()) if path.exists() else None


def speed():
    found = measured()
    if found is None:
        return "`./dev bench --record` has not been run yet."
    rows = []
    for scene, sizes in found["scenes"].items():
        small, large = sizes["320x240"], sizes["800x480"]
        targets = [goals.speed(scene, tier) for tier in TIERS]
        rows.append([scene, f"{small['llvmpipe_us']:.0f} us", *(f"{small[tier]:.2f}" for tier in TIERS), " \\| ".join(str(t or "-") for t in targets),
                     f"{100 * small['scatter']:.0f} %", f"{small['dither']:.2f} x", f"{large['balanced']:.2f}"])
    return f"{found['host']}\n\n" + table(["scene", "llvmpipe", *TIERS, "goals", "+-", "dithered", "800x480, balanced"], rows)


def memory():
    found = measured()
    if found is None:
        return "`./dev bench --record` has not been run yet."
    rows = [[scene, *(f"{sizes['320x240'][kind]:,}" for kind in ("context", "surface", "peak")), f"{sizes['320x240']['process'] / 1e6:.1f} MB",
             f"{sizes['320x240']['llvmpipe_process'] / 1e6:.1f} MB"] for scene, sizes in found["scenes"].items()]
    return table(["scene", "context", "surface", "most in all", "process", "llvmpipe's process"], rows)


def changes():
    """Returns what changes of state cost, as `./dev bench changes --update-golden` kept it."""
    path = BENCH / "changes.json"
    if not path.exists():
        return "`./dev bench changes --update-golden` has not been run yet."
    found = json.loads(path.read_text())
    rows = [[change, *(f"{of[how]:,}" for how in ("unlit", "lit", "textured"))] for change, of in found.items()]
    return table(["changed", "unlit", "one light", "one texture"], rows)


def features():
    """Returns what each optional system costs, sorted by the bytes of code on the smallest target."""
    path = BENCH / "features.json"
    if not path.exists():
        return "`python3 tests/tools/bench/features.py` has not been run yet."
    found = json.loads(path.read_text())
    order = sorted(found["Cortex-M0+"], key=lambda name: -found["Cortex-M0+"][name]["text"])
    rows = [["all of gl/" if name == "everything" else f"`{name}`",
             *(f"{found[target][name][kind]:,}" if name in found[target] else "-" for target in found for kind in ("text", "context"))] for name in order]
    return table(["feature", *(f"{target}, {kind}" for target in found for kind in ("code", "context"))], rows)


def transports():
    """Returns what `./dev bench hal --record` kept: means over the frames of a scene."""
    def cells(r):
        wire, cpu = r["wire_us"], r["cpu_us"]
        serial = "MHz" in r["transport"]  # only for these buses does the model know how long the wire takes
        return [r["transport"], r["scene"], f"{r['bytes']:,}", f"{1e6 / wire:.0f}" if serial else "-", f"{cpu / 1000:.2g} ms" if cpu >= 1000 else f"{cpu:.0f} us",
                f"{100 * cpu / wire:.1f} %" if serial else "-"]
    return table(["transport", "scene", "bytes a frame", "frames/s of the wire", "processor a frame", "share of it"],
                 [cells(r) for r in json.loads((BENCH / "hal.json").read_text())])


def refreshed(text, name, content):
    """Returns the page with this table in place."""
    pattern = re.compile(rf"(<!-- table: {name} -->\n).*?(\n<!-- end -->)", re.S)
    if len(pattern.findall(text)) != 1:
        raise SystemExit(f"{page_of(name).name} has not one place for the table '{name}'")
    return pattern.sub(lambda match: match.group(1) + content + match.group(2), text)


NUMBER = re.compile(r"2\^(-?[\d.]+)|([\d.]+) %|(\d[\d.,]*)")


# By how much a table may claim more than is measured: an exponent, a percentage, a count or step; or a share of the claimed figure.
SLACK = {"accuracy": (1.0, 0.05, 2.0), "stages": (1.0, 0.05, 2.0), "instructions": (0.0, 0.0, 0.1), "goals": (0.0, 0.0, 0.1), "dithering": (0.0, 0.0, 0.3), "bands": (0.0, 0.0, 0.0)}
PART = {"bands": 0.02}


def value(text):
    return float(text.replace(",", "") or 0)


def too_good(name, old, new):
    """Returns whether the table claims more than was measured, or has other rows."""
    if name not in SLACK:
        return old != new
    old, new = ("\n".join(line for line in text.splitlines() if line.startswith("|")) for text in (old, new))
    if NUMBER.sub("#", old) != NUMBER.sub("#", new):
        return True
    for claimed, found in zip(NUMBER.findall(old), NUMBER.findall(new)):
        for kind, (a, b) in enumerate(zip(claimed, found)):
            gain = value(b) - value(a) if kind != 1 else value(a) - value(b)
            if (a == "") != (b == "") or gain > SLACK[name][kind] + PART.get(name, 0) * value(a):
                return True
    return False


def standing(text, name):
    return re.search(rf"<!-- table: {name} -->\n(.*?)\n<!-- end -->", text, re.S).group(1)


def page_of(name):
    return PAGES[name]


def recorded():
    """Returns the tables that need no program."""
    return {"instructions": instructions(), "changes": changes(), "speed": speed(), "memory": memory(), "features": features(), "transports": transports(), "goals": goals_met(), "dithering": dithering()}


def write(contents):
    for name, content in contents.items():
        outfile.write(page_of(name), refreshed(page_of(name).read_text(), name, content))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--spangle")
    arguments = parser.parse_args()
    contents = recorded()
    if arguments.spangle is not None:
        cli = CommandLine(arguments.spangle)
        contents |= {"accuracy": accuracy(cli), "stages": stages(cli), "bands": bands(cli)}
    if not arguments.check:
        write(contents)
        return 0
    good = True
    for name, content in contents.items():
        old = standing(page_of(name).read_text(), name)
        if old == content:
            continue
        worse = too_good(name, old, content)
        print(f"{page_of(name).name}: the table '{name}' is {'not' if worse else 'less than'} what was measured; `./dev tables` writes it:\n{content}")
        good = good and not worse
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
