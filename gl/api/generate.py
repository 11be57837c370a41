#!/usr/bin/env python3
"""Turns the command table (commands/*.json) into everything that would otherwise be written by hand once per entry
point: the public header, the wrappers, the name table of GetProcAddress, the table the tests and fuzzers walk, and
the feature matrix. Usage: generate.py [--check]   (--check: write nothing, fail when the committed output is stale)

One row is a family, for instance Vertex{234}{sifdx}[v]. Its fields:
  name, row     the family and its row of the feature matrix
  kind          plain (default), components, matrix, plane, rect, flag, params, get_params
  args          "type name[=accepted]": tokens, @group[:first token to try], low..[high], or a number to try.
                A "real" is given once per entry of "types", and so is an "array" of them, read or written ("array*"). Components: what stands before them
  types         how reals and components come: b s i f d ub us ui x(=GLfixed) cf cd cx, "code:suffix" to name the
                suffix oneself ("d:" is glFrustum, "d" would be glFrustumd)
  inside        legal between Begin and End
  list          true: compiled word by word; "attribute" and "client_data": encoders by hand; false: runs at once
  feature       optional system it belongs to; "A|B": it is there with either; "and" is one more that it takes
  vector        of a plain family of reals: they come as an array, too
  refuses       the error that all arguments raise, legal or not
  digits        of components: false where the name does not tell their number
  pnames        parameter -> kind and count: c4 colour, r1 real, i1 integer; "=TOKEN" is a value to try, "@TOKEN" the
                target it belongs to (else the first), "?FEATURE" the optional system, "!CODE" the error that it raises
                as things are at first
"""
import json
import re
import sys
from pathlib import Path

API = Path(__file__).resolve().parent
ROOT = API.parent.parent
CHAPTERS = ["state", "vertex", "transform", "lighting", "pixel", "texture", "list", "selection", "evaluators"]
NOTICE = "// Written by gl/api/generate.py from gl/api/commands: change those, not this.\n"

C_TYPES = {"b": "GLbyte", "s": "GLshort", "i": "GLint", "f": "GLfloat", "d": "GLdouble", "ub": "GLubyte",
           "us": "GLushort", "ui": "GLuint", "x": "GLfixed", "cf": "GLclampf", "cd": "GLclampd", "cx": "GLclampx"}
CONVERT_AS = {"cf": "f", "cd": "d", "cx": "x"}
ARRAY_TYPES = {"f": "GL_FLOAT", "d": "GL_DOUBLE", "i": "GL_INT", "x": "GL_FIXED", "ui": "GL_UNSIGNED_INT",
               "us": "GL_UNSIGNED_SHORT"}
INTEGERS = {"b", "s", "i", "ub", "us", "ui"}


class Arg:
    """One argument of a plain or params family."""

    def __init__(self, text, groups):
        declaration, _, accepted = text.partition("=")
        self.type, self.name = declaration.rsplit(" ", 1)
        self.pointer, self.array = "*" in self.type, self.type.startswith("array")
        self.accepted, self.good, self.low, self.high = [], "0", None, None
        self.parse(accepted, groups)

    def parse(self, text, groups):
        bounds = re.fullmatch(r"(-?\d+)\.\.(-?\d*)", text)
        if bounds:
            self.low, self.high, self.good = bounds[1], bounds[2] or None, bounds[1]
        elif re.fullmatch(r"-?\d+", text):
            self.good = text
        elif text:
            first = None
            for word in text.split():
                if word.startswith("@"):
                    group, _, wish = word[1:].partition(":")
                    first = first or wish or None
                    self.accepted += groups[group].split()
                else:
                    self.accepted.append(word)
            self.good = "GL_" + (first or self.accepted[0])

    @property
    def c_type(self):
        return re.sub(r"\b(?!const|void)([a-z]+)", r"GL\1", self.type).replace("GL ", "")


class Pname:
    """One parameter of a params family."""

    def __init__(self, name, text):
        self.name = name
        found = re.fullmatch(r"([cri])(\d+)(?:=(-?\w+))?(?:@(\w+))?(?:\?(\w+))?(?:!(\w+))?", text)
        self.kind, self.count, good, target, self.feature, code = found.groups()
        self.code = f"GL_{code or 'NO_ERROR'}"
        self.good = "0" if good is None else good if re.fullmatch(r"-?\d+", good) else f"GL_{good}"
        self.target = f"GL_{target}" if target else "0"

    @property
    def row(self):
        present = f"SPANGLE_FEATURE_{self.feature} != 0" if self.feature else "true"
        return f"{{GL_{self.name}, {self.count}, '{self.kind}', {self.good}, {self.target}, {present}, {self.code}}}"


