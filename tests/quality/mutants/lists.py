"""Reads the seeded defects of tests/quality/mutants/*.txt, and keeps the record of those that the tests caught.

tests/quality/mutants/caught.txt has one line for each caught defect: its id, its row of the feature matrix, two hashes and the day.
The first hash is that of the declaration with the defect in it, which mostly is a function. The second is that of the
command, of the tests that it runs, and of what stands beside them in their files. Both are hashes of code, in which
comments and layout do not count. Where either differs from the tree, the record is stale, and the defect must be tried again.
"""
import fnmatch
import functools
import hashlib
import json
import pathlib
import re
import shlex
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import outfile  # noqa: E402
from tokens import CPP, code, declaration, declarations  # noqa: E402
HERE = ROOT / "tests/quality/mutants"
RECORD = HERE / "caught.txt"
ROWS = {row["id"] for row in json.loads((ROOT / "gl/api/commands/rows.json").read_text())} | {"-"}
HEAD = "# Written by ./dev mutants --write: each mutant that the tests caught, its row, hashes of file and test, the day.\n"


def digest(*parts):
    total = hashlib.sha256()
    for part in parts:
        part = part.encode(errors="surrogateescape")
        total.update(len(part).to_bytes(8, "little") + part)
    return total.hexdigest()[:10]


class Mutant:
    def __init__(self, source, fields):
        self.source = source
        for key in ("id", "file", "find", "replace", "test"):
            if key not in fields:
                raise SystemExit(f"{source}: a mutant has no '{key}': {fields}")
        self.id, self.file, self.test = fields["id"], fields["file"], shlex.split(fields["test"])
        self.find, self.replace = fields["find"], fields["replace"]
        self.row = fields.get("row", "-")

    def problem(self):
        """Returns why this entry cannot be used, or None."""
        path = ROOT / self.file
        if not path.is_file():
            return f"no file {self.file}"
        if self.row not in ROWS:
            return f"the feature matrix has no row {self.row}"
        if area(self.test[0]) is None:
            return f"no folder of tests belongs to {self.test[0]}"
        text = path.read_text()
        count = text.count(self.find)
        if count != 1:
            return f"'{self.find}' stands {count} times in {self.file}"
        rest = text[text.index(self.find) + len(self.find):].partition("\n")[0]
        if path.suffix in CPP and "//" in self.find and "//" not in self.replace and rest.strip():
            return f"'{self.find}' ends in a comment, so that '{rest.strip()}' becomes code; leave the comment out"
        return None

    def seeded(self, tree):
        """Returns the text of the file with the defect in it."""
        return (tree / self.file).read_text().replace(self.find, self.replace)

    def change(self, text):
        """Returns the code around the defect, as it is and with the defect in it."""
        suffix = pathlib.Path(self.file).suffix
        around = declaration(text, text.find(self.find)) if suffix in CPP else text
        around = around if self.find in around else text
        return code(suffix, around), code(suffix, around.replace(self.find, self.replace))


@functools.cache
def areas():
    """Returns {AREA: its folder in tests/}. tests/CMakeLists.txt has the same rule: a chapter of GL has gl_ before its name."""
    folders = [path for path in (ROOT / "tests").glob("*/*") if path.is_dir()]
    return {("gl_" if path.parent.name == "gl" else "") + path.name: f"{path.parent.name}/{path.name}" for path in folders}


@functools.cache
def area(program):
    """Returns the folder of tests/ with the sources of a test program: AREA of test_AREA, or the one that names it; else None."""
    words = program.removeprefix("test_").split("_")
    names = ["_".join(words[:n]) for n in range(len(words), 0, -1)]
    makers = [f"{p.parts[-3]}/{p.parts[-2]}" for p in sorted((ROOT / "tests").glob("*/*/CMakeLists.txt")) if program in p.read_text()]
    return next((folder for folder in [areas().get(name) for name in names] + makers if folder), None)


