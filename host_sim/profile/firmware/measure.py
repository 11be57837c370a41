#!/usr/bin/env python3
"""Builds a program as firmware for an emulated Cortex-M4, whole and in a profile, and measures both.

usage: measure.py PROFILE.cmake --tier TIER --scene SCENE [--size WxH] [--first N] [--end N] [--out FILE]
       measure.py PROFILE.cmake --tier TIER --program OBJECT --header FILE --source FILE... [...]
       measure.py PROFILE.cmake --tier TIER --commands glBegin,glVertex,...

Writes one JSON object: of the whole library ("whole") and of the profile ("profiled") the bytes of flash by folder, bytes of RAM, and,
of programs, the instructions and a hash of each frame; of the profile also what each line of the program costs. --commands names
families of commands, of a program whose source is not there: the image holds them and is not run.
Exit status 3: a compiler or the emulator is not installed. 1: an image does not build or does not run.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path[:0] = [str(ROOT / "boards/tools"), str(ROOT / "gl/api")]
import command_table  # noqa: E402
import firmware  # noqa: E402
import profile  # noqa: E402
from firmware import HOT, outfile  # noqa: E402

TARGET, BOARD = "cortex-m4", "mps2_an386"
MACHINE = ["qemu-system-arm", "-M", BOARD.replace("_", "-")]
MISSING, POOL, NS_PER_TICK = 3, 1536 * 1024, 40
NOTHING = "measure_nothing"  # a call of no command: what counting itself takes
# A line of assembler for each command: it is called by its callers, keeps where they want to go on, and calls the command with the
# stack as it was. Counting changes no register that the command reads or gives back.
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
    """What is measured: its sources, and how the images name it."""

    def __init__(self, arguments):
        self.commands = arguments.commands.split(",") if arguments.commands else []
        if arguments.scene:
            name = firmware.SCENES.get(arguments.scene)
            if name is None:
                raise SystemExit(f"measure.py: no scene {arguments.scene}")
            self.object, self.header = f"spangle::scenes::{name}", "boards/scenes/scene.hpp"
            self.sources = sorted((ROOT / "boards/scenes").glob("*.cpp"))
        else:
            self.object, self.header = arguments.program, arguments.header
            self.sources = [path.resolve() for path in arguments.source]
        if self.commands:
            self.object, self.header = "spangle::measure::nothing", "host_sim/profile/firmware/nothing.hpp"
        width, height = arguments.size.split("x")
        self.defines = [f"-DMEASURE_PROGRAM={self.object}", f'-DMEASURE_HEADER="{self.header}"', f"-DMEASURE_WIDTH={width}",
                        f"-DMEASURE_HEIGHT={height}", f"-DMEASURE_FIRST={arguments.first}", f"-DMEASURE_END={arguments.end}",
                        f"-DMEASURE_PRECISION=EGL_PRECISION_{arguments.tier.upper()}_SPANGLE", f"-DMEASURE_POOL={POOL}"]

    def kept(self):
        """Entry points that an image without a program holds."""
        wanted = set(self.commands)
        return [entry.name for _, families in command_table.load()[0] for family in families
                if f"gl{family.name}" in wanted for entry in family.entries]


class Images:
    """Of one library, the image whose size counts and the one that is run."""

    def __init__(self, build, program, name, defines):
        self.build, self.program, self.name = build, program, name
        # The lines of the program are looked up; the library's are not.
        self.core = [build.compile(TARGET, "-O2" if room in HOT else "-Os", path, defines, name) for room, path in firmware.sources()]
        self.core += [build.compile(TARGET, "-Os", path) for path in firmware.startup(TARGET)]
        self.own = [build.compile(TARGET, "-O2", path, [*defines, "-g"], name) for path in program.sources]
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
        """The image that counts for each line; the program's objects are there already."""
        listing = subprocess.run(["arm-none-eabi-nm", "-u", *map(str, self.own)], capture_output=True, text=True, check=True).stdout
        commands = [NOTHING, *sorted(set(re.findall(r"\bgl[A-Z]\w*", listing)))]
        trampolines = self.build.folder / f"{self.name}_commands.S"
        outfile.write(trampolines, "  .syntax unified\n  .thumb\n" + "".join(TRAMPOLINE.format(name=name, index=i) for i, name in enumerate(commands)))
        objects = [self.build.compile(TARGET, "-Os", trampolines),
                   *(self.build.compile(TARGET, "-Os", HERE / f"{name}.cpp", ["-DMEASURE_LINES"]) for name in ("lines", "nothing_called"))]
        image = self.image("lines", ["-DMEASURE_LINES"], objects, [f"-Wl,--wrap={name}" for name in commands])
        return image, commands