class Entry:
    """One entry point: its C signature and how its arguments reach the family's function."""

    def __init__(self, family, name, params, body, tries):
        self.family, self.name, self.params, self.body, self.tries = family, name, params, body, tries

    @property
    def prototype(self):
        return f"{self.family.returns} GLAPIENTRY {self.name}({self.c_params})"

    @property
    def needs(self):
        """The optional systems this entry point takes, each a condition of the preprocessor."""
        features = [self.family.feature] if self.family.feature else []
        features += [self.family.data["and"]] if "and" in self.family.data else []
        features += ["FIXED_POINT"] if re.search(r"xv?OES$", self.name) else []
        return tuple(" || ".join(f"SPANGLE_FEATURE_{word}" for word in feature.split("|")) for feature in features)

    @property
    def c_params(self):
        return ", ".join(f"{t} {n}" for t, n in self.params) or "void"


class Family:
    def __init__(self, data, groups, by_name):
        self.name, self.row = data["name"], data["row"]
        self.kind = data.get("kind", "plain")
        self.args = [Arg(text, groups) for text in data.get("args", [])]
        self.inside, self.feature = data.get("inside", False), data.get("feature")
        self.listing = {True: "words", False: "never"}.get(data.get("list", True), data.get("list"))
        if self.kind == "get_params":
            self.listing = "never"
        self.returns = "GL" + data["returns"] if "returns" in data else "void"
        self.returns = self.returns.replace("GLconst ", "const GL").replace("GLvoid", "void")
        self.types = [self.type_suffix(word) for word in data.get("types", "").split()]
        self.data, self.by_name = data, by_name
        self.pnames = dict(by_name[data["of"]].pnames if "of" in data else {}, **data.get("pnames", {}))
        self.pnames.pop(data.get("without"), None)
        self.entries = list(getattr(self, "entries_" + self.kind)())

    @staticmethod
    def type_suffix(word):
        code, colon, suffix = word.partition(":")
        return code, suffix if colon else ("xOES" if code in ("x", "cx") else code)

    # --- entry points ------------------------------------------------------------------------------------------

    def entry(self, name, params, call, tries, null=None):
        """`call` are the canonical arguments; `null` names a pointer that must not be null."""
        text = ", ".join(call)
        guard = f"    if ({null} == nullptr)\n        return refuse_null(SPANGLE_TEXT(\"{name}: null pointer\"));\n" if null else ""
        verb = "return ask" if self.returns != "void" else "issue"
        return Entry(self, name, params, f"{guard}    {verb}<family::{self.name}>({text});\n", tries)

    def entries_plain(self):
        for code, suffix in self.types or [("", "")]:
            params, call, tries = [], [], []
            for arg in self.args:
                if arg.type == "real":
                    params.append((C_TYPES[code], arg.name))
                    call.append(cast(code, arg.name))
                    tries.append(("real", arg))
                elif arg.array:
                    params.append((("" if arg.pointer else "const ") + C_TYPES[code] + "*", arg.name))
                    call.append(f"Values{{{arg.name}, {ARRAY_TYPES[code]}}}")
                    tries.append(("values", arg))
                else:
                    params.append((arg.c_type, arg.name))
                    call.append(f"{arg.name} != 0" if arg.type == "boolean" else arg.name)
                    tries.append((arg.type, arg))
            yield self.entry("gl" + self.name + suffix, params, call, tries)
            if self.data.get("vector"):
                vector, value = suffix.replace("x", "xv", 1) if code == "x" else suffix + "v", Arg("real value", {})
                yield self.entry("gl" + self.name + vector, [(f"const {C_TYPES[code]}*", "v")],
                                 [cast(code, f"v[{i}]") for i in range(len(self.args))], [("values", value)], "v")

    def entries_components(self):
        pad = ["numeric::one" if p == "1" else "numeric::zero" for p in self.data["pad"].split()]
        names = {"Normal": ["nx", "ny", "nz"]}.get(self.name, self.component_names)
        leading = [(a.c_type, a.name) for a in self.args]
        first, first_tries = [n for _, n in leading], [(a.type, a) for a in self.args]
        for size in self.data["sizes"]:
            for code, suffix in self.types:
                convert = normalize if self.data["integers"] == "normalize" else cast
                rest = pad[size:]
                one = first + [convert(code, n) for n in names[:size]] + rest
                many = first + [convert(code, f"v[{i}]") for i in range(size)] + rest
                stem, c = f"gl{self.name}{size if self.data.get('digits', True) else ''}", C_TYPES[code]
                vector = suffix.replace("x", "xv", 1) if code == "x" else suffix + "v"
                value = Arg("real value", {})
                yield self.entry(stem + suffix, leading + [(c, n) for n in names[:size]], one,
                                 first_tries + [("real", value)] * size)
                yield self.entry(stem + vector, leading + [(f"const {c}*", "v")], many,
                                 first_tries + [("values", value)], "v")

    def entries_flag(self):
        value = Arg("boolean flag", {})
        yield self.entry("gl" + self.name, [("GLboolean", "flag")], ["flag != 0"], [("boolean", value)])
        yield self.entry(f"gl{self.name}v", [("const GLboolean*", "flag")], ["*flag != 0"], [("values", value)], "flag")

    def entries_rect(self):
        for code, suffix in self.types:
            c, value = C_TYPES[code], Arg("real value", {})
            vector = suffix.replace("x", "xv", 1) if code == "x" else suffix + "v"
            names = ["x1", "y1", "x2", "y2"]
            yield self.entry("glRect" + suffix, [(c, n) for n in names], [cast(code, n) for n in names],
                             [("real", value)] * 4)
            yield self.entry("glRect" + vector, [(f"const {c}*", "v1"), (f"const {c}*", "v2")],
                             [cast(code, n) for n in ("v1[0]", "v1[1]", "v2[0]", "v2[1]")], [("values", value)] * 2,
                             null="v1 == nullptr || v2")

    def entries_matrix(self):
        for code, suffix in self.types:
            yield self.entry(f"gl{self.name}{suffix}", [(f"const {C_TYPES[code]}*", "m")],
                             [f"convert::matrix_{code}(m)"], [("values", Arg("real m", {}))], "m")

    def entries_plane(self):
        leading = [(a.c_type, a.name) for a in self.args]
        call = [n for _, n in leading]
        for code, suffix in self.types:
            yield self.entry(f"gl{self.name}{suffix}", leading + [(f"const {C_TYPES[code]}*", "equation")],
                             call + [cast(code, f"equation[{i}]") for i in range(4)],
                             [(a.type, a) for a in self.args] + [("values", Arg("real equation", {}))], "equation")

    def entries_params(self):
        leading = [(a.c_type, a.name) for a in self.args] + [("GLenum", "pname")]
        call = [n for _, n in leading]
        tries = [("enum", a) for a in self.args] + [("pname", None)]
        for code, suffix in self.types:
            c, shape = C_TYPES[code], f"shape::{self.name}(pname)"
            yield self.entry(f"gl{self.name}{suffix}", leading + [(c, "param")],
                             call + [f"convert::scalar_{code}({shape}, param)"], tries + [("pvalue", None)])
            if not self.data.get("scalar_only"):
                vector = suffix.replace("x", "xv", 1) if code == "x" else suffix + "v"
                yield self.entry(f"gl{self.name}{vector}", leading + [(f"const {c}*", "params")],
                                 call + [f"convert::vector_{code}({shape}, params)"], tries + [("pvalues", None)],
                                 "params")

    def entries_get_params(self):
        leading = [(a.c_type, a.name) for a in self.args] + [("GLenum", "pname")]
        call = [n for _, n in leading]
        tries = [(a.type, a) for a in self.args] + [("pname", None), ("out", None)]
        for code, suffix in self.types:
            name = f"gl{self.name}" + (suffix.replace("x", "xv", 1) if code == "x" else suffix + "v")
            body = (f"    if (params == nullptr)\n        return refuse_null(SPANGLE_TEXT(\"{name}: null pointer\"));\n"
                    f"    Params found;\n    fetch<family::{self.name}>(found, {', '.join(call)});\n"
                    f"    convert::store_{code}(shape::{self.name}(pname), found, params);\n")
            yield Entry(self, name, leading + [(f"{C_TYPES[code]}*", "params")], body, tries)

    @property
    def component_names(self):
        known = {"Color": ["red", "green", "blue", "alpha"], "TexCoord": list("strq"), "MultiTexCoord": list("strq"),
                 "Index": ["index"], "FogCoord": ["coord"]}
        return known.get(self.name, list("xyzw")[:len(self.data["pad"].split())])

    # --- the handwritten function ------------------------------------------------------------------------------

    @property
    def canonical(self):
        """Parameter list of cmd::Name after the context."""
        if self.kind == "components":
            return [(a.c_type, a.name) for a in self.args] + [("Real", n) for n in self.component_names]
        if self.kind == "flag":
            return [("bool", "flag")]
        if self.kind == "plane":
            return [(a.c_type, a.name) for a in self.args] + [("Real", n) for n in "abcd"]
        if self.kind == "rect":
            return [("Real", n) for n in ("x1", "y1", "x2", "y2")]
        if self.kind == "matrix":
            return [("const Matrix16&", "matrix")]
        plain = [("Real" if a.type == "real" else "bool" if a.type == "boolean" else "const Values&" if a.array else a.c_type, a.name)
                 for a in self.args]
        if self.kind == "params":
            return plain + [("GLenum", "pname"), ("const Params&", "params")]
        if self.kind == "get_params":
            return plain + [("GLenum", "pname"), ("Params&", "params")]
        return plain

    @property
    def signature(self):
        params = ["Context& context"] + [f"{t} {n}".replace("* ", "* ") for t, n in self.canonical]
        return ", ".join(params)


