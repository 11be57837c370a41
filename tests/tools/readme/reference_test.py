#!/usr/bin/env python3
"""Tests that the reference manual of the public headers is whole: Doxygen (host_sim/tools/reference.py) finds every public entity
documented, every link leading somewhere and terms linked to the glossary. Each kind of defect is reported in a small tree.

usage: reference_test.py
"""
import pathlib
import re
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "host_sim/tools"), str(ROOT / "tests/support")]
import reference  # noqa: E402
from checks import check, failures  # noqa: E402

HEADER = """// A header of a test.
#pragma once

namespace spangle {

/// A size, see [glass](docs/glossary.md#glass).
struct Size {
    /// Pixels across and down.
    int width = 0, height = 0;
    friend constexpr bool operator==(const Size&, const Size&) = default;
};

/// Doubles a size.
constexpr Size doubled(Size size) { return {2 * size.width, 2 * size.height}; }

namespace detail {
inline constexpr int private_number = 3;
}

} // namespace spangle
"""
C_HEADER = """/* A header of a test. */
#ifndef TEST_H
#define TEST_H

/* Numbers of fish. */
#define TEST_SALMON 1
#define TEST_TROUT 2
typedef int Fish; /* one fish */
/* Catches fish. */
GLAPI void GLAPIENTRY testCatch(Fish a);
GLAPI void GLAPIENTRY testCatchAll(
    Fish a);

#endif
"""
PAGE = """# A page

## One part

See [the header](../raster/include/spangle/test.hpp) and [this
part](#one-part), or [the glossary](glossary.md#glass), or [a test](../tests/test.cpp). `[code](is not.md)`

```
[neither](is.md#this)
```
"""
GLOSSARY = '# Glossary\n\n<a id="glass"></a>**glass**: What a person sees.\n'
FILES = {"raster/include/spangle/test.hpp": HEADER, "gl/include/spangle/GL/test.h": C_HEADER, "docs/architecture.md": PAGE,
         "docs/glossary.md": GLOSSARY}

# What is replaced in which file, and what the warning must say. None: no warning.
DEFECTS = [
    ("raster/include/spangle/test.hpp", "", "", None),
    ("raster/include/spangle/test.hpp", "/// Doubles a size.\n", "", "test.hpp:13: .*doubled.*not documented"),
    ("raster/include/spangle/test.hpp", "    /// Pixels across and down.\n", "", "test.hpp:8: .*width.*not documented"),
    ("raster/include/spangle/test.hpp", "/// A size, see", "// A size, see", "test.hpp:7: .*Size is not documented"),
    ("raster/include/spangle/test.hpp", "}\n\n} // n", "}\nenum class Kind { a };\n} // n", "test.hpp:19: .*Kind.*not documented"),
    ("raster/include/spangle/test.hpp", "#glass", "#grass", "the link to md_docs_glossary.html#glossary-grass leads nowhere"),
    ("raster/include/spangle/test.hpp", "[glass](docs/glossary.md#glass)", "glass", "test.hpp: 'glass' is not linked to docs/glossary.md#glass"),
    ("gl/include/spangle/GL/test.h", "/* Numbers of fish. */\n", "", "test.h:5: .*TEST_SALMON.*not documented"),
    ("gl/include/spangle/GL/test.h", "/* Catches fish. */\n", "\n", "test.h:10: .*testCatch.*not documented"),
    ("gl/include/spangle/GL/test.h", "; /* one fish */", ";\n\ntypedef int Boat;", "test.h:10: .*Boat.*not documented"),
    ("docs/architecture.md", "](#one-part)", "](#two-parts)", "index.html: the link to index.html#architecture-two-parts leads nowhere"),
    ("docs/architecture.md", "glossary.md#glass", "grammar.md", "index.html: the link to md_docs_grammar.html leads nowhere"),
]


def check_defects():
    """A small tree is without fault, and each defect of it is reported."""
    for name, old, new, expected in DEFECTS:
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder).resolve() / "tree"
            for path, text in FILES.items():
                (tree / path).parent.mkdir(parents=True, exist_ok=True)
                check(path != name or old in text, f"{name} has no {old!r}")
                (tree / path).write_text(text.replace(old, new, 1) if path == name and old else text)
            shutil.copy(ROOT / "docs/Doxyfile", tree / "docs/Doxyfile")
            said = "\n".join(reference.build(tree, pathlib.Path(folder) / "out"))
        if expected is None:
            check(said == "", f"a tree without fault: {said}")
        else:
            check(re.search(expected, said) is not None, f"{name}, {old!r} -> {new!r}: {said or 'nothing'} is said in place of {expected}")


def check_inputs():
    """The manual has the folders that are installed, and no others."""
    rooms = re.search(r"foreach\(room (.*?)\)", (ROOT / "cmake/Install.cmake").read_text())[1].split()
    wanted = {f"{room}/include" for room in rooms if (ROOT / room / "include").is_dir()}
    check(set(reference.INCLUDES) == wanted, f"the manual reads {set(reference.INCLUDES)}, installed are {wanted}")
    check(len(list(reference.inputs(ROOT))) > 130, "the manual reads hardly anything")


def check_tree():
    """The manual of this tree is without warnings, and has what it should."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        warnings = reference.build(ROOT, out)
        check(not warnings, "\n".join(warnings))
        for page, words in (("gl_8h.html", "glNewList"), ("egl_8h.html", "eglSwapBuffers"), ("index.html", "architecture/house.svg"),
                            ("classspangle_1_1hal_1_1Bus.html", "Starts the whole list"), ("md_docs_glossary.html", "glossary-tier")):
            file = out / "html" / page
            check(file.is_file() and words in file.read_text(), f"{page} has no {words}")


def main():
    if shutil.which("doxygen") is None:
        print("skipped: there is no doxygen; ./dev setup --all installs it")
        return 77
    check_inputs()
    check_defects()
    check_tree()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
