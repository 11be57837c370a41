#!/usr/bin/env python3
"""Builds a program as firmware for an emulated Cortex-M4, whole and in a profile, and measures both.

usage: measure.py PROFILE.cmake --tier TIER --scene SCENE [--size WxH] [--first N] [--end N] [--out FILE]
       measure.py PROFILE.cmake --tier TIER --program OBJECT --header FILE --source FILE... [...]
       measure.py PROFILE.cmake --tier TIER --trace FILE [--commands glBegin,glVertex,...] [...]

Writes one JSON object with figures of the whole library ("whole") and of the profile ("profiled"): bytes of flash by folder, bytes of
RAM, the instructions and a hash of each frame, and what a pixel costs with each state key. For the profile it also tells what each
line of the program costs. A trace becomes a program that makes the same calls (replay.py); its lines are the numbers of its calls, and
its own code does not count as flash. --commands names the trace's families of commands. If no image can replay the trace, the image
only holds these commands, and is not run. The exit status is 3 if a compiler or the emulator is not installed, and 1 if an image does
not build or does not run.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path[:0] = [str(ROOT / "boards/tools"), str(ROOT / "gl/api")]
import command_table  # noqa: E402
import firmware  # noqa: E402
import profile  # noqa: E402
import replay  # noqa: E402
from figures import BOARD, MACHINE, TARGET, flash_of, keys_of, lines_of, run  # noqa: E402
from firmware import HOT, outfile  # noqa: E402

MISSING = 3
POOL, MOST = 1536 * 1024, 3840 * 1024  # bytes of a program with buffers of 320x240; most bytes that the board has beside variables and stack
RGB565, RGB888, RGBA8888, Z16, Z24S8 = 1, 4, 8, 2, 4  # bits of SPANGLE_COLOR_FORMATS and SPANGLE_DEPTH_FORMATS
NOTHING = "measure_nothing"  # called to measure what counting itself costs
# The assembler of a trampoline, one for each command. The program calls the trampoline, which keeps the return address, and calls the
# command with the stack as it was. Counting changes no register that the command reads or returns.
TRAMPOLINE = """  .section .text.__wrap_{name},"ax",%progbits
  .thumb_func
  .global __wrap_{name}
__wrap_{name}:
  push {{r0-r3, r4, lr}}
  mov r0, lr
  movw r1, #{index}
  bl measure_begin
  pop {{r0-r3, r4, lr}}
  bl __real_{name}
  push {{r0-r3}}
  bl measure_end
  mov lr, r0
  pop {{r0-r3}}
  bx lr
"""


class Program:
    """The program that is measured: its sources, and the name of its object in the images."""

    def __init__(self, arguments, folder):
        self.first, self.end, self.trace = arguments.first, arguments.end, None
        self.commands, self.unmeasured = [], None
        if arguments.trace:
            self.object, self.header = "spangle::measure::replay", "host_sim/profile/firmware/replay.hpp"
            self.bake(arguments, folder)
        elif arguments.scene:
            name = firmware.SCENES.get(arguments.scene)
            if name is None:
                raise SystemExit(f"measure.py: no scene {arguments.scene}")
            self.object, self.header = f"spangle::scenes::{name}", "boards/scenes/scene.hpp"
            self.sources = sorted((ROOT / "boards/scenes").glob("*.cpp"))
        else:
            self.object, self.header = arguments.program, arguments.header
            self.sources = [path.resolve() for path in arguments.source]
        width, height = map(int, arguments.size.split("x"))
        self.whole, buffers, pixel_bytes = self.surface(profile.definitions(str(arguments.profile)))
        pool = POOL + max(0, width * height - 320 * 240) * pixel_bytes
        if pool > MOST:
            raise SystemExit(f"measure.py: the emulated board has no memory for {arguments.size} pixels; record a smaller window")
        self.defines = [f"-DMEASURE_PROGRAM={self.object}", f'-DMEASURE_HEADER="{self.header}"', f"-DMEASURE_WIDTH={width}",
                        f"-DMEASURE_HEIGHT={height}", f"-DMEASURE_FIRST={self.first}", f"-DMEASURE_END={self.end}",
                        f"-DMEASURE_REPLAYS={int(self.trace is not None)}", *buffers,
                        f"-DMEASURE_PRECISION=EGL_PRECISION_{arguments.tier.upper()}_SPANGLE", f"-DMEASURE_POOL={pool}"]

    @staticmethod
    def surface(definitions):
        """Returns the definitions of the whole library, those of both images' surface, and the bytes of a pixel.

        Both images ask for the same surface, which is the one of the profile.
        """
        says = dict(definition.split("=", 1) for definition in definitions)
        colors, depths = int(says.get("SPANGLE_COLOR_FORMATS", RGB565)), int(says.get("SPANGLE_DEPTH_FORMATS", Z16))
        stencil = 8 if depths & Z24S8 and not depths & Z16 else 0
        sizes = 8 if colors & (RGB888 | RGBA8888) and not colors & RGB565 else 0
        # EGL cannot be asked for a format by components that it does not know, so both builds have no other format.
        whole = [] if colors & (RGB565 | RGB888 | RGBA8888) else [f"-DSPANGLE_COLOR_FORMATS={colors}"]
        buffers = [f"-DMEASURE_STENCIL={stencil}", f"-DMEASURE_RED={sizes}", f"-DMEASURE_ALPHA={sizes if colors & RGBA8888 else 0}"]
        return whole, buffers, (4 if sizes else 2) + (4 if stencil else 2)

    def bake(self, arguments, folder):
        """Writes the source of a trace's calls. If firmware cannot make the calls, the image only holds the commands."""
        try:
            text, frames = replay.source_of(arguments.trace, self.end)
        except replay.Unbaked as why:
            self.commands, self.sources, self.unmeasured = [name for name in arguments.commands.split(",") if name], [], str(why)
            self.object, self.header = "spangle::measure::nothing", "host_sim/profile/firmware/nothing.hpp"
            if not self.commands:
                raise SystemExit(f"measure.py: {why}") from None
            return
        # A trace of one frame is measured with the work that is done only once.
        self.trace, self.end, self.first = arguments.trace, frames, min(self.first, frames - 1)
        self.sources = [folder / "replay.cpp"]
        folder.mkdir(parents=True, exist_ok=True)
        outfile.write(self.sources[0], text)

    def kept(self):
        """Returns the entry points that an image without a program must hold."""
        wanted = set(self.commands)
        return [entry.name for _, families in command_table.load()[0] for family in families
                if f"gl{family.name}" in wanted for entry in family.entries]