def cast(code, name):
    return f"convert::cast_{CONVERT_AS.get(code, code)}({name})"


def normalize(code, name):
    return f"convert::unit_{code}({name})" if code in INTEGERS else cast(code, name)


# --- reading -----------------------------------------------------------------------------------------------------

def load():
    chapters, by_name, groups, tokens = [], {}, {}, {}
    raw = [json.loads((API / "commands" / f"{name}.json").read_text()) for name in CHAPTERS]
    for data in raw:
        groups.update(data["groups"])
        for token, value in data["tokens"].items():
            value = int(str(value), 0)
            if tokens.setdefault(token, value) != value:
                sys.exit(f"token {token} has two values")
    for data in raw:
        families = []
        for row in data["families"]:
            family = Family(row, groups, by_name)
            by_name[family.name] = family
            families.append(family)
        chapters.append((data, families))
    for family in by_name.values():
        for arg in family.args:
            for token in arg.accepted:
                if token not in tokens:
                    sys.exit(f"{family.name}: token {token} has no value")
    return chapters, tokens


# --- the public header -------------------------------------------------------------------------------------------

HEADER_TOP = """/* OpenGL as Spangle has it: exactly the commands that exist. For C89 and up, and C++.
   Written by gl/api/generate.py from gl/api/commands: change those, not this. */
#ifndef SPANGLE_GL_GL_H
#define SPANGLE_GL_GL_H

#ifndef GLAPI
#define GLAPI extern
#endif
#ifndef APIENTRY
#define APIENTRY
#endif
#ifndef GLAPIENTRY
#define GLAPIENTRY APIENTRY
#endif

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SPANGLE_GL 1
#define GL_VERSION_1_0 1

typedef unsigned int GLenum;
typedef unsigned char GLboolean;
typedef unsigned int GLbitfield;
typedef void GLvoid;
typedef ptrdiff_t GLintptr;
typedef ptrdiff_t GLsizeiptr;
typedef signed char GLbyte;
typedef short GLshort;
typedef int GLint;
typedef unsigned char GLubyte;
typedef unsigned short GLushort;
typedef unsigned int GLuint;
typedef int GLsizei;
typedef float GLfloat;
typedef float GLclampf;
typedef double GLdouble;
typedef double GLclampd;
typedef int GLfixed;  /* S15.16, GL_OES_fixed_point */
typedef int GLclampx; /* S15.16, clamped to [0, 1] */
"""


