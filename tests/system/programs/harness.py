"""Runs programs of other authors with the drop-in pair and with Mesa, and compares their pictures.

A test names programs; this module knows how to run each kind (piglit, a trace, a program with a window), and when the pictures of two
correct GLs are the same. It uses the standard library only. The environment variable SPANGLE_KEEP names a folder where pictures stay.
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
sys.path[:0] = [str(HERE.parents[1] / "support"), str(HERE.parents[2] / "host_sim" / "tools")]
import outfile  # noqa: E402, F401
import png  # noqa: E402
from checks import check, failures  # noqa: E402, F401

SKIPPED = 77
PIGLIT = pathlib.Path("/usr/lib/x86_64-linux-gnu/piglit/bin")
ORACLES = ("softpipe", "llvmpipe")
# Two correct GLs differ at edges and by rounding. The limits are a percentage of pixels, and steps of a component within which a pixel is
# equal.
SPREAD = 0.1
TRACE_STEPS = 16
LAST_CALL = 2**32 - 1  # apitrace's largest number of a call, which no trace reaches


def need(*programs):
    """Ends the test as skipped if one of these programs is missing."""
    for program in programs:
        if shutil.which(str(program)) is None:
            print(f"skipped: there is no {program}; ./dev setup --programs installs it")
            sys.exit(SKIPPED)


def spangle_environment(pair, **more):
    """Returns an environment with the pair's folder first and no variable of a desktop session."""
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("SPANGLE_", "MESA_", "LIBGL_", "GALLIUM_", "EGL_"))
             and k not in ("DISPLAY", "LD_PRELOAD")}
    return clean | {"LD_LIBRARY_PATH": str(pair)} | more


def mesa_environment(oracle, version="1.3", **more):
    """Returns an environment for one of Mesa's rasterizers, which reports that version of OpenGL."""
    clean = spangle_environment("", **more)
    del clean["LD_LIBRARY_PATH"]
    return clean | {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": oracle, "MESA_GL_VERSION_OVERRIDE": version + "COMPAT",
                    "EGL_LOG_LEVEL": "fatal"}


class Ended:
    """The end of a program: its status (None: it was stopped after its time) and its output."""
    def __init__(self, status, words):
        self.status, self.words = status, words


def run(command, environment, seconds=120, folder=None):
    """Runs a program to its end or for its time. After its time it is killed with everything that it started, because a tracer's program
    would go on without the tracer.
    """
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
    """Returns a number from the name of the commit, so that tests of a part take another part with each commit."""
    words = run(["git", "-C", HERE, "rev-parse", "HEAD"], dict(os.environ)).words[:7]
    return int(words, 16) if all(c in "0123456789abcdef" for c in words) and words else 0


@contextlib.contextmanager
def folder(name):
    """A folder where a test leaves pictures. It is deleted afterwards unless SPANGLE_KEEP is set."""
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
    """Starts an X server that does not reset when its last client leaves. Yields the value of DISPLAY."""
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
    """Returns the result that a piglit program reports (pass, fail, skip, warn), else crash or timeout."""
    ended = run([PIGLIT / name, *arguments, "-auto"],
                spangle_environment(pair, PIGLIT_NO_WINDOW="1", PIGLIT_PLATFORM="surfaceless_egl"), seconds)
    for line in reversed(ended.words.splitlines()):
        if line.startswith("PIGLIT:") and '"result"' in line:
            return line.split('"result":')[1].split('"')[1], ended.words
    return ("timeout" if ended.status is None else "crash"), ended.words


def trim(trace, frames, to):
    """Returns a trace of the first frames of a trace."""
    done = run(["apitrace", "trim", f"--frames=0-{frames - 1}", "-o", to, trace], dict(os.environ))
    if done.status != 0:
        raise RuntimeError(done.words)


@functools.lru_cache(maxsize=1)
def contexts_and_swaps(trace, _written):
    """Returns the calls of a trace that make contexts and end frames, one line each. A long trace takes seconds, so the answer is kept
    until the file changes.
    """
    grep = "--grep=^eglCreateContext$|^(egl|glX)SwapBuffers$"
    return run(["apitrace", "dump", "--color=never", grep, trace], dict(os.environ), 300).words


def contexts_and_swaps_of(trace):
    return contexts_and_swaps(trace, trace.stat().st_mtime_ns)


