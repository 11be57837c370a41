#!/usr/bin/env python3
"""Writes needs.inc: which commands and tokens ask for which optional system, from the command table and the state table.

usage: generate.py [--check]

--check writes nothing: its exit status is 1 when the file is not what would be written.
"""
import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tools"))
import outfile  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
OUT = pathlib.Path(__file__).resolve().parent / "needs.inc"
COMMANDS = ROOT / "gl/api/commands"


def commands():
    """Yields (command, feature). A command that two features offer has no row, because its tokens tell them apart."""
    for path in sorted(COMMANDS.glob("*.json")):
        table = json.loads(path.read_text())
        for family in table["families"] if isinstance(table, dict) else []:
            for feature in (family.get("feature"), family.get("and")):
                if feature and "|" not in feature:
                    yield f"gl{family['name']}", feature


def tokens():
    """Yields (token, feature) for the rows of the state table that a build without the feature lacks."""
    words = dict(re.findall(r"^FEATURE\((of_\w+), (\w+)\)", (ROOT / "gl/context/state_row.hpp").read_text(), re.M))
    for path in sorted((ROOT / "gl/context").glob("state_rows_*.hpp")):
        text = path.read_text()
        for word, token in re.findall(r"\b(of_\w+)\((?:[\w<>:.]+\()*(GL_\w+)", text):
            if word in words and not token.endswith("_"):
                yield token, words[word]
        for feature, block in re.findall(r"^#if SPANGLE_FEATURE_(\w+)\n(.*?)^#endif", text, re.M | re.S):
            for token in re.findall(r"\bGL_\w+\b(?<!_)", block):
                yield token, feature


def text():
    lines = ["// Which commands and tokens ask for which optional system.",
             "// Written by host_sim/profile/generate.py from gl/api/commands and gl/context/state_rows_*.hpp: change those, not this."]
    lines += [f'COMMAND("{command}", {feature})' for command, feature in sorted(set(commands()))]
    lines += [f"TOKEN({token}, {feature})" for token, feature in sorted(set(tokens()))]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        fresh = OUT.read_text() == text()
        print("needs.inc is fresh" if fresh else "needs.inc is stale: run host_sim/profile/generate.py")
        sys.exit(0 if fresh else 1)
    outfile.write(OUT, text())
