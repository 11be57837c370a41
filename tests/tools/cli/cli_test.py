#!/usr/bin/env python3
"""Tests the command line as a user meets it.

usage: cli_test.py SPANGLE accuracy|shadow|errors|outputs|written|presents|bands|window|bringup
"""
import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "host_sim/tools"), str(ROOT / "tests/support")]
import png  # noqa: E402
from checks import check, failures  # noqa: E402

SPANGLE = sys.argv[1] if len(sys.argv) == 3 else ""
KEYS = ["scene", "board", "precision", "frames", "fragments", "triangles", "identical_565_percent", "max_lsb", "psnr_565_db",
        "coverage_mismatches", "coverage_unsnapped", "bus_bytes", "bus_commands", "bus_pixel_bytes", "full_frame_bytes", "fps_at_bus_clock", "picture_hash"]
# SDL's video drivers keep memory that they do not free, so leaks are not reported.
WINDOWED = {**os.environ, "ASAN_OPTIONS": "detect_leaks=0"}


def run(*words, cwd=None):
    return subprocess.run([SPANGLE, *words], capture_output=True, text=True, cwd=cwd)


def report(*words, cwd=None):
    done = run("run", *words, "--json", cwd=cwd)
    check(done.returncode == 0, f"run {' '.join(words)}: exit {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def scenes():
    return [line.split()[0] for line in run("scenes").stdout.splitlines()]


def accuracy():
    """The exact tier draws at least 99.99 % of the covered pixels as the reference in double does, dithered, as GL begins, or not. The
    balanced tier draws 95 %, or 94 % dithered. Coverage is always right.
    """
    check(len(scenes()) >= 12, "the scenes are listed")
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes():
            for precision, dither, least in (("exact", "off", 99.99), ("exact", "on", 99.99), ("balanced", "off", 95.0), ("balanced", "on", 94.0)):
                r = report(scene, "--precision", precision, "--dither", dither, "--frames", "2", "--compare", cwd=folder)
                print(f"{scene:<5}{precision:<10}{dither:<4}{r['identical_565_percent']:>10.4f} %  worst {r['max_lsb']:>2}  off snapped {r['coverage_mismatches']}  off unsnapped {r['coverage_unsnapped']}, by snapping alone {r['coverage_snapping']}")
                check(r["identical_565_percent"] >= least, f"{scene} {precision}, dither {dither}: {r['identical_565_percent']} % identical")
                check(r["coverage_mismatches"] == 0, f"{scene} {precision}: coverage differs from brute force")
                # The vertex half adds nothing to the error of positions in n.8: at most one pixel, where a position is half-way between two
                # steps.
                check(abs(r["coverage_unsnapped"] - r["coverage_snapping"]) <= 1, f"{scene} {precision}: {r['coverage_unsnapped']} pixels off, {r['coverage_snapping']} by snapping")
                check(r["coverage_unsnapped"] <= 1e-4 * r["fragments"], f"{scene} {precision}: {r['coverage_unsnapped']} pixels off the unsnapped ones")


# Bounds of the stages in the exact tier (design of the numbers): half a step of n.8, half a step of a 16-bit depth.
STAGE_BOUNDS = {"vertex color": 2**-19, "vertex coord": 2**-20, "vertex fog": 2**-27, "window x": 0.5 / 256 + 1e-6, "window y": 0.5 / 256 + 1e-6, "snapping": 1,
                "window z": 2**-27, "1/w": 2**-27, "depth": 0.5 / 65535 + 1e-7, "primary": 2**-18, "coord 0": 1 / 64, "texture 0": 1 / 255, "fog factor": 2**-21,
                "fog": 1 / 255, "blend": 1 / 255}


# The balanced tier promises a quarter of a texel and a quarter of a step of R5; fog distances are affine within 2^-9 of the factor.
BALANCED_BOUNDS = {"coord 0": 0.25 + 1 / 64, "primary": 0.25 / 31, "vertex color": 2**-13, "fog factor": 2**-9}


def shadow_tiers():
    """The shadow of each tier draws the tier's picture, and the balanced tier keeps its promises."""
    for tier in ("balanced", "fast"):
        for scene in ("S4", "S4r", "S5", "S6", "S9"):
            plain, r = report(scene, "--dither", "off", "--precision", tier), report(scene, "--dither", "off", "--precision", f"shadow-{tier}")
            check(r["picture_hash"] == plain["picture_hash"], f"{scene}: the picture of the {tier} tier")
            for s in r["stages"]:
                bound = BALANCED_BOUNDS.get(s["stage"]) if tier == "balanced" else None
                check(bound is None or s["max"] <= bound, f"{scene} {tier} {s['stage']}: {s['max']}")


def shadow():
    """Shadow precision draws the exact tier's picture, and reports the worst error and the RMS of every stage within the stage's bound."""
    shadow_tiers()
    worst = {}
    for scene in scenes():
        exact, r = report(scene, "--dither", "off"), report(scene, "--dither", "off", "--precision", "shadow")
        check(r["precision"] == "shadow" and r["picture_hash"] == exact["picture_hash"], f"{scene}: the picture of the exact tier")
        check("stages" not in exact, f"{scene}: no stages without the twin")
        check(list(r)[:len(KEYS)] == KEYS, f"{scene}: the usual keys first")
        for s in r.get("stages", []):
            check(s["count"] > 0 and 0 <= s["rms"] <= s["max"] <= STAGE_BOUNDS[s["stage"]], f"{scene} {s['stage']}: worst {s['max']}, RMS {s['rms']}")
            worst[s["stage"]] = max(s["max"], worst.get(s["stage"], 0))
    check(set(worst) == set(STAGE_BOUNDS), f"every stage is seen: {sorted(set(STAGE_BOUNDS) ^ set(worst))}")
    for stage, error in worst.items():
        print(f"{stage:<14}{error:.2e}")
    table = run("run", "S6", "--precision", "shadow").stdout
    check(all(word in table for word in ("max error", "rms error", "saturated", "window x", "1/256 pixel")), "a table for people")


def presents():
    """A board presents frames without tears, at its own pace, and sends only what changed."""
    plain = report("HUD", "--frames", "20")
    hashed = report("HUD", "--frames", "20", "--row-hash")
    check(hashed["picture_hash"] == plain["picture_hash"], "the row hash changes no picture")
    check(hashed["bus_bytes"] * 3 < plain["bus_bytes"], f"row hash: {hashed['bus_bytes']} of {plain['bus_bytes']} bytes")
    check("presents" not in plain, "only when it is asked for")
    for how in ("te", "poll"):
        tearless = report("S6", "--frames", "12", "--tear-free", how)
        done = tearless["presents"]
        check(done["led"] + done["lagged"] >= 10 and done["unsafe"] <= 2, f"--tear-free {how}: {done}")
        check(tearless["picture_hash"] == report("S6", "--frames", "12")["picture_hash"], "landscape in the order of the scan is the same picture")
    paced = {pacing: report("S6", "--frames", "20", "--buffers", "2", "--pacing", pacing, "--draw-ms", "2") for pacing in ("block", "drop", "coalesce")}
    check(paced["block"]["presents"]["put_off"] == 0, "a blocked program sends every frame")
    for pacing in ("drop", "coalesce"):
        check(paced[pacing]["presents"]["put_off"] > 10 and paced[pacing]["presents"]["fps"] > 3 * paced["block"]["presents"]["fps"], f"{pacing}: {paced[pacing]['presents']}")
    check("led the beam" in run("run", "S6", "--tear-free", "te").stdout, "presents in the table")
    for words, advice in ((["--size", "9x9", "--row-hash"], "--size excludes --row-hash"), (["--tear-free", "maybe"], "--tear-free"),
                          (["--board", "st7735-128x160", "--tear-free", "poll"], "polling the scanned line")):
        check(advice in run("run", "S5", *words).stderr, f"{words}: {run('run', 'S5', *words).stderr!r} says {advice!r}")


def bands():
    """A board that holds some rows draws the same picture, from a record or by callback, also if the record is too small."""
    whole = report("S5", "--frames", "3")
    check("bands" not in whole, "only when it is asked for")
    for words, record in ((["--band-height", "8"], 0), (["--band-height", "8", "--bands", "record"], 1000), (["--band-height", "60", "--bands", "record", "--record-bytes", "5000"], 0)):
        r = report("S5", "--frames", "3", *words)
        check(r["picture_hash"] == whole["picture_hash"] and r["bus_bytes"] > 0, f"{words}: another picture")
        rows = int(words[1])
        check(r["bands"]["planes"] >= rows * 320 * 2 and r["bands"]["planes"] < rows * 320 * 2 + 2500, f"{words}: {r['bands']}")
        check(r["bands"]["buffers"] == rows * 320 * 2, f"{words}: {r['bands']}")
        check((r["triangles"], r["fragments"]) == (whole["triangles"], whole["fragments"]), f"{words}: {r['triangles']} triangles, {r['fragments']} fragments, not those of whole frames, {whole['triangles']}, {whole['fragments']}")
        check(r["bands"]["record"] > record, f"{words}: {r['bands']}") if record else None
    check("of record" in run("run", "S5", "--band-height", "8", "--bands", "record").stdout, "bands in the table")
    for words, advice in ((["--size", "9x9", "--band-height", "8"], "--size excludes --band-height"), (["--bands", "record"], "--bands requires --band-height"),
                          (["--board", "ssd1306-i2c", "--band-height", "3"], "multiple of 8"), (["--band-height", "8", "--row-hash"], "no row hash")):
        check(advice in run("run", "S5", *words).stderr, f"{words}: {run('run', 'S5', *words).stderr!r} says {advice!r}")


def errors():
    """An error prints one line that says what to do, exits with status 2, and writes nothing."""
    with tempfile.TemporaryDirectory() as folder:
        broken = pathlib.Path(folder) / "broken.obj"
        broken.write_bytes(b"\x00\x01 no model \xff")
        for words in (["run", "S99"], ["run"], ["run", "S5", "--board", "nothing"], ["run", "S5", "--size", "0x5"], ["run", "S5", "--size", "99999x99999"],
                      ["run", "S5", "--size", "big"], ["run", "S5", "--shot", "no/such/folder/x.png"], ["run", "S5", "--vcd", "no/such/folder/x.vcd"],
                      ["run", "--model", "nothing.obj"], ["run", "--model", str(broken)], ["run", "S5", "--frames", "0"], ["run", "S5", "--precision", "best"],
                      ["run", "S5", "--nonsense"], ["dance"], []):
            done = run(*words, cwd=folder)
            text = " ".join(words)
            check(done.returncode == 2, f"'{text}': exit status {done.returncode} instead of 2")
            check(len(done.stderr.strip().splitlines()) == 1, f"'{text}': one line on stderr, not {done.stderr!r}")
            check(done.stdout == "", f"'{text}': nothing on stdout")
        check([p.name for p in pathlib.Path(folder).iterdir()] == ["broken.obj"], "nothing was written")
    for words, advice in ((["dance"], "no command 'dance'; see spangle --help"), (["run", "S5", "--nonsense"], "see spangle run --help"),
                          (["run", "S5", "--model", "x.obj"], "a scene or --model FILE, not both"), (["run", "--model", "/"], "it is a folder"),
                          (["run", "S5", "--size", "9x9", "--board", "ili9341"], "--board excludes --size")):
        check(advice in run(*words).stderr, f"'{' '.join(words)}': {run(*words).stderr!r} says '{advice}'")
    check("Usage: spangle run [OPTIONS]" in run("run", "--help").stdout, "the help calls the program by its name, wherever it lies")
    wrong = run("run", "S5", "--precision", "best").stderr
    for text, name in ((run("run", "--help").stdout, "help"), (wrong, "error text")):
        check(all(c.isprintable() or c == "\n" for c in text), f"the {name} holds control characters: {text!r}")
        check("shadow-balanced" in text, f"the {name} names the precisions")


def outputs():
    """Pictures, JSON and VCD are written, the same picture every time; a board's damage is less than a frame."""
    with tempfile.TemporaryDirectory() as folder:
        r = report("S5", "--frames", "3", cwd=folder)
        check(list(r) == KEYS, f"keys {list(r)}")
        check(r["identical_565_percent"] is None, "without --compare there is no error figure")
        check(r["frames"] == 3 and r["full_frame_bytes"] == 153600, "frames and bytes of a frame")
        check(r["bus_bytes"] < 3 * r["full_frame_bytes"], "damage sends less than whole frames")
        check(r["picture_hash"] == report("S5", "--frames", "3", cwd=folder)["picture_hash"], "the same picture twice")
        check(r["picture_hash"] == report("S5", "--frames", "3", "--size", "320x240", cwd=folder)["picture_hash"], "a board changes no pixel")
        done = run("run", "HUD", "--board", "st7735", "--shot", "hud.png", "--vcd", "bus.vcd", "--stats", cwd=folder)
        check(done.returncode == 0, f"run HUD: {done.stderr}")
        picture = (pathlib.Path(folder) / "hud.png").read_bytes()
        check(picture[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", picture[16:24]) == (128, 160), "a PNG of the glass")
        check("$enddefinitions" in (pathlib.Path(folder) / "bus.vcd").read_text(), "a VCD file")
        memory = report("S9", "--size", "320x240", "--stats", cwd=folder)["memory"]
        check(memory["surface"] >= 320 * 240 * 4 and memory["surface"] < 320 * 240 * 4 + 1024, f"colour and depth of 16 bits: {memory}")
        check(4096 < memory["context"] < 2 << 20, f"a context, with the vertices of a whole mesh: {memory}")
        check(memory["peak"] > memory["context"] + memory["surface"] + 64 * 64 * 2, f"the texture, too: {memory}")
        check(memory["peak"] < memory["process"] < 500e6, f"the process: {memory}")
        check("memory" in run("run", "S9", "--stats", cwd=folder).stdout, "memory in the table")
        check("memory" not in run("run", "S9", cwd=folder).stdout, "only when it is asked for")
        for board in [line.split()[0] for line in run("boards").stdout.splitlines()]:
            done = run("run", "S9", "--board", board, "--frames", "2", "--stats", cwd=folder)
            check(done.returncode == 0 and "rule " not in done.stderr, f"{board}: {done.stderr}")
        # The first frame changes every pixel, so a board sends a full frame in its wire format. Commands are few: at most seven for each of
        # eight pages.
        for board in [line.split()[0] for line in run("boards").stdout.splitlines()]:
            r = report("S1", "--board", board, cwd=folder)
            commands = r["bus_bytes"] - r["full_frame_bytes"]
            check(r["bus_pixel_bytes"] == r["full_frame_bytes"], f"{board}: {r['bus_pixel_bytes']} bytes of pixels for a full frame")
            check(0 <= commands <= 64, f"{board}: {r['bus_bytes']} bytes for a full frame of {r['full_frame_bytes']}")


def written():
    """A file is whole or as it was before, devices and pipes are written to as they are, and a lost output is told in one line."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check(run("run", "S2", "--compare", cwd=name).returncode == 0 and list(folder.iterdir()) == [], "--compare writes nothing by itself")
        done = run("run", "S2", "--difference", "d.png", "--shot", "s.png", cwd=name)
        check(sorted(p.name for p in folder.iterdir()) == ["d.png", "s.png"] and "coverage" in done.stdout, f"--difference compares, and writes there: {done.stderr}")
        shot = (folder / "s.png").read_bytes()
        null = os.stat("/dev/null")
        check(run("run", "S2", "--shot", "/dev/null", "--vcd", "/dev/null").returncode == 0, "to a device")
        check((os.stat("/dev/null").st_ino, os.stat("/dev/null").st_rdev) == (null.st_ino, null.st_rdev), "the device is the one that was there")
        for path in ("-", "/dev/stdout", "/dev/fd/1"):
            piped = subprocess.run([SPANGLE, "run", "S2", "--shot", path], capture_output=True)
            check(piped.returncode == 0 and piped.stdout == shot, f"--shot {path}: the picture and nothing else on standard output")
            check(b"picture: " in piped.stderr, "words for people are on standard error then")
        header = subprocess.run([SPANGLE, "bake", "s.png", "-o", "-", "--name", "shot"], capture_output=True, text=True, cwd=name)
        check(header.returncode == 0 and header.stdout.startswith("//") and "texture" in header.stderr, f"bake to standard output: {header.stderr}")
        # A picture and figures cannot share one stream, so both are refused.
        for words in (["--shot", "-", "--vcd", "-"], ["--shot", "-", "--json"], ["--vcd", "/dev/stdout", "--json"], ["--shot", "-", "--difference", "-"]):
            done = run("run", "S2", *words)
            check(done.returncode == 2 and "standard output" in done.stderr and done.stdout == "", f"{words}: {done.stderr!r}")
        project = (ROOT / "CMakeLists.txt").read_text()
        version = run("--version").stdout.removeprefix("spangle ").strip()
        check(f"project(Spangle VERSION {version} " in project, f"--version says {version}, which is not the version of the project")
        # On a full device every write must be checked.
        (folder / "s.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        for words in (["run", "S2", "--shot", "/dev/full"], ["run", "S2", "--vcd", "/dev/full"], ["run", "S2", "--difference", "/dev/full"], ["bake", "s.png", "-o", "/dev/full", "--name", "x"],
                      ["bake", "s.obj", "-o", "/dev/full", "--name", "x"], ["card", "--shot", "/dev/full"], ["formats", "--shot", "/dev/full"], ["samples", "--shot", "/dev/full"]):
            done = run(*words, cwd=name)
            check(done.returncode == 1 and done.stdout == "" and len(done.stderr.splitlines()) == 1, f"{words}: {done.returncode} {done.stderr!r}")
            check("cannot write '/dev/full': No space left on device; make room" in done.stderr, f"{words}: {done.stderr!r}")
        with open("/dev/full", "w") as full:
            for words in (["run", "S2"], ["run", "S2", "--json"], ["scenes"], ["boards"], ["--help"], ["--version"], ["bake", "s.obj", "-o", "s.hpp"], ["card", "--list-wrong"], ["probe"]):
                done = subprocess.run([SPANGLE, *words], stdout=full, stderr=subprocess.PIPE, text=True, cwd=name)
                check(done.returncode == 1 and done.stderr == "spangle: cannot write standard output: No space left on device; make room there, or name another place\n",
                      f"{words} to a full device: {done.returncode} {done.stderr!r}")
            done = subprocess.run([SPANGLE, "run", "S2"], stdout=subprocess.PIPE, stderr=full, text=True)
            check(done.returncode == 0 and "S2 on" in done.stdout, "a full standard error disturbs nobody")
        reader, writer = os.pipe()
        os.close(reader)
        done = subprocess.run([SPANGLE, "scenes"], stdout=writer, stderr=subprocess.PIPE, text=True)
        os.close(writer)
        check(done.returncode == 1 and "nobody reads it any more" in done.stderr, f"a reader that went: {done.returncode} {done.stderr!r}")
        done = subprocess.run(f"{SPANGLE} run S2 --shot closed.png >&-", shell=True, capture_output=True, text=True, cwd=name)
        check(done.returncode == 1 and "standard output" in done.stderr, f"a closed standard output: {done.returncode} {done.stderr!r}")
        check((folder / "closed.png").read_bytes() == shot, "and the picture is a picture all the same")
        limited(folder, shot)
        dumps(folder)


def limited(folder, shot):
    """If a file cannot be finished, the file before it stays as it was, and no temporary file is left."""
    (folder / "s.png").write_bytes(shot)
    before = sorted(p.name for p in folder.iterdir())
    for words in (["run", "S9", "--shot", "s.png"], ["run", "S9", "--vcd", "new.vcd"], ["bake", "s.png", "-o", "new.hpp"]):
        done = subprocess.run(["prlimit", "--fsize=400", SPANGLE, *words], capture_output=True, text=True, cwd=folder)
        check(done.returncode == 1 and "make room" in done.stderr and len(done.stderr.splitlines()) == 1, f"{words}: {done.returncode} {done.stderr!r}")
        check(sorted(p.name for p in folder.iterdir()) == before, f"{words}: nothing half-written is left: {sorted(p.name for p in folder.iterdir())}")
    check((folder / "s.png").read_bytes() == shot, "the old picture is as it was")


def dumps(folder):
    """A dump that reaches its limit ends there as a whole file, and the run says when that was."""
    done = run("run", "S5", "--frames", "3", "--vcd", "bus.vcd", "--vcd-limit", "100kB", cwd=folder)
    text = (folder / "bus.vcd").read_text()
    said = [line for line in done.stderr.splitlines() if line.startswith("bus.vcd: stopped at ")]
    check(done.returncode == 0 and len(said) == 1 and "--vcd-limit" in said[0], f"the run goes on, and says so: {done.stderr!r}")
    check(len(text) <= 100 * 1024, f"{len(text)} bytes")
    check("$comment stopped here: the file has reached its limit $end" in text, "the dump says so, too")
    last = [int(line[1:]) for line in text.splitlines() if line.startswith("#")][-2]  # one more moment shows the last edge
    check(f"{last / 1e6:.6f} ms" in said[0], f"{said[0]!r} tells the moment, {last} ns")
    whole = run("run", "S2", "--vcd", "whole.vcd", cwd=folder)
    check(whole.stderr == "" and "$comment" not in (folder / "whole.vcd").read_text(), "others say nothing")


def screen_pixels(path):
    """Returns (width, height, bytes of BGRX) of an X server's frame buffer file, which is an XWD file."""
    data = path.read_bytes()
    size, _, _, _, width, height, _, _, _, _, _, bits, stride = struct.unpack(">13I", data[:52])
    check(bits == 32 and stride == width * 4, "32 bits a pixel")
    at = size + 12 * struct.unpack(">I", data[76:80])[0]
    return width, height, data[at:at + stride * height]


def differs(screen, shot, scale):
    """Returns why the left half of a window at the screen's corner is not the glass, or None."""
    width, _, pixels = screen
    rows = png.read(shot)[2]
    for y, row in enumerate(rows):
        for x, (r, g, b) in enumerate(row):
            at = ((y * scale + scale // 2) * width + x * scale + scale // 2) * 4
            # The glass has six bits a channel, the drawing buffer five or six.
            if max(abs(pixels[at] - b), abs(pixels[at + 1] - g), abs(pixels[at + 2] - r)) > 8:
                return f"pixel {x}, {y}: {tuple(pixels[at:at + 3][::-1])} instead of {(r, g, b)}"
    return None


def on_x_server(folder):
    """On an X server of the window's size, the window shows the glass pixel by pixel, with the memory beside it. Closing the window ends
    the run in good order.
    """
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x480x24", "-fbdir", folder, "-nolisten", "tcp"],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        display = os.read(read, 16).decode().strip()
        check(display != "", "Xvfb starts")
        environment = {**WINDOWED, "DISPLAY": ":" + display, "SDL_VIDEODRIVER": "x11"}
        shot = pathlib.Path(folder) / "still.png"
        check(run("run", "S4", "--shot", str(shot)).returncode == 0, "a picture to compare with")
        program = subprocess.Popen([SPANGLE, "run", "S4", "--window", "--frames", "1000000", "--json"], env=environment,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        problem, deadline = "nothing was looked at", time.monotonic() + 60
        while problem is not None and time.monotonic() < deadline and program.poll() is None:
            time.sleep(0.2)
            screen = screen_pixels(pathlib.Path(folder) / "Xvfb_screen0")
            problem = differs(screen, shot.read_bytes(), 2)
        check(problem is None, f"the window shows the glass: {problem}")
        width, _, pixels = screen
        beside = [pixels[(y * width + x) * 4:(y * width + x) * 4 + 3] for y in range(0, 480, 16) for x in range(640, 1000, 16)]
        check(len(set(beside)) > 20, "the controller's memory beside it")
        program.send_signal(signal.SIGTERM)  # SDL takes this signal as a user who closes the window
        out, err = program.communicate(timeout=60)
        check(program.returncode == 0, f"closed: exit status {program.returncode}: {err}")
        check(0 < json.loads(out)["frames"] < 1000000, "the frames that were drawn are reported")
        stays_until_closed(environment, pathlib.Path(folder))
    finally:
        server.terminate()
        server.wait()
        os.close(read)


def stays_until_closed(environment, folder):
    """Without --frames, as the README has it, the window stays, the scene goes on in it, and one frame is reported."""
    words = ["run", "S5", "--window", "--json", "--vcd", str(folder / "window.vcd")]
    program = subprocess.Popen([SPANGLE, *words], env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    seen, deadline = set(), time.monotonic() + 60
    while len(seen) < 4 and time.monotonic() < deadline and program.poll() is None:
        time.sleep(0.3)
        seen.add(screen_pixels(folder / "Xvfb_screen0")[2])
    check(program.poll() is None, "the window stays open")
    check(len(seen) >= 4, f"the scene goes on: {len(seen)} pictures")
    program.send_signal(signal.SIGTERM)
    out, err = program.communicate(timeout=60)
    check(program.returncode == 0, f"closed: exit status {program.returncode}: {err}")
    shown, alone = json.loads(out), report("S5", "--vcd", str(folder / "alone.vcd"))
    check(shown["frames"] == 1 and shown["picture_hash"] == alone["picture_hash"], "one frame is reported")
    check((folder / "window.vcd").read_bytes() == (folder / "alone.vcd").read_bytes(), "one frame is recorded")


def window():
    """Tests --window on an X server if there is one, on SDL's dummy driver, and where no window can be opened."""
    with tempfile.TemporaryDirectory() as folder:
        if shutil.which("Xvfb"):
            on_x_server(folder)
        words = ["run", "S2", "--window", "--frames", "2", "--json"]
        expected = report("S2", "--frames", "2")["picture_hash"]
        # Without a display SDL would choose its driver "offscreen", and show nothing to nobody.
        bare = {name: value for name, value in WINDOWED.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR", "SDL_VIDEODRIVER")}
        for driver, said in (("dummy", False), ("nonsense", True), (None, not pathlib.Path("/dev/dri").exists())):
            done = subprocess.run([SPANGLE, *words], capture_output=True, text=True, env={**bare, "SDL_VIDEODRIVER": driver} if driver else bare)
            check(done.returncode == 0 and json.loads(done.stdout)["picture_hash"] == expected, f"{driver}: the run goes on: {done.stderr}")
            lines = done.stderr.strip().splitlines()
            check(len(lines) == 1 and "no window" in lines[0] if said else lines == [], f"{driver}: {done.stderr!r}")


def bringup():
    """Tests probe, card, wizard and the gallery: a panel is found, seen and described."""
    probe = run("probe", "--board", "ili9341-spi")
    check(probe.returncode == 0 and "fits: ILI9341 240x320  (board ili9341-spi)" in probe.stdout, f"probe: {probe.stdout}{probe.stderr}")
    for words, says in ((["probe", "--board", "st7789-240"], "cannot read"), (["probe", "--board", "none"], "no board 'none'"),
                        (["probe", "--spidev", "/dev/spidev99.9", "--dc", "gpiochip0:24"], "/dev/spidev99.9: open: No such file"),
                        (["probe", "--spidev", "/dev/spidev99.9", "--dc", "24"], "CHIP:NUMBER"), (["card", "--wrong", "nothing"], "no setting 'nothing'"),
                        (["probe", "--ftdi", "--usb", "/dev/bus/usb/999/999"], "/dev/bus/usb/999/999: open: No such file"),
                        (["wizard", "--glass", "0x9"], "--glass takes"), (["wizard"], "the answers ended")):
        done = subprocess.run([SPANGLE, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
        check(done.returncode == 2 and says in done.stderr.splitlines()[-1] and done.stdout == "", f"{words}: {done.stderr!r}")
    with tempfile.TemporaryDirectory() as folder:
        shot, card, header = (pathlib.Path(folder) / name for name in ("wizard.png", "card.png", "my_board.hpp"))
        answers = "n\ny\nr\nf\nu\n0 20\ny\nr\nf\nu\n0 0\n"
        done = subprocess.run([SPANGLE, "wizard", "--board", "st7789-240x280", "--shot", str(shot)], input=answers, capture_output=True, text=True)
        check(done.returncode == 0 and "p.offset = {0, 20};" in done.stdout, f"wizard: {done.stdout}{done.stderr}")
        check(run("card", "--board", "st7789-240x280", "--shot", str(card)).returncode == 0, "card")
        check(shot.read_bytes() == card.read_bytes(), "the wizard's last card is the right one")
        header.write_text(done.stdout)
        rooms = [f"-I{ROOT / room / 'include'}" for room in ("hal", "raster/format", "boards")]
        compiled = subprocess.run(["c++", "-std=c++20", "-fsyntax-only", "-x", "c++", *rooms, str(header)], capture_output=True, text=True)
        check(compiled.returncode == 0, f"the definition compiles: {compiled.stderr}")
    gallery = subprocess.run([sys.executable, str(ROOT / "host_sim/tools/gallery.py"), SPANGLE, "--check"], capture_output=True, text=True)
    check(gallery.returncode == 0, gallery.stdout)


def main():
    if len(sys.argv) != 3 or sys.argv[2] not in ("accuracy", "shadow", "errors", "outputs", "written", "presents", "bands", "window", "bringup"):
        print(__doc__.strip())
        return 2
    globals()[sys.argv[2]]()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
