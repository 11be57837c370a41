#!/usr/bin/env python3
"""Makes all files that contain something for each entry point from the command table (commands/*.json):
the public headers, the wrappers, the name table of GetProcAddress, the extensions and their names for commands,
the table of entry points for tests and fuzzers, and the feature matrix.

Usage: generate.py [--check]. With --check it writes nothing, and fails if the committed output is stale.
"""
import sys

from command_table import ROOT, load
from emit_code import commands_header, header, names, shapes_header, wrappers
from emit_egl import egl_header
from emit_test_table import test_table
from emit_texts import texts
from extensions import aliases_list, extensions_header, load_extensions
from feature_matrix import features, matrix

sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402


def outputs():
    chapters, tokens = load()
    extensions = load_extensions(chapters)
    rows = list(matrix(chapters))
    files = {
        "gl/include/spangle/GL/gl.h": header(chapters, tokens),
        "gl/include/spangle/EGL/egl.h": egl_header(),
        "gl/api/generated/commands.hpp": commands_header(chapters, tokens),
        "gl/api/generated/shapes.hpp": shapes_header(chapters, tokens),
        "gl/api/generated/names.cpp": names(chapters, extensions),
        "gl/api/generated/texts.cpp": texts(chapters),
        "gl/api/generated/aliases.inc": aliases_list(extensions),
        "gl/api/generated/extensions.hpp": extensions_header(extensions),
        "tests/gl/api/generated/command_table.inc": test_table(chapters, tokens),
        "docs/features.md": features(rows),
    }
    for data, families in chapters:
        files[f"gl/api/generated/{data['chapter']}.cpp"] = wrappers(data, families)
    return files


def main():
    check = "--check" in sys.argv[1:]
    stale = []
    for name, text in outputs().items():
        path = ROOT / name
        if path.exists() and path.read_text() == text:
            continue
        stale.append(name)
        if not check:
            path.parent.mkdir(parents=True, exist_ok=True)
            outfile.write(path, text)
    if check and stale:
        sys.exit("stale, run gl/api/generate.py: " + ", ".join(stale))


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
