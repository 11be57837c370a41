"""Draws the picture at the head of README.md: five glasses with scenes in motion, each as the simulator scans it out.

The glasses of small displays are shown with two pixels for one. Frames of the drawing are those of `spangle run`, pixel by pixel.
"""
import concurrent.futures
import os
import pathlib
import subprocess
import tempfile

import apng
import png

FRAMES, PER_SECOND = 24, 10
MOST_BYTES = 600_000  # a page with the picture must open quickly
WIDTH, HEIGHT, BEZEL = 852, 628, 10
DARK, EDGE = bytes((34, 36, 40)), bytes((98, 102, 110))
MODEL = "/usr/share/assimp/models/Collada/duck.dae"
# What is drawn; the frames of the scene until it is as at first, or looks so; pixels for a pixel; left and top of the glass.
GLASSES = [
    (["HUD", "--board", "st7796s-spi"], 120, 1, 10, 10),
    (["S5", "--board", "ili9341-spi"], 72, 1, 522, 10),
    (["BAKED", "--board", "gc9a01"], 90, 1, 10, 368),
    (["--model", MODEL, "--board", "ssd1327-spi"], 180, 2, 286, 362),
    (["TINY", "--board", "ssd1306-spi"], 60, 2, 578, 380),
]


def glass(spangle, words, number):
    """Returns the rows of the glass with frame `number` of the scene."""
    with tempfile.TemporaryDirectory() as folder:
        shot = pathlib.Path(folder) / "glass.png"
        subprocess.run([spangle, "run", *words, "--dither", "off", "--frames", str(number + 1), "--shot", str(shot)], check=True,
                       stdout=subprocess.DEVNULL)
        return png.read_lines(shot.read_bytes())


def larger(rows, times):
    """Returns the rows with `times` pixels for a pixel, each way."""
    if times == 1:
        return rows
    wide = [b"".join(row[at:at + 3] * times for at in range(0, len(row), 3)) for row in rows]
    return [row for row in wide for _ in range(times)]


def put(canvas, rows, x, y):
    """Copies the rows onto the canvas, with (x, y) as left and top."""
    for n, row in enumerate(rows, y):
        canvas[n] = canvas[n][:3 * x] + row + canvas[n][3 * x + len(row):]


def frame_around(canvas, width, height, x, y):
    """Draws a dark frame around where a glass of this size will be."""
    outer, inner = width + 2 * BEZEL, width + 2 * BEZEL - 2
    put(canvas, [EDGE * outer] + [EDGE + DARK * inner + EDGE] * (height + 2 * BEZEL - 2) + [EDGE * outer], x - BEZEL, y - BEZEL)


def frames(spangle):
    """Returns the frames of the picture, as apng.py has them."""
    numbers = [(glass_number, n) for glass_number in range(len(GLASSES)) for n in range(FRAMES)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        drawn = dict(zip(numbers, pool.map(lambda key: glass(spangle, GLASSES[key[0]][0], GLASSES[key[0]][1] * key[1] // FRAMES), numbers)))
    empty = [apng.CLEAR * WIDTH] * HEIGHT
    for number, (_, _, times, x, y) in enumerate(GLASSES):
        rows = drawn[number, 0]
        frame_around(empty, times * len(rows[0]) // 3, times * len(rows), x, y)
    result = []
    for n in range(FRAMES):
        canvas = list(empty)
        for number, (_, _, times, x, y) in enumerate(GLASSES):
            put(canvas, larger(drawn[number, n], times), x, y)
        result.append(canvas)
    return result


def made(spangle):
    """Returns the bytes of the picture, and refuses one that is too large."""
    data = apng.write(frames(spangle), PER_SECOND)
    if len(data) >= MOST_BYTES:
        raise SystemExit(f"the picture of the glasses has {len(data)} bytes, and must have fewer than {MOST_BYTES}")
    return data


def is_fresh(spangle, kept):
    """Returns whether these bytes are small enough and show the frames that this build draws."""
    return len(kept) < MOST_BYTES and apng.read(kept) == frames(spangle)