def header(chapters, _tokens):
    out = [HEADER_TOP]
    for data, families in chapters:
        out.append(f"\n/* {data['title']} (GL 1.3, {data['section']}) */\n")
        for token, value in data["tokens"].items():
            value = int(str(value), 0)
            out.append(f"#define GL_{token} {value if value < 2 else f'0x{value:04X}'}\n")
        for family in families:
            out += [f"GLAPI {entry.prototype};\n" for entry in family.entries]
    out.append("\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n")
    return "".join(out)


# --- declarations and wrappers -----------------------------------------------------------------------------------

def commands_header(chapters, _tokens):
    out = ["// One handwritten function per family, and what the wrappers know about it.\n", NOTICE,
           "#pragma once\n\n#include \"gl/api/family.hpp\"\n#include \"gl/context/types.hpp\"\n\n",
           "namespace spangle::gl {\nstruct Context;\n}\n\nnamespace spangle::gl::cmd {\n"]
    everything = [f for _, families in chapters for f in families]
    for data, families in chapters:
        out.append(f"\n// {data['title']} (GL 1.3, {data['section']}).\n")
        out += [f"{f.returns} {f.name}({f.signature});\n" for f in families]
    out.append("\n} // namespace spangle::gl::cmd\n\n/// Handwritten encoders of display lists, in gl/list.\n"
               "namespace spangle::gl::encode {\n\n")
    out += [f"void {f.name}({f.signature});\n" for f in everything if f.listing in ("attribute", "client_data")]
    out.append("\n} // namespace spangle::gl::encode\n\nnamespace spangle::gl::family {\n\n")
    for f in everything:
        encoder = f"&encode::{f.name}" if f.listing in ("attribute", "client_data") else "nullptr"
        out.append(f"struct {f.name} {{\n    static constexpr auto run = &cmd::{f.name};\n"
                   f"    static constexpr auto encode = {encoder};\n"
                   f"    static constexpr bool inside = {str(f.inside).lower()};\n"
                   f"    static constexpr Listing listing = Listing::{f.listing};\n"
                   f"    static constexpr const char* refusal = SPANGLE_TEXT(\"gl{f.name} between glBegin and glEnd\");\n}};\n")
    out.append("\n} // namespace spangle::gl::family\n")
    return "".join(out)


