#!/usr/bin/env python3
"""Builds each scene profile (cmake/profiles) as firmware for a Cortex-M4. Compares its text and RAM with the goals and the golden sizes,
and its pictures with those of the whole library.

usage: profiles.py [PROFILE...] [--update] [--build FOLDER]

Text is .text with .rodata of a linked image with start-up, EGL, one panel and one bus, without the data of the model. It is compiled with
-Os, fused spans with -O2, linked as one (-flto), without messages. The image is the program of boards/minimal; except for the profile
minimal, it has every command of GL 1.3 that the profile holds (whole: every declared command). RAM is what the pictures took of statics,
arena and stack, without the colour and depth of the screen. Exit status 1 when a picture differs or a size is above the golden one by 3 %;
77 (skipped) without compiler or emulator.
"""
import argparse
import dataclasses
import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "boards/tools"))
sys.path.insert(0, str(ROOT / "gl/api"))
import command_table  # noqa: E402
import firmware  # noqa: E402
import profile  # noqa: E402
from firmware import outfile  # noqa: E402

GOLDEN = HERE / "golden.json"
TARGET, BOARD, FRAMES = "cortex-m4", "mps2_an386", 3
BUFFERS = 320 * 240 * (2 + 2)  # bytes of the screen's colour and depth
MACHINE = ["qemu-system-arm", "-M", "mps2-an386"]
HOT = tuple(f"raster/fused/part_{part}.cpp" for part in range(8))


@dataclasses.dataclass(frozen=True)
class Subject:
    goal: int  # bytes of text; 0: there is no goal
    ram_goal: int  # bytes beyond colour and depth; 0: there is no goal
    precision: str
    scenes: tuple  # scenes whose pictures are compared with the whole library's; for a program of its own, its name
    later: bool = False  # whether it is measured with commands later than GL 1.3, too


SUBJECTS = {
    "minimal": Subject(20 * 1024, 8 * 1024, "FAST", ("MINIMAL",)),
    "first_slice": Subject(56 * 1024, 0, "BALANCED", ("BAKED", "S3", "S4", "S6", "S7", "S9")),
    "gl13": Subject(128 * 1024, 0, "BALANCED", ("BAKED", "S4b", "S5", "S6", "S8", "S9")),
    "whole": Subject(0, 0, "BALANCED", ("BAKED", "HUD", "S4b", "S5", "S6", "S7", "S8", "S9"), later=True),
}
GL_BYTES = 64 * 1024  # bytes that the whole library keeps of boards/minimal, at most
CONFIG = 5  # the config of the whole library that the profile minimal has, with depth; three tiers without depth come first


def later_rows():
    """Returns the rows of the feature matrix that a GL after 1.3 brought. The names of the rows say which."""
    rows = json.loads((command_table.API / "commands/rows.json").read_text())
    return {row["id"] for row in rows if re.search(r"\(GL (1\.[4-9]|[2-9])", row["name"])}


def commands(definitions, later):
    """Returns the commands that a build holds. If not `later`, they are those of GL 1.3, without commands that an extension or OpenGL ES
    named.
    """
    off = set(re.findall(r"SPANGLE_FEATURE_(\w+)=0", " ".join(definitions)))
    beyond = set() if later else later_rows()

    def held(entry):
        needs = [re.findall(r"SPANGLE_FEATURE_(\w+)", condition) for condition in entry.needs]
        return entry.family.row not in beyond and all(set(either) - off for either in needs)

    names = [entry.name for _, families in command_table.load()[0] for family in families for entry in family.entries if held(entry)]
    return [name for name in names if later or not re.search(r"(OES|SPANGLE)$|^gl(DepthRange|ClearDepth)f$", name)]