def without_refused_contexts(trace, to):
    """Returns a trace without the contexts that EGL refused when it was recorded: eglretrace ends at the first context that it cannot make.
    """
    return without_calls(trace, re.findall(r"^(\d+) eglCreateContext\(.*\) = NULL$", contexts_and_swaps_of(trace), re.M), to)


def without_smoothing(trace, to):
    """Returns a trace whose points, lines and polygons are not antialiased by coverage, or the trace itself if none are."""
    said = run(["apitrace", "dump", "--color=never", "--grep=^glEnable$", trace], dict(os.environ), 300).words
    return without_calls(trace, re.findall(r"^(\d+) glEnable\(cap = GL_(?:POINT|LINE|POLYGON)_SMOOTH\)", said, re.M), to)


def all_but(left_out):
    """Returns all calls but those with these ascending numbers, in the words of apitrace's option --calls."""
    begins, ends = [0, *(n + 1 for n in left_out)], [*(n - 1 for n in left_out), LAST_CALL]
    return ",".join(f"{a}-{b}" for a, b in zip(begins, ends) if a <= b)


def without_calls(trace, numbers, to):
    """Returns a trace without the calls of these numbers, or the trace itself if there are no numbers."""
    if not numbers:
        return trace
    done = run(["apitrace", "trim", "--calls=" + all_but([int(n) for n in numbers]), "-o", to, trace], dict(os.environ))
    if done.status != 0:
        raise RuntimeError(done.words)
    return to


def some(things, most):
    """Returns at most `most` items of a list in order: the first, the last, and others that lie evenly between. For 1 it is the last item.
    """
    if most < 2 or len(things) <= most:
        return things[-most:]
    return [things[(len(things) - 1) * i // (most - 1)] for i in range(most)]


def some_frames(trace, most):
    """Returns some frames of a trace, among them the first and the last, in the words of eglretrace's option -S."""
    return ",".join(some(re.findall(r"^(\d+) \w+SwapBuffers", contexts_and_swaps_of(trace), re.M), most)) or "frame"


def replay(trace, environment, to, seconds=300, frames="frame"):
    """Returns the pictures of all frames of a trace, or of some_frames, in order, and the retracer's output."""
    to.mkdir(parents=True, exist_ok=True)
    ended = run(["eglretrace", "--headless", "-s", f"{to}/", "-S", frames, trace],
                environment | {"WAFFLE_PLATFORM": "surfaceless_egl"}, seconds)
    return sorted(to.glob("*.png")), ended


class Picture:
    """Returns the pixels of a PNG, or of its lower left part of the given size. A replay shows a window there that fills only part of its
    surface.
    """
    def __init__(self, path, window=None):
        self.width, self.height, self.rows = png.read(pathlib.Path(path).read_bytes())
        if window and (window[0] < self.width or window[1] < self.height):
            self.width, self.height = min(window[0], self.width), min(window[1], self.height)
            self.rows = [row[:self.width] for row in self.rows[len(self.rows) - self.height:]]


def steps(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


def near(a, b, x, y, most):
    """Returns whether a pixel of b around a place has the colour that a has there."""
    return any(steps(a.rows[y][x], b.rows[v][u]) <= most
               for v in range(max(y - 1, 0), min(y + 2, b.height)) for u in range(max(x - 1, 0), min(x + 2, b.width)))


def agree(a, b, x, y, most):
    """Returns whether a pixel differs by rounding only, or lies on an edge that is one pixel further on."""
    return steps(a.rows[y][x], b.rows[y][x]) <= most or (near(a, b, x, y, most) and near(b, a, x, y, most))


def bad_percent(ours, oracles, most):
    """Returns the percentage of pixels that agree with no oracle."""
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
    """Returns the percentage of a picture's pixels that differ from the oracles, and its limit: 0.1, or three times the percentage by which
    the oracles differ from each other.
    """
    spread = bad_percent(oracles[0], oracles[1:], most) if len(oracles) > 1 else 0.0
    return bad_percent(ours, oracles, most), max(SPREAD, 3 * spread)


def compare(name, ours, oracles, most=TRACE_STEPS):
    """Checks a picture file against the oracles' pictures."""
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
    """Returns the number of colours in a picture; an empty picture has one."""
    return len({pixel for row in picture.rows for pixel in row})