def shapes_header(chapters, _tokens):
    out = ["// How many values a pname takes, and of what kind.\n", NOTICE,
           "#pragma once\n\n#include \"gl/api/family.hpp\"\n\nnamespace spangle::gl::shape {\n"]
    kinds = {"c": "color", "r": "real", "i": "integer"}
    for _, families in chapters:
        for f in families:
            if not f.pnames:
                continue
            cases = {}
            for pname in (Pname(n, t) for n, t in f.pnames.items()):
                cases.setdefault(pname.kind + pname.count, []).append(pname.name)
            out.append(f"\ninline Shape {f.name}(GLenum pname) {{\n    switch (pname) {{\n")
            for text, names in cases.items():
                out += [f"    case GL_{n}:\n" for n in names]
                out.append(f"        return {{Kind::{kinds[text[0]]}, {text[1:]}}};\n")
            out.append("    default:\n        return {};\n    }\n}\n")
    out.append("\n} // namespace spangle::gl::shape\n")
    return "".join(out)


def wrappers(data, families):
    out = [f"// Entry points: {data['title']}.\n", NOTICE,
           "#include \"gl/api/convert.hpp\"\n#include \"gl/api/generated/commands.hpp\"\n"
           "#include \"gl/api/generated/shapes.hpp\"\n#include \"gl/api/issue.hpp\"\n\n"
           "using namespace spangle::gl;\nnamespace numeric = spangle::numeric;\n\nextern \"C\" {\n"]
    needs = ()
    for f in families:
        for entry in f.entries:
            if entry.needs != needs:
                out.append(("\n#endif\n" if needs else "") + (f"\n#if {both(entry.needs)}\n" if entry.needs else ""))
                needs = entry.needs
            out.append(f"\n{entry.prototype.replace('(void)', '()')} {{\n{entry.body}}}\n")
    out.append("\n#endif\n" if needs else "")
    out.append(refusals([e for f in families for e in f.entries]))
    out.append("\n} // extern \"C\"\n")
    return "".join(out)


def both(needs):
    """One condition of several."""
    return " && ".join(f"({need})" if "||" in need and len(needs) > 1 else need for need in needs)


def refusals(entries):
    """What the entry points of a feature do in a build without it."""
    out = []
    for needs in sorted({e.needs for e in entries if e.needs}):
        for i, need in enumerate(needs):
            absent = f"!({need})" if "||" in need else f"!{need}"
            out.append(f"\n#if {both([*needs[:i], absent])}\n")
            for entry in (e for e in entries if e.needs == needs):
                types = ", ".join(t for t, _ in entry.params)
                back = "" if entry.family.returns == "void" else "    return 0;\n"
                text = f"{entry.name}: this build has no {need.replace('||', 'and no')}"
                out.append(f"\n{entry.family.returns} GLAPIENTRY {entry.name}({types}) {{\n"
                           f"    refuse_feature(SPANGLE_TEXT(\"{text}\"));\n{back}}}\n")
            out.append("\n#endif\n")
    return "".join(out)


