#!/usr/bin/env python3
"""Tests what types.py takes for the definition of a type, and then the tree itself."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
TOOL = HERE / "types.py"


def check(*words):
    done = subprocess.run([sys.executable, str(TOOL), *words], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def collisions(first, second):
    """Returns the names that the tool finds in both of two files of a tree."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in (("gl/first.hpp", first), ("host_sim/second.cpp", second)):
            (pathlib.Path(folder) / path).parent.mkdir()
            (pathlib.Path(folder) / path).write_text(f"struct {path[-5]} {{}};\n{text}")
        status, said = check(folder)
        found = [line.split(" is defined in ")[0] for line in said.splitlines() if " is defined in " in line]
        assert status == bool(found), said
        return found


class Types(unittest.TestCase):
    def both(self, first, second, *names):
        self.assertEqual(collisions(first, second), list(names))

    def test_each_kind_of_type_shares_names_with_each_other(self):
        kinds = ["struct T {};", "class T final : public B<f(2)>, C<int, D<2>> {};", "union T {};", "enum T { a };",
                 "enum class T : unsigned { a };", "struct alignas(2 * sizeof(int)) T {};",
                 "class [[nodiscard]] T {};", "struct PACKED T {};", "template <class A, int n = 3> struct T : B<A> {};"]
        for kind in kinds:
            with self.subTest(kind):
                self.both(f"namespace a::b {{ {kind} }}", "namespace a { namespace b { struct T {}; } }", "a::b::T")

    def test_other_namespaces_are_other_names(self):
        self.both("namespace a { struct T {}; }", "namespace b { struct T {}; }")
        self.both("namespace a { } struct T {};", "namespace a { struct T {}; }")

    def test_types_of_one_file_or_of_other_types_are_left_out(self):
        self.both("namespace { struct T {}; }", "namespace { struct T {}; }")
        self.both("struct A { struct T {}; };", "struct B { struct T {}; };")
        self.both("inline void f() { struct T {}; }", "inline void g() { struct T {}; }")
        self.both("struct A { struct T; };", "struct A::T {};")

    def test_only_definitions_count(self):
        self.both("struct T {};", "struct T; struct T f() { return {}; } template <> struct T<int> {}; enum class T : int;")
        self.both("struct T {};", "// struct T {};\n/* struct T {}; */ const char* s = \"struct T {};\"; auto r = R\"(struct T {};)\";")
        self.both("struct T {};", "#define T_OF \\\n    struct T {};\n")

    def test_each_branch_of_an_if_begins_in_the_same_namespace(self):
        self.both("namespace a {\n#if A\nvoid f() {\n#else\nvoid g() {\n#endif\n}\nstruct T {};\n}", "namespace a { struct T {}; }", "a::T")

    def test_literals_hide_no_code(self):
        self.both("const char c = '\"'; struct T {}; const char d = '\"'; int n = 1'000; struct U {}; int m = 2'000;",
                  "struct T {}; struct U {};", "T", "U")

    def test_comments_and_linkage_leave_a_namespace_open(self):
        self.both('/// See "T".\nnamespace a { struct T {}; }', 'namespace a { extern "C" { struct T {}; } }', "a::T")

    def test_a_file_that_cannot_be_read_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "gl").mkdir()
            for text in ("struct T {", "}"):
                (pathlib.Path(folder) / "gl/first.hpp").write_text(text)
                self.assertEqual(check(folder)[0], 1)

    def test_the_tree_has_each_name_once(self):
        status, said = check()
        self.assertEqual(status, 0, said)


if __name__ == "__main__":
    sys.exit(unittest.main(argv=sys.argv[:1]))
