#!/usr/bin/env python3
"""Builds the reference manual of the public headers and of docs with Doxygen (docs/Doxyfile).

usage: reference.py [--root TREE] OUT    writes OUT/html; what Doxygen warns of is printed, and the exit status is then 1
       reference.py --filter FILE        prints FILE as Doxygen is to read it

What headers say stays as C++ readers want it. Doxygen asks for more, and the filter writes that:
  \\file        before the first comment of a header, which says what the file is for
  \\page names  of headings and anchors: those of GitHub, with the page's name in front, so that links between pages lead somewhere
  one member   per declaration: the comment of `int width, height;` holds for both
  comparisons  that are defaulted compare all members; they need no comment
  boards       have a header each, whose first comment is theirs, too
Lines keep their numbers, so that warnings name the line of the source.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

import outfile

TREE = pathlib.Path(__file__).resolve().parents[2]
INCLUDES = ("raster/format/include", "raster/include", "hal/include", "hal/mcu/include", "hal/linux/include", "hal/usb/include",
            "boards/include", "gl/include", "host_sim/include")
PICTURES = {".png", ".svg"}
MAIN_PAGE = pathlib.Path("docs/architecture.md")


# --- terms of the glossary -----------------------------------------------------------------------------------------

# Words of ours that a header links where it first uses them, and their places in the glossary.
TERMS = {"tier": "tier", "glass": "glass", "wire": "wire", "damage": "damage", "band": "band", "twin": "twin", "knob": "knob", "row hash": "row-hash",
         "op list": "op", "touched rows": "touched-rows", "violation": "violation", "virtual time": "virtual-time"}


def use_of(term):
    """A pattern of a term, or its plural, as a word of a sentence: names in code are none."""
    plural = "" if term == "wire" else "s?" # wires are those that one can touch
    return rf"(?<![\w`:.#/-])(?<!guard ){term}{plural}(?![\w`:/(]|-?\w|\.\w)"


def is_comment(line):
    """Whether a line is one of a comment of its own, not one behind code."""
    return re.match(r"\s*(//(?!/<)| \*|/\*(?!.*\*/.))", line) is not None


def unlinked_terms(text):
    """Yields each term that a header uses without linking it at the first use."""
    said = " ".join(re.sub(r"^\s*(///?|/?\*)\s*", "", line) for line in text.split("\n") if is_comment(line))
    for term, place in TERMS.items():
        first = re.search(use_of(term), said)
        if first is not None and not re.match(rf"\[[^]]*\]\(docs/glossary\.md#{place}\)", said[max(first.start() - 1, 0):]):
            yield f"'{term}' is not linked to docs/glossary.md#{place} where it is first used: {said[first.start():first.start() + 60]}"


# --- headers -------------------------------------------------------------------------------------------------------

def installed_name(path):
    """The name by which programs include a header: spangle/..."""
    parts = path.parts
    return "/".join(parts[len(parts) - parts[::-1].index("include"):]) if "include" in parts else path.name


def top_level(text):
    """Splits at commas that stand in no bracket."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


DECLARED = re.compile(r"^(\s*)((?:extern \"C\" )?(?:(?:static|constexpr|inline|const|mutable) )*[A-Za-z_][\w:]*(?:<[\w:, *]*>)?[*&]? )"
                      r"([A-Za-z_]\w*(?:\[[^;]*?\])*(?: = [^;]+?|\{[^;]*?\})?,[^;]*|[A-Za-z_]\w* =$)")
NAMED = re.compile(r"[A-Za-z_]\w*(?:\[.*?\])*(?: =\s.*|\{.*\})?$", re.S)


def comment_above(lines, at):
    """Takes the comment that ends in front of a line."""
    said = ""
    if at > 0 and lines[at - 1].startswith("#if"):
        at -= 1
    while at > 0 and re.match(r"^\s*///(?!<)", lines[at - 1]):
        at -= 1
        said = lines[at].strip()[3:].strip() + " " + said
        lines[at] = ""
    return said.strip()


def one_member_each(lines):
    """Gives each variable of `T a, b;` a declaration of its own, with the comment of them all, in the same line."""
    for i, line in enumerate(lines):
        found = DECLARED.match(line)
        if not found or found[2].split()[0] in ("return", "using", "goto", "case", "typename", "template"):
            continue
        last = i
        while ";" not in lines[last] and last < i + 9 and last + 1 < len(lines) and "//" not in lines[last]:
            last += 1
        statement, closed, comment = "\n".join(lines[i:last + 1]).partition(";")
        names = top_level(statement[len(found[1] + found[2]):])
        if not closed or len(names) < 2 or not all(NAMED.match(name) for name in names):
            continue
        said = comment.partition("///<")[2].strip()
        while said and last + 1 < len(lines) and re.match(r"^\s*///<", lines[last + 1]):
            last += 1
            said += " " + lines[last].split("///<", 1)[1].strip()
        said = said or comment_above(lines, i)
        comment = f"/** {said} */ " if said else ""
        lines[i] = found[1] + " ".join(f"{comment}{found[2]}{name};".replace("\n", " ") for name in names)
        lines[i + 1:last + 1] = [""] * (last - i)


