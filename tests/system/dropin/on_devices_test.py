#!/usr/bin/env python3
"""Tests that `spangle exec`, `spangle replay` and the variables show a program on real displays, here those of modelled machines.

usage: on_devices_test.py PAIR SPANGLE PROGRAM (tests/system/dropin/on_machine.cpp, which has the machine inside)
"""
import json
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "programs"))
from harness import Picture, check, failures, folder, run, spangle_environment  # noqa: E402

PAIR, SPANGLE, PROGRAM = (str(pathlib.Path(word).resolve()) for word in sys.argv[1:])
TRACE = pathlib.Path(__file__).resolve().parents[1] / "programs/traces/redbook_light.trace"
FRAMES = 3
SPI = "ili9341-spi"
# The everyday tests do without Debian's apitrace; `spangle replay` then says so, and nothing is replayed.
APITRACE = shutil.which("apitrace")
DISPLAYS = {
    "spidev": (["--spidev", "/dev/spidev0.0", "--dc", "gpiochip0:24", "--reset", "gpiochip0:25", "--light", "gpiochip0:18"],
               {"SPANGLE_SPIDEV": "/dev/spidev0.0", "SPANGLE_DC": "gpiochip0:24", "SPANGLE_RESET": "gpiochip0:25",
                "SPANGLE_LIGHT": "gpiochip0:18"}, SPI, "ili9341-spi at /dev/spidev0.0"),
    "i2c": (["--i2c", "/dev/i2c-1", "--address", "0x3C"], {"SPANGLE_I2C": "/dev/i2c-1", "SPANGLE_ADDRESS": "0x3C"},
            "ssd1306-i2c", "ssd1306-i2c at /dev/i2c-1 address 3Ch"),
    "ftdi": (["--ftdi", "--usb", "/dev/bus/usb/001/003", "--hz", "30000000"],
             {"SPANGLE_FTDI": "1", "SPANGLE_USB": "/dev/bus/usb/001/003", "SPANGLE_HZ": "30000000"}, SPI,
             "ili9341-spi at FTDI adapter /dev/bus/usb/001/003"),
    "gud": (["--gud", "--usb", "/dev/bus/usb/001/002"], {"SPANGLE_GUD": "1", "SPANGLE_USB": "/dev/bus/usb/001/002"}, None,
            "GUD display 320x240 at /dev/bus/usb/001/002"),
}


def pixels(path):
    """Returns the rows of a picture, or None."""
    if not path.exists():
        return None
    return Picture(path).rows


def near(ours, theirs):
    """Compares pictures of a GUD display, which has fewer bits than what was drawn: no component is off by more than a step of five bits.
    """
    return ours is not None and all(abs(a - b) <= 8 for row, other in zip(ours, theirs) for p, q in zip(row, other)
                                    for a, b in zip(p, q))


def simulated(place, board):
    """Returns what the glass of a simulated board shows after the same frames."""
    shot = place / f"simulated-{board}.png"
    where = ["--board", board] if board else ["--board", "none"]
    ended = run([SPANGLE, "exec", *where, "--frames", FRAMES, "--shot", shot, "--", PROGRAM], spangle_environment(PAIR))
    check(ended.status == 0, f"{board}: {ended.status}: {ended.words}")
    return pixels(shot)


def shown(name, how, glass, expected, exact):
    """Checks that the display shows what the simulated board shows, and that its model has no complaints."""
    ours = pixels(glass)
    check(ours == expected if exact else near(ours, expected), f"{name} by {how}: the display shows another picture")


