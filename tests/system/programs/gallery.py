#!/usr/bin/env python3
"""Runs screen savers and programs of toolkits (programs_list.py) with the drop-in pair, and compares them with Mesa.

usage: gallery.py [--build BUILD] [--only EXPRESSION]
       gallery.py [--build BUILD] --check PARTS
       gallery.py [--build BUILD] --sheet

Each program runs under Xvfb for some frames, must end by itself and show more than one colour. Its calls are recorded by apitrace
and replayed by Spangle and by Mesa's softpipe and llvmpipe. No error of GL may be Spangle's alone, and the pictures must agree. Where
they differ and something is antialiased, they are compared again without that.
gallery.csv gets a line for each program that was run and keeps those of the others. --only runs the programs whose names the regular
expression finds. --check leaves the table alone and fails where a program gets a worse verdict than its line has; of the lines it
takes one in PARTS, other ones with each commit. --sheet draws docs/pictures/programs.png: some of the programs on the glass of a panel.
The same program draws the same frames in each run, whatever the machine's speed (same_run.c). BUILD is a build folder, build/host
unless given.
"""
import argparse
import collections
import csv
import os
import pathlib
import re
import sys
import tempfile

from harness import (HERE, ORACLES, SKIPPED, Picture, check, difference, failures, folder, mesa_environment, need, outfile, png, replay,
                     run, some_frames, spangle_environment, turn, without_refused_contexts, without_smoothing, xvfb)
from programs_list import HACKS, KNOWN, SHEET, every

ROOT = HERE.parents[2]
MADE = ROOT / "build/gallery"
TABLE, PICTURE, PAGE = HERE / "gallery.csv", ROOT / "docs/pictures/programs.png", ROOT / "docs/programs.md"
COLUMNS = ("program", "suite", "verdict", "reason")
# Frames of a run, and sizes of windows. A program that shows one colour is run again for longer, at last in a window of its own size.
STARTS, SECONDS = ((20, "320x240"), (100, "320x240"), (400, "320x240"), (20, None), (400, None)), 120
PICTURES = 10  # pictures of a replay that are compared
PAIR = ("libGL.so.1", "libEGL.so.1", "libOpenGL.so.0", "libGLX.so.0")
TRIES = 2  # runs of a program: events of X come at their own time, and a helper may be late
# Verdicts that tell nothing about Spangle, because they come of a machine that is busy. A check accepts them on any line.
EMPTY, SLOW = "draws nothing", "Mesa takes too long"
DIFFER, SMOOTH = "pictures differ", "smooth edges differ"
LEAST_DRAWN = 0.1  # percentage of pixels that must not have the commonest colour
SAVER_SETTINGS = {"textMode": "literal", "textLiteral": "Words for savers that show some.", "chooseRandomImages": True,
                  "grabDesktopImages": False, "grabVideoFrames": False, "imageDirectory": PICTURE.parent}
BOARD, SHEET_FRAMES, ACROSS, GAP, PAPER, MOST_BYTES = "ili9341", 60, 4, 8, (255, 255, 255), 400_000


def build(source, *flags):
    """Compiles a file of this folder, or of any folder by its whole path. Returns the program or library, which has the file's first name.
    """
    MADE.mkdir(parents=True, exist_ok=True)
    made = MADE / pathlib.Path(source).stem
    ended = run(["c++" if str(source).endswith("pp") else "cc", "-O1", HERE / source, "-o", made, *flags], dict(os.environ))
    if ended.status != 0:
        sys.exit(f"{source} is not built: {ended.words[-1000:]}")
    return made


def build_imgui():
    """Returns the program with Dear ImGui, or None where its headers are missing."""
    flags = run(["pkg-config", "--cflags", "--libs", "imgui", "glfw3", "sdl2", "gl"], dict(os.environ))
    return build("imgui_demo.cpp", *flags.words.split()) if flags.status == 0 else None


