#!/usr/bin/env python3
"""Draws every file of Debian's assimp-testmodels: docs/models.png shows those that are models, docs/models.md lists all.

usage: models.py SPANGLE [--check] [--models FOLDER]

--check writes nothing. It fails when a file makes spangle crash, hang, or print anything but one clear line. It also fails when
docs/models.md or docs/models.png is not what this build gives.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import outfile
import png

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODELS = pathlib.Path("/usr/share/assimp/models")
SHEET, LIST = ROOT / "docs/models.png", ROOT / "docs/models.md"
TILE, COLUMNS, BACKGROUND, INK = 40, 22, (32, 64, 99), (255, 255, 255)
TIMEOUT = 240  # most seconds for one file

# Kinds of files beside the models that are no models, by the ending of their names.
COMPANIONS = {
    "a picture": "bmp dds dib gif jpeg jpg ktx2 pcx png psd swatch tga tif tiff xcf",
    "text about models": "0 md pdf rtf source txt html",
    "materials, named by a model": "material mtl",
    "vertex data, named by a model": "bin",
    "a skeleton or animation, named by a model": "anim animation md5anim md5camera skeleton vrd",
    "a shader, named by a model": "frag fx glsl vert",
    "the source file of a modelling program that libassimp does not read": "c4d lxo max mb ma blend1 mbx wings skp",
}
KIND_OF = {ending: kind for kind, endings in COMPANIONS.items() for ending in endings.split()}

# The shapes of digits, 3x5 pixels each; an octal digit holds a row.
DIGITS = {"0": "75557", "1": "26227", "2": "71747", "3": "71717", "4": "55711", "5": "74717", "6": "74757", "7": "71111", "8": "75757", "9": "75717"}


class Outcome:
    """The result for one file: its picture, or the reason why there is none."""

    def __init__(self, name, done, shot):
        self.name, self.rows, self.reason, self.fault = name, None, None, None
        said = [line for line in done.stderr.splitlines() if line.startswith("spangle: ")]
        if done.returncode == 0:
            _, _, rows = png.read(shot.read_bytes())
            self.rows = rows if any(pixel != rows[0][0] for row in rows for pixel in row) else None
            self.reason = None if self.rows else f"drawn, but nothing of it meets a pixel of {TILE}x{TILE}"
        elif done.returncode == 2 and len(said) == 1 and not shot.exists():
            self.reason = reason_of(name, said[0])
        else:
            self.fault = f"{name}: exit status {done.returncode}: {done.stderr.strip()[-300:]}"


def reason_of(name, line):
    """Returns the reason why a file is not drawn, in the program's own words but without paths."""
    ending = name.rsplit(".", 1)[-1].lower() if "." in name.rsplit("/", 1)[-1] else "0"
    if ending in KIND_OF:
        return KIND_OF[ending]
    text = re.sub(r"^spangle: (cannot read )?model '[^']*':? ?", "", line)
    text = re.sub(r"/\S*/", "", text).strip()
    if text.startswith("No suitable reader found"):
        return "a format libassimp does not read"
    return f"{'libassimp: ' if 'cannot read' in line else ''}{text.rstrip('.')}"


def draw(spangle, folder, path, shots):
    name = str(path.relative_to(folder))
    shot = shots / (name.replace("/", "_") + ".png")
    command = [spangle, "run", "--model", str(path), "--size", f"{TILE}x{TILE}", "--dither", "off", "--frames", "1", "--shot", str(shot)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=TIMEOUT)
    except subprocess.TimeoutExpired:
        done = subprocess.CompletedProcess(command, -1, "", f"not done after {TIMEOUT} s")
    return Outcome(name, done, shot)


def draw_all(spangle, folder):
    files = sorted((p for p in folder.rglob("*") if p.is_file()), key=lambda p: str(p).lower())
    with tempfile.TemporaryDirectory() as shots, concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 2) as pool:
        return list(pool.map(lambda path: draw(spangle, folder, path, pathlib.Path(shots)), files))


def sheet(shown):
    """Returns the contact sheet: the pictures in rows of COLUMNS, each with its number."""
    height = (len(shown) + COLUMNS - 1) // COLUMNS * (TILE + 1) - 1
    rows = [[(255, 255, 255)] * (COLUMNS * (TILE + 1) - 1) for _ in range(height)]
    for n, outcome in enumerate(shown):
        left, top = n % COLUMNS * (TILE + 1), n // COLUMNS * (TILE + 1)
        for y in range(TILE):
            rows[top + y][left:left + TILE] = outcome.rows[y]
        for i, digit in enumerate(str(n + 1)):
            for y, bits in enumerate(DIGITS[digit]):
                for x in range(3):
                    if int(bits) & 4 >> x:
                        rows[top + 1 + y][left + 1 + 4 * i + x] = INK
    return rows


def document(outcomes):
    shown = [o for o in outcomes if o.rows]
    reasons = collections.defaultdict(list)
    for o in outcomes:
        if not o.rows:
            reasons[o.reason].append(o.name)
    out = ["# Models nobody here made", "",
           f"All {len(outcomes)} files of Debian's `assimp-testmodels`, each given to `spangle run --model` as it is: {len(shown)} are drawn, "
           f"{len(outcomes) - len(shown)} are not models or are broken, with the reason below. None crashes, hangs or needs more than 2 GiB.",
           "Made by `./dev models`; a slow test holds the list against what the program does.", "", "![contact sheet](models.png)", "", "## Shown", ""]
    by_folder = collections.defaultdict(list)
    for n, o in enumerate(shown):
        folder, _, leaf = o.name.rpartition("/")
        by_folder[folder].append(f"{n + 1} {leaf}")
    out += [f"* **{folder}**: {', '.join(names)}" for folder, names in by_folder.items()]
    out += ["", "## Not shown", ""]
    for reason, names in sorted(reasons.items(), key=lambda item: (-len(item[1]), item[0])):
        out.append(f"* **{reason}** ({len(names)}): {', '.join(names)}")
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("spangle")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--models", type=pathlib.Path, default=MODELS)
    options = parser.parse_args()
    if not options.models.is_dir():
        print(f"models: there is no {options.models}; install assimp-testmodels", file=sys.stderr)
        return 2
    outcomes = draw_all(options.spangle, options.models)
    faults = [o.fault for o in outcomes if o.fault]
    if faults:
        print("\n".join(faults))
        return 1
    text, shown = document(outcomes), [o for o in outcomes if o.rows]
    if options.check:
        if LIST.read_text() != text:
            print("docs/models.md is not what this build gives; run ./dev models")
            theirs, ours = LIST.read_text().splitlines(), text.splitlines()
            print("\n".join(["now: " + line for line in ours if line not in theirs] + ["then: " + line for line in theirs if line not in ours])[:2000])
            return 1
        if png.write(sheet(shown)) != SHEET.read_bytes():
            print("docs/models.png is not what this build draws; run ./dev models")
            return 1
    else:
        outfile.write(LIST, text)
        outfile.write(SHEET, png.write(sheet(shown)))
        print(f"{SHEET.relative_to(ROOT)} ({SHEET.stat().st_size // 1024} KiB), {LIST.relative_to(ROOT)}")
    print(f"{len(outcomes)} files: {len(shown)} drawn, {len(outcomes) - len(shown)} listed with their reason")
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
