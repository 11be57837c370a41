#!/usr/bin/env python3
"""Tests that the runner of random frames goes on where it ended, and says which frame failed. A shell script stands for the program."""
import contextlib
import io
import pathlib
import tempfile
import unittest

import nightly


class Runner(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "random_frames"
        self.calls = self.folder / "calls"
        self.write("true")

    def write(self, then):
        self.program.write_text(f"#!/bin/sh\necho $1 $2 >>{self.calls}\n{then}\n")
        self.program.chmod(0o755)

    def draw(self, chunks):
        done = nightly.Done(self.folder / "nightly.json", self.program)
        left = [chunk for chunk in chunks if chunk not in done.chunks]
        self.said = io.StringIO()
        with contextlib.redirect_stdout(self.said):
            return nightly.draw(self.program, left, done, 2), left

    def test_every_frame_is_drawn_once(self):
        self.assertEqual(self.draw(range(3)), (True, [0, 1, 2]))
        self.assertEqual(sorted(self.calls.read_text().split("\n")), ["", "0 500", "1000 500", "500 500"])
        self.assertIn("1,500 of 1,500 frames", self.said.getvalue())

    def test_a_second_run_goes_on(self):
        self.draw(range(2))
        self.assertEqual(self.draw(range(4)), (True, [2, 3]))

    def test_another_program_begins_anew(self):
        self.draw(range(2))
        self.write("sleep 0")
        self.assertEqual(self.draw(range(2)), (True, [0, 1]))

    def test_a_failure_names_its_frame(self):
        self.write(r"printf '\r%s\r%s\nruntime error: overflow\n' $1 $(($1 + 7)); exit 3")
        good, _ = self.draw([2])
        self.assertFalse(good)
        self.assertIn(f"{self.program} 1007 1", self.said.getvalue())
        self.assertIn("runtime error: overflow", self.said.getvalue())
        self.assertEqual(nightly.Done(self.folder / "nightly.json", self.program).chunks, set())


if __name__ == "__main__":
    unittest.main()
