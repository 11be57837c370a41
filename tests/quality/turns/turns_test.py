#!/usr/bin/env python3
"""Tests turns.py with tests that are made up here."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import turns  # noqa: E402


def rows(*lines):
    return turns.rows_of("tests,seconds,every\n" + "\n".join(lines) + "\n")


def test(name, *labels, serial=False):
    return turns.Test(name, {"slow", *labels}, serial)


def names(groups, turn):
    return {t.name for group in turns.turns_of(groups)[turn] for t in group.tests}


class Table(unittest.TestCase):
    def test_rows_that_make_no_sense_are_refused(self):
        for line in ("a,10,3", "a,10,0", "a,-1,4", "a,10,128"):
            with self.subTest(line), self.assertRaises(ValueError):
                rows(line)

    def test_ctest_tells_labels_and_what_runs_alone(self):
        listed = {"tests": [{"name": "quick", "properties": []},
                            {"name": "long", "properties": [{"name": "LABELS", "value": ["cross", "slow"]}, {"name": "RUN_SERIAL", "value": True}]},
                            {"name": "other", "properties": [{"name": "LABELS", "value": ["slow"]}]}]}
        self.assertEqual(turns.slow_tests(listed), [test("long", "cross", serial=True), test("other")])

    def test_faults_are_told(self):
        groups = turns.grouped(rows("a,2000,1", r"b\..*,1500,8"), [test("a"), test("b.x")])
        said = turns.faults(rows("a,2000,1", r"b\..*,1500,8"), groups)
        self.assertEqual(len(said), 2 + turns.TURNS // 8)  # none of these rows belongs to a group, so neither names a test
        table = rows("a,2000,1", r"b\..*,300,8", "gone,1,4")
        self.assertEqual(turns.faults(table, turns.grouped(table, [test("a"), test("b.x")])), ["the row gone names no slow test"])


class Turns(unittest.TestCase):
    def test_each_test_has_as_many_turns_as_its_row_says(self):
        for every in (1, 2, 4, 8, 16, 32, 64):
            groups = turns.grouped(rows(f"a,10,{every}"), [test("a")])
            with self.subTest(every):
                self.assertEqual(sum("a" in names(groups, turn) for turn in range(turns.TURNS)), turns.TURNS // every)

    def test_what_has_the_same_parentheses_goes_together(self):
        groups = turns.grouped(rows(r"(build\w+)\..*,10,16"), [test("build1.a"), test("build2.a"), test("build1.b")])
        self.assertEqual([[t.name for t in group.tests] for group in groups], [["build1.a", "build1.b"], ["build2.a"]])

    def test_the_first_row_that_matches_the_whole_name_has_a_test(self):
        groups = turns.grouped(rows("a,10,16", r"a.*,20,1"), [test("ab"), test("a")])
        self.assertEqual({group.tests[0].name: group.seconds() for group in groups}, {"a": 10, "ab": 20})

    def test_no_turn_has_much_more_to_do_than_another(self):
        sizes = [400, 300, 300, 200, 150, 100, 100, 90, 80, 70, 60, 50, 40, 30, 20, 10] * 8
        table = rows(*(f"t{at},{size},{turns.TURNS}" for at, size in enumerate(sizes)), *(f"q{at},50,4" for at in range(4)))
        groups = turns.grouped(table, [test(f"t{at}") for at in range(len(sizes))] + [test(f"q{at}") for at in range(4)])
        loads = [sum(group.seconds() for group in of_turn) for of_turn in turns.turns_of(groups)]
        self.assertEqual(sum(loads), sum(sizes) + turns.TURNS * 50)
        self.assertLessEqual(max(loads), 450)  # the longest test, and one test of each commit
        self.assertGreaterEqual(min(loads), 200)

    def test_what_runs_alone_takes_both_cores(self):
        groups = turns.grouped(rows("a,100,1"), [test("a", serial=True)])
        self.assertEqual(groups[0].seconds(), 200)

    def test_tests_without_a_row_are_never_left_out(self):
        groups = turns.grouped(rows(f"a,10,{turns.TURNS}"), [test("a"), test("new")])
        self.assertNotIn("new", {name for turn in range(turns.TURNS) for name in turns.left_out(groups, turn)})

    def test_what_a_turn_leaves_out_and_runs_is_everything(self):
        groups = turns.grouped(rows(r"t.*,10,4"), [test(f"t{at}") for at in range(9)])
        for turn in range(2 * turns.TURNS):
            with self.subTest(turn):
                left = set(turns.left_out(groups, turn))
                self.assertEqual(left | names(groups, turn % turns.TURNS), {f"t{at}" for at in range(9)})
                self.assertFalse(left & names(groups, turn % turns.TURNS))

    def test_labels_are_those_of_the_tests_that_run(self):
        groups = turns.grouped(rows("a,10,2", "b,10,2"), [test("a", "kernel"), test("b", "page")])
        self.assertEqual([turns.labels_of(groups, turn) for turn in (0, 1)], [["kernel", "slow"], ["page", "slow"]])


class Expression(unittest.TestCase):
    def test_it_matches_the_names_and_nothing_else(self):
        said = turns.expression(["a.b", "c+d(e)"])
        self.assertTrue(re.search(said, "a.b") and re.search(said, "c+d(e)"))
        for name in ("axb", "a.b.c", "za.b", "ccd(e)"):
            self.assertFalse(re.search(said, name), name)

    def test_no_names_match_no_test(self):
        self.assertFalse(re.search(turns.expression([]), "a"))

    def test_cmake_reads_it(self):
        said = turns.expression(["a.b", "c+d(e)"])
        script = f'foreach(n a.b axb "c+d(e)")\nif(n MATCHES [=[{said}]=])\nmessage("${{n}}")\nendif()\nendforeach()\n'
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "matches.cmake"
            file.write_text(script)
            done = subprocess.run(["cmake", "-P", file], capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr.split(), ["a.b", "c+d(e)"])


if __name__ == "__main__":
    unittest.main()
