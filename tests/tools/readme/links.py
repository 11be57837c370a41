#!/usr/bin/env python3
"""Tests that each link of a page to a file, or to a heading of a page, leads somewhere; and that code cites pages that are there.
docs/README.md must lead to each page beside it, and README.md must be short enough for one sitting.

usage: links.py [FOLDER]

Pages are all Markdown files of the tree. Links to other sites are not followed.
"""
import pathlib
import re
import sys
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from checks import check, failures  # noqa: E402

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[3])
ROOMS = [room for room in ROOT.iterdir() if room.is_dir() and room.name != "build" and not room.name.startswith(".")]
LONGEST_README = 200
CODE = {".cpp", ".hpp", ".h", ".c", ".py", ".cmake", ".txt"}


def without_code(text):
    """Returns a page without its blocks of code and without what stands in backquotes."""
    text = re.sub(r"^( *)```.*?^\1```", "", text, flags=re.S | re.M)
    return re.sub(r"`[^`\n]*`", "", text)


def anchors(page):
    """Returns the names by which the headings of a page are linked, as GitHub makes them."""
    text = re.sub(r"^( *)```.*?^\1```", "", page.read_text(), flags=re.S | re.M)
    found, seen = set(re.findall(r'<a (?:id|name)="([^"]+)"', text)), {}
    for heading in re.findall(r"^#+ +(.*?)\s*$", text, re.M):
        plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
        name = re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")
        number = seen[name] = seen.get(name, -1) + 1
        found.add(f"{name}-{number}" if number else name)
    return found


def links(text):
    """Returns what the links and pictures of a page name, those of HTML among them."""
    named = re.findall(r"\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)", text) + re.findall(r"^\[[^]]+\]:\s*(\S+)", text, re.M)
    return named + re.findall(r'<(?:img|a|source)\b[^>]*?\b(?:src|href|srcset)="([^"]+)"', text)


def check_pages():
    """Returns how many links to files there are."""
    count = 0
    for page in sorted([*ROOT.glob("*.md"), *(path for room in ROOMS for path in room.rglob("*.md"))]):
        for link in links(without_code(page.read_text())):
            if re.match(r"[a-z]+:", link):
                continue
            count += 1
            path, _, anchor = link.partition("#")
            target = (page.parent / urllib.parse.unquote(path)).resolve() if path else page
            name = f"{page.relative_to(ROOT)}: {link}"
            if not target.exists():
                check(False, f"{name} is not there")
            elif anchor and target.suffix == ".md":
                check(anchor in anchors(target), f"{name}: that page has no such heading")
    return count


def check_code():
    """Comments cite a page by its path, and a heading of it in quotes behind that, or link a place in it. Returns how many do."""
    count = 0
    for path in sorted(path for room in ROOMS for path in room.rglob("*") if path.suffix in CODE and path.is_file()):
        # A citation may go on in the next line of a comment.
        text = re.sub(r"\n\s*(?:///?|#|\*) ?", " ", path.read_text(errors="replace"))
        for page, anchor, heading in re.findall(r"\b(docs/[\w./-]+\.md)\b(?:#([\w-]+))?(?:, \"([^\"\n]{3,60})\")?", text):
            count += 1
            name = f"{path.relative_to(ROOT)} cites {page}"
            if not (ROOT / page).is_file():
                check(False, f"{name}, which is not there")
            elif anchor:
                check(anchor in anchors(ROOT / page), f"{name}#{anchor}, a place that is not there")
            elif heading:
                check(re.search(rf"^#+ +{re.escape(heading)}\s*$", (ROOT / page).read_text(), re.M) is not None,
                      f"{name}, which has no heading \"{heading}\"")
    return count


def check_index():
    """The way in is short, and the index of the pages is whole."""
    length = len((ROOT / "README.md").read_text().splitlines())
    check(length <= LONGEST_README, f"README.md has {length} lines, at most {LONGEST_README} are read at one sitting")
    named = set(links(without_code((ROOT / "docs/README.md").read_text())))
    for page in sorted((ROOT / "docs").glob("*.md")):
        check(page.name in named or page.name == "README.md", f"docs/README.md does not lead to {page.name}")


def main():
    check_index()
    pages, code = check_pages(), check_code()
    check(pages > 200 and code > 30, f"only {pages} links of pages and {code} citations of code were found: what is looked for?")
    print(f"{pages} links of pages, {code} citations of code")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
