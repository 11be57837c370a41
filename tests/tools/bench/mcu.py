"""Builds the scenes as firmware for MPS2 boards and counts their instructions in QEMU."""
import concurrent.futures
import dataclasses
import itertools
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "boards/tools"))
import firmware  # noqa: E402
from firmware import CCACHE, HOT, INCLUDES, sources  # noqa: E402,F401

SCENES = {scene: name for scene, name in firmware.SCENES.items() if scene != "BAKED"}  # in fixed point, which other GLs lack
# No emulated M0+ board has enough memory, so its code runs on the M3, whose instructions include the M0+'s.
BOARDS = {"m4": ("mps2_an386", "cortex-m4"), "m3": ("mps2_an385", "cortex-m3"), "m0+": ("mps2_an385", "cortex-m0plus")}
FLAGS = [*firmware.FLAGS, *firmware.THUMB]


@dataclasses.dataclass
class Result:
    instructions: int  # instructions of a frame, the mean of three
    picture: str  # hash of the picture of frame 2
    text: int  # bytes of .text and .rodata of the whole image
    context: int  # bytes of memory, as in the next four fields
    surface: int
    peak: int  # peak of the memory handed to GL, context and surface included
    static: int  # .data and .bss of the library
    stack: int  # most bytes of the stack that were used
    fragments: int = 0  # stored in a frame; counted if the scene is dithered


def available():
    return not firmware.missing(["cortex-m4"])


class Programs:
    """The images of one board, and what they print."""

    def __init__(self, board, folder):
        name, self.cpu = BOARDS[board]
        self.machine = ["qemu-system-arm", "-M", name.replace("_", "-")]
        self.script = ROOT / "boards" / name / "memory.ld"
        self.build = firmware.Build(folder)
        self.library = [*self.build.library(self.cpu), *(self.build.compile(self.cpu, "-Os", path) for path in firmware.startup(self.cpu))]

    def add(self, name, main, defines=()):
        own = self.build.compile(self.cpu, "-Os", main, defines, name)
        return self.build.image(self.cpu, [own, *self.library], self.script, f"{name}.elf")

    def run(self, image, *options):
        return firmware.emulate(self.machine, image, options=options)


def count(programs, image):
    """Returns the Result of one scene's image."""
    frames, memory = [], {}
    for words in map(str.split, programs.run(image, "-icount", "shift=0").splitlines()):
        if len(words) == 3 and words[0] == "frame":
            frames.append((int(words[1]), words[2]))
        elif len(words) == 2:
            memory[words[0]] = int(words[1])
    if len(frames) != 3:
        raise RuntimeError(f"{image.name}: {len(frames)} frames")
    size = subprocess.run(["arm-none-eabi-size", str(image)], capture_output=True, text=True, check=True).stdout
    return Result(sum(n for n, _ in frames) // len(frames), frames[0][1], int(size.splitlines()[1].split()[0]), **memory)


def measure(board, scenes, precisions, dithers=(False,)):
    """Returns {(scene, precision, dithered): Result}."""
    with tempfile.TemporaryDirectory() as folder:
        programs = Programs(board, folder)
        jobs = list(itertools.product(scenes, precisions, dithers))
        images = [programs.add(f"{scene}_{precision}_{dither}", ROOT / "tests/tools/bench/mcu_main.cpp",
                               [f"-DBENCH_SCENE={SCENES[scene]}", f"-DBENCH_PRECISION=EGL_PRECISION_{precision.upper()}_SPANGLE",
                                f"-DBENCH_DITHERS={str(dither).lower()}"])
                  for scene, precision, dither in jobs]
        programs.build.run()
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            return dict(zip(jobs, pool.map(lambda image: count(programs, image), images)))
