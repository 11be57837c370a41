#!/usr/bin/env python3
"""Records programs, builds the library for this host in the profile of each, and holds its frames against those of the whole library.
Then other programs run on the same build. Where one asks for what the profile left out, GL raises an error and a message names the
option; without an error it draws what the whole library draws.

usage: same_bytes.py PROFILE_OF COMPILER [--tier exact|balanced|fast] [--small] [--others all|NAME,...] PROGRAM...

PROFILE_OF: the program of tests/tools/profile that records. PROGRAM: one of its list, or a scene as S5.
"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path[:0] = [str(ROOT / "boards/tools"), str(ROOT / "tests/support")]
import firmware  # noqa: E402
import profile  # noqa: E402
from checks import check, failures  # noqa: E402

FLAGS = ["-std=c++20", "-O0", "-Wall", "-Wextra", "-Werror", "-fno-exceptions", "-fno-rtti", "-ffp-contract=off", *firmware.INCLUDES]


SCENES = ["HUD", "S3", "S4r", "S5", "S7", "S9", "CUBE"]  # with the programs of the tool's list these are what `--others all` means


def frames(text):
    return [line for line in text.splitlines() if line.startswith("frame ")]


def record(tool, name, tier, path, small):
    """Returns what PROFILE_OF prints."""
    done = subprocess.run([tool, name, tier, str(path), *(["small"] if small else [])], capture_output=True, text=True)
    check(done.returncode == 0, f"{name} is not recorded: {done.stdout}{done.stderr}")
    return done.stdout


def known_options():
    """Returns the names of what a build may leave out or limit; a useful message names one of them."""
    return {f"SPANGLE_{name}" for name in profile.limits()} | {f"SPANGLE_FEATURE_{name}" for name in profile.features()} | {"SPANGLE_FUSED"}


def build(compiler, tier, path, folder):
    """Builds the programs in this profile. Returns the program, or how the build fails."""
    defines = [f"-D{definition}" for definition in profile.definitions(str(path))]
    own = [f"-DPROFILE_PRECISION=EGL_PRECISION_{tier.upper()}_SPANGLE"]
    drawing = [*(HERE / "programs").glob("*.cpp"), *(ROOT / "boards/scenes").glob("*.cpp")]
    sources = [source for _, source in firmware.sources()] + [HERE / "draw.cpp", *drawing]

    def compile_one(source):
        target = folder / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")
        # The programs themselves do not depend on the build of the library.
        chosen = own if source == HERE / "draw.cpp" else [] if source in drawing else defines
        done = subprocess.run([*firmware.CCACHE, compiler, *FLAGS, *firmware.sound_calls(compiler), *chosen, "-ffunction-sections", "-c", str(source), "-o", str(target)],
                              capture_output=True, text=True)
        return str(target), done.stderr

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        objects = list(pool.map(compile_one, sources))
    errors = "".join(text for _, text in objects)
    if errors:
        return None, errors[:3000]
    linked = subprocess.run([compiler, *(target for target, _ in objects), "-Wl,--gc-sections", "-o", str(folder / "draw")], capture_output=True, text=True)
    return (folder / "draw" if linked.returncode == 0 else None), linked.stderr[:3000]


def draw(program, name):
    """Returns the exit status, and what a program drew, raised and was told, as lines: frames, errors, messages."""
    done = subprocess.run([str(program), name], capture_output=True, text=True)
    return done.returncode, done.stdout.splitlines()


# A call that an option refused may cause a second error whose message names no option: glEnd ends what did not begin.
FOLLOWS = {"message glEnd: no glBegin came before": "message glBegin: this build", "message glPopMatrix: the stack has nothing to pop": "message glPushMatrix: the stack is full"}


def first_error(lines):
    return next((i for i, line in enumerate(lines) if line.startswith("error ")), len(lines))


def hold_other(name, other, status, lines, whole, known):
    """Checks what another program did on the profile of `name`: all of it as on the whole library, or everything until its first error."""
    end = first_error(lines)
    drawn, expected = frames("\n".join(lines[:end])), frames(whole)
    check(drawn == expected[:len(drawn)], f"{other} on the profile of {name} draws something else, and no error says so: {drawn}, not {expected}")
    if end == len(lines):
        check(status == 0 and drawn == expected != [], f"{other} on the profile of {name} ends with {status}: {lines}")
        return "the same bytes"
    check(status == 1, f"{other} on the profile of {name} ends with {status} after an error: {lines}")
    messages = [line for line in lines if line.startswith("message ")]
    for follows, refused in FOLLOWS.items():
        if any(line.startswith(refused) for line in messages):
            messages = [line for line in messages if not line.startswith(follows)]
    unclear = [line for line in messages if not known & set(re.findall(r"SPANGLE_\w+", line))]
    check(messages and not unclear, f"{other} on the profile of {name}: messages name no option: {list(dict.fromkeys(unclear)) or lines[:end + 1]}")
    return f"refused: {messages[0].removeprefix('message ')}" if messages else "refused without a word"


def run_others(tool, program, name, others, options, folder):
    known = known_options()
    for other in others:
        whole = record(tool, other, options.tier, folder / "other.cmake", options.small)
        status, lines = draw(program, other)
        print(f"{other} on the profile of {name}: {hold_other(name, other, status, lines, whole, known)}", flush=True)


def others_of(tool, wanted, name):
    listed = subprocess.run([tool, "--list"], capture_output=True, text=True, check=True).stdout.split() + SCENES
    check(wanted in (["all"], []) or set(wanted) <= set(listed), f"no programs {sorted(set(wanted) - set(listed))}")
    return [other for other in listed if other != name and (wanted == ["all"] or other in wanted)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tool")
    parser.add_argument("compiler")
    parser.add_argument("--tier", default="balanced")
    parser.add_argument("--small", action="store_true")
    parser.add_argument("--others", default="", type=lambda words: [word for word in words.split(",") if word], metavar="all|NAME,...")
    parser.add_argument("programs", nargs="+")
    options = parser.parse_args()
    for name in options.programs:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / f"{name}.cmake"
            whole = record(options.tool, name, options.tier, path, options.small)
            if not path.exists():
                continue
            program, problem = build(options.compiler, options.tier, path, pathlib.Path(folder))
            check(program is not None, f"{name} does not build in its profile: {problem}")
            if program is None:
                continue
            status, lines = draw(program, name)
            same = status == 0 and frames("\n".join(lines)) == frames(whole) != []
            check(same, f"{name}: the profile draws something else, exit {status}: {lines}, not {frames(whole)}\n{path.read_text()}")
            print(f"{name}: {'the same bytes' if same else 'DIFFERENT'}", flush=True)
            run_others(options.tool, program, name, others_of(options.tool, options.others, name), options, pathlib.Path(folder))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