class Images:
    """Two images with one library: one whose size counts, and one that is run."""

    def __init__(self, build, program, name, defines):
        self.build, self.program, self.name = build, program, name
        # Only the program is built with lines to look up. Tail calls are off, because such a call would return to another line.
        self.core = [build.compile(TARGET, "-O2" if room in HOT else "-Os", path, defines, name) for room, path in firmware.sources()]
        self.setup = next(path for path in self.core if path.name == "gl_pixel_fragment_setup.cpp.o")
        self.core += [build.compile(TARGET, "-Os", path) for path in firmware.startup(TARGET)]
        optimize = "-Os" if program.trace else "-O2"
        self.own = [build.compile(TARGET, optimize, path, [*defines, "-g", "-fno-optimize-sibling-calls"], name) for path in program.sources]
        self.main = HERE / "main.cpp"
        self.defines = [*defines, *program.defines]
        self.size = self.image("size", ["-DMEASURE_SIZE"])
        self.run = None if program.commands else self.image("run", [])

    def image(self, kind, more, objects=(), options=()):
        main = self.build.compile(TARGET, "-Os", self.main, [*self.defines, *more], f"{self.name}_{kind}")
        script = self.build.folder / f"{self.name}_{kind}.ld"
        script.parent.mkdir(parents=True, exist_ok=True)
        keep = "".join(f"EXTERN({symbol})\n" for symbol in (self.program.kept() if self.program.commands else []))
        outfile.write(script, keep + (ROOT / f"boards/{BOARD}/memory.ld").read_text())
        return self.build.image(TARGET, [main, *objects, *self.own, *self.core], script, f"{self.name}_{kind}.elf", options=options)

    def counting(self):
        """Builds the image that counts for each line. The program's objects must be compiled already."""
        listing = subprocess.run(["arm-none-eabi-nm", "-u", *map(str, self.own)], capture_output=True, text=True, check=True).stdout
        commands = [NOTHING, *sorted(set(re.findall(r"\bgl[A-Z]\w*", listing)))]
        trampolines = self.build.folder / f"{self.name}_commands.S"
        outfile.write(trampolines, "  .syntax unified\n  .thumb\n" + "".join(TRAMPOLINE.format(name=name, index=i) for i, name in enumerate(commands)))
        objects = [self.build.compile(TARGET, "-Os", trampolines),
                   *(self.build.compile(TARGET, "-Os", HERE / f"{name}.cpp", ["-DMEASURE_LINES"]) for name in ("lines", "nothing_called"))]
        image = self.image("lines", ["-DMEASURE_LINES"], objects, [f"-Wl,--wrap={name}" for name in commands])
        return image, commands

    def counting_keys(self):
        """Builds the image that counts for each state key, in which the function that compiles states is wrapped."""
        listing = subprocess.run(["arm-none-eabi-nm", "-u", str(self.setup)], capture_output=True, text=True, check=True).stdout
        compiles, = set(re.findall(r"\b_ZN\w*6Engine7compile\w+", listing))
        defines = ["-DMEASURE_KEYS", f'-DMEASURE_COMPILE="{compiles}"']
        return self.image("keys", defines, [self.build.compile(TARGET, "-O2", HERE / "keys.cpp", [*self.defines, *defines], self.name)], [f"-Wl,--wrap={compiles}"])


