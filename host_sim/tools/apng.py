"""Writes and reads animated PNG files (APNG) of 8-bit RGBA. It needs only the standard library.

A frame is a list of rows, and a row is bytes, three for a pixel; pixels of the colour CLEAR are transparent. In the file, a frame after
the first holds the rectangle that changed, in which pixels that did not change are transparent. So a pixel that was drawn cannot become
transparent later.
"""
import struct
import zlib

import png

CLEAR = bytes((1, 2, 3))  # no RGB565 colour and no grey, so that no glass shows it
OVER = 1  # fcTL: transparent pixels keep what is there


def changed(before, after):
    """Returns (x, y, rows): the rectangle that holds every pixel that changed, with CLEAR where one did not. One pixel if none did."""
    rows, left, right = {}, None, 0
    for y, (old, new) in enumerate(zip(before, after)):
        if old == new:
            continue
        row, first, end = bytearray(CLEAR * (len(new) // 3)), None, 0
        for at in range(0, len(new), 3):
            if old[at:at + 3] != new[at:at + 3]:
                row[at:at + 3] = new[at:at + 3]
                first, end = at if first is None else first, at + 3
        rows[y], left, right = row, first if left is None else min(left, first), max(right, end)
    if not rows:
        return 0, 0, [CLEAR]
    top, bottom = min(rows), max(rows)
    empty = CLEAR * (len(after[0]) // 3)
    return left // 3, top, [bytes(rows.get(y, empty)[left:right]) for y in range(top, bottom + 1)]


def with_alpha(row):
    """Returns a row of RGBA, in which pixels of the colour CLEAR are transparent."""
    rgba = bytearray(b"\xff" * (len(row) // 3 * 4))
    for channel in range(3):
        rgba[channel::4] = row[channel::3]
    at = row.find(CLEAR)
    while at >= 0:
        if at % 3 == 0:
            rgba[at // 3 * 4:at // 3 * 4 + 4] = bytes(4)
        at = row.find(CLEAR, at + 3 - at % 3)
    return bytes(rgba)


def without_alpha(row):
    """Returns the row of RGB that a row of RGBA was made from."""
    return b"".join(row[at:at + 3] if row[at + 3] else CLEAR for at in range(0, len(row), 4))


def packed(rows):
    """Returns the compressed rows, with the filter for all rows, or for each row, that makes them smallest."""
    above, lines = bytes(len(rows[0]) // 3 * 4), []
    for row in map(with_alpha, rows):
        lines.append((row, png.less_left(row, 4), png.less_above(row, above)))
        above = row
    ways = [[kind] * len(rows) for kind in range(3)]
    ways.append([min(range(3), key=lambda kind: png.roughness(line[kind])) for line in lines])
    return min((deflated(b"".join(bytes([kind]) + line[kind] for kind, line in zip(way, lines))) for way in ways), key=len)


def deflated(data):
    """Compresses with shorter blocks than zlib.compress has: pictures of several glasses become smaller by 1.5 %."""
    coder = zlib.compressobj(9, zlib.DEFLATED, zlib.MAX_WBITS, 6)
    return coder.compress(data) + coder.flush()


def write(frames, per_second):
    """Returns the bytes of a file that shows the frames for ever."""
    width, height = len(frames[0][0]) // 3, len(frames[0])
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    data = b"\x89PNG\r\n\x1a\n" + png.chunk(b"IHDR", header) + png.chunk(b"acTL", struct.pack(">II", len(frames), 0))
    number = 0
    for before, after in zip([None, *frames], frames):
        x, y, rows = (0, 0, after) if before is None else changed(before, after)
        control = (number, len(rows[0]) // 3, len(rows), x, y, 1, per_second, 0, OVER if before else 0)
        data += png.chunk(b"fcTL", struct.pack(">IIIIIHHBB", *control))
        number += 1
        if before is None:
            data += png.chunk(b"IDAT", packed(rows))
        else:
            data += png.chunk(b"fdAT", struct.pack(">I", number) + packed(rows))
            number += 1
    return data + png.chunk(b"IEND", b"")


def chunks(data):
    at = 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + length]
        at += length + 12


def unpacked(compressed, width):
    stride, above = 4 * width, bytes(4 * width)
    flat = zlib.decompress(compressed)
    for at in range(0, len(flat), stride + 1):
        above = bytes(png.unfiltered(flat[at], bytearray(flat[at + 1:at + 1 + stride]), above, 4))
        yield without_alpha(above)


def over(below, above):
    """Returns a row with the pixels of `above` that are not transparent on it."""
    if CLEAR not in above:
        return above
    row = bytearray(below)
    for at in range(0, len(above), 3):
        if above[at:at + 3] != CLEAR:
            row[at:at + 3] = above[at:at + 3]
    return bytes(row)


def read(data):
    """Returns the frames of a file that this module wrote, as a viewer shows them."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("not a PNG file")
    frames, canvas, control, count = [], None, None, 0
    for kind, body in chunks(data):
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            if depth != 8 or color != 6:
                raise ValueError("only 8-bit RGBA is read")
            canvas = [CLEAR * width] * height
        elif kind == b"acTL":
            count = struct.unpack(">II", body)[0]
        elif kind == b"fcTL":
            control = struct.unpack(">IIIIIHHBB", body)
        elif kind in (b"IDAT", b"fdAT"):
            _, wide, _, x, y, *_ = control
            canvas = list(canvas)
            for n, row in enumerate(unpacked(body if kind == b"IDAT" else body[4:], wide), y):
                canvas[n] = canvas[n][:3 * x] + over(canvas[n][3 * x:3 * (x + wide)], row) + canvas[n][3 * (x + wide):]
            frames.append(canvas)
    if len(frames) != count:
        raise ValueError(f"{len(frames)} frames, not the {count} of its header")
    return frames
