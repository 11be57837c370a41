"""Runs programs that nobody here wrote with the drop-in pair, and with Mesa, and compares their pictures.

A test names programs; this file knows how to run each kind (piglit, a trace, a program with a window) and when two pictures of two
correct GLs are the same. Standard library only. The environment variable SPANGLE_KEEP names a folder where pictures stay.
"""
import contextlib
import functools
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1] / "host_sim" / "tools")]
import outfile  # noqa: E402, F401
import png  # noqa: E402
from checks import check, failures  # noqa: E402, F401

SKIPPED = 77
PIGLIT = pathlib.Path("/usr/lib/x86_64-linux-gnu/piglit/bin")
ORACLES = ("softpipe", "llvmpipe")
# Two correct GLs differ in edges and by rounding: pixels that are off by more, in a hundred, and steps of a component.
SPREAD = 0.1
TRACE_STEPS = 16
LAST_CALL = 2**32 - 1  # apitrace's largest number of a call, which no trace reaches


def need(*programs):
    """Ends the test as skipped where one of these is not there."""
    for program in programs:
        if shutil.which(str(program)) is None:
            print(f"skipped: there is no {program}; ./dev setup --programs installs it")
            sys.exit(SKIPPED)


def spangle_environment(pair, **more):
    """The pair's folder comes first; no variable of a session is left."""
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("SPANGLE_", "MESA_", "LIBGL_", "GALLIUM_", "EGL_"))
             and k not in ("DISPLAY", "LD_PRELOAD")}
    return clean | {"LD_LIBRARY_PATH": str(pair)} | more


def mesa_environment(oracle, version="1.3", **more):
    """One of Mesa's rasterizers, which calls itself that version of OpenGL."""
    clean = spangle_environment("", **more)
    del clean["LD_LIBRARY_PATH"]
    return clean | {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": oracle, "MESA_GL_VERSION_OVERRIDE": version + "COMPAT",
                    "EGL_LOG_LEVEL": "fatal"}


class Ended:
    """What became of a program: its status (None: it was stopped after its time) and its words."""
    def __init__(self, status, words):
        self.status, self.words = status, words


def run(command, environment, seconds=120, folder=None):
    """Runs a program to its end or for its time, after which it is killed with all that it started: a tracer's program, for one, would
    go on without the tracer."""
    with subprocess.Popen([str(c) for c in command], env=environment, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          errors="replace", start_new_session=True) as started:
        ends = False
        try:
            words, _ = started.communicate(timeout=seconds)
            ends = True
            return Ended(started.returncode, words)
        except subprocess.TimeoutExpired:
            pass
        finally:
            if not ends:
                os.killpg(started.pid, signal.SIGKILL)
        return Ended(None, started.communicate()[0])


def turn():
    """A number from the name of the commit: what only a part of is run takes another part each time."""
    words = run(["git", "-C", HERE, "rev-parse", "HEAD"], dict(os.environ)).words[:7]
    return int(words, 16) if all(c in "0123456789abcdef" for c in words) and words else 0


@contextlib.contextmanager
def folder(name):
    """Where a test leaves pictures; gone afterwards unless SPANGLE_KEEP is set."""
    keep = os.environ.get("SPANGLE_KEEP")
    if keep:
        path = pathlib.Path(keep) / name
        path.mkdir(parents=True, exist_ok=True)
        yield path
    else:
        with tempfile.TemporaryDirectory() as path:
            yield pathlib.Path(path)


@contextlib.contextmanager
def xvfb(size="800x600x24", *options):
    """An X server of its own, which stays as it is when its last client goes; gives the value of DISPLAY."""
    need("Xvfb")
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", size, "-noreset", "-nolisten", "tcp", *options],
                              pass_fds=(write,), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        with os.fdopen(read) as words:
            number = words.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        yield ":" + number
    finally:
        server.terminate()
        server.wait()


def piglit(name, pair, *arguments, seconds=120):
    """The result that a piglit program reports: pass, fail, skip, warn; else crash or timeout."""
    ended = run([PIGLIT / name, *arguments, "-auto"],
                spangle_environment(pair, PIGLIT_NO_WINDOW="1", PIGLIT_PLATFORM="surfaceless_egl"), seconds)
    for line in reversed(ended.words.splitlines()):
        if line.startswith("PIGLIT:") and '"result"' in line:
            return line.split('"result":')[1].split('"')[1], ended.words
    return ("timeout" if ended.status is None else "crash"), ended.words


def trim(trace, frames, to):
    """The first frames of a trace."""
    done = run(["apitrace", "trim", f"--frames=0-{frames - 1}", "-o", to, trace], dict(os.environ))
    if done.status != 0:
        raise RuntimeError(done.words)


@functools.lru_cache(maxsize=1)
def contexts_and_swaps(trace, _written):
    """The calls of a trace that make contexts and end frames, a line each. A long trace takes seconds, so the answer is kept for as long
    as the file is as it was written."""
    grep = "--grep=^eglCreateContext$|^(egl|glX)SwapBuffers$"
    return run(["apitrace", "dump", "--color=never", grep, trace], dict(os.environ), 300).words


