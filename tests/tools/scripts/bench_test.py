#!/usr/bin/env python3
"""Tests what `./dev bench` computes from made-up times (quartiles and JSON), and its options, with programs that only print times."""
import json
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
BENCH = ROOT / "tests/tools/bench"
sys.path[:0] = [str(ROOT / "tests/support"), str(BENCH)]
from checks import check, failures  # noqa: E402
import changes  # noqa: E402
from spread import scatter, spread, text  # noqa: E402

# A stand-in for a benchmark program. Each call of a name prints the next time of a list, doubled for each tier, quadrupled for Mesa.
TIMED = """#!/bin/sh
name={prefix}
for word; do
    case $word in
    --benchmark_filter=*) scene=${{word#*=^}}; scene=${{scene%%/*}}; size=${{word#*/}}; size=${{size%%(*}}; size=${{size%%/*}}; size=${{size%%$}} ;;
    --benchmark_out=*) out=${{word#*=}} ;;
    esac
done
echo x >> {folder}/$name-$scene-$size
case $(wc -l < {folder}/$name-$scene-$size) in 1) t=50 ;; 2) t=10 ;; 3) t=40 ;; 4) t=20 ;; *) t=30 ;; esac
entry() {{ printf '%s{{"name": "%s", "cpu_time": %s, "hash": 255, "context": 1, "surface": 2, "peak": 3, "process": 4}}' "$3" "$scene/$size$1" $((t * $2)); }}
{{ printf '{{"benchmarks": ['; {entries}; printf ']}}'; }} > $out
"""
OURS = "entry /exact 4; entry /balanced 2 ,; entry /balanced/dither 3 ,; entry /fast 1 ,"
FRAMES = "#!/bin/sh\necho 000000ff\n"
TRANSPORTS = """#!/bin/sh
echo x >> {folder}/runs
t=$(($(wc -l < {folder}/runs) * 7 % 5 + 1))
printf '{{"transport": "spi 10 MHz", "scene": "S1", "bytes": 100, "wire_us": 1000, "cpu_us": %s}}\\n' $t
"""


def quartiles():
    """The order of runs does not matter. The quartiles enclose the median and half of the runs."""
    of = spread([3, 1, 2, 5, 4])
    check(of == {"lower": 1.5, "median": 3, "upper": 4.5, "runs": 5}, f"five runs: {of}")
    check(text(of, 1) == "3.0 (1.5 .. 4.5)" and scatter(of) == 0.5, f"{text(of, 1)}, {scatter(of)}")
    numbers = random.Random(1)
    for runs in range(5, 40):
        values = [numbers.expovariate(1) for _ in range(runs)]
        of = spread(values)
        check(min(values) <= of["lower"] < of["median"] < of["upper"] <= max(values) and of["runs"] == runs, f"order: {of}")
        check(of == spread(values[::-1]), "whatever the order of the runs")
        inside = sum(of["lower"] <= value <= of["upper"] for value in values)
        check(abs(inside - runs / 2) <= 1.5, f"{inside} of {runs} runs between the quartiles")
    try:
        spread([1, 2, 3, 4])
        check(False, "four runs have quartiles")
    except ValueError as error:
        check("4 runs" in str(error), str(error))


def program(path, script):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(script)
    path.chmod(0o755)


def built(folder):
    """Makes what looks like the folder of a build."""
    build = folder / "build"
    for name, prefix, entries in (("bench_spangle", "spangle", OURS), ("bench_mesa", "mesa", 'entry "" 8')):
        program(build / "tests/tools/bench" / name, TIMED.format(folder=folder, prefix=prefix, entries=entries))
    program(build / "tests/tools/bench/frames", FRAMES)
    program(build / "tests/tools/bench/bench_hal", TRANSPORTS.format(folder=folder))
    (build / "CMakeCache.txt").write_text("CMAKE_CXX_COMPILER:STRING=c++\n")
    return build


def run(script, build, *options):
    return subprocess.run([sys.executable, str(BENCH / script), "--build", str(build), *options], capture_output=True, text=True)


