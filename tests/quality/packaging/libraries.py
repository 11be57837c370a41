#!/usr/bin/env python3
"""Tests a project that takes Spangle in another way than by find_package with static libraries.

usage: libraries.py pkg_config|shared|subdirectory BUILD_DIR

pkg_config: BUILD_DIR is installed, the prefix is moved, and programs are compiled with the flags of pkg-config alone. The command line, its
manual page and the licence are installed. shared: a build with BUILD_SHARED_LIBS, in BUILD_DIR/packaging_shared, is installed. Its
libraries have a soname and export what public headers declare and nothing else, and programs run with them.
subdirectory: add_subdirectory handles build types, and packages that are missing (nothing is compiled).
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from check import HELLO, ROOT, build_project, run

sys.path.insert(0, str(ROOT / "boards/tools"))
import firmware  # noqa: E402

COMPILER = os.environ.get("CXX", "c++")


def pkg_config(prefix, *words):
    environment = {**os.environ, "PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig")}
    done = subprocess.run(["pkg-config", *words], env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"pkg-config {' '.join(words)} failed:\n{done.stderr}")
    return done.stdout.split()


def compiled(prefix, source, program, *packages):
    """Compiles one program with the flags that pkg-config prints, and runs it."""
    flags = pkg_config(prefix, "--cflags", "--libs", *packages)
    run(COMPILER, "-std=c++20", "-O2", source, "-o", program, *flags)
    return run("env", f"LD_LIBRARY_PATH={prefix / 'lib'}", program)


def check(good, what):
    if not good:
        sys.exit(f"packaging: {what}")


def install(build, folder):
    """Installs the build into a prefix, and moves the prefix."""
    run("cmake", "--install", build, "--prefix", folder / "first")
    (folder / "first").rename(folder / "prefix")
    return folder / "prefix"


def through_pkg_config(build, outside):
    prefix = install(build, outside)
    print(compiled(prefix, HELLO / "hello.cpp", outside / "hello", "spangle-gl", "spangle-sim"), end="")
    print(compiled(prefix, HELLO / "raster.cpp", outside / "raster", "spangle-raster"), end="")
    print(compiled(prefix, HELLO / "accuracy.cpp", outside / "accuracy", "spangle-gl_reference"), end="")
    cache = (build / "CMakeCache.txt").read_text()
    gcc = "gcc" in run(re.search(r"CMAKE_CXX_COMPILER:\w+=(.*)", cache).group(1), "--version").lower()
    flags = pkg_config(prefix, "--cflags", "spangle-gl")
    check(not gcc or set(firmware.SOUND_CALLS) <= set(flags), f"spangle-gl.pc has not the flags that GCC needs: {flags}")
    check("-DSPANGLE_FEATURE_LISTS=1" in flags, f"spangle-gl.pc does not tell the features: {flags}")
    check(not [word for word in pkg_config(prefix, "--libs", "spangle-raster") if "png" in word or "gl" in word.split("_")], "spangle-raster.pc asks for more")
    said = run(prefix / "bin/spangle", "--version")
    check(said.strip() != "", "the installed command line does not run")
    check("MIT" in (prefix / "share/doc/spangle/LICENSE").read_text(), "the licence is not installed")
    check((prefix / "share/man/man1/spangle.1").is_file(), "the manual page is not installed")
    return 0


def exported(library):
    """Returns the names that a shared library exports, demangled."""
    return {line.split(maxsplit=2)[2] for line in run("nm", "-DC", "--defined-only", library).splitlines()}


def shared(build, outside):
    own = build / "packaging_shared"
    run("cmake", "-S", ROOT, "-B", own, "-G", "Ninja", "-DSPANGLE_TESTS=OFF", "-DSPANGLE_CLI=OFF", "-DBUILD_SHARED_LIBS=ON")
    run("cmake", "--build", own)
    prefix = install(own, outside)
    version = re.search(r"project\(Spangle VERSION (\d+)\.(\d+)", (ROOT / "CMakeLists.txt").read_text()).groups()
    for name in ("spangle", "spangle_sim"):
        soname = f"lib{name}.so.{'.'.join(version)}"
        check(f"[{soname}]" in run("readelf", "-d", prefix / f"lib/lib{name}.so"), f"lib{name}.so has not the soname {soname}")
        check((prefix / "lib" / soname).exists(), f"{soname} is not installed")
    check(not list((prefix / "lib").glob("*.a")), "static libraries are installed beside the shared ones")
    shown = exported(prefix / "lib/libspangle.so")
    header = (ROOT / "gl/include/spangle/GL/gl.h").read_text() + (ROOT / "gl/include/spangle/EGL/egl.h").read_text()
    declared = set(re.findall(r"\b(gl[A-Z]\w*|egl[A-Z]\w*)\s*\(", header))
    check(len(declared) > 400, "the headers declare hardly anything")
    check(declared <= shown, f"libspangle.so does not show {sorted(declared - shown)[:10]}")
    # Users may name the rasterizer, and the tiers' knobs, which are variables of a public header.
    inner = [name for name in shown if re.match(r"spangle::(gl|egl)::|spangle::raster::(?!Rasterizer::|FragmentState::|clear|(exact|balanced|fast)_knobs$)", name)]
    check(not inner, f"libspangle.so shows what is internal: {inner[:10]}")
    print(compiled(prefix, HELLO / "hello.cpp", outside / "hello_pc", "spangle-gl", "spangle-sim"), end="")
    project = shutil.copytree(HELLO, outside / "hello")
    build_project(project, outside, f"-DCMAKE_PREFIX_PATH={prefix}")
    print(run(outside / "build/hello") + run(outside / "build/raster"), end="")
    check("libspangle.so" in run("ldd", outside / "build/hello"), "the program of find_package does not use the shared library")
    return 0


PROJECT = """cmake_minimum_required(VERSION 3.22)
project(Own LANGUAGES CXX)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(SPANGLE_HOST ON)
add_subdirectory({root} spangle EXCLUDE_FROM_ALL)
add_executable(own own.cpp)
target_link_libraries(own Spangle::gl)
if(OWN_SIM)
    target_link_libraries(own Spangle::sim)