def contexts_and_swaps_of(trace):
    return contexts_and_swaps(trace, trace.stat().st_mtime_ns)


def without_refused_contexts(trace, to):
    """A trace without the contexts that EGL refused when it was recorded: eglretrace ends at the first that it does not get."""
    return without_calls(trace, re.findall(r"^(\d+) eglCreateContext\(.*\) = NULL$", contexts_and_swaps_of(trace), re.M), to)


def without_smoothing(trace, to):
    """A trace whose points, lines and polygons are not antialiased by coverage; the same trace where none are."""
    said = run(["apitrace", "dump", "--color=never", "--grep=^glEnable$", trace], dict(os.environ), 300).words
    return without_calls(trace, re.findall(r"^(\d+) glEnable\(cap = GL_(?:POINT|LINE|POLYGON)_SMOOTH\)", said, re.M), to)


def all_but(left_out):
    """All calls but some, whose numbers ascend, in the words of apitrace's option --calls."""
    begins, ends = [0, *(n + 1 for n in left_out)], [*(n - 1 for n in left_out), LAST_CALL]
    return ",".join(f"{a}-{b}" for a, b in zip(begins, ends) if a <= b)


def without_calls(trace, numbers, to):
    """A trace without the calls of these numbers; the same trace where there are none."""
    if not numbers:
        return trace
    done = run(["apitrace", "trim", "--calls=" + all_but([int(n) for n in numbers]), "-o", to, trace], dict(os.environ))
    if done.status != 0:
        raise RuntimeError(done.words)
    return to


def some(things, most):
    """The first and the last of a list and others that lie evenly between them, `most` in all at most, in their order. One: the last."""
    if most < 2 or len(things) <= most:
        return things[-most:]
    return [things[(len(things) - 1) * i // (most - 1)] for i in range(most)]


def some_frames(trace, most):
    """Some frames of a trace, the first and the last among them, in the words of eglretrace's option -S."""
    return ",".join(some(re.findall(r"^(\d+) \w+SwapBuffers", contexts_and_swaps_of(trace), re.M), most)) or "frame"


def replay(trace, environment, to, seconds=300, frames="frame"):
    """The pictures of all frames of a trace, or of some_frames, in order, and what the retracer said."""
    to.mkdir(parents=True, exist_ok=True)
    ended = run(["eglretrace", "--headless", "-s", f"{to}/", "-S", frames, trace],
                environment | {"WAFFLE_PLATFORM": "surfaceless_egl"}, seconds)
    return sorted(to.glob("*.png")), ended


class Picture:
    """The pixels of a PNG, of all of it or of its lower left part: there a replay has a window (a size) that fills its surface in part."""
    def __init__(self, path, window=None):
        self.width, self.height, self.rows = png.read(pathlib.Path(path).read_bytes())
        if window and (window[0] < self.width or window[1] < self.height):
            self.width, self.height = min(window[0], self.width), min(window[1], self.height)
            self.rows = [row[:self.width] for row in self.rows[len(self.rows) - self.height:]]


def steps(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


def near(a, b, x, y, most):
    """Whether some pixel of b around a place is what a has there."""
    return any(steps(a.rows[y][x], b.rows[v][u]) <= most
               for v in range(max(y - 1, 0), min(y + 2, b.height)) for u in range(max(x - 1, 0), min(x + 2, b.width)))


def agree(a, b, x, y, most):
    """A pixel may be off by rounding, or lie on an edge that runs a pixel further on."""
    return steps(a.rows[y][x], b.rows[y][x]) <= most or (near(a, b, x, y, most) and near(b, a, x, y, most))


def bad_percent(ours, oracles, most):
    """Pixels, in a hundred, that are not those of any oracle."""
    bad = 0
    for y in range(ours.height):
        rows = [o.rows[y] for o in oracles]
        if ours.rows[y] in rows:
            continue
        for x in range(ours.width):
            if not any(agree(ours, o, x, y, most) for o in oracles):
                bad += 1
    return 100.0 * bad / (ours.width * ours.height)


def difference(ours, oracles, most=TRACE_STEPS):
    """How many pixels of a picture, in a hundred, are not those of the oracles, and how many may be: 0.1, or three times as many
    as the oracles have against each other."""
    spread = bad_percent(oracles[0], oracles[1:], most) if len(oracles) > 1 else 0.0
    return bad_percent(ours, oracles, most), max(SPREAD, 3 * spread)


def compare(name, ours, oracles, most=TRACE_STEPS):
    """Checks a picture file against those of the oracles."""
    pictures = [Picture(o) for o in oracles]
    mine = Picture(ours)
    sizes = {(p.width, p.height) for p in [mine, *pictures]}
    check(len(sizes) == 1, f"{name}: pictures have sizes {sizes}")
    if len(sizes) != 1:
        return
    bad, limit = difference(mine, pictures, most)
    print(f"{name}: {bad:.3f} % of the pixels are off, {limit:.3f} % may be")
    check(bad <= limit, f"{name}: {bad:.3f} % of the pixels are not those of {' or '.join(ORACLES)}, {limit:.3f} % may be")


def colors(picture):
    """How many colours a picture has: one is an empty one."""
    return len({pixel for row in picture.rows for pixel in row})