def names(chapters, _tokens):
    found = sorted(e.name for _, families in chapters for f in families for e in f.entries)
    out = ["// The name table of GetProcAddress: a feature, because it keeps every entry point in the program.\n", NOTICE,
           "#include \"gl/api/names.hpp\"\n\n#include <spangle/GL/gl.h>\n\n"
           "namespace spangle::gl {\n\n#if SPANGLE_FEATURE_GET_PROC_ADDRESS\n\nnamespace {\n\n"
           "struct Name {\n    const char* text;\n    EntryPoint function;\n};\n\n"
           "const Name table[] = {\n"]
    out += [f"    {{\"{n}\", reinterpret_cast<EntryPoint>(&{n})}},\n" for n in found]
    out.append("};\n\nint compare(const char* a, const char* b) {\n    while (*a != 0 && *a == *b)\n        ++a, ++b;\n"
               "    return static_cast<unsigned char>(*a) - static_cast<unsigned char>(*b);\n}\n\n} // namespace\n\n"
               "EntryPoint find_entry_point(const char* name) {\n"
               "    unsigned low = 0, high = sizeof table / sizeof table[0];\n    while (low < high) {\n"
               "        const unsigned middle = (low + high) / 2;\n        const int order = compare(name, table[middle].text);\n"
               "        if (order == 0)\n            return table[middle].function;\n"
               "        (order < 0 ? high : low) = order < 0 ? middle : middle + 1;\n    }\n    return nullptr;\n}\n\n#else\n\n"
               "EntryPoint find_entry_point(const char*) { return nullptr; }\n\n#endif\n\n} // namespace spangle::gl\n")
    return "".join(out)


# --- what tests and fuzzers walk ---------------------------------------------------------------------------------

FETCH = {"real": "{c}(a[{i}].number)", "enum": "GLenum(a[{i}].integer)", "uint": "GLuint(a[{i}].integer)", "ushort": "GLushort(a[{i}].integer)",
         "int": "GLint(a[{i}].integer)", "intptr": "GLintptr(a[{i}].integer)", "sizeiptr": "GLsizeiptr(a[{i}].integer)", "sizei": "GLsizei(a[{i}].integer)", "bitfield": "GLbitfield(a[{i}].integer)",
         "boolean": "GLboolean(a[{i}].integer)", "pname": "GLenum(a[{i}].integer)", "pvalue": "{c}(a[{i}].number)"}


def test_table(chapters, tokens):
    out = ["// Every entry point with its argument kinds and a uniform way to call it.\n", NOTICE,
           "namespace {\n\n"]
    rows, pool = [], {}

    def array(kind, items):
        """A shared static array of `items`."""
        text = ", ".join(items)
        if text not in pool:
            pool[text] = f"{kind.lower()}_{len(pool)}"
            out.append(f"const {kind} {pool[text]}[] = {{{text}}};\n")
        return f"{{{pool[text]}, {len(items)}}}"

    for _, families in chapters:
        for f in families:
            pnames = [Pname(n, t).row for n, t in f.pnames.items()]
            pname_list = array("Pname", pnames) if pnames else "{}"
            for e in f.entries:
                args, calls = [], []
                for i, ((kind, arg), (c_type, _)) in enumerate(zip(e.tries, e.params)):
                    pointer = "*" in c_type
                    calls.append(f"static_cast<{c_type}>(a[{i}].pointer)" if pointer
                                 else FETCH[kind].format(c=c_type, i=i))
                    label = "out" if pointer and not c_type.startswith("const") else "in" if pointer else kind
                    label = "in" if kind in ("values", "pvalues") and label != "out" else label
                    accepted = array("GLenum", ["GL_" + t for t in arg.accepted]) if arg and arg.accepted else "{}"
                    low = arg.low if arg and arg.low is not None else "INT32_MIN"
                    high = arg.high if arg and arg.high is not None else "INT32_MAX"
                    label = {"enum": "enum_", "int": "int_", "intptr": "int_", "sizeiptr": "sizei", "ushort": "uint"}.get(label, label)
                    args.append(f"{{Kind::{label}, {accepted}, {low}, {high}, {arg.good if arg else '0'}, "
                                f"sizeof({c_type.replace('const ', '').replace('*', '').replace('void', 'char').strip() or 'char'})}}")
                arg_list = array("Arg", args) if args else "{}"
                rows.append(f"    {{\"{e.name}\", \"{f.name}\", \"{f.row}\", {str(f.inside).lower()}, "
                            f"Listing::{f.listing}, {f'({both(e.needs)}) != 0' if e.needs else 'true'}, "
                            f"GL_{f.data.get('refuses', 'NO_ERROR')}, {arg_list}, {pname_list},\n"
                            f"     [](const Value* {'a' if calls else ''}) {{ {e.name}({', '.join(calls)}); }}}},\n")
    out.append("\nconst Command table[] = {\n" + "".join(rows) + "};\n\n} // namespace\n")
    return "".join(out)