def messages_of(arguments, program, build):
    """Returns the messages of the profile's image about what the program asks for and the profile lacks."""
    defines = ["-USPANGLE_MESSAGES", "-DSPANGLE_MESSAGES=1", *(f"-D{definition}" for definition in profile.definitions(str(arguments.profile)))]
    image = Images(build, program, "telling", defines).run
    build.run()
    done = subprocess.run(["timeout", "600", *firmware.qemu(MACHINE, image, (), ("-monitor", "none"))], capture_output=True, text=True, env=firmware.ENVIRONMENT)
    said = [line.removeprefix("message ") for line in (done.stdout + done.stderr).splitlines() if line.startswith("message ")]
    return list(dict.fromkeys(said))


def measured(images):
    total, rooms = flash_of(images.size)
    if images.program.trace:
        total -= rooms.pop("the program", 0)
    out = {"flash": total, "flash_of": rooms}
    if images.run is None:
        return out
    frames, memory, *_ = run(images.run)
    peak = memory["peak"] - memory["surface"]
    return out | {"instructions": sum(n for n, _ in frames) // len(frames), "frames": [name for _, name in frames], "buffers": memory["surface"],
                  "ram": memory["static"] + peak + memory["stack"], "ram_of": {"variables": memory["static"], "arena": peak, "stack": memory["stack"]}}


def measure(arguments, folder):
    build = firmware.Build(folder)
    program = Program(arguments, build.folder)
    whole = Images(build, program, "whole", program.whole)
    profiled = Images(build, program, "profiled", [f"-D{definition}" for definition in profile.definitions(str(arguments.profile))])
    build.run()
    out = {"board": BOARD, "whole": measured(whole), "lines": []}
    try:
        out["profiled"] = measured(profiled)
    except RuntimeError as why:
        said = messages_of(arguments, program, build)
        raise SystemExit("measure.py: the program fails in its profile: " + ("; ".join(said[:3]) or str(why))) from None
    if program.unmeasured:
        return out | {"unmeasured": program.unmeasured}
    image, commands = profiled.counting()
    of_keys = {"whole": whole.counting_keys(), "profiled": profiled.counting_keys()}
    build.run()
    frames = program.end - program.first
    for name, keys in of_keys.items():
        out[name]["keys"] = keys_of(keys, frames)
    out["lines"] = lines_of(image, commands, frames, program.trace)
    out["same_bytes"] = out["whole"]["frames"] == out["profiled"]["frames"] != []
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("profile", type=pathlib.Path)
    parser.add_argument("--tier", choices=("exact", "balanced", "fast"), required=True)
    parser.add_argument("--scene")
    parser.add_argument("--program", help="its object, as spangle::programs::wires")
    parser.add_argument("--header", help="that declares the object")
    parser.add_argument("--source", type=pathlib.Path, nargs="*", default=[])
    parser.add_argument("--trace", type=pathlib.Path, help="of apitrace")
    parser.add_argument("--commands", default="")
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--first", type=int, default=0, help="the first frame; those of a trace before it are drawn, too")
    parser.add_argument("--end", type=int, default=1, help="the frame behind the last one")
    parser.add_argument("--build", type=pathlib.Path, help="where objects and images go, and stay")
    parser.add_argument("--out", type=pathlib.Path, help="else standard output")
    arguments = parser.parse_args()
    missing = firmware.missing([TARGET]) + [tool for tool in ["apitrace"] if arguments.trace and shutil.which(tool) is None]
    if missing:
        print(f"{', '.join(missing)} not installed (./dev setup --all installs them)", file=sys.stderr)
        return MISSING
    with tempfile.TemporaryDirectory() as folder:
        text = json.dumps(measure(arguments, arguments.build or folder), indent=1) + "\n"
    if arguments.out:
        outfile.write(arguments.out, text)
    else:
        print(text, end="")
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
