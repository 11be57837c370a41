#!/usr/bin/env python3
"""Checks that each name of a type is defined in at most one file of the product.

usage: types.py [ROOT]

Two types of one name in one namespace break the one definition rule of C++ (basic.def.odr). The linker then keeps one of two functions of
the same name for both types. No compiler sees this, because each of them sees one file at a time.

Types of anonymous namespaces belong to their file. Types inside of types or functions belong to what is around them. A specialisation of
a template is no new name. Each branch of an #if begins with the braces that were open at the #if.
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
ROOMS = ("gl", "raster", "hal", "boards", "host_sim")
SUFFIXES = {".h", ".hpp", ".c", ".cpp", ".inc"}
ANONYMOUS = "(anonymous)"

RAW_STRING = r'R"([^()\s\\]*)\(.*?\)\1"'
UNREAD = re.compile(rf"""{RAW_STRING}|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)'(?:\\.|[^'\\\n])+'""", re.S)
PIECE = re.compile(r"^[ \t]*#[ \t]*(?P<directive>\w*)(?:\\\n|[^\n])*|(?P<mark>[;{}])", re.M)
NAMESPACE = re.compile(r"(?:inline\s+)?namespace(?:\s+(?P<name>[\w:]+))?")
ATTRIBUTE = r"(?:\[\[.*?\]\]|(?:alignas|__attribute__)\s*\((?:[^()]|\([^()]*\))*\)|[A-Z][A-Z0-9_]+(?=\s+\w))\s*"
KIND = r"(?:enum\s+class|enum\s+struct|enum|struct|class|union)"
TYPE = re.compile(rf"(?:.*[\s>])??{KIND}\s+(?:{ATTRIBUTE})*(?P<name>\w+)(?:\s+final)?\s*(?::[^:].*)?", re.S)


def without_arguments(head):
    """Returns the beginning of a declaration with `<>` in place of all arguments of templates."""
    before = None
    while before != head:
        before, head = head, re.sub(r"<[^<>]+>", "<>", head)
    return re.sub(r"\btemplate\s*<>\s*", "", head).strip()


def opened(head):
    """Returns what a brace opens after this text: ("namespace", names), ("type", name), or None for anything else."""
    if re.fullmatch(r'extern\s*""', head):
        return "namespace", ()
    if found := NAMESPACE.fullmatch(head):
        return "namespace", tuple((found["name"] or ANONYMOUS).split("::"))
    if found := TYPE.fullmatch(without_arguments(head)):
        return "type", found["name"]
    return None


def types(text):
    """Yields the full names of the types that a source defines in namespaces that other files share."""
    text = UNREAD.sub(lambda found: '""' if found[0][0] in 'R"' else " ", text)
    around, branches, begin = [], [], 0  # `branches` has what is around each #if that is open
    for piece in PIECE.finditer(text):
        head, begin = text[begin:piece.start()].strip(), piece.end()
        directive = piece["directive"] or ""
        if directive.startswith("if"):
            branches.append(list(around))
        elif directive.startswith("el"):
            around = list(branches[-1])
        elif directive == "endif":
            branches.pop()
        elif piece["mark"] == "}":
            around.pop()
        elif piece["mark"] == "{":
            what = opened(head)
            scope = [name for kind, names in filter(None, around) if kind == "namespace" for name in names]
            if what and what[0] == "type" and ANONYMOUS not in scope and all(outer and outer[0] == "namespace" for outer in around):
                yield "::".join([*scope, what[1]])
            around.append(what)
    if around:
        raise ValueError("braces do not match")


def defined(root):
    """Returns {name: files that define it}, paths relative to the root."""
    found = collections.defaultdict(set)
    for room in ROOMS:
        for path in sorted((root / room).rglob("*")):
            if path.suffix in SUFFIXES and path.is_file():
                inside = path.relative_to(root)
                try:
                    for name in types(path.read_text()):
                        found[name].add(inside)
                except (ValueError, IndexError) as error:
                    raise SystemExit(f"{inside} cannot be read: {error}") from error
    return found


def main():
    found = defined(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT)
    wrong = 0
    for name, paths in sorted(found.items()):
        if len(paths) > 1:
            print(f"{name} is defined in {' and in '.join(map(str, sorted(paths)))}; give one of them another name")
            wrong += 1
    print(f"{len(found)} types, {wrong} of them defined more than once")
    return 1 if wrong or not found else 0


if __name__ == "__main__":
    sys.exit(main())