def c_header(name, text):
    """A comment of gl.h and egl.h holds for all declarations below it, up to the next comment or empty line."""
    out, said, lines = [], "", iter(text.replace("/*", f"/** \\file {name}", 1).split("\n"))
    for line in lines:
        trailing = re.match(r"^(\S.*?;)\s*/\*\s*(.*?)\s*\*/$", line)
        if trailing:
            out.append(f"{trailing[1]} /**< {trailing[2]} */")
            continue
        if line.startswith("/* "):
            comment = [line]
            while "*/" not in comment[-1]:
                comment.append(next(lines))
            said = " ".join(part.strip().removeprefix("*" if i else "").strip() for i, part in enumerate(comment))[2:-2].strip()
            out += [""] * len(comment)
        elif not line:
            said = ""
            out.append("")
        elif said and re.match(r"^(GLAPI|EGLAPI|typedef) ", line):
            out.append(f"/** {said} */ {line}")
        elif said and line.startswith("#define ") and not line.endswith("_H"):
            out.append(f"{line} /**< {said} */")
        else:
            out.append(line)
    return "\n".join(out)


def header(path, text):
    name = installed_name(path)
    text = re.sub(r'^.*\]\(docs/.*$', lambda line: line[0].replace('"', "&quot;"), text, flags=re.M) # an inch is no quotation
    text = re.sub(r"\[([^][]+)\]\((docs/[^)\s]+)\)", lambda m: link(TREE, pathlib.Path(), m[1], m[2]), text)
    if path.suffix == ".h":
        return c_header(name, text)
    lines, first_comment = text.split("\n"), []
    for i, line in enumerate(lines):
        if not line.startswith("//"):
            break
        first_comment.append(line.lstrip("/").strip())
        lines[i] = "/// " + line.lstrip("/").strip() + (f" \\file {name}" if not lines[i + 1].startswith("//") else "")
    for i, line in enumerate(lines):
        lines[i] = re.sub(r"^(\s*)(friend\b.*\boperator(?:==|<=>)\(.*\) = default;)$", r"\1/** Compares all members. */ \2", line)
        if re.match(r"^inline constexpr hal::Board \w+ = ", line) and not lines[i - 1].startswith("///"):
            lines[i] = f"/** {' '.join(first_comment)} */ {line}"
    one_member_each(lines)
    return "\n".join(lines)


# --- pages ---------------------------------------------------------------------------------------------------------

def page_name(path):
    """The name that Doxygen gives the page of a Markdown file of docs."""
    if path == MAIN_PAGE:
        return "index"
    return "md_" + "_".join(path.with_suffix("").parts).replace("-", "_")


def label(path, anchor):
    return f"{path.stem}-{anchor}"


def slug(heading):
    """The name by which GitHub links a heading."""
    plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")


def as_html(text):
    return re.sub(r"`([^`]*)`", lambda code: "<code>" + code[1].replace("<", "&lt;") + "</code>", text)


def link(tree, page, text, target):
    """A link of a page: to another page of the manual, to a header, to another site, or nowhere, where the manual has no such file."""
    if re.match(r"[a-z]+:", target):
        return f"[{text}]({target})"
    name, _, anchor = target.partition("#")
    file = pathlib.Path(os.path.normpath(page.parent / name)) if name else page
    if file.parts[0] == "docs" and file.suffix == ".md":
        place = f"{page_name(file)}.html" + (f"#{label(file, anchor)}" if anchor else "")
        return f'<a href="{place}">{as_html(text)}</a>'
    if file.suffix in (".hpp", ".h") and "include" in file.parts and (tree / file).is_file():
        return f'\\ref {installed_name(file)} "{text.replace("`", "")}"'
    return text


def markdown(tree, path, text):
    """Links and headings of a page; blocks of code stay as they are."""
    parts, seen = re.split(r"^( *```.*?^ *```$)", text, flags=re.S | re.M), {}
    for i in range(0, len(parts), 2):
        part = re.sub(r"!\[([^]]*)\]\(([^)\s]+)\)", lambda m: f'<img src="{os.path.normpath(path.parent / m[2])}" alt="{m[1]}">', parts[i])
        part = re.sub(r"(?<!!)\[((?:`[^`]*`|[^][`])+)\]\(([^)\s]+)\)", lambda m: link(tree, path, m[1], m[2]), part)
        part = re.sub(r'<a id="([^"]+)">', lambda m: f'<a id="{label(path, m[1])}">', part)
        headings = iter(re.findall(r"^#+ +(.*?)\s*$", parts[i], re.M))
        parts[i] = re.sub(r"^(#+) +.*$", lambda m: named_heading(path, m, next(headings), seen), part, flags=re.M)
    return "".join(parts)


