"""How real programs are recorded: under an X server of their own, over Mesa's llvmpipe, which calls itself GL 1.3.

A program sees the extensions of 2003 and earlier but for shaders and framebuffer objects, so it takes the way through GL 1.x that it takes
on Spangle. Games are played: keys are pressed at given seconds, and bzflag meets robots on a server that is started for it. A recording is
a file of apitrace; its last frame is what is measured. Programs that are not installed are left out.
"""
import contextlib
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[2] / "system/programs")]
import gallery  # noqa: E402
import harness  # noqa: E402
import programs_list  # noqa: E402
from harness import outfile, run  # noqa: E402

SEEN = {"MESA_EXTENSION_MAX_YEAR": "2003", "LP_NUM_THREADS": "0", "MESA_EXTENSION_OVERRIDE": " ".join(
    f"-GL_{name}" for name in ("ARB_shader_objects", "ARB_vertex_shader", "ARB_fragment_shader", "ARB_vertex_program",
                               "ARB_fragment_program", "EXT_framebuffer_object"))}
SIZE = "320x240"
# Calls that draw and set nothing. A list may set something, so calls of lists are not here.
DRAWS = {"glClear", "glDrawArrays", "glDrawElements", "glDrawRangeElements", "glRectf", "glRecti", "glBitmap"}
FRAMES = 60  # frames of a recording, unless a program needs longer to show its usual picture
BZFLAG_PORT = "5177"
ARMAGETRONAD = ".armagetronad/var/user.cfg", "FIRST_USE 0\nLANGUAGE_FIRST American English\nLANGUAGE_SECOND American English\n"


class Recorded:
    """A program: its command, the trace API that sees its calls, seconds that it runs, and frames that are kept (None: all). `keys` are
    names of X's keys and the seconds at which they are pressed, `files` is what its home holds, and `beside` is a server for it. With
    `same`, clock and random numbers are the same in each run (same_run.c).
    """
    def __init__(self, name, kind, command, api, seconds=8, frames=FRAMES, keys=(), files=(), beside=None, folder=None, same=True):
        self.name, self.kind, self.command, self.api, self.seconds, self.frames = name, kind, command, api, seconds, frames
        self.keys, self.files, self.beside, self.folder, self.same = keys, files, beside, folder, same

    def there(self):
        return all(pathlib.Path(words[0]).exists() for words in (self.command, self.beside) if words)


def game(name, *words):
    return [programs_list.game(name), *words]


def saver(name, seconds=8, frames=FRAMES):
    return Recorded(name, "saver", [programs_list.HACKS / name, "-geometry", SIZE], "egl", seconds, frames)


def every(clients, imgui):
    """Returns all programs by kind. `clients` are the two programs of clients.c, `imgui` is Dear ImGui's demo, or None if it cannot be
    built.
    """
    found = [
        Recorded("armagetronad", "game", game("armagetronad", "-w"), "gl", 24, None, files=[ARMAGETRONAD], same=False,
                 keys=[(8, "Return"), (10.2, "Down"), (12.4, "Return"), (14.6, "Return")]),
        Recorded("bzflag", "game", game("bzflag", "-m", "-time", "12:00:00", "-window", "640x480+0+0", "-team", "red", "-solo", "3",
                                        "player@localhost:" + BZFLAG_PORT), "gl", 19, None, keys=[(10, "i"), (11.5, "i")], same=False,
                 beside=game("bzfs", "-i", "127.0.0.1", "-p", BZFLAG_PORT, "-cr", "-ms", "3")),
        Recorded("billard-gl", "game", game("billard-gl"), "gl"),
        Recorded("stormbaancoureur", "game", game("stormbaancoureur"), "gl"),
        Recorded("cultivation", "game", game("cultivation"), "gl"),
        Recorded("testsprite2", "SDL2", [programs_list.SDL / "testsprite2", "--geometry", SIZE], "gl", folder=programs_list.SDL),
        *(saver(name) for name in ("gears", "atlantis", "dangerball", "lament")),
        *(saver(name, 20, 300) for name in ("glmatrix", "starwars")),  # these two savers show little at first
        *(Recorded(name, "own", [clients, name, "30"], "egl", 30) for name in ("particles", "rectangles")),
    ]
    if imgui is not None:
        found.append(Recorded("imgui", "Dear ImGui", [imgui, "sdl2"], "gl"))
    order = ("game", "SDL2", "Dear ImGui", "saver", "own")
    return sorted((program for program in found if program.there()), key=lambda program: order.index(program.kind))


