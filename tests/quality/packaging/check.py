#!/usr/bin/env python3
"""Builds and runs projects outside of the tree against Spangle, as a user would.

usage: check.py find_package|fetch_content|self_test|cortex_m|rv32|raspberry_pi|oled_i2c|gud_display|ftdi_adapter BUILD_DIR

find_package: installs BUILD_DIR into a temporary prefix, where the project finds it. fetch_content: gives the source tree to FetchContent.
The project links every exported library, draws a triangle on a simulated board and checks the glass.
self_test: the example boards/examples/self_test with the installed package. Its tests pass; with another golden picture one test fails and
leaves the difference.
cortex_m, rv32: installs a build for that processor, builds a project outside with the toolchain file, runs it in QEMU, and compares its
picture with that of the same project on this machine.
raspberry_pi, oled_i2c, gud_display, ftdi_adapter: builds these examples with the installed package. They must report what this machine
lacks.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
HELLO = pathlib.Path(__file__).with_name("hello")
SELF_TEST = ROOT / "boards/examples/self_test"
EXAMPLES = {  # program, arguments, and what it says where there is no such device
    "raspberry_pi": ("cube", ["0"], "cube: /dev/spidev0.0: open: No such file"),
    "oled_i2c": ("gem", ["0"], "gem: /dev/i2c-1 address 3Ch: open: No such file"),
    "ftdi_adapter": ("clock", ["0", "/dev/bus/usb/999/999"], "clock: /dev/bus/usb/999/999: open: No such file"),
    "gud_display": ("triangle", ["0", "/dev/bus/usb/999/999"], "triangle: eglInitialize: /dev/bus/usb/999/999: open: No such file"),
}


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        print(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
        sys.exit(1)
    return done.stdout


def installed(build, outside):
    run("cmake", "--install", build, "--prefix", outside / "prefix")
    return f"-DCMAKE_PREFIX_PATH={outside / 'prefix'}"


def build_project(project, outside, option):
    run("cmake", "-S", project, "-B", outside / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", option)
    run("cmake", "--build", outside / "build", "-j", os.cpu_count() or 2)


def hello(way, build, outside):
    project = shutil.copytree(HELLO, outside / "hello")
    option = installed(build, outside) if way == "find_package" else f"-DHELLO_SPANGLE_SOURCE={ROOT}"
    build_project(project, outside, option)
    print(run(outside / "build/hello") + run(outside / "build/raster") + run(outside / "build/accuracy"), end="")
    return 0


def self_test(build, outside):
    project = shutil.copytree(SELF_TEST, outside / "self_test", ignore=shutil.ignore_patterns("build"))
    build_project(project, outside, installed(build, outside))
    tests = ["ctest", "--test-dir", str(outside / "build"), "--output-on-failure"]
    print(run(*tests), end="")
    golden = project / "goldens/gauge_70.png"
    shutil.copy(ROOT / "docs/pictures/gears.png", golden)
    wrong = subprocess.run(tests, capture_output=True, text=True)
    if wrong.returncode == 0 or "1 tests failed out of" not in wrong.stdout or not golden.with_suffix(".difference.png").is_file():
        print(f"another golden picture was not noticed:\n{wrong.stdout}{wrong.stderr}")
        return 1
    run("env", "SPANGLE_UPDATE_GOLDEN=1", *tests)
    print(run(*tests), end="")
    if golden.read_bytes() != (SELF_TEST / "goldens/gauge_70.png").read_bytes():
        print("the updated golden picture is not the one of the source tree")
        return 1
    return 0


def example(way, build, outside):
    program, words, says = EXAMPLES[way]
    project = shutil.copytree(ROOT / "boards/examples" / way, outside / way, ignore=shutil.ignore_patterns("build"))
    option = installed(build, outside)
    if not list((outside / "prefix").rglob("rules.d/60-spangle.rules")):
        print("the udev rules are not installed")
        return 1
    build_project(project, outside, option)
    if pathlib.Path("/dev/spidev0.0").exists():
        return 0  # this machine has the device: to run the example is left to its owner
    done = subprocess.run([outside / "build" / program, *words], capture_output=True, text=True)
    if done.returncode != 1 or not done.stderr.startswith(says):
        print(f"{program} does not say what is missing here: {done.returncode} {done.stderr}")
        return 1
    return 0


BARE_METAL = pathlib.Path(__file__).with_name("bare_metal")
QEMU = ["-display", "none", "-monitor", "none", "-serial", "null", "-semihosting-config", "enable=on,target=native", "-kernel"]
PROCESSORS = {  # toolchain file, its compiler, emulator
    "cortex_m": ("cortex-m.cmake", "arm-none-eabi-g++", ["qemu-system-arm", "-M", "mps2-an385"]),
    "rv32": ("rv32imac.cmake", "riscv64-unknown-elf-g++", ["qemu-system-riscv32", "-M", "virt", "-bios", "none"]),
}


def bare_metal(way, build, outside):
    toolchain, compiler, emulator = PROCESSORS[way]
    missing = [program for program in (compiler, emulator[0]) if shutil.which(program) is None]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs them)")
        return 77
    project = shutil.copytree(BARE_METAL, outside / "project")
    cross = f"-DCMAKE_TOOLCHAIN_FILE={ROOT / 'cmake/toolchains' / toolchain}"
    run("cmake", "-S", ROOT, "-B", outside / "spangle", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=MinSizeRel", "-DSPANGLE_HOST=OFF", "-DSPANGLE_TESTS=OFF",
        "-DSPANGLE_FUSED_SPANS=0", cross)
    run("cmake", "--build", outside / "spangle", "-j", os.cpu_count() or 2)
    run("cmake", "--install", outside / "spangle", "--prefix", outside / "cross")
    run("cmake", "-S", project, "-B", outside / "firmware", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=MinSizeRel", cross,
        f"-DCMAKE_PREFIX_PATH={outside / 'cross'}")
    run("cmake", "--build", outside / "firmware")
    build_project(project, outside, installed(build, outside))
    emulated = subprocess.run(["timeout", "120", *emulator, *QEMU, str(outside / "firmware/picture")], capture_output=True, text=True)
    drawn, expected = (emulated.stdout + emulated.stderr).strip(), run(outside / "build/picture").strip()
    print(f"{way}: {drawn}, here {expected}")
    return 0 if emulated.returncode == 0 and drawn == expected else 1


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("find_package", "fetch_content", "self_test", *EXAMPLES, *PROCESSORS):
        print(__doc__.strip())
        return 2
    way, build = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        outside = pathlib.Path(folder)
        if way == "self_test":
            return self_test(build, outside)
        if way in PROCESSORS:
            return bare_metal(way, build, outside)
        return example(way, build, outside) if way in EXAMPLES else hello(way, build, outside)


if __name__ == "__main__":
    sys.exit(main())