def image(build, name, library, sources, emulated, defines=(), keep=(), lto=False):
    """Adds an image of these sources with the board's start-up code."""
    paths = [*sources, *(path for path in firmware.startup(TARGET) if emulated or path.parent.name != "emulated")]
    own = [build.compile(TARGET, "-Os", path, defines, name, lto) for path in paths]
    script = build.folder / f"{name}.ld"
    script.parent.mkdir(parents=True, exist_ok=True)
    script.write_text("".join(f"EXTERN({symbol})\n" for symbol in keep) + (ROOT / f"boards/{BOARD}/memory.ld").read_text())
    return build.image(TARGET, [*own, *library], script, f"{name}.elf", lto)


def demo(build, name, library, scenes, subject, lto=False):
    """Adds an image of the demo of these scenes, which reports its frames."""
    defines = ["-DDEMO_SCENES=" + ",".join(f"&scenes::{firmware.SCENES[scene]}" for scene in scenes),
               f"-DDEMO_PRECISION=EGL_PRECISION_{subject.precision}_SPANGLE"]
    sources = [ROOT / path for path in ("boards/demo/main.cpp", "boards/demo/demo.cpp", "boards/demo/report_semihosting.cpp", f"boards/{BOARD}/board.cpp")]
    return image(build, name, library, sources, True, defines, lto=lto)


def minimal(build, name, library, emulated, defines, keep=(), lto=False):
    """Adds an image of the program of boards/minimal; if emulated, the image reports its frames."""
    sources = [HERE / "minimal.cpp" if emulated else ROOT / "boards/minimal/main.cpp", *(ROOT / f"boards/minimal/{file}.cpp" for file in ("rocket", "screen"))]
    return image(build, name, library, sources, emulated, defines, keep, lto)


def sized(build, name, library, defines, later):
    """Adds an image of the program of boards/minimal with the commands of a profile. The text of this image is measured."""
    kept = commands(defines, later)  # and the command that chooses a config, which that program does not call
    return minimal(build, f"{name}_size", library, False, [*defines, f"-DMINIMAL_GL_BYTES={GL_BYTES}"], [*kept, "eglChooseConfig"], lto=True)


def images_of(name, build, everything, library, defines):
    """Adds the three images of a profile: one is measured, and the pictures of the second are compared with those of the third."""
    subject = SUBJECTS[name]
    if name == "minimal":
        return (minimal(build, f"{name}_size", library, False, defines, lto=True), minimal(build, f"{name}_pictures", library, True, defines, lto=True),
                minimal(build, f"{name}_reference", everything, True, [f"-DMINIMAL_GL_BYTES={GL_BYTES}", f"-DMINIMAL_CONFIG={CONFIG}"]))
    return (sized(build, name, library, defines, subject.later),
            demo(build, f"{name}_pictures", library, subject.scenes, subject, lto=True),
            demo(build, f"{name}_reference", everything, subject.scenes, subject))


@dataclasses.dataclass
class Run:
    frames: dict  # {scene: [hash]} as the image prints them
    memory: dict  # {"arena", "peak", "stack": bytes}


def run(image):
    out, scene = Run({}, {}), None
    for words in map(str.split, firmware.emulate(MACHINE, image, (str(FRAMES),)).splitlines()):
        if words[:1] == ["scene"]:
            scene = out.frames.setdefault(words[1], [])
        elif words[:1] == ["frame"]:
            scene.append(words[1])
        elif words[:1] == ["failed"]:
            scene.append("failed: " + " ".join(words[1:]))
        elif len(words) == 2 and words[1].isdigit():
            out.memory[words[0]] = int(words[1])
    return out


def model_bytes(image):
    """Returns the bytes of baked meshes, textures and tables of scenes, which are not the library's."""

    listing = subprocess.run(["arm-none-eabi-nm", "-S", "-C", str(image)], capture_output=True, text=True, check=True).stdout
    return sum(int(size, 16) for size in re.findall(r"^\w+ (\w+) \w spangle::baked::", listing, re.M))


DOCUMENT = ROOT / "docs/profiles.md"


def with_table(text, name, table):
    """Returns the document with another table of that name."""
    before, rest = text.split(f"<!-- table: {name} -->\n")
    return f"{before}<!-- table: {name} -->\n{table}<!-- end -->" + rest.split("<!-- end -->", 1)[1]


