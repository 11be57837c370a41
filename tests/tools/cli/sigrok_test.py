#!/usr/bin/env python3
"""Decodes dumps of the simulated wires with sigrok, a program of other authors: SPI, 8080 and I2C.

usage: sigrok_test.py SPANGLE

A frame of a scene is recorded. sigrok's decoders must find on the wires the commands that open a window, and then the bytes of the picture
that --shot wrote.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "host_sim/tools"), str(ROOT / "tests/support")]
import png  # noqa: E402
from checks import check, failures  # noqa: E402

SPI = ["-P", "spi:clk=SCK:mosi=SDA:cs=CS", "-B", "spi=mosi"]
PARALLEL = ["-P", "parallel:clk=WR:" + ":".join(f"d{n}=D{n}" for n in range(8)), "-A", "parallel=items"]
I2C = ["-P", "i2c:scl=SCL:sda=SDA", "-A", "i2c=start:repeat-start:stop:ack:nack:address-write:address-read:data-write:data-read:warnings"]


def words_565(rows):
    """Returns the bytes of RGB565 pixels, high byte first."""
    return b"".join((r >> 3 << 11 | g >> 2 << 5 | b >> 3).to_bytes(2, "big") for row in rows for r, g, b in row)


def pages(rows):
    """Returns the bytes of a picture in pages: a byte holds eight rows, the uppermost in bit 0."""
    return bytes(sum((rows[top + n][x][0] > 127) << n for n in range(8)) for top in range(0, len(rows), 8) for x in range(len(rows[0])))


def record(spangle, folder, board):
    """Records one frame of a dashboard. Returns its dump and its picture."""
    dump, shot = folder / f"{board}.vcd", folder / f"{board}.png"
    done = subprocess.run([spangle, "run", "HUD", "--board", board, "--vcd", str(dump), "--shot", str(shot)], capture_output=True, text=True)
    check(done.returncode == 0 and done.stderr == "", f"{board}: {done.stderr}")
    return dump, png.read(shot.read_bytes())[2]


def sigrok(dump, words):
    done = subprocess.run(["sigrok-cli", "-I", "vcd", "-i", str(dump), *words], capture_output=True)
    # Debian's Python may crash on sigrok's reference counts when the program ends; all output is there by then.
    check(done.returncode == 0 or b"bool_dealloc" in done.stderr, f"sigrok: {done.stderr}")
    return done.stdout


def spi(spangle, folder):
    dump, rows = record(spangle, folder, "ssd1331-spi")
    found = sigrok(dump, SPI)
    opened, sent = found[:6], found[6:]
    check(opened == bytes([0x15, 0, 95, 0x75, 0, 63]), f"SPI: the window of the whole glass, not {opened.hex()}")
    check(sent == words_565(rows), "SPI: the pixels of the picture")


def spi_with_start_bytes(spangle, folder):
    """Each message has a chip select of its own, and begins with the byte that stands for D/C."""
    dump, rows = record(spangle, folder, "hx8347-spi")
    found, pixels = sigrok(dump, SPI), words_565(rows)
    check(found.endswith(bytes([0x70, 0x22, 0x72]) + pixels), "start bytes: index 22h and the pixels of the picture")


def parallel(spangle, folder):
    dump, rows = record(spangle, folder, "ili9341-8080")
    found = bytes(int(word, 16) for word in re.findall(rb"^parallel-1: ([0-9A-Fa-f]+)$", sigrok(dump, PARALLEL), re.M))
    # The decoder reports a word when the next one begins, so the last word is missing.
    check(found[:1] == b"\x2c" and found[1:] == words_565(rows)[:-1], f"8080: RAMWR and the pixels of the picture, not {found[:16].hex()}")


def i2c(spangle, folder):
    """A frame is two messages to 3Ch, with every byte acknowledged: commands behind 00h, pixels behind 40h."""
    dump, rows = record(spangle, folder, "ssd1306-i2c")
    lines = [line.partition(": ")[2] for line in sigrok(dump, I2C).decode().splitlines()]
    messages = []
    for line in lines:
        if line == "Start":
            messages.append([])
        elif line not in ("Stop", "Write", "ACK"):
            check(line.startswith(("Address write: ", "Data write: ")), f"I2C: {line}")
            messages[-1].append(int(line.rpartition(" ")[2], 16))
    check(lines.count("Stop") == len(messages), "I2C: each message ends")
    check(lines.count("ACK") == sum(map(len, messages)), "I2C: each byte is acknowledged")
    check(len(messages) == 2 and all(m[0] == 0x3C for m in messages), f"I2C: two messages to 3Ch, not {len(messages)}")
    check(messages[0][1:] == [0x00, 0x21, 0, 127, 0x22, 0, 7], f"I2C: the window, not {messages[0]}")
    check(messages[1][1] == 0x40 and bytes(messages[1][2:]) == pages(rows), "I2C: the pages of the picture")


def main():
    if len(sys.argv) != 2:
        print(__doc__.strip())
        return 2
    if not shutil.which("sigrok-cli"):
        print("sigrok-cli is not installed: ./dev setup --all installs it")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        for part in (spi, spi_with_start_bytes, parallel, i2c):
            part(sys.argv[1], pathlib.Path(folder))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
