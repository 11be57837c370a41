"""How firmware is built: compilers and flags of the emulated processors, a Ninja file, and a run in QEMU.

Boards and benchmarks share this module; it knows no single board.
"""
import dataclasses
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402
INCLUDES = [f"-I{ROOT}"] + [f"-I{ROOT}/{room}/include" for room in ("raster/format", "raster", "gl", "hal", "hal/mcu", "boards")]
# With these flags GCC keeps every call that has effects; SPANGLE_SOUND_CALLS in cmake/SpangleTargets.cmake says why.
SOUND_CALLS = ["-fno-delete-null-pointer-checks", "-fno-ipa-modref"]
FLAGS = ["-std=c++20", "-ffreestanding", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", "-fno-tree-loop-distribute-patterns",
         "-ffunction-sections", "-fdata-sections", "-ffp-contract=off", "-DSPANGLE_FIRMWARE=1", "-DSPANGLE_MESSAGES=0", *SOUND_CALLS, *INCLUDES]
CORE = ["raster/numeric", "raster/surface", "raster/compile", "raster/ops", "raster/chain", "raster/fused",
        "raster/primitive", "raster/band", "hal/bus", "hal/panel", "hal/display",
        "gl/api", "gl/api/generated", "gl/context", "gl/vertex", "gl/pixel", "gl/texture", "gl/list", "gl/egl"]
HOT = ("raster/compile", "raster/ops", "raster/chain", "raster/fused", "raster/primitive", "raster/surface", "gl/vertex", "gl/list")  # built with -O2; the other rooms are built for size
# The ids of the scenes, and the names of their objects in boards/scenes.
SCENES = {"S1": "clear", "S2": "two_triangles", "S3": "gouraud", "S4": "plane", "S4b": "plane_linear", "S4r": "plane_rolled", "S5": "gears",
          "S6": "torus", "S7": "sprites", "S8": "wireframe", "S9": "torus_textured", "HUD": "hud", "BAKED": "rocket", "TINY": "tiny",
          "CUBE": "cube"}
LTO = ("-flto=auto", "-flto-partition=one", "-Os", "-ffreestanding", "-fno-tree-loop-distribute-patterns", *SOUND_CALLS)  # link flags
SMALL = ("-fno-schedule-insns2", "-fno-move-loop-invariants")  # beside -Os in images optimized as a whole: 0.8 % less text
CCACHE = ["ccache"] if shutil.which("ccache") else []
THUMB = ["-mthumb", "-mfloat-abi=soft"]
ENVIRONMENT = {**os.environ, "QEMU_AUDIO_DRV": "none"}
# Warnings of QEMU about things that the machines do not need.
HARMLESS = ("qemu: module audio-", "Timer with period zero")
# RISC-V uses the C++ headers of the Arm package: both compilers have the same version, and only headers are taken.
RISCV_HEADERS = ["-isystem", "/usr/include/newlib/c++/12.2.1", "-isystem", "/usr/include/newlib/c++/12.2.1/arm-none-eabi",
                 "-isystem", "/usr/lib/picolibc/riscv64-unknown-elf/include"]


@dataclasses.dataclass(frozen=True)
class Target:
    """A processor: the prefix of its compiler, the flags that name the processor, and the folder of its start-up code."""
    prefix: str
    machine: tuple
    startup: str
    headers: tuple = ()


def _cortex_m(cpu):
    return Target("arm-none-eabi-", (f"-mcpu={cpu}", *THUMB), "hal/mcu/cortex_m")


TARGETS = {cpu: _cortex_m(cpu) for cpu in ("cortex-m0", "cortex-m0plus", "cortex-m3", "cortex-m4", "cortex-m7", "cortex-m33", "cortex-m33+nodsp", "cortex-m55")}
TARGETS["cortex-a9"] = Target("arm-none-eabi-", ("-mcpu=cortex-a9", *THUMB), "hal/mcu/cortex_a")
TARGETS["rv32imac"] = Target("riscv64-unknown-elf-", ("-march=rv32imac", "-mabi=ilp32"), "hal/mcu/riscv", tuple(RISCV_HEADERS))