def share(size, goal):
    return f"{size / goal:.2f} x" if goal else "-"


def sizes_table(golden):
    def cells(size, goal):
        return f"{size} | {goal or '-'} | {share(size, goal)}"

    rows = [f"| {name} | {cells(golden[name]['text'], subject.goal)} | {cells(golden[name]['ram'], subject.ram_goal)} |\n" for name, subject in SUBJECTS.items()]
    return "| profile | bytes of text | goal | of the goal | bytes of RAM | goal | of the goal |\n|---|--:|--:|--:|--:|--:|--:|\n" + "".join(rows)


def text_of(image):
    return firmware.sizes(TARGET, image)[".text"] - model_bytes(image)


def ram_of(image, memory):
    """Returns the RAM beyond the screen's buffers: variables, the peak of the arena, and the deepest stack."""
    size = firmware.sizes(TARGET, image)
    return sum(size.get(section, 0) for section in (".data", ".bss", ".noinit")) - memory["arena"] + memory["peak"] + memory["stack"] - BUFFERS


def measure(names, folder):
    """Returns {profile: ({"text", "ram": bytes}, {scene: [hash]}, {scene: [hash] of the whole library})}."""
    build = firmware.Build(folder)
    images = {}
    everything = build.library(TARGET, (), "everything")
    for name in names:
        defines = [f"-D{definition}" for definition in profile.definitions(name)]
        images[name] = images_of(name, build, everything, build.library(TARGET, defines, name, hot=HOT, lto=True), defines)
    build.run()
    measured = {}
    for name, (size, pictures, reference) in images.items():
        ours = run(pictures)
        measured[name] = {"text": text_of(size), "ram": ram_of(pictures, ours.memory)}, ours.frames, run(reference).frames
    return measured


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("profiles", nargs="*", help="else all")
    parser.add_argument("--update", action="store_true", help="keeps these sizes as the golden ones")
    parser.add_argument("--build", type=pathlib.Path, help="where objects and images go, and stay")
    arguments = parser.parse_args()
    missing = firmware.missing([TARGET])
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs them)")
        return 77
    golden = json.loads(GOLDEN.read_text()) if GOLDEN.exists() else {}
    names, bad = arguments.profiles or list(SUBJECTS), []
    with tempfile.TemporaryDirectory() as folder:
        measured = measure(names, arguments.build or folder)
    print(f"{'profile':<14}{'text':>9}{'golden':>9}{'goal':>9}{'of the goal':>13}{'ram':>9}{'golden':>9}{'goal':>9}  pictures")
    for name, (sizes, ours, theirs) in measured.items():
        subject, kept = SUBJECTS[name], golden.get(name, dict.fromkeys(sizes, 0))
        equal = ours == theirs and set(ours) == set(subject.scenes) and all(len(f) == FRAMES for f in ours.values())
        print(f"{name:<14}{sizes['text']:>9}{kept['text']:>9}{subject.goal or '-':>9}{share(sizes['text'], subject.goal):>13}{sizes['ram']:>9}{kept['ram']:>9}{subject.ram_goal or '-':>9}  "
              + ("equal" if equal else f"differ: {ours} instead of {theirs}"))
        if not equal:
            bad.append(f"{name}: pictures are not those of the whole library")
        if not arguments.update:
            bad += [f"{name}: {sizes[kind]} bytes of {kind}, {kept[kind]} are the golden ones" for kind in sizes if sizes[kind] > kept[kind] * 1.03]
        golden[name] = sizes
    if arguments.update:
        outfile.write(GOLDEN, json.dumps(golden, indent=1) + "\n")
        outfile.write(DOCUMENT, with_table(DOCUMENT.read_text(), "sizes", sizes_table(golden)))
    elif with_table(DOCUMENT.read_text(), "sizes", sizes_table(json.loads(GOLDEN.read_text()))) != DOCUMENT.read_text():
        bad.append("docs/profiles.md does not show the golden sizes; --update writes it")
    print("\n".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
