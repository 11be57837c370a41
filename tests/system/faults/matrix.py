#!/usr/bin/env python3
"""Checks every transport under every fault: each cell of matrix.json names tests that exist, or says why the fault cannot happen.

usage: matrix.py PROGRAM... [--write]

PROGRAM: test programs, which are asked for their tests. The table of docs/faults.md follows from the cells. --write writes the table;
without it the table is compared with the cells.
"""
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "host_sim/tools"))
import outfile  # noqa: E402
PAGE = HERE.parents[2] / "docs/faults.md"
HEAD = """# Every transport under every fault

Each cell is a test: the right error in time, no hang, no leak, and the panel right again after the device is. Where a fault cannot happen the table says why.
"At random": 1,000 sequences of frames with faults drawn by chance, after each of which the glass is the frame. All of them run under ASan and UBSan (`./dev sanitize`), and once more with ThreadSanitizer
(`hal_linux.threads`, `hal_usb.threads`). This page is made from [tests/system/faults/matrix.json](../tests/system/faults/matrix.json); a test holds every cell against what the test programs have.

"""


def tests_of(program):
    names, suite = set(), ""
    for line in subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout.splitlines():
        word = line.split("#")[0].rstrip()
        if word.endswith(".") and not line.startswith(" "):
            suite = word.removeprefix("/")
        elif line.startswith(" "):
            names.add(suite + word.strip())
    return names


def problems(matrix, known):
    for transport, cells in matrix["transports"].items():
        if extra := set(cells) - set(matrix["faults"]) - {"program", "of"}:
            yield f"{transport}: no fault is called {', '.join(sorted(extra))}"
        for fault in matrix["faults"]:
            cell = cells.get(fault)
            if not cell:
                yield f"{transport}, {fault}: no test and no reason"
            if not isinstance(cell, list) or cells["program"] not in known:
                continue
            for test in cell:
                wanted = [f"{test}/{one}" for one in cells["of"]] if test.startswith("Faults.") else [test]
                for name in wanted:
                    if name not in known[cells["program"]]:
                        yield f"{transport}, {fault}: {cells['program']} has no test {name}"


def page(matrix):
    faults, transports = matrix["faults"], matrix["transports"]
    text = HEAD + "| fault | " + " | ".join(transports) + " |\n|---|" + "---|" * len(transports) + "\n"
    notes = []
    for fault in faults:
        cells = []
        for transport, row in transports.items():
            if isinstance(row[fault], list):
                cells.append("<br>".join(f"`{name.split('.')[1]}`" for name in row[fault]))
                continue
            if row[fault] not in notes:
                notes.append(row[fault])
            cells.append(f"- ({notes.index(row[fault]) + 1})")
        text += f"| {fault} | " + " | ".join(cells) + " |\n"
    return text + "\n" + "\n".join(f"{i}. {note}" for i, note in enumerate(notes, 1)) + "\n"


def main():
    programs = [pathlib.Path(word) for word in sys.argv[1:] if word != "--write"]
    programs = [program for program in programs if program.exists()]  # builds without these libraries lack some programs
    matrix = json.loads((HERE / "matrix.json").read_text())
    found = list(problems(matrix, {program.name: tests_of(program) for program in programs}))
    if "--write" in sys.argv:
        outfile.write(PAGE, page(matrix))
    elif not PAGE.exists() or PAGE.read_text() != page(matrix):
        found.append("docs/faults.md is not what tests/system/faults/matrix.json says: matrix.py --write")
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