def measured(folder, where):
    """Returns the figures of one scene, and what was printed beside them."""
    done = run("bench.py", built(folder), "--quick", "--scenes", "S1", "--no-mcu", "--no-callgrind", "--json", where)
    check(done.returncode == 0, f"exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout if where == "-" else pathlib.Path(where).read_text()), done


def scenes(folder):
    figures, done = measured(folder / "to_stdout", "-")
    times = {"lower": 15, "median": 30, "upper": 45, "runs": 5}  # of the times 50, 10, 40, 20, 30
    for size, of in figures["scenes"]["S1"].items():
        check(of["llvmpipe_us"] == {name: n * 8 if name != "runs" else n for name, n in times.items()}, f"{size}, llvmpipe: {of['llvmpipe_us']}")
        for tier, longer in (("exact", 4), ("balanced", 2), ("fast", 1)):
            check(of[tier]["us"] == {name: n * longer if name != "runs" else n for name, n in times.items()}, f"{size} {tier}: {of[tier]['us']}")
            check(of[tier]["times_llvmpipe"]["median"] == 8 / longer, f"{size} {tier}: {of[tier]['times_llvmpipe']}")
        check(of["dithered"]["median"] == 1.5 and of["memory"]["peak"] == 3, f"{size}: {of}")
    check(set(figures["scenes"]["S1"]) == {"320x240", "800x480"}, str(set(figures["scenes"]["S1"])))
    check("240.0 (120.0 .. 360.0)" in done.stderr, "the tables go to standard error, with quartiles")
    again, done = measured(folder / "to_file", str(folder / "figures.json"))
    check(again == figures and "240.0 (120.0 .. 360.0)" in done.stdout, "a file has the same figures, and standard output the tables")


def transports(folder):
    done = run("hal.py", built(folder), "--json", "-")
    row = json.loads(done.stdout)["transports"][0]
    check(done.returncode == 0 and row["cpu"] == {"lower": 1.5, "median": 3, "upper": 4.5, "runs": 5} and row["cpu_us"] == 1, str(row))
    check("3.0 (1.5 .. 4.5)" in done.stderr, done.stderr)


def changes_of_state():
    """A change that takes over 3 % more fails, and so does one that is new or gone."""
    was = {"light": {"lit": 1000, "unlit": 100}, "matrix": {"lit": 500, "unlit": 500}}
    check(changes.compare(was, was) == ([], []), "equal counts are neither worse nor better")
    slack = {"light": {"lit": 1030, "unlit": 98}, "matrix": {"lit": 500, "unlit": 500}}
    check(changes.compare(slack, was) == ([], []), "3 % are allowed")
    bad, better = changes.compare({"light": {"lit": 1031, "unlit": 97}, "matrix": was["matrix"]}, was)
    check(bad == ["light, lit: 1,031 instructions, and took 1,000"] and better == ["light, unlit: 97 instructions, and took 100"], f"{bad} {better}")
    bad, _ = changes.compare({"light": was["light"]}, was)
    check(bad == ["other changes than in changes.json: matrix"], str(bad))


def options(folder):
    """Impossible options are refused before anything is measured."""
    for script in ("bench.py", "hal.py", "changes.py"):
        for bad in (["--jsn", "x"], ["--json"], ["--json", str(folder / "none/x.json")]):
            done = run(script, folder, *bad)
            check(done.returncode == 2 and done.stdout == "" and f"{script}: error: " in done.stderr, f"{script} {bad}: {done.returncode} {done.stderr}")
    for bad in (["--scenes", "S1,S77"], ["--update-golden", "--json", "-"], ["--record", "--quick"]):
        done = run("bench.py", folder, *bad)
        check(done.returncode == 2 and "error: " in done.stderr, f"{bad}: {done.returncode} {done.stderr}")


def main():
    quartiles()
    changes_of_state()
    for part in (scenes, transports, options):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("to_stdout", "to_file"):
                (pathlib.Path(folder) / name).mkdir()
            part(pathlib.Path(folder))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
