#!/usr/bin/env python3
"""Tests what `./dev bench programs` computes from times, and the library that measures a replayer."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

BENCH = pathlib.Path(__file__).resolve().parents[2] / "tools/bench/programs"
sys.path[:0] = [str(BENCH)]
import programs  # noqa: E402
import recorded  # noqa: E402
import replayed  # noqa: E402
import speeds  # noqa: E402

# A library that stands for EGL and GL, as a replayer uses them, and draws three frames; and a program that finds both by name.
LIBRARY = """
#include <string.h>
static int drawn;
unsigned eglSwapBuffers(void* d, void* s) { return d == s ? 7 : 8; }
long glClear(void) { return ++drawn; }
long glFinish(void) { return 100; }
long glGetError(void) { return drawn; }
void* eglGetProcAddress(const char* name) {
    const int ends[] = {!strcmp(name, "glClear"), !strcmp(name, "glFinish"), !strcmp(name, "glGetError")};
    return ends[0] ? (void*)glClear : ends[1] ? (void*)glFinish : ends[2] ? (void*)glGetError : 0;
}
"""
PROGRAM = """
import ctypes, sys
library = ctypes.CDLL(sys.argv[1], ctypes.RTLD_GLOBAL)
library.eglGetProcAddress.restype = ctypes.c_void_p
of = lambda name: ctypes.CFUNCTYPE(ctypes.c_long)(library.eglGetProcAddress(name))
for i in range(3):
    library.glClear()
    of(b"glClear")()
    print(library.eglSwapBuffers(None, None))
