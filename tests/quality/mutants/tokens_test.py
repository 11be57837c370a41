#!/usr/bin/env python3
"""Tests what makes a record of a caught defect stale, and what does not (tests/quality/mutants/tokens.py and lists.py)."""
import pathlib
import sys
import tempfile

from lists import Hashes, Mutant, outfile
from tokens import code, declaration, declarations

FAILED = []
FILE = """// A head.
#pragma once
#include "some/file.hpp"
namespace a {
constexpr int table[] = {1, 2,
                         3};
template <class T> struct Part {
    /// A member.
    int size() const { return size_; }
    int twice() const { return 2 * size_; }

  private:
    int size_ = 0x1'0; // not "a // string"
};
#define SQUARE(x) \\
    ((x) * (x))
inline int first(int v) {
    if (v < 0) {
        return '{';
    }
    return v + 1;
}
const char* const second = R"x(no { brace)x";
} // namespace a
"""
TESTS = """#include "tests/helper.hpp"
static int helper() { return 3; }
TEST(Suite, One) { EXPECT_EQ(first(1), 2); }
TEST(Suite, Two) { EXPECT_EQ(first(2), helper()); }
"""
FIELDS = {"id": "m", "file": "a.hpp", "find": "return v + 1;", "replace": "return v + 2;",
          "test": "test_area --gtest_filter=Suite.One"}


def check(right, what):
    if not right:
        FAILED.append(what)


def hashes(file, tests, helper="int shared();\n"):
    """Returns both hashes of a tree that holds these texts."""
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        (tree / "tests/area").mkdir(parents=True)
        outfile.write(tree / "a.hpp", file)
        outfile.write(tree / "tests/helper.hpp", helper)
        outfile.write(tree / "tests/area/suite.cpp", tests)
        found = Hashes(tree)
        found.folder = lambda name: [tree / "tests/area/suite.cpp"]
        return found.of(Mutant("list.txt", FIELDS))


def main():
    import lists
    lists.area = lambda program: "area"
    base = hashes(FILE, TESTS)
    same = {
        "a comment": (FILE.replace("// A head.", "// Another one.").replace("not \"a", "\"a"), TESTS),
        "the layout": (FILE.replace("    return v + 1;", "    return v + 1;  \n"), TESTS.replace("{ EXPECT", "{\n    EXPECT")),
        "another function": (FILE.replace("2 * size_", "3 * size_"), TESTS),
        "a function that was added before it": (FILE.replace("#define", "int zero() { return 0; }\n#define"), TESTS),
        "a test that the filter leaves out": (FILE, TESTS.replace("first(2)", "first(3)")),
    }
    for what, texts in same.items():
        check(hashes(*texts) == base, f"{what} makes a record stale")
    other = {
        "the function": ((FILE.replace("v < 0", "v < 1"), TESTS), (True, False)),
        "the test": ((FILE, TESTS.replace("first(1)", "first(3)")), (False, True)),
        "what stands beside the test": ((FILE, TESTS.replace("return 3", "return 4")), (False, True)),
        "what the test includes": ((FILE, TESTS, "int shared(int);\n"), (False, True)),
    }
    for what, (texts, changed) in other.items():
        found = hashes(*texts)
        check((found[0] != base[0], found[1] != base[1]) == changed, f"{what} has changed, and the hashes say {found} after {base}")
    parts = [FILE[begin:end] for begin, end in declarations(FILE)]
    for begin in ("constexpr int table", "int size()", "int twice()", "#define SQUARE", "inline int first", "const char* const second"):
        check(sum(begin in part for part in parts) == 1, f"{begin} is no declaration of its own")
    check("'{'" in declaration(FILE, FILE.find("return v + 1")), "a brace in a character ends a function")
    check(declaration(FILE, 3) == FILE, "a place without a declaration has one")
    check(code(".hpp", "a + /* x */ b // y") == code(".hpp", "a+b"), "comments count")
    check(code(".hpp", 'f("// x")') != code(".hpp", 'f("// y")'), "strings do not count")
    check(code(".hpp", "int a1") != code(".hpp", "inta 1"), "names run together")
    check(code(".py", "a = 1  # x\n") == code(".py", "a = 1\n"), "comments of Python count")
    check(code(".py", "a = (") == "a = (", "a text that is no Python is not taken as it is")
    check(code(".txt", "a # b") != code(".txt", "a # c"), "other files have no comments")
    print("\n".join(FAILED) or "ok")
    return 1 if FAILED else 0


if __name__ == "__main__":
    sys.exit(main())