def named_heading(path, line, heading, seen):
    """A heading with the name by which it is linked; titles of pages have none."""
    name = slug(heading)
    number = seen[name] = seen.get(name, -1) + 1
    return line[0] if line[1] == "#" else f"{line[0].rstrip()} {{#{label(path, f'{name}-{number}' if number else name)}}}"


# --- Doxygen -------------------------------------------------------------------------------------------------------

def inputs(tree):
    """The paths of all public headers and pages."""
    for folder, endings in [*((room, (".hpp", ".h")) for room in INCLUDES), ("docs", (".md",))]:
        yield from sorted(path.relative_to(tree) for path in (tree / folder).rglob("*") if path.suffix in endings)


def filtered(tree, path):
    text = (tree / path).read_text()
    return markdown(tree, path, text) if path.suffix == ".md" else header(path, text)


def broken_links(folder):
    """Yields each link of a page to a file, or to a place in a page, that is not there; but Doxygen's own to private classes."""
    places = {}

    def has(page, place):
        if page not in places:
            places[page] = set(re.findall(r'\b(?:id|name)="([^"]+)"', page.read_text(errors="replace")))
        return place in places[page]

    for page in sorted(folder.glob("*.html")):
        for target in sorted(set(re.findall(r'\b(?:href|src)="([^"]+)"', page.read_text(errors="replace")))):
            name, _, place = urllib.parse.unquote(target).partition("#")
            file = folder / name if name else page
            if not re.match(r"[a-z]+:|#nested-classes$", target) and not (file.exists() and (not place or has(file, place))):
                yield f"{page.name}: the link to {target} leads nowhere"


def run_doxygen(tree, out):
    """Returns what Doxygen says of a copy of the headers and pages as it is to read them."""
    with tempfile.TemporaryDirectory() as name:
        copy = pathlib.Path(name).resolve()
        for path in inputs(tree):
            (copy / path).parent.mkdir(parents=True, exist_ok=True)
            outfile.write(copy / path, filtered(tree, path))
        rooms = [room for room in INCLUDES if (copy / room).is_dir()]
        settings = [(tree / "docs/Doxyfile").read_text(), f'OUTPUT_DIRECTORY = "{out.resolve()}"', f"STRIP_FROM_PATH = {copy}",
                    f"INPUT = {' '.join(rooms)} docs", f"INCLUDE_PATH = {' '.join(rooms)}", f"STRIP_FROM_INC_PATH = {' '.join(rooms)}",
                    f"USE_MDFILE_AS_MAINPAGE = {MAIN_PAGE}"]
        done = subprocess.run(["doxygen", "-"], cwd=copy, input="\n".join(settings), text=True, capture_output=True)
        said = (done.stdout + done.stderr).replace(f"{copy}/", "")
    return said if done.returncode == 0 or said.strip() else f"doxygen ended with status {done.returncode}"


def build(tree, out):
    """Returns what is wrong, line by line, with names of files as the tree has them."""
    shutil.rmtree(out / "html", ignore_errors=True)
    out.mkdir(parents=True, exist_ok=True)
    said = run_doxygen(tree, out)
    for picture in (path for path in (tree / "docs").rglob("*") if path.suffix in PICTURES):
        copy = out / "html" / picture.relative_to(tree)
        copy.parent.mkdir(parents=True, exist_ok=True)
        outfile.write(copy, picture.read_bytes())
    terms = [f"{path}: {what}" for path in inputs(tree) if path.suffix != ".md" for what in unlinked_terms((tree / path).read_text())]
    return [line for line in said.splitlines() if line.strip()] + list(broken_links(out / "html")) + terms


def main():
    words, tree = sys.argv[1:], TREE
    if words[:1] == ["--root"] and len(words) > 1:
        tree, words = pathlib.Path(words[1]).resolve(), words[2:]
    if len(words) == 2 and words[0] == "--filter":
        sys.stdout.write(filtered(tree, pathlib.Path(os.path.relpath(words[1], tree))))
        return 0
    if len(words) != 1 or words[0].startswith("-"):
        print(__doc__.strip())
        return 2
    out = pathlib.Path(words[0])
    warnings = build(tree, out)
    if warnings:
        print("\n".join(warnings))
        print(f"{len(warnings)} warnings")
        return 1
    print(f"{out}/html/index.html")
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
