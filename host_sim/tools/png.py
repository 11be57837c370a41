"""Reads PNG files of 8-bit RGB or RGBA, and writes PNG files with a palette or of RGB. It needs only the standard library."""
import itertools
import struct
import zlib


def read(data):
    """Decodes a file that spangle --shot writes. Returns width, height and rows of (r, g, b) tuples."""
    lines = read_lines(data)
    return len(lines[0]) // 3, len(lines), [list(zip(*(line[channel::3] for channel in range(3)))) for line in lines]


def read_lines(data):
    """Decodes such a file. Returns rows of bytes, three for a pixel."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("not a PNG file")
    at, packed, width, height, channels = 8, b"", 0, 0, 0
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        at += length + 12
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", body)
            if depth != 8 or color not in (2, 6) or interlace:
                raise ValueError("only 8-bit RGB and RGBA are read")
            channels = 3 if color == 2 else 4
        elif kind == b"IDAT":
            packed += body
    flat, stride = zlib.decompress(packed), width * channels
    if len(flat) != height * (stride + 1):
        raise ValueError("the file does not hold its rows")
    rows, above = [], bytearray(stride)
    for at in range(0, height * (stride + 1), stride + 1):
        above = unfiltered(flat[at], bytearray(flat[at + 1:at + 1 + stride]), above, channels)
        rows.append(bytes(above) if channels == 3 else without_alpha(above))
    return rows


def without_alpha(row):
    """Returns a row of RGB from a row of RGBA."""
    rgb = bytearray(len(row) // 4 * 3)
    for channel in range(3):
        rgb[channel::3] = row[channel::4]
    return bytes(rgb)


def unfiltered(kind, row, above, channels):
    """Undoes the filter of a row: adds to each byte what the filter predicts. A pixel has `channels` bytes."""
    if kind == 1:  # Sub: predicts the pixel on the left
        for channel in range(channels):
            row[channel::channels] = bytes(itertools.accumulate(row[channel::channels], lambda left, byte: (left + byte) & 255))
    elif kind == 2:  # Up: predicts the pixel above; adds all bytes at once, as one number without carries between bytes
        tops = int.from_bytes(b"\x80" * len(row), "little")
        a, b = int.from_bytes(row, "little"), int.from_bytes(above, "little")
        row = bytearray((((a & ~tops) + (b & ~tops)) ^ ((a ^ b) & tops)).to_bytes(len(row), "little"))
    elif kind == 3:  # Average: predicts the mean of both
        for i in range(len(row)):
            row[i] = (row[i] + ((row[i - channels] if i >= channels else 0) + above[i]) // 2) & 255
    elif kind == 4:  # Paeth: predicts left, above or corner (left above), whichever is nearest to left + above - corner
        for i in range(channels):
            row[i] = (row[i] + above[i]) & 255
        for i in range(channels, len(row)):
            left, up, corner = row[i - channels], above[i], above[i - channels]
            to_left, to_up, to_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
            nearest = left if to_left <= to_up and to_left <= to_corner else up if to_up <= to_corner else corner
            row[i] = (row[i] + nearest) & 255
    return row


def palette(counts, colors):
    """Selects a palette by median cut. Returns {color: index} and [color of index].

    The box with the largest extent times square root of pixels is halved next.
    """
    boxes = [list(counts)]
    while len(boxes) < colors:
        def weight(box):
            return max(max(c[i] for c in box) - min(c[i] for c in box) for i in range(3)) * sum(counts[c] for c in box) ** 0.5
        box = max(boxes, key=weight)
        if len(box) == 1:
            break
        axis = max(range(3), key=lambda i: max(c[i] for c in box) - min(c[i] for c in box))
        box.sort(key=lambda c: c[axis])
        half, passed, cut = sum(counts[c] for c in box) / 2, 0, 1
        for cut, color in enumerate(box[:-1], 1):
            passed += counts[color]
            if passed >= half:
                break
        boxes.remove(box)
        boxes += [box[:cut], box[cut:]]
    index, table = {}, []
    for n, box in enumerate(boxes):
        total = sum(counts[c] for c in box)
        table.append(tuple(round(sum(c[i] * counts[c] for c in box) / total) for i in range(3)))
        index.update({c: n for c in box})
    return index, table


def write(rows, colors=256):
    """Returns the bytes of a PNG file with a palette."""
    counts = {}
    for row in rows:
        for color in row:
            counts[color] = counts.get(color, 0) + 1
    index, table = palette(counts, colors)
    flat = b"".join(b"\0" + bytes(index[color] for color in row) for row in rows)

    return file_of(rows, 3, flat, chunk(b"PLTE", bytes(v for color in table for v in color)))


def write_exact(rows):
    """Returns the bytes of a PNG file of RGB, which keeps every colour. Each row has the filter that leaves the smallest differences."""
    flat, above = bytearray(), bytes(3 * len(rows[0]))
    for row in rows:
        line = bytes(value for color in row for value in color)
        kinds = (line, less_left(line), less_above(line, above))
        best = min(kinds, key=roughness)
        flat += bytes([kinds.index(best)]) + best
        above = line
    return file_of(rows, 2, bytes(flat), b"")


def less_left(line, channels=3):
    """Filters a row by Sub, kind 1: keeps the difference to the pixel on the left."""
    return bytes((a - b) & 255 for a, b in zip(line, bytes(channels) + line))


def less_above(line, above):
    """Filters a row by Up, kind 2: keeps the difference to the pixel above."""
    return bytes((a - b) & 255 for a, b in zip(line, above))


def roughness(line):
    """Returns how far the bytes of a filtered row are from zero, in all. Rows with small bytes are likely to compress well."""
    return sum(min(value, 256 - value) for value in line)


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def file_of(rows, color_type, flat, table):
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, color_type, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + table + chunk(b"IDAT", zlib.compress(flat, 9)) + chunk(b"IEND", b""))
