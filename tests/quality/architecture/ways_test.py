#!/usr/bin/env python3
"""Tests what ways.py takes for a choice between speed and size, and then the tree itself."""
import pathlib
import tempfile
import unittest

import ways

CHOOSES = ways.selector("raster/span", "rows.hpp", "// Chooses rows.")


def faults(left=(), **files):
    """Returns the faults of a tree of these files. In a name, __ stands for / and the suffix .hpp is left out."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            path = root / (name.replace("__", "/") + ".hpp")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return list(ways.faults(root, dict(left)))


class Ways(unittest.TestCase):
    def test_a_pair_and_the_header_that_chooses_are_no_fault(self):
        self.assertEqual(faults(raster__span__rows=CHOOSES, raster__span__speed__rows="", raster__span__size__rows=""), [])

    def test_half_of_a_pair_is_a_fault(self):
        for half in ("raster__span__speed__rows", "raster__span__size__rows"):
            found = faults(**{"raster__span__rows": CHOOSES, half: ""})
            self.assertEqual(len(found), 1)
            self.assertIn("has no counterpart", found[0])

    def test_the_header_that_chooses_holds_nothing_else(self):
        for text in (CHOOSES + "inline int rows;\n", CHOOSES.replace("speed", "size"), ""):
            found = faults(raster__span__rows=text, raster__span__speed__rows="", raster__span__size__rows="")
            self.assertTrue(any("must choose" in line for line in found), found)

    def test_only_that_header_includes_one_of_the_pair(self):
        found = faults(raster__span__rows=CHOOSES, raster__span__speed__rows="", raster__span__size__rows="",
                       gl__user='#include "raster/span/size/rows.hpp"\n')
        self.assertEqual(found, ["gl/user.hpp may not include raster/span/size/rows.hpp, but the header that chooses"])

    def test_lines_that_name_the_choice_are_counted(self):
        text = "if constexpr (has_shortcuts)\n    return;\n#if SPANGLE_SHORTCUTS\n#endif\nbool has_shortcuts_too;\n"
        self.assertEqual(faults({"gl/a.hpp": 2}.items(), gl__a=text), [])
        self.assertIn("in 2 lines, not 1", faults({"gl/a.hpp": 1}.items(), gl__a=text)[0])
        self.assertIn("in 2 lines, not 0", faults(gl__a=text)[0])

    def test_the_list_of_what_is_left_can_only_become_smaller(self):
        self.assertIn("must become smaller", faults({"gl/a.hpp": 1}.items(), gl__a="")[0])
        self.assertIn("no source", faults({"gl/b.hpp": 1}.items(), gl__a="")[0])

    def test_the_tree(self):
        self.assertEqual(list(ways.faults(ways.ROOT, ways.DEFINED | ways.LEFT)), [])


if __name__ == "__main__":
    unittest.main()
