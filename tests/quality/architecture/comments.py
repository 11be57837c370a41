#!/usr/bin/env python3
"""Draws comments of the product at random, to be read without their code: can a stranger understand each of them?

usage: comments.py [--seed N] [--count N] [--room NAME] [--total]

Prints FILE:LINE and the comment alone. The same tree, seed and count give the same comments. docs/strangers-test.md says how they are read.
A comment is a run of whole lines, or what stands behind code with its further lines below. Closing comments of namespaces, marks for
tools, empty comments and generated files are left out. --total prints how many comments each room has.
"""
import argparse
import pathlib
import random
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/quality/mutants"))
from tokens import TOKEN  # noqa: E402
ROOMS = ("gl", "raster", "hal", "boards", "host_sim")
SUFFIXES = {".cpp", ".hpp", ".h", ".inc"}
FOR_TOOLS = re.compile(r"(namespace\b|extern \"C\"|NOLINT|clang-format|IWYU|#\w+)")
GENERATED = re.compile(r"\bWritten by \S+\.py\b")


def pieces(text):
    """Yields (line, column, whether nothing stands before it, text) of each // or /* comment of a C++ source."""
    for found in TOKEN.finditer(text):
        piece, begin = found.group(), found.start()
        if found["directive"]:
            at = piece.find("//")
            if at < 0:
                continue
            piece, begin = piece[at:], begin + at
        elif found["left"] is None or not piece.startswith(("//", "/*")):
            continue
        first = text.rfind("\n", 0, begin) + 1
        yield text.count("\n", 0, begin) + 1, begin - first, not text[first:begin].strip(), piece


def said(piece):
    """The words of a comment, without its marks."""
    if piece.startswith("/*"):
        return " ".join(re.sub(r"^\s*\*+", "", line).strip() for line in piece[2:-2].splitlines()).strip(" *")
    return re.sub(r"^//[/!]?<?", "", piece).strip()


def comments(text):
    """Yields (line, words) of the comments of a source; pieces that belong together are one comment."""
    run, last = None, None
    for line, column, alone, piece in pieces(text):
        goes_on = (run is not None and line == last[0] + 1 and column == last[1] and alone and not piece.startswith("/*"))
        if goes_on:
            run[1].append(said(piece))
        else:
            if run:
                yield run[0], " ".join(filter(None, run[1]))
            run = (line, [said(piece)])
        last = (line + piece.count("\n"), column)
    if run:
        yield run[0], " ".join(filter(None, run[1]))


def all_comments(rooms):
    """Returns (room, file, line, words) of every comment that a person wrote in these rooms."""
    out = []
    for room in rooms:
        for path in sorted((ROOT / room).rglob("*")):
            if path.suffix not in SUFFIXES or not path.is_file() or "generated" in path.parts:
                continue
            text = path.read_text(errors="replace")
            if GENERATED.search(text[:400]):
                continue
            out += [(room, path.relative_to(ROOT), line, words) for line, words in comments(text)
                    if re.search(r"[A-Za-z]", words) and not FOR_TOOLS.match(words)]
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--room", choices=ROOMS)
    parser.add_argument("--total", action="store_true")
    options = parser.parse_args()
    found = all_comments([options.room] if options.room else ROOMS)
    if options.total:
        for room in ROOMS:
            print(f"{room}: {sum(1 for comment in found if comment[0] == room)}")
        return
    drawn = random.Random(options.seed).sample(found, min(options.count, len(found)))
    for _, path, line, words in drawn:
        print(f"{path}:{line}: {words}")


if __name__ == "__main__":
    main()