with folder("devices") as place:
    (place / "eglretrace").symlink_to(PROGRAM)
    for name, (options, variables, board, where) in DISPLAYS.items():
        glass = place / f"{name}.png"
        machine = {"ON_MACHINE": name, "ON_MACHINE_GLASS": str(glass), "SPANGLE_SIGNAL": "1"}
        expected = simulated(place, board)
        ways = {
            "exec": ([SPANGLE, "exec", *options, "--frames", FRAMES, "--json", "--", PROGRAM], {}),
            "replay": ([SPANGLE, "replay", *options, "--frames", FRAMES, "--json", TRACE],
                       {"PATH": f"{place}:/usr/bin:/bin"}),
            "variables": ([PROGRAM], {**variables, "SPANGLE_FRAMES": str(FRAMES)}),
        }
        if not APITRACE:
            del ways["replay"]
        for how, (command, more) in ways.items():
            glass.unlink(missing_ok=True)
            ended = run(command, spangle_environment(PAIR, **machine, **more))
            check(ended.status == 0, f"{name} by {how}: {ended.status}: {ended.words}")
            shown(name, how, glass, expected, board is not None)
            if how == "variables":
                check(ended.words == "", f"{name}: {ended.words}")
                continue
            figures = json.loads(ended.words) if ended.words.startswith("{") else {"words": ended.words}
            check(figures.get("board") == where and figures.get("frames") == FRAMES, f"{name} by {how}: {figures}")
            check(figures.get("measured_fps", 0) > 0, f"{name} by {how}: {figures}")
            check(board is None or figures.get("bus_bytes", 0) > 1000, f"{name} by {how}: {figures}")
    plain = spangle_environment(PAIR)
    REFUSED = (
        (["--spidev", "/dev/spidev9.9", "--dc", "gpiochip0:24"], {}, 1, "spangle: /dev/spidev9.9: open: No such file"),
        (["--i2c", "/dev/i2c-1", "--board", "ili9341"], {}, 2, "does not hang on I2C; take one that does"),
        (["--ftdi", "--gud"], {}, 2, "name one display each; leave out all but one"),
        (["--gud", "--board", "none"], {}, 2, "--board none shows nothing"),
        (["--i2c", "/dev/i2c-1", "--address", "0x99"], {}, 2, "--address"),
        (None, {"SPANGLE_I2C": "/dev/i2c-1", "SPANGLE_BOARD": "ili9341"}, 2, "does not hang on I2C; take one that does"),
        (None, {"SPANGLE_ADDRESS": "0x99"}, 2, "SPANGLE_ADDRESS=0x99: it takes a number from 3 to 119"),
        (None, {"SPANGLE_FTDI": "yes"}, 2, "SPANGLE_FTDI=yes: it takes a number from 0 to 1"),
    )
    for options, more, status, says in REFUSED:
        command = [PROGRAM] if options is None else [SPANGLE, "exec", *options, "--frames", FRAMES, "--", PROGRAM]
        ended = run(command, {**plain, **more})
        check(ended.status == status and says in ended.words and ended.words.count("\n") == 1,
              f"{options} {more}: {ended.status}: {ended.words}")
    # If a device cannot be written or read, the program says so in one line, and says nothing else.
    picture = place / "x.png"
    picture.write_bytes((place / "simulated-ili9341-spi.png").read_bytes())
    FAILED = (
        (["exec", "--frames", "1", "--shot", "/dev/full", "--", PROGRAM], 1, "cannot write '/dev/full': No space left on device"),
        (["exec", "--frames", "1", "--json", "--shot", "/dev/full", "--", PROGRAM], 1, "cannot write '/dev/full'"),
        (["exec", "--size", "9999x1", "--", PROGRAM], 2, "--size takes WIDTHxHEIGHT, each 1 to 2048, not '9999x1'"),
        (["exec", "--size", "5", "--", PROGRAM], 2, "--size takes WIDTHxHEIGHT, each 1 to 2048, not '5'"),
        (["replay", str(picture)], 2,
         f"'{picture}' is not a trace of apitrace" if APITRACE else "which is not there; ./dev setup --programs installs it"),
        (["replay", str(place)], 2, f"'{place}' is not a trace of apitrace"),
        (["replay", "/dev/null"], 2, "'/dev/null' is not a trace of apitrace"),
        (["replay", str(place / "no.trace")], 2, "there is no trace"),
    )
    for command, status, says in FAILED:
        ended = run([SPANGLE, *command], plain)
        check(ended.status == status and ended.words.startswith("spangle: ") and says in ended.words and ended.words.count("\n") == 1,
              f"{command}: {ended.status}: {ended.words}")
sys.exit(1 if failures else 0)
