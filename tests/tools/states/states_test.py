#!/usr/bin/env python3
"""Tests what `./dev bench states` computes from its figures, and its options.

usage: states_test.py RUNNER    which is bench_states of the build under test
"""
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
BENCH = ROOT / "tests/tools/bench/states"
sys.path[:0] = [str(ROOT / "tests/support"), str(BENCH)]
import figures  # noqa: E402
import golden  # noqa: E402
import measure  # noqa: E402
import report  # noqa: E402
import states as tool  # noqa: E402
from checks import check, failures  # noqa: E402

DUMP = """# callgrind format
events: Ir
summary: 0

ob=x
fn=void spangle::raster::draw_rows<spangle::raster::Fixed, 8>(int, int)
10 100
11 +20
calls=1 5
11 5000
12 7
fn=spangle::gl::Context::operator()(int)
3 73

fn=plain
5 800
totals: 1000
"""


def state(number, key=None, **words):
    """Returns a state of these words, each (choice, work) or (choice, work, pass)."""
    shown = {"surface": ("565 z16", -1), "tier": ("exact", 3), "shape": ("triangles", -1), "view": ("parallel", 0)} | words
    return {"number": number, "key": number if key is None else key, "words": {word: [*of, *([False] if len(of) == 2 else [])] for word, of in shown.items()}}


def percentiles():
    values = [5, 1, 3, 2, 4]
    check([figures.percentile(values, share) for share in (0, 25, 50, 75, 100)] == [1, 2, 3, 4, 5], "percentiles of five values are these values")
    check(figures.percentile(values, 90) == 4.6, f"between two values in proportion: {figures.percentile(values, 90)}")
    check(figures.percentile([7], 95) == 7, "one value is each percentile")
    check(figures.percentiles(list(range(101))) == {"p10": 10, "p50": 50, "p80": 80, "p90": 90, "p95": 95}, "the shares that are printed")
    check(figures.slower([0.5, 1.0, 2.0, 0.99]) == 0.5, "as fast as llvmpipe is not slower")


def neighbours():
    fogged, plain = state(2, fog=("LINEAR", 1)), state(1, fog=("", 0))
    textured = state(3, fog=("", 0), texture=("2D", 3, True), filter=("LINEAR", 1, True))
    bare = state(4, fog=("", 0), texture=("", 0, True))
    same_key = state(5, key=1, fog=("", 0), tier=("fast", 0))
    other_tier = state(6, fog=("LINEAR", 1), tier=("fast", 0))
    two = state(7, fog=("LINEAR", 1), view=("mild perspective", 1))
    found = {(a["number"], b["number"]): word for a, b, word in figures.neighbours([plain, fogged, bare, textured, same_key, other_tier, two])}
    check(found.get((1, 2)) == "fog", f"fog alone differs: {found}")
    check(found.get((4, 3)) == "texture", "a word that applies to one of two states is no difference of its own")
    check((1, 7) not in found and (2, 7) in found, "two words differ, or one")
    check(found.get((1, 5)) == "tier", "the variants of one key are neighbours")
    check((2, 6) not in found, "other keys are compared in the same variant")


def far_apart():
    a, b, c = state(1, texture=("", 0, True)), state(2, texture=("2D", 3, True)), state(3, fog=("LINEAR", 1))
    pairs = [(a, b, "texture"), (c, a, "fog")]
    found = figures.far_apart(pairs, {1: 100, 2: 201, 3: 40})
    check([(round(ratio, 2), low["number"], high["number"]) for ratio, low, high, _ in found] == [(2.5, 3, 1), (2.01, 1, 2)], f"the worst first: {found}")
    check(figures.far_apart(pairs, {1: 100, 2: 200, 3: 50}) == [], "2 times is not more than 2 times")
    check(figures.far_apart(pairs, {1: 100}) == [], "states that were not measured have no pairs")
    check(figures.adds_pass(a, b, "texture") and not figures.adds_pass(c, a, "shape"), "a texture is a pass of its own, a shape is none")


def inversions():
    none, linear, exponent = state(1, fog=("", 0)), state(2, fog=("LINEAR", 1)), state(3, fog=("EXP", 3))
    other, kills = state(4, fog=("TABLE", 4)), state(5, fog=("SOME", -1))
    check(figures.less_work(none, linear, "fog") and figures.less_work(linear, exponent, "fog"), "some of the bits are less work")
    for a, b in ((linear, none), (linear, linear), (linear, other), (other, exponent), (none, kills), (kills, linear)):
        check(not figures.less_work(a, b, "fog"), f"{a['words']['fog']} is not less than {b['words']['fog']}")
    pairs = [(linear, none, "fog"), (linear, exponent, "fog"), (other, linear, "fog")]
    cost = {1: 106, 2: 100, 3: 50, 4: 1}
    check([(round(ratio, 2), less["number"], more["number"]) for ratio, less, more, _ in figures.inversions(pairs, cost)] == [(2, 2, 3), (1.06, 1, 2)], "the worst first")
    check(len(figures.inversions(pairs, cost | {1: 105})) == 1, "5 % more is no inversion")


