#!/usr/bin/env python3
"""Turns a trace of apitrace into a program in C++ that makes the same calls, for firmware, which cannot read traces.

Each call becomes a line whose number is that of the call (#line), so that figures by line are figures by call. Numbers that a
program handed over by address become constants. Names that GL generated stay as they are, because every name may be used without
generating it. Commands that only ask or read back are therefore left out.

usage: replay.py TRACE FRAMES OUT.cpp
"""
import math
import pathlib
import pickle
import re
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "gl/api"), str(ROOT / "host_sim/tools")]
import command_table  # noqa: E402
import outfile  # noqa: E402

END_OF_FRAME = re.compile(r"(glX|egl)SwapBuffers")
MAKE_CURRENT = re.compile(r"(glX|egl)Make(Context)?Current")
# Commands that give GL memory to write to later, or take memory of GL. A trace holds neither memory.
NOT_BAKED = ("glFeedbackBuffer", "glSelectBuffer", "glMapBuffer", "glMapBufferARB", "memcpy")
LONGEST = 500  # most calls in one function, so that the compiler's work grows only linearly
SUFFIX = re.compile(r"(ARB|EXT|SGIS)$")


class Address(int):
    """An address in the memory of the traced program."""


class Reader(pickle.Unpickler):
    """Reads the pickles of apitrace, which name a single class, that of addresses."""

    def find_class(self, module, name):
        if (module, name) != ("unpickle", "Pointer"):
            raise pickle.UnpicklingError(f"{module}.{name} is not expected")
        return Address


class Unbaked(Exception):
    """Raised with a sentence that says why no image can make the calls of a trace."""


def refuse(number, name, why):
    raise Unbaked(f"call {number}, {name}, cannot be made by firmware: {why}")


