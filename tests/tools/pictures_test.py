#!/usr/bin/env python3
"""Tests how the tools read pictures: host_sim/tools/png.py undoes each filter of the PNG specification."""
import pathlib
import random
import struct
import sys
import unittest
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
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


if __name__ == "__main__":
    unittest.main()
