"""Writes the code that commands need apart from their functions: declarations, wrappers, names, the public header."""
import json
import textwrap

from command_table import API, STATE_QUERIES, Pname

NOTICE = "// Written by gl/api/generate.py from gl/api/commands: change those, not this.\n"

HEADER_TOP = """/* OpenGL as Spangle has it: exactly the commands that exist. For C89 and up, and C++.
   Written by gl/api/generate.py from gl/api/commands: change those, not this.

   A comment holds for all commands and tokens below it, up to the next one. A command that raises an error does nothing else (GL 1.3,
   2.5). It raises GL_INVALID_ENUM for a token that it does not take, GL_INVALID_VALUE for a number outside of its range, a negative size
   or a null pointer, and GL_INVALID_OPERATION where its optional system is left out of the build, or between glBegin and glEnd unless its
   comment allows that. What a pointer of a command refers to is read or written before the command returns, except where a comment says
   that it must stay. Vertex arrays are read when they are drawn; the arrays of glSelectBuffer and glFeedbackBuffer are written until
   their mode ends. */
#ifndef SPANGLE_GL_GL_H
#define SPANGLE_GL_GL_H

/* How functions are declared and called; a build may define them. */
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

/* This GL is Spangle, and has these versions. */
#define SPANGLE_GL 1
#define GL_VERSION_1_0 1
#define GL_VERSION_1_1 1
#define GL_VERSION_1_2 1
#define GL_VERSION_1_3 1
#define GL_VERSION_1_4 1
#define GL_VERSION_1_5 1

/* Types (GL 1.3, 2.4, table 2.2; GL 1.5, 2.4) */
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


MOST_TOKENS = 12 # a comment does not list more than these


def taken(family):
    """Says in words which arguments a family takes."""
    for arg in family.args:
        if arg.accepted and len(arg.accepted) <= MOST_TOKENS and family.name not in STATE_QUERIES:
            yield f"{arg.name}: " + ", ".join("GL_" + token for token in arg.accepted)
        elif arg.low is not None:
            most = f" to {arg.high}" if arg.high != arg.low else ""
            yield f"{arg.name}: {arg.low}{most}" if arg.high else f"{arg.name}: at least {arg.low}"
    if family.pnames and len(family.pnames) <= MOST_TOKENS:
        yield "pname: " + ", ".join("GL_" + name for name in family.pnames)


def comment(family, section):
    """The comment about a family in the public header."""
    said = [f"{family.does} ({section})", *taken(family)]
    if family.data.get("refuses"):
        said.append(f"Always GL_{family.data['refuses']}")
    if family.inside:
        said.append("Also between glBegin and glEnd")
    if family.listing == "never" and family.returns == "void":
        said.append("Not compiled into display lists")
    if family.feature:
        said.append("Optional system: " + " or ".join(family.feature.split("|")))
    return "\n".join(textwrap.wrap(f"/* {'. '.join(said)}. */", 140, subsequent_indent="   ", break_long_words=False)) + "\n"


def header(chapters, _tokens):
    rows = {row["id"]: row for row in json.loads((API / "commands" / "rows.json").read_text())}
    out = [HEADER_TOP]
    for data, families in chapters:
        out.append(f"\n/* {data['title']} (GL 1.3, {data['section']}) */\n")
        for token, value in data["tokens"].items():
            value = int(str(value), 0)
            out.append(f"#define GL_{token} {value if value < 2 else f'0x{value:04X}'}\n")
        for family in families:
            out.append(comment(family, rows[family.row].get("section", f"GL 1.3, {data['section']}")))
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
    out.append("\n} // namespace spangle::gl::encode\n\n#if SPANGLE_MESSAGES\nnamespace spangle::gl::texts {\n\n")
    out += [f"extern const CommandText {f.name};\n" for f in everything]
    out.append("\n} // namespace spangle::gl::texts\n#define SPANGLE_COMMAND_TEXT(name) &texts::name\n#else\n"
               "#define SPANGLE_COMMAND_TEXT(name) nullptr\n#endif\n\nnamespace spangle::gl::family {\n\n")
    for f in everything:
        encoder = held(f, f"&encode::{f.name}") if f.listing in ("attribute", "client_data") else "nullptr"
        out.append(f"struct {f.name} {{\n    static constexpr auto run = {held(f, f'&cmd::{f.name}')};\n"
                   f"    static constexpr auto encode = {encoder};\n"
                   f"    static constexpr bool inside = {str(f.inside).lower()};\n"
                   f"    static constexpr Listing listing = Listing::{f.listing};\n"
                   f"    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT({f.name});\n}};\n")
    out.append("\n} // namespace spangle::gl::family\n")
    return "".join(out)


def held(family, function):
    """The function of a family, which holds the lock of the share group's objects if the family uses them."""
    return f"sharing<{function}>" if family.shares else function