class Hashes:
    """Computes the two hashes of mutants in one state of the tree. What was read for one mutant is kept for the next."""

    def __init__(self, tree=ROOT):
        self.tree = tree
        self.texts = functools.cache(lambda path: path.read_text(errors="surrogateescape"))
        self.folder = functools.cache(lambda name: sorted(
            p for p in (tree / "tests" / name).rglob("*") if p.is_file() and "__pycache__" not in p.parts))
        self.tests = functools.cache(lambda path: [f"{suite}.{name}" for suite, name in re.findall(
            r"^TEST\w*\(\s*(\w+),\s*(\w+)", self.texts(path), re.M)])
        self.code = functools.cache(lambda path, patterns: code(path.suffix, self.run(path, patterns)))
        self.test = functools.cache(lambda words: digest(shlex.join(words), *(
            part for p in self.files(words) for part in (str(p.relative_to(tree)), self.code(p, self.patterns(words))))))

    def patterns(self, words):
        """Returns the tests that the filter lets run, as patterns of Suite.Name; "All/Suite.Name/0" has parameters."""
        found = [p for w in words if w.startswith("--gtest_filter=") for p in w.partition("=")[2].split("-")[0].split(":")]
        return tuple(re.sub(r"^[^.]*/", "", p).partition("/")[0] for p in found)

    def run(self, path, patterns):
        """Returns the text of a file of tests, without tests that the filter leaves out."""
        text = self.texts(path)
        if path.suffix != ".cpp" or not patterns:
            return text
        kept = []
        for begin, end in declarations(text):
            test = re.match(r"(?:TYPED_)?TEST\w*\(\s*(\w+),\s*(\w+)", text[begin:end])
            if test is None or any(fnmatch.fnmatch(f"{test[1]}.{test[2]}", pattern) for pattern in patterns):
                kept.append(text[begin:end])
        return "\n".join(kept)

    def files(self, words):
        """Returns the files with a test that the filter lets run, and the files of tests/ that these include. No filter: all."""
        folder = self.folder(area(words[0]))
        names = self.patterns(words)
        found = [p for p in folder if p.suffix == ".cpp" and any(fnmatch.filter(self.tests(p), name) for name in names)]
        for path in found:  # the list grows while it is read
            for name in re.findall(r'^#include "(tests/[^"]+)\.hpp"', self.texts(path), re.M):
                found += [p for p in (self.tree / f"{name}.hpp", self.tree / f"{name}.cpp") if p.is_file() and p not in found]
        return sorted(found) or folder

    def of(self, mutant):
        return digest(*mutant.change(self.texts(self.tree / mutant.file))), self.test(tuple(mutant.test))


def read_lists():
    mutants, seen = [], set()
    for path in sorted(HERE.glob("*.txt")):
        if path.name in ("caught.txt", "CMakeLists.txt"):
            continue
        for block in path.read_text().split("\n\n"):
            fields = {}
            for line in block.splitlines():
                if line.startswith("#") or not line.strip():
                    continue
                key, _, value = line.partition(":")
                fields[key.strip()] = value.strip()
            if fields:
                mutant = Mutant(path.name, fields)
                if mutant.id in seen:
                    raise SystemExit(f"{path.name}: two mutants are called {mutant.id}")
                seen.add(mutant.id)
                mutants.append(mutant)
    return mutants


def recorded():
    """Returns {id: (file hash, test hash, day)} of the mutants that were caught; older records lack the hashes."""
    lines = RECORD.read_text().splitlines() if RECORD.exists() else []
    return {line.split()[0]: tuple(line.split()[2:]) for line in lines if line and line[0] != "#"}


def record(outcome):
    """Writes the record: what was caught now, and earlier records of what was not tried now.

    `outcome` has for each id what recorded() returns, or None. The lists and the record are read anew, because a run takes
    hours, in which others add to both.
    """
    known = recorded()
    known.update(outcome)
    lines = [" ".join((m.id, m.row, *known[m.id])) for m in read_lists() if known.get(m.id) is not None]
    outfile.write(RECORD, HEAD + "\n".join(lines) + "\n")


def stale(mutants, known):
    """Returns the mutants whose record belongs to another state of their file or test, the oldest first."""
    hashes = Hashes()
    old = [m for m in mutants if m.id in known and known[m.id][:2] != hashes.of(m)]
    return sorted(old, key=lambda m: known[m.id][2:])