def flash_of(image):
    """Bytes that are stored, by the folder that they come from; constants that are shared, and start-up's, are `others`."""
    out = collections.Counter()
    text = pathlib.Path(f"{image}.map").read_text().partition("\nLinker script and memory map\n")[2]
    for address, size, path in re.findall(r"^ \.(?:text|rodata|data|vectors|init_array)\S*\s+0x([0-9a-f]+)\s+0x([0-9a-f]+) (\S+)$", text, re.M):
        name = pathlib.PurePath(path).name
        room = next((room for room in sorted(firmware.CORE, key=len, reverse=True) if name.startswith(room.replace("/", "_") + "_")), None)
        out["fused spans" if "fused_part" in name else room or ("the program" if "/objects/" in path and "hal_mcu" not in name else "others")] += int(size, 16)
    sizes = firmware.sizes(TARGET, image)
    total = sizes.get(".text", 0) + sizes.get(".data", 0)
    out["others"] += total - sum(out.values())
    return total, {room: size for room, size in out.most_common() if size}


def run(image):
    """([(instructions, hash)], {kind of memory: bytes}, [(address, command, calls, ticks)])"""
    frames, memory, lines = [], {}, []
    for words in map(str.split, firmware.emulate(MACHINE, image, options=("-icount", "shift=0"), timeout=600).splitlines()):
        if words[:1] == ["frame"]:
            frames.append((int(words[1]), words[2]))
        elif words[:1] == ["line"]:
            lines.append(tuple(map(int, words[1:])))
        elif len(words) == 2 and words[1].isdigit():
            memory[words[0]] = int(words[1])
    return frames, memory, lines


def measured(images):
    total, rooms = flash_of(images.size)
    out = {"flash": total, "flash_of": rooms}
    if images.run is None:
        return out
    frames, memory, _ = run(images.run)
    peak = memory["peak"] - memory["surface"]
    return out | {"instructions": sum(n for n, _ in frames) // len(frames), "frames": [name for _, name in frames], "buffers": memory["surface"],
                  "ram": memory["static"] + peak + memory["stack"], "ram_of": {"variables": memory["static"], "arena": peak, "stack": memory["stack"]}}


def source_of(path):
    """The source as the reader knows it: from ROOT on. A cache of objects may have compiled it in a folder that lies elsewhere."""
    parts = pathlib.PurePath(os.path.normpath(path)).parts
    inside = (pathlib.PurePath(*parts[i:]) for i in range(1, len(parts)))
    return str(next((tail for tail in inside if len(tail.parts) > 1 and (ROOT / tail).is_file()), os.path.normpath(path)))


def lines_of(image, commands, frames):
    """[{"line", "command", "calls", "instructions"}] of a frame, the dearest first."""
    _, _, counted = run(image)
    nothing = [(calls, ticks) for _, command, calls, ticks in counted if command == 0]
    overhead = sum(t for _, t in nothing) / max(sum(c for c, _ in nothing), 1) * NS_PER_TICK
    counted = [line for line in counted if line[1] != 0]
    said = subprocess.run(["arm-none-eabi-addr2line", "-e", str(image)], input="\n".join(hex(address - 2) for address, *_ in counted),
                          capture_output=True, text=True, check=True).stdout.split("\n")
    sums = collections.defaultdict(lambda: [0, 0.0])
    for (_, command, calls, ticks), place in zip(counted, said):
        path, _, number = re.sub(r" \(discriminator.*", "", place).rpartition(":")
        place = f"{source_of(path)}:{number}"
        sums[place, commands[command]][0] += calls
        sums[place, commands[command]][1] += max(ticks * NS_PER_TICK - calls * overhead, 0)
    rows = [{"line": place, "command": command, "calls": round(calls / frames, 2), "instructions": round(instructions / frames)}
            for (place, command), (calls, instructions) in sums.items()]
    return sorted(rows, key=lambda row: (-row["instructions"], row["line"], row["command"]))


def measure(arguments, folder):
    build = firmware.Build(folder)
    program = Program(arguments)
    whole = Images(build, program, "whole", [])
    profiled = Images(build, program, "profiled", [f"-D{definition}" for definition in profile.definitions(str(arguments.profile))])
    build.run()
    out = {"board": BOARD, "whole": measured(whole), "profiled": measured(profiled), "lines": []}
    if not program.commands:
        image, commands = profiled.counting()
        build.run()
        out["lines"] = lines_of(image, commands, arguments.end - arguments.first)
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
    parser.add_argument("--commands")
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--first", type=int, default=0, help="the first frame")
    parser.add_argument("--end", type=int, default=1, help="the frame behind the last one")
    parser.add_argument("--build", type=pathlib.Path, help="where objects and images go, and stay")
    parser.add_argument("--out", type=pathlib.Path, help="else standard output")
    arguments = parser.parse_args()
    missing = firmware.missing([TARGET])
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