def environment_of(base, display, home):
    """Returns the variables of a home without sound, where SDL draws by OpenGL and the clock goes the same way in each run. Savers find
    there the programs that give them pictures and words: a child that finds none ends, and writes into its parent's trace.
    """
    (home / ".asoundrc").write_text("pcm.!default { type null }\nctl.!default { type null }\n")
    outfile.write(home / ".xscreensaver", "".join(f"{name}: {value}\n" for name, value in SAVER_SETTINGS.items()))
    return base | {"DISPLAY": display, "HOME": str(home), "PATH": f"/usr/local/bin:/usr/bin:/bin:/usr/games:{HACKS}",
                   "SDL_RENDER_DRIVER": "opengl", "SDL_AUDIODRIVER": "dummy", "LD_PRELOAD": str(MADE / "same_run")}


def drawn(picture):
    """Returns the number of colours in a picture, and the percentage of pixels that do not have the commonest colour."""
    count = collections.Counter(pixel for row in picture.rows for pixel in row)
    return len(count), 100 - 100 * max(count.values()) / sum(count.values())


def errors(words):
    """Returns the number of errors of GL that the retracer reported."""
    return len(re.findall(r"GL_INVALID_\w+|GL_STACK_\w+|GL_OUT_OF_MEMORY", words))


def last_line(words):
    return (words.strip().splitlines() or [""])[-1][:200]


def last_drawn(pictures, window):
    """Returns the number of the last picture whose window shows something, or of the last picture if none does."""
    empty = set()
    for at in range(len(pictures) - 1, -1, -1):
        file = pictures[at].read_bytes()
        if file not in empty and drawn(Picture(pictures[at], window))[1] >= LEAST_DRAWN:
            return at
        empty.add(file)
    return len(pictures) - 1


