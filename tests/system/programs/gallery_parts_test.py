#!/usr/bin/env python3
"""Tests what gallery.py rests on: the clock of same_run.c, which depends only on what a program does, and the window's part of a picture.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[2] / "host_sim" / "tools")]
import png  # noqa: E402
from harness import LAST_CALL, Picture, all_but, run, some  # noqa: E402

START = 1700000000
# A program that prints each reading of the clocks between other work. It computes for `busy` turns before each reading.
PROGRAM = """
import json, os, select, subprocess, sys, time
busy, words = int(sys.argv[1]), []
def read(name):
    for _ in range(busy):
        hash(words.__repr__())
    words.append((name, time.time_ns(), time.monotonic_ns()))
read("first")
read("second")
time.sleep(0.25)
read("slept")
inner, outer = os.pipe()
select.select([inner], [], [], 0.125)
read("waited in vain")
os.write(outer, b"x")
select.select([inner], [], [], 10)
read("something was there")
waiting = select.poll()
waiting.register(inner)
os.read(inner, 1)
waiting.poll(50)
read("polled in vain")
made = sys.argv[2]
helper = subprocess.Popen(["sh", "-c", "i=0; while [ $i -lt 20000 ]; do i=$((i+1)); done; echo x > " + made])
time.sleep(0.001)
words.append(("helper is done", os.path.exists(made), helper.wait()))
words.append(("process", os.getpid(), 0))
print(json.dumps(words))
"""


class Clock(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.library = pathlib.Path(cls.place.name) / "same_run"
        subprocess.run(["cc", "-O1", "-Wall", "-Wextra", "-Werror", "-shared", "-fPIC", "-o", cls.library, HERE / "same_run.c"], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def readings(self, busy):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-c", PROGRAM, str(busy), folder + "/made"], check=True, capture_output=True, text=True,
                                  env=os.environ | {"LD_PRELOAD": str(self.library), "PYTHONHASHSEED": "0"}, timeout=60)
        return json.loads(done.stdout)

    def test_two_runs_read_the_same_times_whatever_the_speed(self):
        self.assertEqual(self.readings(0), self.readings(20000))

    def test_time_goes_by_sleeping_and_by_waiting_in_vain(self):
        words = self.readings(0)
        day, up = ([word[k] for word in words if word[0] not in ("helper is done", "process")] for k in (1, 2))
        self.assertEqual(day[0] // 10**9, START)
        self.assertLess(up[0], 2 * 10**9)
        for times in (day, up):
            steps = [b - a for a, b in zip(times, times[1:])]
            for step, asked in zip(steps, (0, 250, 125, 0, 50)):
                # Each reading of a clock takes a millisecond, and Python itself reads the clock around each wait.
                self.assertGreaterEqual(step, (asked + 1) * 10**6)
                self.assertLessEqual(step, (asked + 8) * 10**6)

    def test_who_sleeps_wakes_when_helpers_have_ended(self):
        words = {word[0]: word[1] for word in self.readings(0)}
        self.assertTrue(words["helper is done"])
        self.assertEqual(words["process"], 4242)


class Ends(unittest.TestCase):
    def test_who_is_late_ends_with_all_that_it_started(self):
        with tempfile.TemporaryDirectory() as folder:
            late = pathlib.Path(folder) / "late"
            ended = run(["sh", "-c", f"echo begun; (sleep 2; echo x > {late}) & wait"], dict(os.environ), 1)
            self.assertEqual((ended.status, ended.words), (None, "begun\n"))
            time.sleep(2)
            self.assertFalse(late.exists())

    def test_who_ends_in_time_tells_how(self):
        ended = run(["sh", "-c", "echo out; echo error >&2; exit 3"], dict(os.environ), 10)
        self.assertEqual((ended.status, ended.words), (3, "out\nerror\n"))


class Some(unittest.TestCase):
    def test_some_of_many_have_the_first_and_the_last(self):
        self.assertEqual(some(list(range(1, 401)), 10), [1, 45, 89, 134, 178, 222, 267, 311, 355, 400])
        self.assertEqual(some(list("abcdefghijklm"), 4), ["a", "e", "i", "m"])

    def test_all_of_few(self):
        for few in ([], ["a"], list("abcd")):
            self.assertEqual(some(few, 4), few)

    def test_never_more_than_asked_for(self):
        for count in range(1, 60):
            for most in (1, 2, 3, 10):
                chosen = some(list(range(count)), most)
                self.assertEqual(len(chosen), min(most, count))
                self.assertEqual(len(set(chosen)), len(chosen))
                self.assertEqual(chosen[-1], count - 1)
                if most > 1:
                    self.assertEqual(chosen[0], 0)


class Calls(unittest.TestCase):
    def test_all_but_some(self):
        self.assertEqual(all_but([5, 9]), f"0-4,6-8,10-{LAST_CALL}")
        self.assertEqual(all_but([0, 3, 4]), f"1-2,5-{LAST_CALL}")


class Windows(unittest.TestCase):
    ROWS = [[(x, y, 9) for x in range(7)] for y in range(5)]

    def picture(self, window):
        with tempfile.NamedTemporaryFile(suffix=".png") as file:
            file.write(png.write_exact(self.ROWS))
            file.flush()
            return Picture(file.name, window)

    def test_a_window_is_the_lower_left_part(self):
        part = self.picture((3, 2))
        self.assertEqual((part.width, part.height), (3, 2))
        self.assertEqual([[tuple(pixel) for pixel in row] for row in part.rows], [row[:3] for row in self.ROWS[3:]])

    def test_a_window_as_large_as_the_surface_or_larger_is_all_of_it(self):
        for window in (None, (7, 5), (70, 50)):
            part = self.picture(window)
            self.assertEqual((part.width, part.height, len(part.rows), len(part.rows[0])), (7, 5, 5, 7))

    def test_a_window_may_be_larger_one_way(self):
        part = self.picture((70, 2))
        self.assertEqual((part.width, part.height, tuple(part.rows[0][6])), (7, 2, (6, 3, 9)))


if __name__ == "__main__":
    unittest.main()