@contextlib.contextmanager
def started(command, environment, folder, words=subprocess.DEVNULL):
    """Starts a process. At the end the process and all that it started are asked to end, and then killed."""
    process = subprocess.Popen([str(c) for c in command], env=environment, cwd=folder, stdout=words, stderr=subprocess.STDOUT,
                               start_new_session=True)
    try:
        yield process
    finally:
        for asked in (signal.SIGTERM, signal.SIGKILL):
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, asked)
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(20)


def press(key, environment):
    """Presses a key in the last window that was opened. There is no window manager, so the window gets the focus first."""
    windows = run(["xdotool", "search", "--onlyvisible", "--name", "."], environment).words.split()
    if windows:
        run(["xdotool", "windowfocus", windows[-1]], environment)
    run(["xdotool", "keydown", key], environment)
    time.sleep(0.15)
    run(["xdotool", "keyup", key], environment)


def play(program, process, environment):
    begin = time.monotonic()
    for second, key in program.keys:
        time.sleep(max(0, begin + second - time.monotonic()))
        press(key, environment)
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(max(0, begin + program.seconds - time.monotonic()))


def environment_for(program, display, home):
    for name, text in program.files:
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        outfile.write(home / name, text)
    environment = gallery.environment_of(harness.mesa_environment("llvmpipe", **SEEN), display, home)
    if program.kind == "own":
        environment |= {"EGL_PLATFORM": "surfaceless"}
    return environment if program.same else {name: text for name, text in environment.items() if name != "LD_PRELOAD"}


def record(program, display, to):
    """Records a program; the file `to` then holds its first frames. Returns what went wrong, or nothing."""
    with tempfile.TemporaryDirectory() as place, tempfile.TemporaryFile("w+", errors="replace") as words:
        home, long, kept = pathlib.Path(place), pathlib.Path(place) / "long.trace", pathlib.Path(place) / "kept.trace"
        environment = environment_for(program, display, home)
        folder = program.folder or home
        with contextlib.ExitStack() as running:
            if program.beside:
                running.enter_context(started(program.beside, environment, folder))
                time.sleep(1)
            command = ["apitrace", "trace", "-a", program.api, "-o", long, *program.command]
            play(program, running.enter_context(started(command, environment, folder, words)), environment)
        words.seek(0)
        whole = frames_of(long) - 1 if long.exists() else 0  # what follows the last whole frame may be half a frame
        if whole < 1:
            return "no frame was recorded: " + gallery.last_line(words.read())
        harness.trim(long, min(whole, program.frames or whole), kept)
        if program.frames is None:
            kept = without_early_drawing(kept, pathlib.Path(place) / "quiet.trace")
        played = harness.without_refused_contexts(kept, pathlib.Path(place) / "played.trace")
        outfile.write(to, played.read_bytes())
    return ""


def early_drawing(lines):
    """Returns the numbers of the calls that only draw, in all frames but the last two, from the lines of apitrace's dump. Calls that are
    compiled into lists are left out.
    """
    drawing, swaps, in_list, in_primitive = [], [], False, False
    for line in lines:
        number, _, call = line.partition(" ")
        name = call.partition("(")[0]
        if not number.isdigit():
            continue
        if name in ("eglSwapBuffers", "glXSwapBuffers"):
            swaps.append(int(number))
        in_list = name == "glNewList" or (in_list and name != "glEndList")
        in_primitive = name == "glBegin" or in_primitive
        if not in_list and (in_primitive or name in DRAWS):
            drawing.append(int(number))
        in_primitive = in_primitive and name != "glEnd"
    return [number for number in drawing if len(swaps) > 2 and number < swaps[-3]]


def without_early_drawing(trace, to):
    """Shortens the trace of a program that was played for long: its early frames set all state and draw nothing, so they are over soon."""
    with subprocess.Popen(["apitrace", "dump", "--color=never", trace], stdout=subprocess.PIPE, text=True, errors="replace") as dump:
        drawing = early_drawing(dump.stdout)
    calls = to.with_suffix(".calls")
    outfile.write(calls, harness.all_but(drawing).replace(",", "\n") + "\n")
    done = run(["apitrace", "trim", f"--calls=@{calls}", "-o", to, trace], dict(os.environ))
    if done.status != 0:
        raise RuntimeError(done.words)
    return to


def frames_of(trace):
    return len(re.findall(r"^\d+ \w+SwapBuffers", harness.contexts_and_swaps_of(trace), re.M))