print(of(b"glGetError")(), library.eglGetProcAddress(b"glNever"))
"""


def milliseconds(llvmpipe, balanced, exact, replayer=1.0):
    return {"replayer": replayer, "llvmpipe": llvmpipe, "balanced": balanced, "exact": exact}


class Times(unittest.TestCase):
    def test_a_frame_is_the_median_of_the_last_ones(self):
        ends, now = [], 0
        for took in [900, 900, 50, 2, 3, 4, 90]:  # start-up, then five times of the last frame, the first of which compiles
            now += took * 1000000
            ends.append(now)
        self.assertEqual(replayed.frame_time(ends, times=5, warm=1), 3.5)
        self.assertEqual(replayed.frame_time(ends, times=5, warm=2), 4)
        self.assertEqual(replayed.frame_time(ends, times=6, warm=0), 27)

    def test_a_trace_that_was_not_drawn_often_enough_is_no_time(self):
        with self.assertRaises(ValueError):
            replayed.frame_time([1, 2, 3], times=3, warm=1)
        with self.assertRaises(ValueError):
            replayed.frame_time([1, 2, 3, 4], times=3, warm=3)


class Library(unittest.TestCase):
    def replay(self, **variables):
        with tempfile.TemporaryDirectory() as place:
            place = pathlib.Path(place)
            (place / "egl.c").write_text(LIBRARY)
            for source, made in ((BENCH / "frame_times.c", "times.so"), (place / "egl.c", "egl.so")):
                subprocess.run(["cc", "-O1", "-Wall", "-Wextra", "-shared", "-fPIC", source, "-o", place / made], check=True)
            done = subprocess.run([sys.executable, "-c", PROGRAM, place / "egl.so"], capture_output=True, text=True, check=True,
                                  env=os.environ | {"LD_PRELOAD": str(place / "times.so"), "FRAME_TIMES": str(place / "times")} | variables)
            return done.stdout.split(), [int(line) for line in (place / "times").read_text().split()]

    def test_each_swap_is_a_time_and_everything_is_called(self):
        words, times = self.replay()
        self.assertEqual(words, ["7", "7", "7", "6", "None"])
        self.assertEqual(len(times), 3)
        self.assertTrue(0 < times[0] < times[1] < times[2])

    def test_without_gl_only_questions_are_answered(self):
        words, times = self.replay(NO_GL="1")
        self.assertEqual(words, ["7", "7", "7", "0", "None"])
        self.assertEqual(len(times), 3)


class Speeds(unittest.TestCase):
    def test_the_replayer_is_taken_off_both_sides(self):
        self.assertEqual(speeds.speed(milliseconds(5, 3, 9), "balanced"), 2)
        self.assertEqual(speeds.speed(milliseconds(5, 3, 9), "exact"), 0.5)
        with self.assertRaises(ValueError):
            speeds.speed(milliseconds(5, 1, 9), "balanced")

    def test_the_median_of_the_rounds_counts(self):
        rounds = [milliseconds(1 + 4 * times, 5, 9) for times in (0.9, 1.1, 1.3, 9, 0.1)]
        of = speeds.row("one", "game", 60, rounds)
        self.assertAlmostEqual(of["speed"]["balanced"]["median"], 1.1)
        self.assertAlmostEqual(of["speed"]["exact"]["median"], 0.55)
        self.assertAlmostEqual(of["ms"]["llvmpipe"], 5.4)
        self.assertEqual(of["missed"], ["exact"])

    def test_a_goal_is_reached_exactly_and_differs_by_kind_and_tier(self):
        reached = speeds.row("one", "game", 60, [milliseconds(5, 5, 6)] * 5)
        self.assertEqual(reached["missed"], [])
        own = speeds.row("two", "own", 60, [milliseconds(5, 5, 6)] * 5)
        self.assertEqual(own["missed"], ["exact"])
        slower = speeds.row("three", "saver", 60, [milliseconds(5, 5.1, 6.1)] * 5)
        self.assertEqual(slower["missed"], ["balanced", "exact"])
        self.assertEqual(speeds.verdict([reached, own, slower]),
                         ["balanced: 2 of 3 programs reach their goal; these do not: three.",
                          "exact: 1 of 3 programs reach their goal; these do not: two, three."])
        self.assertEqual(speeds.verdict([reached])[0], "balanced: 1 of 1 programs reach their goal.")

    def test_a_table_marks_what_is_missed(self):
        line = speeds.markdown([speeds.row("one", "game", 60, [milliseconds(5, 3, 9)] * 5)]).splitlines()[2]
        self.assertEqual(line, "| one | game | 60 | 1.000 | 5.000 | 3.000 | 9.000 | 2.00 (2.00 .. 2.00) | 0.50 (0.50 .. 0.50) \\* |")


class Recordings(unittest.TestCase):
    def test_early_frames_lose_what_draws_and_keep_lists(self):
        lines = ["0 glNewList(list = 1)", "1 glBegin(mode = 4)", "2 glEnd()", "3 glEndList()", "4 glClear(mask = 1)", "5 glBegin(mode = 4)",
                 "6 glColor3f(red = 1)", "7 glEnd()", "8 glColor3f(red = 0)", "9 glXSwapBuffers(drawable = 1)", "", "10 glRectf(x1 = 0)",
                 "11 glDrawBuffer(buf = 1)", "12 glXSwapBuffers(drawable = 1)", "13 glClear(mask = 1)", "14 glXSwapBuffers(drawable = 1)",
                 "15 glClear(mask = 1)", "16 glXSwapBuffers(drawable = 1)"]
        self.assertEqual(recorded.early_drawing(lines), [4, 5, 6, 7, 10])
        self.assertEqual(recorded.early_drawing(lines[:12]), [])


class Page(unittest.TestCase):
    def test_the_page_has_what_was_measured(self):
        rows = json.loads(programs.MEASURED.read_text())
        self.assertEqual(programs.page_with(rows), programs.PAGE.read_text(), "./dev bench programs --record writes both")
        for of in rows:
            self.assertEqual(of["missed"], [t for t in speeds.TIERS if of["speed"][t]["median"] < speeds.goal(of["kind"], t)])

    def test_programs_have_names_of_their_own(self):
        names = [program.name for program in recorded.every(pathlib.Path("/bin/sh"), pathlib.Path("/bin/sh"))]
        self.assertEqual(len(names), len(set(names)))
        self.assertTrue({"particles", "rectangles", "imgui"} <= set(names))


if __name__ == "__main__":
    unittest.main()