endif()
if(TARGET spangle)
    message(STATUS "there is a command line")
endif()
"""
# CMake's options that make it find none of the packages for the command line, pictures and real buses.
BARE = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in ("CLI11", "fmt", "nlohmann_json", "PkgConfig", "GTest")]


def subdirectory(outside):
    (outside / "CMakeLists.txt").write_text(PROJECT.format(root=ROOT))
    (outside / "own.cpp").write_text("int main() { return 0; }\n")

    def optimized(name, *options):
        """Configures a project. Returns what CMake says, and the -O flags of Spangle's sources and of the project's own source."""
        environment = {key: value for key, value in os.environ.items() if key not in ("CXXFLAGS", "CMAKE_BUILD_TYPE")}
        done = subprocess.run(["cmake", "-S", outside, "-B", outside / name, "-G", "Ninja", *options], capture_output=True, text=True, env=environment)
        check(done.returncode == 0, f"{name}: configuring fails:\n{done.stdout}{done.stderr}")
        levels = {"gl": set(), "own": set()}
        for entry in json.loads((outside / name / "compile_commands.json").read_text()):
            for room, folder in (("gl", ROOT / "gl"), ("own", outside / "own.cpp")):
                if entry["file"].startswith(str(folder)):
                    levels[room].add(" ".join(re.findall(r" (-O\w*)", entry["command"])))
        return done.stdout, levels["gl"], levels["own"]

    said, library, own = optimized("default", "-DOWN_SIM=ON")
    check(library == {"-O2"}, f"without a build type Spangle is compiled with {library}")
    check(own == {""}, "the project's own sources are optimized, which its author did not ask for")
    check("Release" in said, "nothing says that Spangle is a Release build")
    check("there is a command line" not in said, "a project that did not ask for the command line builds it")
    for name, option, level in (("debug", "-DCMAKE_BUILD_TYPE=Debug", ""), ("flags", "-DCMAKE_CXX_FLAGS=-Og", "-Og"), ("size", "-DCMAKE_BUILD_TYPE=MinSizeRel", "-Os")):
        library = optimized(name, option)[1]
        check(library == {level}, f"{option}: Spangle is compiled with {library}")
    said = optimized("bare", *BARE, "-DSPANGLE_CLI=ON", "-DOWN_SIM=ON")[0]
    missing = re.search(r"command line is left out.*", said)
    check(missing and "libcli11-dev" in missing.group(0) and "libsdl2-dev" in missing.group(0), f"what the command line lacks is not said:\n{said}")
    check("there is a command line" not in said, "the command line is built without its libraries")
    said = optimized("no_png", *BARE, "-DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON")[0]
    check("libpng-dev" in said, f"without libpng nothing is said:\n{said}")
    return 0


def main():
    ways = ("pkg_config", "shared", "subdirectory")
    if len(sys.argv) != 3 or sys.argv[1] not in ways:
        print(__doc__.strip())
        return 2
    build = pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        outside = pathlib.Path(folder)
        if sys.argv[1] == "subdirectory":
            return subdirectory(outside)
        return through_pkg_config(build, outside) if sys.argv[1] == "pkg_config" else shared(build, outside)


if __name__ == "__main__":
    sys.exit(main())
