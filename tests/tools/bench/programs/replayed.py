"""Measures a recording's last frame: eglretrace replays the trace, draws its last frame again and again, and prints each time.

All times are processor time of one thread, in milliseconds. The frames before the last one are not counted, nor the first times of the last
frame, in which llvmpipe compiles its shaders.
"""
import pathlib
import statistics
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[2] / "system/programs")]
import harness  # noqa: E402
from speeds import LLVMPIPE, REPLAYER, TIERS  # noqa: E402

TIMES, WARM = 60, 10  # how often the last frame is drawn, and how many of these times are not counted
SECONDS = 300


def environments(pair):
    """Returns {name: environment} of all that replay a frame: the replayer alone, Mesa's llvmpipe, and Spangle's tiers."""
    mesa = harness.mesa_environment(LLVMPIPE, "1.5", LP_NUM_THREADS="0")
    ours = {tier: harness.spangle_environment(pair, SPANGLE_PRECISION=tier) for tier in TIERS}
    return {REPLAYER: mesa | {"NO_GL": "1"}, LLVMPIPE: mesa} | ours


def frame_time(ends, times=TIMES, warm=WARM):
    """Returns the milliseconds of a frame. `ends` has the processor time in nanoseconds at the end of each frame; the result is the median
    of the last `times` frames without the first `warm` of them.
    """
    if len(ends) < times + 1 or not 0 <= warm < times:
        raise ValueError(f"{len(ends)} frames: {times} times of the last one are asked for")
    return statistics.median(b - a for a, b in zip(ends[warm - times - 1:], ends[warm - times:])) / 1e6


def replay(trace, environment, library, times=TIMES):
    """Returns the milliseconds of the trace's last frame."""
    with tempfile.TemporaryDirectory() as place:
        noted = pathlib.Path(place) / "times"
        more = {"LD_PRELOAD": str(library), "FRAME_TIMES": str(noted), "WAFFLE_PLATFORM": "surfaceless_egl"}
        ended = harness.run(["eglretrace", "--headless", "-b", f"--loop={times}", trace], environment | more, SECONDS)
        if ended.status != 0 or not noted.exists():
            raise RuntimeError(f"eglretrace ends with {ended.status}: {ended.words.strip()[-200:]}")
        return frame_time([int(line) for line in noted.read_text().split()], times)


def rounds(trace, pair, library, count):
    """Returns [{name: milliseconds}]: in each round all replay the trace, one right after the other."""
    by = environments(pair)
    return [{name: replay(trace, environment, library) for name, environment in by.items()} for _ in range(count)]