def sound_calls(compiler):
    """Returns SOUND_CALLS if the compiler is a GCC; clang does not have GCC's fault."""
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout
    return [] if "clang" in version else SOUND_CALLS


def source_flags(source):
    """Returns the flags of one source behind SOUND_CALLS. The loops of the fused spans keep the pass modref (raster/CMakeLists.txt says
    why).
    """
    return ["-fipa-modref"] if source.match("raster/fused/part_*.cpp") else []


def missing(targets):
    """Returns the programs that these targets need and that are not installed."""
    wanted = {TARGETS[t].prefix + "g++" for t in targets}
    wanted |= {"qemu-system-riscv32" if t.startswith("rv") else "qemu-system-arm" for t in targets}
    return sorted(program for program in wanted if shutil.which(program) is None)


def sources():
    """Yields (room, file) for each source of the core."""
    for room in CORE:
        for path in sorted((ROOT / room).glob("*.cpp")):
            if not path.name.endswith("_reference.cpp"):
                yield room, path


def startup(target):
    """Returns the sources that a processor's programs start with and, in an emulator, end with."""
    return [ROOT / "hal/mcu/memory.cpp", *sorted((ROOT / TARGETS[target].startup).glob("*.[cS]*")), ROOT / "hal/mcu/emulated/panic.cpp"]


