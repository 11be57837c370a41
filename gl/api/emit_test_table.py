"""The table of all entry points, with arguments to try, for tests and fuzzers."""
from command_table import Pname
from emit_code import NOTICE, both

FETCH = {"real": "{c}(a[{i}].number)", "enum": "GLenum(a[{i}].integer)", "uint": "GLuint(a[{i}].integer)", "ushort": "GLushort(a[{i}].integer)",
         "int": "GLint(a[{i}].integer)", "intptr": "GLintptr(a[{i}].integer)", "sizeiptr": "GLsizeiptr(a[{i}].integer)", "sizei": "GLsizei(a[{i}].integer)", "bitfield": "GLbitfield(a[{i}].integer)",
         "boolean": "GLboolean(a[{i}].integer)", "pname": "GLenum(a[{i}].integer)", "pvalue": "{c}(a[{i}].number)"}

# The letters of number types, as in Arg::type; other types have none.
LETTERS = {"GLbyte": "b", "GLshort": "s", "GLint": "i", "GLsizei": "i", "GLubyte": "B", "GLushort": "S", "GLuint": "I", "GLbitfield": "I",
           "GLboolean": "B", "GLfloat": "f", "GLclampf": "f", "GLdouble": "d", "GLclampd": "d", "GLfixed": "x", "GLclampx": "x",
           "GLintptr": "l", "GLsizeiptr": "l"}


def accepted_token(arg, token):
    """A token to try. A build without the token's optional system does not accept it and tries another one."""
    feature = arg.features.get(token)
    return f"SPANGLE_FEATURE_{feature} ? GL_{token} : {arg.good}" if feature else f"GL_{token}"


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
                    accepted = array("GLenum", [accepted_token(arg, t) for t in arg.accepted]) if arg and arg.accepted else "{}"
                    low = arg.low if arg and arg.low is not None else "INT32_MIN"
                    high = arg.high if arg and arg.high is not None else "INT32_MAX"
                    label = {"enum": "enum_", "int": "int_", "intptr": "int_", "sizeiptr": "sizei", "ushort": "uint"}.get(label, label)
                    element = c_type.replace("const ", "").replace("*", "").replace("void", "char").strip() or "char"
                    letter = f"'{LETTERS[element]}'" if element in LETTERS else "0"
                    args.append(f"{{Kind::{label}, {accepted}, {low}, {high}, {arg.good if arg else '0'}, "
                                f"sizeof({element}), {letter}, {arg.count if arg else 0}}}")
                arg_list = array("Arg", args) if args else "{}"
                rows.append(f"    {{\"{e.name}\", \"{f.name}\", \"{f.row}\", {str(f.inside).lower()}, "
                            f"Listing::{f.listing}, {f'({both(e.needs)}) != 0' if e.needs else 'true'}, "
                            f"GL_{f.data.get('refuses', 'NO_ERROR')}, {arg_list}, {pname_list},\n"
                            f"     [](const Value* {'a' if calls else ''}) {{ {e.name}({', '.join(calls)}); }}}},\n")
    out.append("\nconst Command table[] = {\n" + "".join(rows) + "};\n\n} // namespace\n")
    return "".join(out)
