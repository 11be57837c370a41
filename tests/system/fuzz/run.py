#!/usr/bin/env python3
"""Builds the fuzzers with clang, ASan and UBSan, runs each for a while and says what was executed.

usage: ./dev fuzz [--seconds N] [--only NAME] [--coverage] [--keep] [--build FOLDER]

--coverage says which lines the inputs reach, too, by llvm-cov in a second build without sanitizers.

The committed inputs of tests/system/fuzz/corpus/NAME and those found in earlier runs (BUILD/corpus/NAME) are where a run starts.
An input that breaks something is left in BUILD/crashes, with the command that replays it, and the exit status is 1.
--keep makes tests/system/fuzz/corpus the fewest inputs that reach all that was reached; the everyday tests replay them.
"""
import argparse
import collections
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402
CORPUS = ROOT / "tests/system/fuzz/corpus"
# The rooms that each fuzzer is meant to reach.
ROOMS = {"gl_commands": ("gl/", "raster/"), "egl": ("gl/", "raster/"), "gud": ("hal/usb/",),
         "controller": ("host_sim/bus/pins", "host_sim/controller"),
         "model": ("host_sim/bake", "host_sim/cli/model_wire"), "picture": ("host_sim/picture/image",)}
LONGEST = {"gl_commands": 2048, "egl": 1536, "gud": 600, "controller": 1024, "model": 4096, "picture": 1024}  # bytes of an input, at most
MOST = {"egl": 48, "gud": 48}  # committed inputs, which the everyday tests replay; other fuzzers keep all that reach something new
# The flags of ./dev sanitize, so that a compiler cache serves what both compile.
SANITIZE = "-fsanitize=address,undefined -fno-sanitize-recover=all -gline-tables-only"
COVERAGE = "-fprofile-instr-generate -fcoverage-mapping"
ENVIRONMENT = {**os.environ, "UBSAN_OPTIONS": "print_stacktrace=1", "ASAN_SYMBOLIZER_PATH": shutil.which("llvm-symbolizer-14") or ""}


def build(folder, flags, targets):
    folder.mkdir(parents=True, exist_ok=True)
    log = folder / "build.log"
    for command in (["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DSPANGLE_TESTS=OFF", "-DSPANGLE_FUZZ=ON",
                     "-DCMAKE_CXX_COMPILER=clang++-14", "-DCMAKE_CXX_FLAGS_RELEASE=-O1", f"-DCMAKE_CXX_FLAGS={flags}"],
                    ["cmake", "--build", folder, "-j", os.environ.get("JOBS", str(os.cpu_count() or 2)), "--target", *targets]):
        with open(log, "w") as out:
            if subprocess.run([str(word) for word in command], stdout=out, stderr=subprocess.STDOUT).returncode != 0:
                print(log.read_text()[-4000:])
                sys.exit(f"fuzz: the build failed; {log}")


def start(name, folder, seconds):
    """Runs one fuzzer on the committed and the earlier inputs; new inputs go to the folder of this machine."""
    found, crashes = folder / "corpus" / name, folder / "crashes"
    crashes.mkdir(exist_ok=True)
    log = folder / f"{name}.log"
    command = [folder / "tests/system/fuzz" / f"fuzz_{name}", f"-max_total_time={seconds}", f"-max_len={LONGEST[name]}", "-len_control=0", "-timeout=20",
               "-rss_limit_mb=3000", "-print_final_stats=1", f"-artifact_prefix={crashes}/{name}-", found]
    if (CORPUS / name).is_dir():
        command.append(CORPUS / name)
    with open(log, "w") as out:
        return subprocess.Popen([str(word) for word in command], stdout=out, stderr=subprocess.STDOUT, env=ENVIRONMENT), log


def executions(log):
    match = re.search(r"stat::number_of_executed_units:\s*(\d+)", log)
    return int(match.group(1)) if match else 0


def crash_files(log):
    return re.findall(r"Test unit written to (\S+)", log)


def coverage(name, folder):
    """Returns {room: [run, all]}: the lines that everything in the corpora runs."""
    program = folder / "coverage/tests/system/fuzz" / f"fuzz_{name}"
    raw, data = folder / f"{name}.profraw", folder / f"{name}.profdata"
    inputs = [str(path) for path in (folder / "corpus" / name, CORPUS / name) if path.is_dir()]
    with open(folder / f"{name}-replay.log", "w") as out:
        subprocess.run([program, "-runs=0", *inputs], stdout=out, stderr=subprocess.STDOUT, env={**os.environ, "LLVM_PROFILE_FILE": str(raw)})
    subprocess.run(["llvm-profdata-14", "merge", "-sparse", raw, "-o", data], check=True)
    summary = subprocess.run(["llvm-cov-14", "export", "-summary-only", "-instr-profile", data, program], check=True, capture_output=True, text=True).stdout
    rooms = collections.defaultdict(lambda: [0, 0])
    for file in json.loads(summary)["data"][0]["files"]:
        where = os.path.relpath(file["filename"], ROOT)
        if where.startswith(ROOMS[name]) and file["summary"]["lines"]["count"] != 0:
            room = rooms["/".join(where.split("/")[:2])]
            room[0] += file["summary"]["lines"]["covered"]
            room[1] += file["summary"]["lines"]["count"]
    return rooms


