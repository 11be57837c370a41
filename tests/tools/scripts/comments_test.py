#!/usr/bin/env python3
"""Tests tests/quality/architecture/comments.py, which draws comments at random.

The tests show what counts as one comment, and that a seed fixes the draw.
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tests/quality/architecture")]
from checks import check, failures  # noqa: E402
import comments  # noqa: E402

SOURCE = """// One comment
// of two lines.

/// A comment of a function.
int f(int a);  ///< behind code
// of its own

int b = 2;     ///< behind code,
               ///< which goes on
const char* text = "// no comment";
/* A block
 * of two lines. */
#define LIMIT 3 // behind a directive
} // namespace spangle
"""
FOUND = [(1, "One comment of two lines."), (4, "A comment of a function."), (5, "behind code"), (6, "of its own"),
         (8, "behind code, which goes on"), (11, "A block of two lines."), (13, "behind a directive"), (14, "namespace spangle")]


def drawn(*words):
    command = [sys.executable, str(ROOT / "tests/quality/architecture/comments.py"), *words]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def main():
    found = list(comments.comments(SOURCE))
    check(found == FOUND, f"comments of a source: {found}")
    some = drawn("--seed", "5", "--count", "20")
    lines = some.splitlines()
    check(len(lines) == len(set(lines)) == 20, f"20 comments were asked for: {len(lines)}")
    check(some == drawn("--seed", "5", "--count", "20"), "the same seed draws the same comments")
    check(some != drawn("--seed", "6", "--count", "20"), "another seed draws others")
    for line in drawn("--count", "300").splitlines():
        place, _, words = line.partition(": ")
        path, _, number = place.rpartition(":")
        at = (ROOT / path).read_text().splitlines()[int(number) - 1]
        check(words.split()[0] in at, f"{place} has no such comment: {words}")
        check("/generated/" not in path and not words.startswith("namespace"), f"{place} is not to be read: {words}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
