#!/usr/bin/env python3
"""Tests the tools of host_sim/profile/firmware without a compiler and an emulator: what they read, add up and refuse.

usage: tool_test.py
"""
import pathlib
import struct
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "host_sim/profile/firmware"), str(ROOT / "tests/support"), str(ROOT / "gl/api")]
import figures  # noqa: E402
import replay  # noqa: E402
from checks import check, failures  # noqa: E402

ENTRIES = replay.entry_points()


def emulated(text, function, *arguments):
    """Returns what the function makes of an image that prints this text."""
    before, figures.firmware.emulate = figures.firmware.emulate, lambda *_, **__: text
    try:
        return function(*arguments)
    finally:
        figures.firmware.emulate = before


def counts():
    said = "frame 100 0a\nframe 300 0b\nsurface 7\nkey 256 0 256 \nkey 10 40 110 balanced full dither\nkey 1 0 1 balanced flat\nkey 5 8 13 balanced affine\nline 0 0 1 9\n"
    frames, memory, lines, keys = emulated(said, figures.run, None)
    check(frames == [(100, "0a"), (300, "0b")] and memory == {"surface": 7} and lines == [(0, 0, 1, 9)] and keys[1] == (10, 40, 110, "balanced full dither"),
          f"an image's lines are read as {frames} {memory} {lines} {keys}")
    # A call that draws nothing takes one tick; a tick is 40 instructions.
    keys = emulated(said, figures.keys_of, None, 2)
    check(keys == {"balanced full dither": {"pixels": 20, "instructions_a_pixel": 100.0}, "balanced affine": {"pixels": 4, "instructions_a_pixel": 40.0}}, f"keys: {keys}")


def flash():
    with tempfile.TemporaryDirectory() as name:
        image = pathlib.Path(name) / "image.elf"
        pathlib.Path(f"{image}.map").write_text(
            " .text.ignored  0x1 0x999 x.o\n\nLinker script and memory map\n\n .text.draw\n                0x0 0x10 /x/objects/gl_vertex_draw.cpp.o\n"
            " .text.a         0x0 0x20 /x/objects/raster_fused_part_1.o\n .rodata.b       0x0 0x30 /x/objects/raster_compile_key.cpp.o\n"
            " .data           0x0 0x8 /x/objects/replay.cpp.o\n")
        before, figures.firmware.sizes = figures.firmware.sizes, lambda *_: {".text": 0x60, ".data": 0x10, ".bss": 0x1000}
        total, rooms = figures.flash_of(image)
        figures.firmware.sizes = before
    check(total == 0x70 and rooms == {"raster/compile": 0x30, "raster/fused": 0x20, "the program": 8, "gl/vertex": 0x10, "others": 8}, f"flash: {total} {rooms}")


def literals():
    for kind, value, text in (("GLfloat", 1.5, "0x1.8000000000000p+0f"), ("GLdouble", -2, "-0x1.0000000000000p+1"), ("GLint", -1, "(GLint)0xffffffffu"), ("GLenum", 5, "5"),
                              ("GLfloat", float("inf"), "__builtin_inf()"), ("GLfloat", float("-inf"), "-__builtin_inf()"), ("GLdouble", float("nan"), '__builtin_nan("")')):
        check(replay.literal(kind, value) == text, f"{value} of {kind} is {replay.literal(kind, value)}")


def source(*calls):
    trace = pathlib.Path('a"b\\.trace')
    return replay.Source(trace, [[(number, ENTRIES[name], values) for number, name, values in calls]]).text


def calls():
    texels = struct.pack("<2I", 1, 2) + b"\x03"
    image = (7, "glTexImage2D", [3553, 0, 3, 1, 1, 0, 6407, 5121, texels])
    text = source((3, "glLoadMatrixf", [[1.0] * 16]), image, image, (9, "glVertexPointer", [3, 5126, 0, replay.Address(16)]), (10, "glDeleteTextures", [1, [4]]))
    check(text.count('const unsigned data_1[] = {0x1, 0x2, 0x3};') == 1 and text.count("data_1)") == 2, f"equal bytes are one constant: {text}")
    check('#line 9 "ab.trace"\n    glVertexPointer(3, 5126, 0, reinterpret_cast<const void*>(16u));' in text, f"an offset stays one, in the line of its call: {text}")
    check("const GLuint data_2[] = {4};" in text, text)
    many = source(*((number, "glEnd", []) for number in range(2 * replay.LONGEST + 1)))
    check(many.count("[[gnu::noinline]]") == 3 and "frame_0_2();" in many, "long frames are several functions")
    for call, says in (((1, "glEnable", []), "are not those of the command"), ((1, "glEnable", [[1]]), "is no GLenum"),
                       ((2, "glTexImage2D", [3553, 0, 3, 1, 1, 0, 6407, 5121, [1, 2]]), "kind of its numbers")):
        try:
            source(call)
            check(False, f"{call} is taken")
        except replay.Unbaked as why:
            check(says in str(why) and f"call {call[0]}, {call[1]}" in str(why), f"{call}: {why}")
    check(replay.only_asks(ENTRIES["glGetError"]) and replay.only_asks(ENTRIES["glReadPixels"]) and replay.only_asks(ENTRIES["glGenTextures"]) and
          not replay.only_asks(ENTRIES["glTexImage2D"]) and not replay.only_asks(ENTRIES["glEnd"]), "what only asks is another")


def traced(*calls):
    """Returns frames_of a trace with these calls."""
    before, replay.calls_of = replay.calls_of, lambda _: iter(calls)
    try:
        return replay.frames_of(None, 2)
    finally:
        replay.calls_of = before


def frames():
    swap, other = (0, "eglSwapBuffers", []), [("ctx", replay.Address(2))]
    now = traced((1, "eglMakeCurrent", [("ctx", replay.Address(1))]), (2, "glEnd", []), swap, (3, "glActiveTextureARB", [("texture", 33984)]), (4, "glGetError", []), swap,
                 (5, "glFlush", []), swap)
    check([[(number, entry.name, values) for number, entry, values in frame] for frame in now] == [[(2, "glEnd", [])], [(3, "glActiveTexture", [33984])]], f"frames are {now}")
    for call, says in (((7, "eglMakeCurrent", other), "several contexts"), ((7, "glMapBuffer", []), "shares memory"), ((7, "glDispatchCompute", []), "no such command")):
        try:
            traced((1, "glXMakeCurrent", [("ctx", replay.Address(1))]), call, swap)
            check(False, f"{call} is taken")
        except replay.Unbaked as why:
            check(says in str(why) and "call 7" in str(why), f"{call}: {why}")


def main():
    for part in (counts, flash, literals, calls, frames):
        part()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