def shape_rows(pnames, tokens):
    """Rows of the shape table. Names with consecutive values and the same shape share a row."""
    runs = []
    for p in sorted(pnames, key=lambda p: value_of(tokens, p)):
        if runs and value_of(tokens, p) == value_of(tokens, runs[-1][0]) + len(runs[-1]) and (p.kind, p.count) == (runs[-1][0].kind, runs[-1][0].count):
            runs[-1].append(p)
        else:
            runs.append([p])
    kinds = {"c": "color", "r": "real", "i": "integer"}
    return "".join(f"    {{GL_{run[0].name}, {len(run)}, Kind::{kinds[run[0].kind]}, {run[0].count}}},\n" for run in runs)


def value_of(tokens, pname):
    return int(str(tokens[pname.name]), 0)


def shapes_header(chapters, tokens):
    out = ["// How many values a pname takes, and of what kind.\n", NOTICE,
           "#pragma once\n\n#include \"gl/api/family.hpp\"\n\nnamespace spangle::gl::shape {\n"]
    # A command and its query share one table with the pnames of both, so each of them checks the pname again.
    families = {f.name: f for _, group in chapters for f in group if f.pnames}
    for f in families.values():
        if f.name.removeprefix("Get") != f.name and f.name.removeprefix("Get") in families:
            out.append(f"\ninline constexpr const auto& {f.name} = {f.name.removeprefix('Get')};\n")
            continue
        taken = {**f.pnames, **(families[f"Get{f.name}"].pnames if f"Get{f.name}" in families else {})}
        rows = shape_rows([Pname(n, t) for n, t in taken.items()], tokens)
        out.append(f"\ninline constexpr ShapeRow {f.name}[] = {{\n{rows}    {{}},\n}};\n")
    out.append("\n} // namespace spangle::gl::shape\n")
    return "".join(out)


def wrappers(data, families):
    out = [f"// Entry points: {data['title']}.\n", NOTICE,
           "#include \"gl/api/components.hpp\"\n#include \"gl/api/convert.hpp\"\n#include \"gl/api/generated/commands.hpp\"\n"
           "#include \"gl/api/generated/shapes.hpp\"\n#include \"gl/api/issue.hpp\"\n#include \"gl/api/params.hpp\"\n#include \"gl/api/refused.hpp\"\n\n"
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
    """Joins conditions of the preprocessor into one that needs all of them."""
    return " && ".join(f"({need})" if "||" in need and len(needs) > 1 else need for need in needs)


def refusals(entries):
    """Entry points for builds without their feature, which raise an error that names the feature."""
    out = []
    for needs in sorted({e.needs for e in entries if e.needs}):
        for i, need in enumerate(needs):
            absent = f"!({need})" if "||" in need else f"!{need}"
            out.append(f"\n#if {both([*needs[:i], absent])}\n")
            for entry in (e for e in entries if e.needs == needs):
                types = ", ".join(t for t, _ in entry.params)
                prototype = f"{entry.family.returns} GLAPIENTRY {entry.name}({types})"
                text = f"{entry.name}: this build has no {need.replace('||', 'and no')}"
                out.append(f"\nSPANGLE_REFUSED(\"{text}\", {prototype})\n" if entry.family.returns == "void" else
                           f"\n{prototype} {{\n    refuse_feature(SPANGLE_TEXT(\"{text}\"));\n    return 0;\n}}\n")
            out.append("\n#endif\n")
    return "".join(out)


def names(chapters, extensions):
    found = {e.name: e.name for _, families in chapters for f in families for e in f.entries}
    found.update((alias.name, alias.entry.name) for extension in extensions for alias in extension.aliases)
    out = ["// The name table of GetProcAddress: a feature, because it keeps every entry point in the program.\n", NOTICE,
           "#include \"gl/api/names.hpp\"\n\n#include <spangle/GL/gl.h>\n\n"
           "namespace spangle::gl {\n\n#if SPANGLE_FEATURE_GET_PROC_ADDRESS\n\nnamespace {\n\n"
           "struct Name {\n    const char* text;\n    EntryPoint function;\n};\n\n"
           "const Name table[] = {\n"]
    out += [f"    {{\"{n}\", reinterpret_cast<EntryPoint>(&{found[n]})}},\n" for n in sorted(found)]
    out.append("};\n\nint compare(const char* a, const char* b) {\n    while (*a != 0 && *a == *b)\n        ++a, ++b;\n"
               "    return static_cast<unsigned char>(*a) - static_cast<unsigned char>(*b);\n}\n\n} // namespace\n\n"
               "EntryPoint find_entry_point(const char* name) {\n"
               "    unsigned low = 0, high = sizeof table / sizeof table[0];\n    while (low < high) {\n"
               "        const unsigned middle = (low + high) / 2;\n        const int order = compare(name, table[middle].text);\n"
               "        if (order == 0)\n            return table[middle].function;\n"
               "        (order < 0 ? high : low) = order < 0 ? middle : middle + 1;\n    }\n    return nullptr;\n}\n\n#else\n\n"
               "EntryPoint find_entry_point(const char*) { return nullptr; }\n\n#endif\n\n} // namespace spangle::gl\n")
    return "".join(out)