def dearest():
    states = [state(number, key=number // 2) for number in range(30)]
    found = figures.worst(states, {number: number for number in range(29)})
    check([s["number"] for s in found] == [28, *range(27, 10, -2)], f"ten, the worst first, no key twice: {[s['number'] for s in found]}")
    said = figures.readable(state(1, samples=("", 0), fog=("EXP2", 7), dither=("on", 1), blend=("", 0)))
    check(said == "565 z16, exact, triangles, parallel, fog EXP2, dither", said)


def dumps():
    found = measure.functions(DUMP)
    check(list(found.values()) == [127, 73, 800], f"a function's own instructions, without those of what it calls: {found}")
    check(measure.hottest(found, 2) == [("plain", 0.8), ("draw_rows<Fixed, 8>", 0.127)], f"the hottest by readable names: {measure.hottest(found, 2)}")
    check(measure.read_counts("7 160 0a0b\n") == {7: (None, 160, "0a0b")}, "what the host prints")
    check(measure.read_counts("7 5000 160 0a0b\n9 1 0 00\n") == {7: (5000, 160, "0a0b"), 9: (1, 0, "00")}, "what a board prints")


def tables():
    members = [state(n, shape=("triangles" if n < 6 else "sprites", -1)) for n in range(10)]
    rows = report.rows(members, {n: 10 * n for n in range(9)}, {0: 0.5, 1: 2.0})
    by_class = {row["class"]: row for row in rows}
    check(by_class["all"]["states"] == 9 and by_class["triangles"]["p50"] == 25 and by_class["sprites"]["p50"] == 70, f"rows: {rows}")
    check(by_class["all"]["slower"] == 0.5 and by_class["all"]["fast50"] == 1.25 and "slower" not in by_class["sprites"], "shares of those that were timed")
    check(tool.page_with(json.loads(tool.MEASURED.read_text())) == tool.PAGE.read_text(),
          "docs/states.md does not show tests/tools/bench/states/measured.json; ./dev bench states --record writes both")


def held():
    was = {"0": [1000, 10], "6": [1000, 10], "12": [1000, 10], "13": [5, 5]}
    bad, better = golden.compare({"0": [1030, 10], "6": [1031, 10], "12": [1000, 11], "14": [5, 5]}, was)
    check([line.split()[1] for line in bad] == ["6", "12", "13", "14"] and better == [], f"{bad} {better}")
    check(len(golden.compare({**was, "0": [970, 10]}, was)[1]) == 1, "what is better by more than 3 % is said")
    numbers = golden.slice_numbers(64)  # a larger slice than golden.json holds
    check(len(set(numbers)) == 64 and [n // 6 for n in numbers] == list(range(64)) and {n % 6 for n in numbers} == set(range(6)), "each key once, each variant")
    check(all(numbers[i] % 6 == numbers[i + 1] % 6 for i in range(0, 64, 2)), "both keys of a pair in the same variant")
    kept = json.loads(golden.GOLDEN.read_text())
    check({target: sorted(table, key=int) for target, table in kept.items()} == {target: list(map(str, golden.slice_numbers(keys))) for target, keys in golden.SLICES.items()},
          "golden.json has the slices and nothing else")


def listed(runner):
    """A state does not depend on which others are asked for, and the program says which arguments it takes."""
    every = measure.listed(runner, 4, list(range(120)))
    check([s["number"] for s in every] == list(range(120)) and measure.listed(runner, 4, [77, 5]) == [every[77], every[5]], "a number is one state")
    check(every != measure.listed(runner, 5, list(range(120))), "another seed has other states")
    pairs = {(a["key"], b["key"]) for a, b, _ in figures.neighbours(every)}
    check(all((key, key + 1) in pairs for key in range(0, 20, 2)), "keys come in pairs of neighbours")
    done = subprocess.run([runner, "1"], capture_output=True, text=True)
    check(done.returncode == 2 and done.stderr.startswith("usage: "), done.stderr)


def options():
    """Impossible options are refused before anything is measured."""
    with tempfile.TemporaryDirectory() as folder:
        for bad in (["--seed", "x"], ["--count", "0"], ["--target", "m7"], ["--rounds", "-1"], ["--json", f"{folder}/none/x.json"], ["--update-golden", "--record"]):
            done = subprocess.run([sys.executable, str(BENCH / "states.py"), "--build", folder, *bad], capture_output=True, text=True)
            check(done.returncode == 2 and done.stdout == "" and "states.py: error: " in done.stderr, f"{bad}: {done.returncode} {done.stderr}")


def main():
    for part in (percentiles, neighbours, far_apart, inversions, dearest, dumps, tables, held, options):
        part()
    listed(sys.argv[1])
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
