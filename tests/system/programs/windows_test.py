#!/usr/bin/env python3
"""Tests that programs with windows of X run with the pair, and that `spangle exec` and `spangle replay` show them on boards.

usage: windows_test.py PAIR SPANGLE
"""
import json
import pathlib
import sys

from harness import HERE, SKIPPED, Picture, check, colors, failures, folder, need, run, spangle_environment, xvfb

PAIR, SPANGLE = pathlib.Path(sys.argv[1]), sys.argv[2]
FRAMES = 10


def shot(name, command, place, environment, size=None):
    """Returns the last of some frames of a program."""
    picture = place / f"{name}.png"
    ended = run(command, environment | {"SPANGLE_FRAMES": str(FRAMES), "SPANGLE_SHOT": str(picture)}, 60)
    check(ended.status == 0, f"{name}: ended with {ended.status}: {ended.words[-1000:]}")
    if not picture.exists():
        return check(False, f"{name}: there is no picture")
    seen = Picture(picture)
    check(colors(seen) > 8, f"{name}: the picture has {colors(seen)} colours")
    if size is not None:
        check((seen.width, seen.height) == size, f"{name}: the picture is {seen.width}x{seen.height}, not {size}")


def toolkits(environment):
    """Windows of SDL2 (by GLX and by EGL), GLFW and freeglut change their size and show the right picture."""
    for name, more in (("sdl2", {}), ("sdl2", {"SDL_VIDEO_X11_FORCE_EGL": "1"}), ("glfw", {}), ("glut", {})):
        ended = run([sys.executable, HERE / "toolkits.py", name], environment | more, 60)
        check(ended.status in (0, SKIPPED), f"{name} {more}: {ended.status}: {ended.words[-1000:]}")


def on_board(place, environment):
    """Checks the figures and the picture of a program on a panel."""
    picture = place / "board.png"
    command = [SPANGLE, "exec", "--board", "ili9341", "--frames", FRAMES, "--shot", picture, "--json", "--", "glxgears"]
    ended = run(command, environment, 60)
    check(ended.status == 0, f"spangle exec: ended with {ended.status}: {ended.words[-1000:]}")
    figures = json.loads(ended.words[ended.words.index("{"):])
    check(figures["frames"] == FRAMES and figures["board"] == "ili9341-spi", f"spangle exec: {figures}")
    check(figures["triangles"] > FRAMES * 100 and figures["bus_bytes"] > 100000, f"spangle exec counts {figures}")
    seen = Picture(picture)
    check((seen.width, seen.height) == (320, 240), "spangle exec: the picture is not the glass")
    check(colors(seen) > 8, "spangle exec: the glass shows one colour")
    for command, status in ((["--board", "nosuch", "--", "true"], 2), (["--", "no-such-program"], 127), (["--", "false"], 1)):
        ended = run([SPANGLE, "exec", *command], environment)
        check(ended.status == status, f"spangle exec {command}: ended with {ended.status}, not {status}: {ended.words}")


def replayed(place, environment):
    """Checks a trace of a program with one buffer, and of a program that swaps buffers."""
    need("eglretrace")
    for name in ("redbook_light", "demos_gears"):
        picture = place / f"{name}.png"
        ended = run([SPANGLE, "replay", "--shot", picture, HERE / "traces" / f"{name}.trace"], environment, 60)
        check(ended.status == 0 and picture.exists(), f"spangle replay {name}: {ended.status}: {ended.words[-1000:]}")
        if picture.exists():
            check(colors(Picture(picture)) > 8, f"spangle replay {name}: the glass shows one colour")


need("glxgears", "glxinfo")
with folder("windows") as place:
    for options in ((), ("-extension", "GLX"), ("-extension", "MIT-SHM")):
        with xvfb("640x480x24", *options) as display:
            environment = spangle_environment(PAIR, DISPLAY=display)
            shot(" ".join(["glxgears", *options]), ["glxgears"], place, environment, (300, 300))
    with xvfb() as display:
        environment = spangle_environment(PAIR, DISPLAY=display)
        ended = run(["glxinfo"], environment, 60)
        check(ended.status == 0 and "OpenGL renderer string: Spangle" in ended.words, f"glxinfo: {ended.words[-1000:]}")
        shot("samples", ["glxgears", "-samples", "4"], place, environment, (300, 300))
        shot("resized", ["glxgears", "-geometry", "400x200"], place, environment, (400, 200))
        shot("sized", ["glxgears"], place, environment | {"SPANGLE_SIZE": "200x160"}, (200, 160))
        for refused in ({"SPANGLE_BOARD": "nosuch"}, {"SPANGLE_PRECISION": "some"}, {"SPANGLE_SIZE": "0x5"}):
            ended = run(["glxinfo"], environment | refused, 60)
            check(ended.status == 2 and "it takes" in ended.words, f"{refused} is taken: {ended.words[-300:]}")
        toolkits(environment)
        on_board(place, environment)
    replayed(place, spangle_environment(PAIR))
sys.exit(1 if failures else 0)