def calls_of(trace):
    """Yields (number, name, [(parameter, value)], ...) for each call."""
    with subprocess.Popen(["apitrace", "pickle", str(trace)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as apitrace:
        try:
            while True:
                yield Reader(apitrace.stdout).load()
        except EOFError:
            return
        except (pickle.UnpicklingError, ValueError, IndexError):
            raise Unbaked(f"apitrace cannot read {trace.name}") from None


def entry_points():
    return {entry.name: entry for _, families in command_table.load()[0] for family in families for entry in family.entries}


def only_asks(entry):
    """Whether the command only asks or reads back, so that it changes nothing that is drawn."""
    return entry.family.returns != "void" or any("*" in kind and "const" not in kind for kind, _ in entry.params) or entry.name == "glReadPixels"


def frames_of(trace, end):
    """Returns the calls that draw, of the first `end` frames: [[(number, entry point, values)]].

    Calls after the end of the last frame are left out.
    """
    known, frames, now, context = entry_points(), [], [], None
    for number, name, arguments, *_ in calls_of(trace):
        if len(frames) == end:
            break
        if END_OF_FRAME.fullmatch(name):
            frames.append(now)
            now = []
        elif MAKE_CURRENT.fullmatch(name):
            current = dict(arguments).get("ctx")
            if current and context not in (None, current):
                refuse(number, name, "the trace draws with several contexts, and firmware has one")
            context = current or context
        elif name in NOT_BAKED:
            refuse(number, name, "it shares memory between the program and GL, which a trace does not hold")
        elif re.match(r"gl[A-WYZ]", name):
            entry = known.get(name) or known.get(SUFFIX.sub("", name))
            if entry is None:
                refuse(number, name, "Spangle has no such command")
            if not only_asks(entry):
                now.append((number, entry, [value for _, value in arguments]))
    return frames


class Source:
    """The text of the C++ source that makes the calls of some frames."""

    def __init__(self, trace, frames):
        self.file, self.data, self.known, self.body = trace.name.replace('"', "").replace("\\", ""), [], {}, []
        counts = [self.frame(i, calls) for i, calls in enumerate(frames)]
        table = "".join(f"    case {i}:\n{''.join(f'        frame_{i}_{part}();{chr(10)}' for part in range(count))}        break;\n" for i, count in enumerate(counts))
        self.text = ('// Calls of a trace, written by host_sim/profile/firmware/replay.py.\n#include <spangle/GL/gl.h>\n\n'
                     'namespace {\n\n' + "".join(self.data) + "\n" + "".join(self.body) +
                     "\n} // namespace\n\nnamespace spangle::measure {\n\nvoid replay_frame(int frame) {\n    switch (frame) {\n" + table +
                     "    default:\n        break;\n    }\n}\n\n} // namespace spangle::measure\n")

    def frame(self, i, calls):
        parts = [calls[at:at + LONGEST] for at in range(0, len(calls), LONGEST)]
        for part, some in enumerate(parts):
            lines = "".join(f'#line {number} "{self.file}"\n    {self.call(number, entry, values)};\n' for number, entry, values in some)
            self.body.append(f"[[gnu::noinline]] void frame_{i}_{part}() {{\n{lines}}}\n")
        return len(parts)

    def call(self, number, entry, values):
        if len(values) != len(entry.params):
            refuse(number, entry.name, "its arguments are not those of the command")
        return f"{entry.name}({', '.join(self.value(number, entry.name, kind, value) for (kind, _), value in zip(entry.params, values))})"

    def value(self, number, name, kind, value):
        if "*" in kind:
            return self.address(number, name, kind, value)
        if isinstance(value, (list, bytes, str)) or value is None:
            refuse(number, name, f"{value!r:.40} is no {kind}")
        return literal(kind, value)

    def address(self, number, name, kind, value):
        if value is None or (isinstance(value, int) and value == 0):
            return "nullptr"
        element = re.sub(r"\bconst\b|\*", "", kind).strip()
        if isinstance(value, int):
            return f"reinterpret_cast<{kind}>({int(value)}u)"  # the offset into a buffer object
        if isinstance(value, str):
            value = value.encode()
        if isinstance(value, list):
            if element == "void":
                refuse(number, name, "the kind of its numbers is not known")
            return self.constant(f"const {element}", ", ".join(literal(element, one) for one in value))
        if not isinstance(value, bytes):
            refuse(number, name, f"{value!r:.40} is no {kind}")
        words = struct.unpack(f"<{(len(value) + 3) // 4}I", value + bytes(-len(value) % 4))
        return f"reinterpret_cast<{kind}>({self.constant('const unsigned', ', '.join(f'{word:#x}' for word in words))})"

    def constant(self, kind, numbers):
        """Returns the name of an array with these numbers. Equal arrays are defined only once."""
        key = kind, numbers
        if key not in self.known:
            self.known[key] = f"data_{len(self.known)}"
            self.data.append(f"alignas(8) {kind} {self.known[key]}[] = {{{numbers}}};\n")
        return self.known[key]


def literal(kind, value):
    """Returns the number as C++ source of this type, with the same bits."""
    if kind in ("GLfloat", "GLclampf", "GLdouble", "GLclampd"):
        value = float(value)
        if math.isnan(value):
            return '__builtin_nan("")'
        if math.isinf(value):
            return "-__builtin_inf()" if value < 0 else "__builtin_inf()"
        return value.hex() + ("f" if kind in ("GLfloat", "GLclampf") else "")
    value = int(value)
    return f"({kind}){value & 0xFFFFFFFF:#x}u" if value < 0 or value > 0x7FFFFFFF else str(value)


def source_of(trace, end):
    """Returns the program that makes the calls of the trace's first frames, at most `end`, and the number of these frames."""
    frames = frames_of(trace, end)
    if not frames:
        raise Unbaked(f"{trace.name} shows no frame")
    return Source(trace, frames).text, len(frames)


def main():
    if len(sys.argv) != 4:
        print(__doc__.strip())
        return 2
    try:
        text, _ = source_of(pathlib.Path(sys.argv[1]), int(sys.argv[2]))
    except Unbaked as why:
        print(f"replay.py: {why}", file=sys.stderr)
        return 1
    outfile.write(pathlib.Path(sys.argv[3]), text)
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