def compare_frames(place, pair, trace, window):
    """Replays a trace by all GLs and compares two frames of its window. Returns the verdict and its reason."""
    frames = some_frames(trace, PICTURES)
    ours, ended = replay(trace, spangle_environment(pair), place / "spangle", SECONDS, frames)
    theirs = {o: replay(trace, mesa_environment(o, "1.5"), place / o, SECONDS, frames) for o in ORACLES}
    late = [o for o, (_, by) in theirs.items() if by.status is None]
    if late:
        return SLOW, f"{late[0]} does not end within {SECONDS} s"
    for name, (pictures, by) in {"Spangle": (ours, ended), **theirs}.items():
        if by.status != 0 or not pictures:
            return "replay fails", f"eglretrace with {name} ends with {by.status}: {last_line(by.words)}"
    if any(len(pictures) != len(ours) for pictures, _ in theirs.values()):
        return "replay fails", "the numbers of frames differ"
    seen, least = errors(ended.words), min(errors(e.words) for _, e in theirs.values())
    if seen > least:
        return "errors", f"{seen} errors of GL; Mesa has {least}"
    last = last_drawn(theirs[ORACLES[-1]][0], window)
    for at in sorted({last // 2, last}):
        mine, pictures = Picture(ours[at], window), [Picture(p[at], window) for p, _ in theirs.values()]
        if any((p.width, p.height) != (mine.width, mine.height) for p in pictures):
            return DIFFER, "their sizes differ"
        off, allowed = difference(mine, pictures)
        if off > allowed:
            return DIFFER, f"{off:.3f} % of the pixels differ; {allowed:.3f} % may"
    if max(drawn(p)[1] for p in (mine, *pictures)) < LEAST_DRAWN:
        return EMPTY, f"Mesa's replays have one colour, too, in each of {len(ours)} frames"
    return "passes", ""


def compare(place, pair, trace, window):
    """Compares the frames of a trace. If they differ and something is antialiased, they are compared without antialiasing, too: Spangle
    computes what a smooth point or line covers, as GL wants, and Mesa estimates it.
    """
    verdict, reason = compare_frames(place, pair, trace, window)
    if verdict != DIFFER:
        return verdict, reason
    plain = without_smoothing(trace, place / "plain.trace")
    if plain == trace:
        return verdict, reason
    (place / "plain").mkdir(exist_ok=True)
    if compare_frames(place / "plain", pair, plain, window)[0] != "passes":
        return verdict, reason
    return SMOOTH, f"{reason}; without GL_POINT_SMOOTH, GL_LINE_SMOOTH and GL_POLYGON_SMOOTH they agree"


def shown(program, environment, place):
    """Runs a program until it shows something. Returns the variables for that and, if the program fails, a verdict and its reason."""
    starts = [{"SPANGLE_FRAMES": str(frames)} | ({"SPANGLE_SIZE": size} if size else {}) for frames, size in STARTS]
    for start in starts:
        picture = place / "live.png"
        ended = run(program.command, environment | start | {"SPANGLE_SHOT": str(picture)}, SECONDS, program.folder or environment["HOME"])
        if ended.status is None:
            break
        if ended.status != 0:
            return start, "does not run", f"ends with {ended.status}: {last_line(ended.words)}"
        if not picture.exists():
            return start, "does not run", "ends before it draws"
        if drawn(Picture(picture))[1] >= LEAST_DRAWN:
            return start, "", ""
    return starts[0], "", ""


def judge(program, pair, display, place):
    """Runs a program, records it and replays it. Returns the verdict and its reason."""
    with tempfile.TemporaryDirectory() as home:
        environment = environment_of(spangle_environment(pair), display, pathlib.Path(home))
        start, verdict, reason = shown(program, environment, place)
        if verdict:
            return verdict, reason
        trace, picture = place / "calls.trace", place / "recorded.png"
        ended = run(["apitrace", "trace", "-a", program.api, "-o", trace, *program.command],
                    environment | start | {"SPANGLE_SIGNAL": "1", "SPANGLE_SHOT": str(picture)}, SECONDS, program.folder or home)
        if ended.status is None or not trace.exists() or not picture.exists():
            return "is not recorded", f"apitrace ends with {ended.status}: {last_line(ended.words)}"
    recorded = Picture(picture)
    return compare(place, pair, without_refused_contexts(trace, place / "played.trace"), (recorded.width, recorded.height))


def read_table():
    if not TABLE.exists():
        return {}
    with TABLE.open(newline="") as lines:
        return {row["program"]: row for row in csv.DictReader(lines)}


def counts(rows):
    """Returns the page's table of how many programs of each suite pass."""
    suites = collections.Counter(row["suite"] for row in rows.values())
    passes = collections.Counter(row["suite"] for row in rows.values() if row["verdict"] == "passes")
    lines = [f"| {suite} | {passes[suite]} | {suites[suite] - passes[suite]} |" for suite, _ in suites.most_common()]
    return "\n".join(["| suite | pass | do not pass |", "|---|---|---|", *lines]) + "\n"


def page_with(rows):
    """Returns the page with the counts of these rows."""
    before, _, rest = PAGE.read_text().partition("<!-- counts -->\n")
    _, _, after = rest.partition("<!-- end -->")
    check(after, f"{PAGE.name} has no place for the counts")
    return before + "<!-- counts -->\n" + counts(rows) + "<!-- end -->" + after


def write_table(rows):
    """Returns the lines of the table by suite and name, and what the page says of them."""
    outfile.write(PAGE, page_with(rows))
    ordered = sorted(rows.values(), key=lambda row: (row["suite"], row["program"]))
    outfile.write_table(TABLE, [COLUMNS, *([row[column] for column in COLUMNS] for row in ordered)])


def row_of(program, verdict, reason):
    """Returns a line of the table. For a program that does not pass, it has what was measured and what is known about it."""
    known = "" if verdict in ("passes", SMOOTH) else "; " + KNOWN.get(program.name, "unexplained")
    return {"program": program.name, "suite": program.suite, "verdict": verdict, "reason": reason + known}


def run_programs(pair, programs):
    """Runs programs one by one, and writes the table after each, so that a run may be stopped."""
    rows = read_table()
    with xvfb() as display:
        for program in programs:
            with folder("gallery-" + program.name) as place:
                rows[program.name] = row_of(program, *judge(program, pair, display, place))
            write_table(rows)
            print(*rows[program.name].values(), sep=", ", flush=True)
    print(dict(collections.Counter(row["verdict"] for row in rows.values())))


def check_part(pair, programs, parts):
    """Judges one in `parts` of the table's lines again, other lines with each commit. A program that is not installed fails, too."""
    check(PAGE.read_text() == page_with(read_table()), f"{PAGE.name} counts others than {TABLE.name} has")
    known = {program.name: program for program in programs}
    with xvfb() as display:
        for row in list(read_table().values())[turn() % parts::parts]:
            name = row["program"]
            if name not in known:
                check(False, f"{name} is not installed; ./dev setup --gallery installs it")
                continue
            for _ in range(TRIES):
                with folder("gallery-" + name) as place:
                    verdict, reason = judge(known[name], pair, display, place)
                if verdict in (row["verdict"], "passes"):
                    break
            check(verdict in (row["verdict"], "passes", EMPTY, SLOW),
                  f"{name} had the verdict '{row['verdict']}' and has '{verdict}' now: {reason}")
            print(name, verdict, sep=", ", flush=True)


def glass(spangle, program, display):
    """Returns the rows of pixels that a panel shows of a program."""
    with tempfile.TemporaryDirectory() as home:
        picture = pathlib.Path(home) / "glass.png"
        environment = environment_of(spangle_environment(""), display, pathlib.Path(home))
        del environment["LD_LIBRARY_PATH"]
        ended = run([spangle, "exec", "--board", BOARD, "--frames", SHEET_FRAMES, "--shot", picture, "--", *program.command],
                    environment, SECONDS, program.folder or home)
        if ended.status != 0 or not picture.exists():
            sys.exit(f"{program.name}: ends with {ended.status}: {ended.words[-500:]}")
        print(program.name, flush=True)
        return Picture(picture).rows


def draw_sheet(spangle, programs):
    """Draws the contact sheet: the glasses of all panels side by side, in their own size."""
    known = {program.name: program for program in programs}
    missing = [name for name in SHEET if name not in known]
    if missing:
        sys.exit(f"{', '.join(missing)}: not installed; ./dev setup --gallery installs them")
    with xvfb() as display:
        pictures = [glass(spangle, known[name], display) for name in SHEET]
    rows = []
    for begin in range(0, len(pictures), ACROSS):
        if rows:
            rows += [[PAPER] * len(rows[0])] * GAP
        for lines in zip(*pictures[begin:begin + ACROSS]):
            rows.append([pixel for line in lines for pixel in line + [PAPER] * GAP][:-GAP])
    data = png.write_exact(rows)
    check(len(data) <= MOST_BYTES, f"the sheet has {len(data)} bytes; {MOST_BYTES} are allowed")
    if not failures:
        outfile.write(PICTURE, data)
        print(f"{PICTURE.relative_to(ROOT)}: {len(data)} bytes")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/host")
    parser.add_argument("--only", metavar="EXPRESSION", default="")
    parser.add_argument("--check", metavar="PARTS", type=int)
    parser.add_argument("--sheet", action="store_true")
    options = parser.parse_args()
    if options.check is not None and options.check < 1:
        parser.error("--check takes a number from 1 on")
    build_folder = options.build.resolve()
    # Some libraries, GLU among them, are linked with libOpenGL. If the system's libOpenGL is found, their calls do not reach the pair.
    if not all((build_folder / "dropin" / name).exists() for name in PAIR):
        sys.exit(f"there is no complete drop-in pair in {options.build}; ./dev build makes it in build/host")
    need("Xvfb", "apitrace", "eglretrace")
    if HACKS.exists() and not (HACKS / "xscreensaver-getimage").exists():
        print("skipped: savers find no pictures; ./dev setup --gallery installs xscreensaver-data")
        return SKIPPED
    build("same_run.c", "-shared", "-fPIC")
    programs = every(build_imgui())
    if options.check:
        if not any(program.suite == "xscreensaver" for program in programs):
            print("skipped: the programs are missing; ./dev setup --gallery installs them")
            return SKIPPED
        check_part(build_folder / "dropin", programs, options.check)
    elif options.sheet:
        draw_sheet(build_folder / "spangle", programs)
    else:
        run_programs(build_folder / "dropin", [p for p in programs if re.search(options.only, p.name)])
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
