#!/usr/bin/env python3
"""Tests how the tools read and write pictures: host_sim/tools/png.py undoes each filter of the PNG specification, and
host_sim/tools/apng.py writes pictures that move as the specification of APNG says."""
import pathlib
import random
import struct
import sys
import unittest
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import apng  # noqa: E402
import hero  # noqa: E402
import png  # noqa: E402


def paeth(left, up, corner):
    """The predictor as the PNG specification writes it (9.4)."""
    estimate = left + up - corner
    to_left, to_up, to_corner = abs(estimate - left), abs(estimate - up), abs(estimate - corner)
    if to_left <= to_up and to_left <= to_corner:
        return left
    return up if to_up <= to_corner else corner


PREDICTORS = (lambda left, up, corner: 0, lambda left, up, corner: left, lambda left, up, corner: up,
              lambda left, up, corner: (left + up) // 2, paeth)


def filtered(kind, row, above, channels):
    """Returns a row of a PNG file: its filter type, and the filtered bytes."""
    left = bytes(channels) + row[:-channels]
    corner = bytes(channels) + above[:-channels]
    return bytes([kind]) + bytes((row[i] - PREDICTORS[kind](left[i], above[i], corner[i])) & 255 for i in range(len(row)))


def file_of(rows, width, channels, kind_of_row):
    """Returns a PNG file of these rows of bytes."""
    flat, above = b"", bytes(width * channels)
    for y, row in enumerate(rows):
        flat += filtered(kind_of_row(y), row, above, channels)
        above = row
    header = struct.pack(">IIBBBBB", width, len(rows), 8, 2 if channels == 3 else 6, 0, 0, 0)
    parts = ((b"IHDR", header), (b"IDAT", zlib.compress(flat)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
                                           for name, body in parts)


def random_rows(width, height, channels, values):
    return [bytes(random.choice(values) for _ in range(width * channels)) for _ in range(height)]


def pixels(rows, channels):
    return [[tuple(row[i:i + 3]) for i in range(0, len(row), channels)] for row in rows]


class Files(unittest.TestCase):
    def test_each_filter_is_undone(self):
        random.seed(1)
        for channels in (3, 4):
            for kind in range(5):
                for values in (range(256), (0, 1, 127, 128, 254, 255)):
                    rows = random_rows(19, 8, channels, values)
                    with self.subTest(channels=channels, kind=kind):
                        self.assertEqual(png.read(file_of(rows, 19, channels, lambda y: kind)), (19, 8, pixels(rows, channels)))

    def test_each_row_has_its_own_filter(self):
        random.seed(2)
        rows = random_rows(1, 40, 4, range(256))
        self.assertEqual(png.read(file_of(rows, 1, 4, lambda y: y * 7 % 5)), (1, 40, pixels(rows, 4)))

    def test_a_file_without_all_of_its_rows_is_refused(self):
        whole = file_of(random_rows(5, 4, 3, range(256)), 5, 3, lambda y: 0)
        with self.assertRaises(ValueError):
            png.read(whole.replace(struct.pack(">II", 5, 4), struct.pack(">II", 5, 5)))


def moving(width, height, frames):
    """Returns frames of random pixels, of which each changes a rectangle of the one before; some change nothing."""
    result = [random_rows(width, height, 3, range(4, 256))]
    for n in range(1, frames):
        canvas = list(result[-1])
        if n % 4:
            x, y = random.randrange(width), random.randrange(height)
            for row in range(y, random.randrange(y, height) + 1):
                line = bytearray(canvas[row])
                line[3 * x:3 * x + 6] = bytes(random.choice((4, 200)) for _ in line[3 * x:3 * x + 6])
                canvas[row] = bytes(line)
        result.append(canvas)
    return result


def chunks(data):
    """Returns (kind, body) of each chunk, whose checksum must be right."""
    at, found = 8, []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body, check = data[at + 8:at + 8 + length], data[at + 8 + length:at + 12 + length]
        assert struct.unpack(">I", check)[0] == zlib.crc32(kind + body)
        found.append((kind, body))
        at += length + 12
    return found


class Moving(unittest.TestCase):
    def test_frames_come_back(self):
        random.seed(3)
        for width, height in ((1, 1), (17, 9), (40, 3)):
            with self.subTest(width=width, height=height):
                frames = moving(width, height, 9)
                self.assertEqual(apng.read(apng.write(frames, 10)), frames)

    def test_a_transparent_background_stays(self):
        frame = [apng.CLEAR * 3 + bytes(range(100, 109))] * 2
        other = [apng.CLEAR * 3 + bytes(range(110, 119))] * 2
        self.assertEqual(apng.read(apng.write([frame, other, frame], 10)), [frame, other, frame])

    def test_the_file_is_what_the_specification_asks_for(self):
        random.seed(4)
        frames = moving(12, 7, 5)
        data = apng.write(frames, 15)
        found = chunks(data)
        self.assertEqual([kind for kind, _ in found], [b"IHDR", b"acTL", b"fcTL", b"IDAT"] + [b"fcTL", b"fdAT"] * 4 + [b"IEND"])
        self.assertEqual(struct.unpack(">II", found[1][1]), (5, 0))
        self.assertEqual([struct.unpack(">I", body[:4])[0] for kind, body in found if kind in (b"fcTL", b"fdAT")], list(range(9)))
        for number, (kind, body) in enumerate(found):
            if kind == b"fcTL":
                _, width, height, x, y, delay, per, dispose, blend = struct.unpack(">IIIIIHHBB", body)
                self.assertTrue(width > 0 and height > 0 and x + width <= 12 and y + height <= 7)
                self.assertEqual((delay, per, dispose, blend), (1, 15, 0, 0 if number == 2 else 1))
        # A viewer that does not know APNG shows the first frame.
        self.assertEqual(png.read_lines(data), frames[0])

    def test_only_the_clear_colour_is_transparent(self):
        # The bytes of CLEAR also stand across two pixels here.
        row = bytes((9, 1, 2, 3, 7, 7)) + apng.CLEAR + bytes((0, 0, 0))
        self.assertEqual(apng.with_alpha(row), bytes((9, 1, 2, 255, 3, 7, 7, 255, 0, 0, 0, 0, 0, 0, 0, 255)))
        self.assertEqual(apng.without_alpha(apng.with_alpha(row)), row)

    def test_a_lost_frame_is_noticed(self):
        random.seed(5)
        data = apng.write(moving(6, 6, 3), 10)
        with self.assertRaises(ValueError):
            apng.read(data.replace(struct.pack(">II", 3, 0), struct.pack(">II", 4, 0)))

    def test_the_glasses_fit_beside_each_other(self):
        sizes = {"st7796s-spi": (480, 320), "ili9341-spi": (320, 240), "gc9a01": (240, 240), "ssd1327-spi": (128, 128),
                 "ssd1306-spi": (128, 64)}
        taken = []
        for words, _, times, x, y in hero.GLASSES:
            width, height = sizes[words[-1]]
            box = (x - hero.BEZEL, y - hero.BEZEL, x + times * width + hero.BEZEL, y + times * height + hero.BEZEL)
            self.assertTrue(min(box) >= 0 and box[2] <= hero.WIDTH and box[3] <= hero.HEIGHT, box)
            for other in taken:
                self.assertTrue(box[0] >= other[2] or box[2] <= other[0] or box[1] >= other[3] or box[3] <= other[1], (box, other))
            taken.append(box)


if __name__ == "__main__":
    unittest.main()
