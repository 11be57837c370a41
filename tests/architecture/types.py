#!/usr/bin/env python3
"""Checks that a type of the product is defined once: no two files define a type of the same name in the same namespace.

usage: types.py [ROOT]

Two types of one name in programs that link both are undefined behaviour (the one definition rule), and no compiler has to say so.
Types in unnamed namespaces belong to their file, and do not count. Where the build chooses one of several files, each of them defines
the type: CHOSEN_BY_THE_BUILD has those.
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ("raster", "gl", "hal", "boards", "host_sim")
CHOSEN_BY_THE_BUILD = {"spangle::hal::EdgeLine", "spangle::hal::Lines"}  # hal/linux/lines_*.cpp: one for each libgpiod, and one without
NOT_CODE = re.compile(r"//[^\n]*|/\*.*?\*/|R\"(\w*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\"|(?<!\w)'(?:\\.|[^'\\\n])*'", re.S)
OPENED = re.compile(r"""
    \bnamespace\s*(?P<namespace>[\w:]*)\s*\{
  | \b(?:struct|class|enum(?:\s+(?:class|struct))?|union)\s+(?:alignas\([^)]*\)\s*)?(?:\[\[[^]]*\]\]\s*)?
    (?P<type>\w+)\s*(?:final\s*)?(?::(?!:)[^;{}()]*)?\{
  | (?P<brace>\{) | (?P<end>\})""", re.X)


def types_of(text):
    """Yields the full name of each type that a source defines in named namespaces, but for nested types and specializations."""
    open_scopes = []
    for found in OPENED.finditer(NOT_CODE.sub(" ", text)):
        if found["end"]:
            if open_scopes:
                open_scopes.pop()
        elif found["namespace"] is not None:
            open_scopes.append(found["namespace"] or None)
        else:
            if found["type"] and all(scope and not scope.startswith("{") for scope in open_scopes):
                yield "::".join([*open_scopes, found["type"]])
            open_scopes.append("{")


def defined_twice(sources):
    """Returns {type: files} of the types that more than one of the sources {file: text} defines."""
    files_of = collections.defaultdict(list)
    for file, text in sources.items():
        for name in sorted(set(types_of(text))):
            files_of[name].append(file)
    return {name: files for name, files in files_of.items() if len(files) > 1 and name not in CHOSEN_BY_THE_BUILD}


def try_itself():
    """Fails if the check misses two types of one name, or sees one where there is none."""
    sources = {"a.hpp": "namespace x { struct A { enum class K { one }; }; namespace { class B : A { }; } class C; }",
               "b.cpp": "namespace x { enum class A : int { k }; namespace { struct B { }; } struct C { int i{'{'}; }; }",
               "c.cpp": "namespace x::y { struct A {}; } namespace x { struct A::K2 {}; void f() { struct C {}; } const char s[] = \"{ struct C {\"; }"}
    assert defined_twice(sources) == {"x::A": ["a.hpp", "b.cpp"]}, defined_twice(sources)


def main():
    try_itself()
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT
    paths = [path for room in ROOMS for path in sorted((root / room).rglob("*.[ch]pp"))]
    twice = defined_twice({str(path.relative_to(root)): path.read_text() for path in paths})
    for name, files in sorted(twice.items()):
        print(f"{name} is defined in {' and in '.join(files)}; give one of them another name")
    return 1 if twice or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