def furthest(control, most):
    """Returns at most so many of the files that a merge looked at. Each reaches more that is new than any other remaining file would."""
    lines = control.read_text().splitlines()
    count = int(lines[0])
    paths, left = lines[2:2 + count], {}
    for line in lines[2 + count:]:
        kind, number, *features = line.split()
        if kind == "FT":
            left[int(number)] = set(features)
    chosen, reached = [], set()
    while left and len(chosen) < most:
        best = max(left, key=lambda number: len(left[number] - reached))
        if not left[best] - reached:
            break
        reached |= left.pop(best)
        chosen.append(paths[best])
    return chosen


def keep(name, folder):
    """Reduces the committed inputs to the fewest that reach every known edge. An input that only runs an edge more often is left out."""
    program, target, chosen, control = folder / "tests/system/fuzz" / f"fuzz_{name}", CORPUS / name, folder / f"{name}-kept", folder / f"{name}.merge"
    shutil.rmtree(chosen, ignore_errors=True)
    chosen.mkdir()
    control.unlink(missing_ok=True)
    inputs = [str(path) for path in (target, folder / "corpus" / name) if path.is_dir()]
    done = subprocess.run([program, "-merge=1", "-use_counters=0", f"-max_len={LONGEST[name]}", f"-merge_control_file={control}", chosen, *inputs],
                          capture_output=True, text=True, env=ENVIRONMENT)
    if done.returncode != 0:
        sys.exit(f"fuzz: merging {name} failed\n{done.stderr[-2000:]}")
    files = furthest(control, MOST[name]) if name in MOST else [str(path) for path in chosen.iterdir()]
    kept = {hashlib.sha1(data).hexdigest(): data for data in (pathlib.Path(path).read_bytes() for path in files)}
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    for digest, data in kept.items():
        outfile.write(target / digest, data)
    print(f"{name}: {len(kept)} inputs in {target.relative_to(ROOT)}")


def failure(name, folder, log, status, text):
    print(f"\n{name}: FAILED with status {status} after {executions(text):,} executions: {log}")
    for line in re.findall(r"^.*(?:ERROR: |runtime error: |stream: |the arena is ).*$", text, re.M)[:3]:
        print(f"  {line}")
    for path in crash_files(text):
        print(f"  replay: {folder / 'tests/system/fuzz' / ('fuzz_' + name)} {path}")
    return 1


def report(name, folder, log, status, seconds, with_lines):
    text = log.read_text(errors="replace")
    if status != 0 or executions(text) == 0:
        return failure(name, folder, log, status, text)
    inputs = sum(1 for path in (folder / "corpus" / name, CORPUS / name) if path.is_dir() for _ in path.iterdir())
    edges = re.findall(r" cov: (\d+)", text)
    print(f"\n{name}: {executions(text):,} executions in {seconds} s, {inputs} inputs, {edges[-1] if edges else 0} edges")
    if not with_lines:
        return 0
    rooms = coverage(name, folder)
    reached, total = sum(r for r, _ in rooms.values()), sum(t for _, t in rooms.values())
    print(f"  {reached} of {total} lines ({100 * reached / total:.1f} %)")
    for room, (hit, of) in sorted(rooms.items()):
        print(f"  {room:<24}{hit:>6} of {of:>6} lines {100 * hit / of:>6.1f} %")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=int, default=300, help="each fuzzer runs so long (300)")
    parser.add_argument("--only", help="just this fuzzer")
    parser.add_argument("--coverage", action="store_true", help="say which lines were reached, too")
    parser.add_argument("--keep", action="store_true", help="renew tests/system/fuzz/corpus from what was found")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/fuzz")
    options = parser.parse_args()
    if options.only is not None and options.only not in ROOMS:
        print(f"fuzz: no fuzzer '{options.only}'; there are {', '.join(ROOMS)}", file=sys.stderr)
        return 2
    names = [options.only] if options.only else list(ROOMS)
    folder = options.build.resolve()
    fuzzers = [f"fuzz_{name}" for name in names]
    build(folder, SANITIZE, [*fuzzers, "fuzz_seeds"])
    if options.coverage:
        build(folder / "coverage", COVERAGE, fuzzers)
    for name in names:
        (folder / "corpus" / name).mkdir(parents=True, exist_ok=True)
        subprocess.run([folder / "tests/system/fuzz/fuzz_seeds", name, folder / "corpus" / name], check=True)
    begin, failed = time.monotonic(), 0
    running = {name: start(name, folder, options.seconds) for name in names}
    for name, (process, log) in running.items():
        status = process.wait()
        failed += report(name, folder, log, status, min(options.seconds, round(time.monotonic() - begin)), options.coverage)
        if status == 0 and options.keep:
            keep(name, folder)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
