#!/usr/bin/env python3
"""Writes docs/bounds.md from what test_bounds measures beside the bounds that tests/oracle/gappa proves.

usage: tests/oracle/bounds/page.py [--check] [PROGRAM [GENERATOR]]

PROGRAM is the built test_bounds, GENERATOR gappa_generate; without them those of build/test. --check writes nothing: it
fails where the page has other rows, where a bound does not hold, and where a proof has no row or a row no proof.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402

PAGE = ROOT / "docs/bounds.md"
BUILT = ROOT / "build/test/tests"
HEAD = """# Bounds

This page says what each stage of the numerics computes in, how far it may be off, and how far it was. A bound is an obligation that Gappa
proves. `tests/oracle/gappa` prints it with the numbers of the headers, and `ctest -R gappa` proves it. The last column is the worst that
`test_bounds` met, in random numbers and at the ends of ranges. The test fails where a number is beyond its bound.

`tests/oracle/bounds/page.py` writes this page. A test compares its rows with what the program prints, and its proofs with the obligations
that exist. Bounds of whole stages, as a pixel shows them, are in [extremes](extremes.md); those of tiers are in [trade](trade.md).

| stage | format | range | bound | proof | worst observed |
|---|---|---|---|---|---|
"""


def main():
    arguments = sys.argv[1:]
    check = arguments[:1] == ["--check"]
    programs = arguments[check:]
    if len(programs) > 2 or any(word.startswith("-") for word in programs):
        print(__doc__.strip())
        return 2
    program = programs[0] if programs else str(BUILT / "test_bounds")
    generator = programs[1] if len(programs) > 1 else str(BUILT / "oracle/gappa/gappa_generate")
    done = subprocess.run([program, "--gtest_brief=1"], capture_output=True, text=True)
    rows = re.findall(r"^\| .* \|$", done.stdout, re.M)
    if done.returncode != 0 or not rows:
        print(done.stdout + done.stderr)
        return 1
    obligations = subprocess.run([generator, "--list"], capture_output=True, text=True, check=True).stdout.split()
    proofs = [row.split(" | ")[-2] for row in rows]
    for name in sorted(set(obligations) ^ set(proofs)):
        print(f"{name}: {'no row of test_bounds measures it' if name in obligations else 'tests/oracle/gappa proves no such bound'}")
    if set(obligations) != set(proofs):
        return 1
    page = HEAD + "".join(re.sub(r"\| (\w+) \| ([^|]*) \|$", r"| [\1](../tests/oracle/gappa) | \2 |", row) + "\n" for row in rows)
    if not check:
        outfile.write(PAGE, page)
    elif PAGE.read_text() != page:
        print("docs/bounds.md is not what test_bounds prints: run tests/oracle/bounds/page.py")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