class Build:
    """A folder of objects and images, which one run of Ninja brings up to date."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        self.lines = ["rule compile", "  description = $out", "  command = $compiler $flags -MMD -MF $out.d -c $in -o $out", "  depfile = $out.d", "  deps = gcc",
                      "rule link", "  description = $out", "  command = $compiler $flags -nostartfiles -nostdlib -Wl,--gc-sections $in -lgcc -o $out"]
        self.known = set()

    def compile(self, target, optimize, source, defines=(), variant="", lto=False):
        """Adds the object of one source. `variant` keeps builds with different definitions apart. With `lto` the object is optimized with
        the rest of its image; start-up code and mem* are not, because the compiler calls them by itself.
        """
        chosen = TARGETS[target]
        name = str(source.relative_to(ROOT) if source.is_relative_to(ROOT) else source.name).replace("/", "_")
        out = self.folder / "objects" / target / variant / (name + ".o")
        if out not in self.known:
            self.known.add(out)
            flags = [*FLAGS, *source_flags(source), *chosen.machine, *chosen.headers, optimize, *defines]
            if lto and not source.is_relative_to(ROOT / "hal/mcu"):
                flags += ["-flto", *(SMALL if optimize == "-Os" else ())]
            self.lines += [f"build {out}: compile {source}", f"  compiler = {' '.join([*CCACHE, chosen.prefix + 'g++'])}",
                           "  flags = " + " ".join(f"'{flag}'" for flag in flags)]
        return out

    def library(self, target, defines=(), variant="", hot=HOT, lto=False):
        """Adds the objects of the core and the scenes. `hot` names the rooms and files that are built for speed."""
        objects = [self.compile(target, "-O2" if room in hot or f"{room}/{path.name}" in hot else "-Os", path, defines, variant, lto) for room, path in sources()]
        objects += [self.compile(target, "-O2", path, defines, variant, lto) for path in sorted((ROOT / "boards/scenes").glob("*.cpp"))]
        return objects

    def image(self, target, objects, script, name, lto=False, options=()):
        """Adds an ELF file of these objects, which a linker script lays out. `options` are more options of the linker."""
        out = self.folder / name
        chosen = TARGETS[target]
        inputs = " ".join(str(o) for o in objects)
        self.lines += [f"build {out}: link {inputs} | {script}", f"  compiler = {chosen.prefix}g++",
                       f"  flags = {' '.join([*chosen.machine, *(LTO if lto else ()), *options])} -L {ROOT} -T {script} -Wl,-Map={out}.map -Wl,--cref -Wl,--no-warn-rwx-segments"]
        return out

    def run(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        outfile.write(self.folder / "build.ninja", "\n".join(self.lines) + "\n")
        done = subprocess.run(["ninja", "--quiet", "-C", str(self.folder), *(["-j", os.environ["JOBS"]] if "JOBS" in os.environ else [])],
                              capture_output=True, text=True)
        if done.returncode != 0:
            said = [line for line in done.stdout.splitlines() if not line.startswith(("[", "FAILED", "ccache ", "arm-none-eabi-", "riscv64-"))]
            raise RuntimeError("the firmware does not build:\n" + "\n".join(said[-60:]) + done.stderr)


def qemu(machine, image, arguments=(), options=()):
    """Returns the command that runs an image. `machine` begins with the emulator; the program gets `arguments` by semihosting."""
    words = "".join(f",arg={word}" for word in ("spangle", *arguments))
    return [machine[0], *machine[1:], *options, "-display", "none", "-serial", "null",
            "-semihosting-config", f"enable=on,target=native{words}", "-kernel", str(image)]


def emulate(machine, image, arguments=(), options=(), status=0, timeout=300):
    """Runs an image, and returns what the program prints. Any other exit status than `status` raises an error."""
    done = subprocess.run(["timeout", str(timeout), *qemu(machine, image, arguments, ("-monitor", "none", *options))], capture_output=True,
                          text=True, env=ENVIRONMENT)
    if done.returncode != status:
        raise RuntimeError(f"{image.name} on {machine[2]}: exit {done.returncode}\n{done.stdout}{done.stderr}")
    return "\n".join(line for line in (done.stdout + done.stderr).splitlines() if not line.startswith(HARMLESS))


def source_of(path):
    """Returns the path of a source below ROOT. A cache of objects may have compiled the source in another folder."""
    parts = pathlib.PurePath(os.path.normpath(path)).parts
    inside = (pathlib.PurePath(*parts[i:]) for i in range(1, len(parts)))
    return str(next((tail for tail in inside if len(tail.parts) > 1 and (ROOT / tail).is_file()), os.path.normpath(path)))


def sizes(target, image):
    """Returns {section: bytes} of an image."""
    text = subprocess.run([TARGETS[target].prefix + "size", "-A", str(image)], capture_output=True, text=True, check=True).stdout
    return {words[0]: int(words[1]) for words in map(str.split, text.splitlines()) if len(words) == 3 and words[1].isdigit()}


# Symbols that no image may hold: the heap, exceptions, RTTI, guards of statics, standard I/O.
FORBIDDEN = re.compile(r"^(malloc|free|calloc|realloc|_sbrk|_Zn[wa]\w*|_Zd[la]\w*|__cxa_(throw|begin_catch|guard_\w+|allocate_exception|atexit)"
                       r"|__gxx_personality\w*|_Unwind\w*|_ZT[IS]\w+|f?printf|puts)$")
# Functions of floating point in software. Scenes are programs and may call them; the library may not.
FLOAT = re.compile(r"^(__aeabi_([fd]\w+|u?[il]2[fd]|ul2[fd]|cf\w+|cd\w+)|__(add|sub|mul|div|neg|eq|ne|lt|le|gt|ge|cmp|unord|extend|trunc|fix|fixuns|float|floatun)\w*[sd]f\w*)$")


def _cross_reference(image):
    """Returns {symbol: [files that define or use it]} for the symbols of a linked image."""
    text = pathlib.Path(f"{image}.map").read_text().partition("\nCross Reference Table\n")[2]
    table, symbol = {}, None
    for line in text.splitlines():
        words = line.split()
        if words and not line.startswith(" "):
            symbol = words[0]
        if words and symbol is not None:
            table.setdefault(symbol, []).append(words[-1])
    return table


def forbidden(target, image):
    """Returns the symbols in an image that must not be there."""
    text = subprocess.run([TARGETS[target].prefix + "nm", str(image)], capture_output=True, text=True, check=True).stdout
    names = {words[-1] for words in map(str.split, text.splitlines()) if words}
    found = sorted(name for name in names if FORBIDDEN.match(name))
    for symbol, files in _cross_reference(image).items():
        if symbol in names and FLOAT.match(symbol):
            found += [f"{symbol}, which {pathlib.Path(f).name} uses" for f in files if "boards_scenes_" not in f and "libgcc" not in f]
    return found
