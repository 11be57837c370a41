#!/usr/bin/env python3
"""Records programs, builds the library for this host in the profile of each, and holds its frames against those of the whole library.

usage: same_bytes.py PROFILE_OF COMPILER [--tier exact|balanced|fast] [--small] PROGRAM...

PROFILE_OF: the program of tests/profile that records. PROGRAM: one of its list, or a scene as S5.
"""
import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT / "boards/tools"), str(ROOT / "tests")]
import firmware  # noqa: E402
import profile  # noqa: E402
from checks import check, failures  # noqa: E402

FLAGS = ["-std=c++20", "-O0", "-Wall", "-Wextra", "-Werror", "-fno-exceptions", "-fno-rtti", "-ffp-contract=off", *firmware.INCLUDES]


def program_object(name):
    return f"scenes::{firmware.SCENES[name]}" if name in firmware.SCENES else f"programs::{name}"


def frames(text):
    return [line for line in text.splitlines() if line.startswith("frame ")]


def record(tool, name, tier, path, small):
    """What PROFILE_OF prints."""
    done = subprocess.run([tool, name, tier, str(path), *(["small"] if small else [])], capture_output=True, text=True)
    check(done.returncode == 0, f"{name} is not recorded: {done.stdout}{done.stderr}")
    return done.stdout


def build(compiler, name, tier, path, folder):
    """The program on a build of this profile, or how that fails."""
    defines = [f"-D{definition}" for definition in profile.definitions(str(path))]
    own = [f"-DPROFILE_PROGRAM={program_object(name)}", f"-DPROFILE_PRECISION=EGL_PRECISION_{tier.upper()}_SPANGLE"]
    needed = [HERE / "draw.cpp", *(HERE / "programs").glob("*.cpp")]
    needed += [ROOT / f"boards/scenes/{file}.cpp" for file in ("font", "textures")]
    needed += [path for path in (ROOT / "boards/scenes").glob("*.cpp") if f"Scene {firmware.SCENES.get(name)}{{" in path.read_text()]
    sources = [path for _, path in firmware.sources()] + [path for path in dict.fromkeys(needed) if path.exists()]

    def compile_one(source):
        target = folder / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")
        extra = own if source.name == "draw.cpp" else []
        done = subprocess.run([*firmware.CCACHE, compiler, *FLAGS, *firmware.sound_calls(compiler), *defines, *extra, "-ffunction-sections", "-c", str(source), "-o", str(target)],
                              capture_output=True, text=True)
        return str(target), done.stderr

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        objects = list(pool.map(compile_one, sources))
    errors = "".join(text for _, text in objects)
    if errors:
        return None, errors[:3000]
    linked = subprocess.run([compiler, *(target for target, _ in objects), "-Wl,--gc-sections", "-o", str(folder / "draw")], capture_output=True, text=True)
    return (folder / "draw" if linked.returncode == 0 else None), linked.stderr[:3000]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tool")
    parser.add_argument("compiler")
    parser.add_argument("--tier", default="balanced")
    parser.add_argument("--small", action="store_true")
    parser.add_argument("programs", nargs="+")
    options = parser.parse_args()
    for name in options.programs:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / f"{name}.cmake"
            whole = record(options.tool, name, options.tier, path, options.small)
            if not path.exists():
                continue
            program, problem = build(options.compiler, name, options.tier, path, pathlib.Path(folder))
            check(program is not None, f"{name} does not build in its profile: {problem}")
            if program is None:
                continue
            drawn = subprocess.run([str(program)], capture_output=True, text=True)
            same = drawn.returncode == 0 and frames(drawn.stdout) == frames(whole) != []
            check(same, f"{name}: the profile draws something else, exit {drawn.returncode}: {frames(drawn.stdout)}, not {frames(whole)}; {drawn.stderr}\n{path.read_text()}")
            print(f"{name}: {'the same bytes' if same else 'DIFFERENT'}", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