# --- the feature matrix ------------------------------------------------------------------------------------------

README_MATRIX = re.compile(r"(<!-- feature matrix: .*? -->\n).*?(<!-- end of the feature matrix -->\n)", re.S)


def matrix(chapters):
    """Of each row: id, name, commands, state, note."""
    rows = json.loads((API / "commands" / "rows.json").read_text())
    entries = {}
    for _, families in chapters:
        for f in families:
            entries.setdefault(f.row, []).extend(e.name for e in f.entries if not e.name.endswith("OES"))
    record = ROOT / "tests" / "mutants" / "caught.txt"
    caught = set(re.findall(r"^\S+ (\w+)$", record.read_text(), re.M)) if record.exists() else set()
    for row in rows:
        have, want = len(entries.get(row["id"], [])), row["entry_points"]
        complete = have >= want if want else row.get("exists", False)
        some = have > 0 or row.get("exists", False)
        missing = row.get("missing", "")
        state = "works" if complete and not missing and row["id"] in caught else "partly" if some else "not yet"
        note = missing or ("" if state != "partly" else
                           f"{want - have} entry point{'s' if want - have > 1 else ''} to come" if have < want else "no seeded defect yet")
        yield row["id"], row["name"], f"{min(have, want)}/{want}" if want else "-", state, note


def totals(rows):
    states = [row[3] for row in rows]
    return ", ".join(f"{states.count(s)} {s}" for s in ("works", "partly", "not yet")) + f" of {len(states)} rows"


def features(rows):
    return ("# Feature matrix\n\n<!-- Written by gl/api/generate.py from gl/api/commands -->\n\n"
            "Rows of GL 1.3. *works*: every command of the row exists, nothing is known to be missing, and a seeded defect of the\n"
            "row is caught by the tests. *partly*: what is missing is said. *not yet*: nothing of it exists, or it is untested.\n\n"
            "| row | system | commands | state | note |\n|---|---|---|---|---|\n"
            + "".join(f"| {' | '.join(row)} |\n" for row in rows) + f"\n{totals(rows)}.\n")


def readme(rows):
    """The README with its matrix renewed."""
    text = (ROOT / "README.md").read_text()
    table = (f"\n<details><summary>{totals(rows)} (a row works when a seeded defect of it is caught)</summary>\n\n"
             "| row | system | state |\n|---|---|---|\n"
             + "".join(f"| {row} | {name} | {state}{': ' + note if note else ''} |\n" for row, name, _, state, note in rows)
             + "\n</details>\n\n")
    renewed, count = README_MATRIX.subn(lambda m: m[1] + table + m[2], text)
    if count != 1:
        sys.exit("README.md: no place for the feature matrix")
    return renewed


# --- writing -----------------------------------------------------------------------------------------------------

def outputs():
    chapters, tokens = load()
    rows = list(matrix(chapters))
    files = {
        "gl/include/spangle/GL/gl.h": header(chapters, tokens),
        "gl/api/generated/commands.hpp": commands_header(chapters, tokens),
        "gl/api/generated/shapes.hpp": shapes_header(chapters, tokens),
        "gl/api/generated/names.cpp": names(chapters, tokens),
        "tests/gl_api/generated/command_table.inc": test_table(chapters, tokens),
        "docs/features.md": features(rows),
        "README.md": readme(rows),
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
            path.write_text(text)
    if check and stale:
        sys.exit("stale, run gl/api/generate.py: " + ", ".join(stale))


if __name__ == "__main__":
    main()
