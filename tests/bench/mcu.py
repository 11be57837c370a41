"""Builds the scenes as firmware for MPS2 boards and counts their instructions in QEMU."""
import concurrent.futures
import dataclasses
import os
import pathlib
import shutil
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = {"S1": "clear", "S2": "two_triangles", "S3": "gouraud", "S4": "plane", "S4b": "plane_linear", "S4r": "plane_rolled", "S5": "gears",
          "S6": "torus", "S7": "sprites", "S8": "wireframe", "S9": "torus_textured", "HUD": "hud"}
# No emulated M0+ board has the memory: its code runs on the M3, whose instructions contain the M0+'s.
BOARDS = {"m4": ("mps2-an386", "cortex-m4"), "m3": ("mps2-an385", "cortex-m3"), "m0+": ("mps2-an385", "cortex-m0plus")}
INCLUDES = [f"-I{ROOT}"] + [f"-I{ROOT}/{room}/include" for room in ("raster/format", "raster", "gl", "hal")]
FLAGS = ["-std=c++20", "-mthumb", "-mfloat-abi=soft", "-ffreestanding", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", "-fno-tree-loop-distribute-patterns",
         "-ffunction-sections", "-fdata-sections", "-ffp-contract=off", "-DSPANGLE_FIRMWARE=1", "-DSPANGLE_MESSAGES=0", *INCLUDES]
CORE = ["raster/numeric", "raster/surface", "raster/span", "raster/primitive", "hal/bus", "hal/panel", "hal/display",
        "gl/api", "gl/api/generated", "gl/context", "gl/vertex", "gl/pixel", "gl/texture", "gl/list", "gl/egl"]
HOT = ("raster/span", "raster/primitive", "raster/surface", "gl/vertex", "gl/list")  # -O2; the rest is built for size
CCACHE = ["ccache"] if shutil.which("ccache") else []


@dataclasses.dataclass
class Result:
    instructions: int  # mean of three frames
    picture: str  # hash of frame 2
    text: int  # .text and .rodata of the whole image
    context: int  # bytes of memory, from here on
    surface: int
    peak: int  # most that was ever taken of the memory handed over, context and surface included
    static: int  # .data and .bss of the library
    stack: int  # deepest


def available():
    return shutil.which("arm-none-eabi-g++") and shutil.which("qemu-system-arm")


def sources():
    for room in CORE:
        for path in sorted((ROOT / room).glob("*.cpp")):
            if not path.name.endswith("_reference.cpp"):
                yield room, path


def compile_one(cpu, optimize, source, target, defines=()):
    subprocess.run([*CCACHE, "arm-none-eabi-g++", *FLAGS, f"-mcpu={cpu}", optimize, *defines, "-c", str(source), "-o", str(target)], check=True)
    return target


def build_library(cpu, folder):
    """Objects of the core and the scenes, compiled once for a CPU."""
    jobs = [(cpu, "-O2" if room in HOT else "-Os", path) for room, path in sources()]
    jobs += [(cpu, "-O2", path) for path in sorted((ROOT / "boards/scenes").glob("*.cpp"))]
    # GCC must not turn the loops of memory.cpp into calls of themselves.
    jobs += [(cpu, "-Os", path) for path in sorted((ROOT / "boards/mps2").glob("*.cpp"))]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(lambda j: compile_one(j[0], j[1], j[2], folder / (str(j[2].relative_to(ROOT)).replace("/", "_") + ".o")), jobs))


def link_image(cpu, objects, main, defines, image):
    """The program `main` with the objects it needs."""
    own = compile_one(cpu, "-Os", main, image.with_suffix(".o"), defines)
    subprocess.run(["arm-none-eabi-g++", f"-mcpu={cpu}", "-mthumb", "-mfloat-abi=soft", "-nostartfiles", "-nostdlib", "-Wl,--gc-sections",
                    "-T", str(ROOT / "boards/mps2/mps2.ld"), str(own), *map(str, objects), "-lgcc", "-o", str(image)], check=True)
    return image


def emulate(machine, image, *options):
    """What the program prints."""
    done = subprocess.run(["timeout", "300", "qemu-system-arm", "-M", machine, *options, "-display", "none", "-monitor", "none",
                           "-serial", "null", "-semihosting-config", "enable=on,target=native", "-kernel", str(image)],
                          capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{image.name} on {machine}: exit {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def count(machine, image):
    """The Result of one scene's image."""
    frames, memory = [], {}
    for words in map(str.split, emulate(machine, image, "-icount", "shift=0").splitlines()):
        if len(words) == 3 and words[0] == "frame":
            frames.append((int(words[1]), words[2]))
        elif len(words) == 2:
            memory[words[0]] = int(words[1])
    if len(frames) != 3:
        raise RuntimeError(f"{image.name} on {machine}: {len(frames)} frames")
    size = subprocess.run(["arm-none-eabi-size", str(image)], capture_output=True, text=True, check=True).stdout
    return Result(sum(n for n, _ in frames) // len(frames), frames[0][1], int(size.splitlines()[1].split()[0]), **memory)


def measure(board, scenes, precisions):
    """{(scene, precision): Result}"""
    machine, cpu = BOARDS[board]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        objects = build_library(cpu, folder)

        def one(job):
            scene, precision = job
            return count(machine, link_image(cpu, objects, ROOT / "tests/bench/mcu_main.cpp",
                                             [f"-DBENCH_SCENE={SCENES[scene]}", f"-DBENCH_PRECISION=EGL_PRECISION_{precision.upper()}_SPANGLE"],
                                             folder / f"{scene}_{precision}.elf"))

        jobs = [(scene, precision) for scene in scenes for precision in precisions]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            return dict(zip(jobs, pool.map(one, jobs)))
