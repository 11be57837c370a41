"""The command table (commands/*.json): families, their entry points, arguments and parameters.

Each row is a family of commands, for instance Vertex{234}{sifdx}[v]. A row has these fields:
  name, row     the name of the family, and its row of the feature matrix
  does          what its commands do, as a sentence for gl.h without its full stop
  kind          plain (default), components, matrix, plane, rect, flag, params, get_params
  args          "type name[=accepted]". `accepted` is a list of tokens ("TOKEN?FEATURE" for one of an optional system), or
                @group[:first token to try], or low..[high], or a number that tests try.
                For each entry of "types" there is an entry point whose "real" has that type, and so has an "array", which is
                read, or written ("array*"). For components these are the arguments before the components.
  types         the types of reals and components: b s i f d ub us ui x(=GLfixed) cf cd cx. "code:suffix" sets the suffix of
                the name ("d:" makes glFrustum, and "d" would make glFrustumd)
  inside        true if the commands are legal between Begin and End
  shares        true if the commands read or write objects that contexts share: textures, lists, buffers. The "shares" of a chapter
                holds for its families that have no field of their own.
  list          true if lists store the commands word by word; "attribute" and "client_data" name handwritten encoders; false if
                the commands run at once
  feature       the optional system that the family belongs to; with "A|B" either is enough, and "and" names one more that it needs
  vector        for plain families of reals: true if there are entry points that take the reals as an array
  refuses       the error that the commands raise for all arguments, even legal ones
  digits        for components: false if the names of the commands do not contain their number
  pnames        for each parameter its kind and count: c4 colour, r1 real, i1 integer. "=TOKEN" is a value that tests try, "@TOKEN"
                the target that the parameter belongs to (by default the first), "?FEATURE" its optional system, and "!CODE" the
                error that it raises in the initial state
"""
import json
import re
import sys
from pathlib import Path

API = Path(__file__).resolve().parent
ROOT = API.parent.parent
CHAPTERS = ["state", "vertex", "transform", "lighting", "pixel", "texture", "list", "selection", "evaluators"]

C_TYPES = {"b": "GLbyte", "s": "GLshort", "i": "GLint", "f": "GLfloat", "d": "GLdouble", "ub": "GLubyte",
           "us": "GLushort", "ui": "GLuint", "x": "GLfixed", "cf": "GLclampf", "cd": "GLclampd", "cx": "GLclampx"}
CONVERT_AS = {"cf": "f", "cd": "d", "cx": "x"}
ARRAY_TYPES = {"f": "GL_FLOAT", "d": "GL_DOUBLE", "i": "GL_INT", "x": "GL_FIXED", "ui": "GL_UNSIGNED_INT",
               "us": "GL_UNSIGNED_SHORT"}
INTEGERS = {"b", "s", "i", "ub", "us", "ui"}
# The tokens of these groups are in the state table. The rows of families name a few that tests try.
STATE_QUERIES = {"GetBooleanv", "GetIntegerv", "GetFloatv", "GetDoublev", "GetFixedvOES", "GetPointerv"}


class Arg:
    """One argument of a plain or params family."""

    def __init__(self, text, groups):
        declaration, _, accepted = text.partition("=")
        self.type, self.name = declaration.rsplit(" ", 1)
        self.pointer, self.array = "*" in self.type, self.type.startswith("array")
        self.group = accepted[1:].partition(":")[0] if accepted.startswith("@") and " " not in accepted else None
        self.accepted, self.features, self.good, self.low, self.high = [], {}, "0", None, None
        self.count = 1 if self.array else 0  # the number of values that the pointer must point at; 0: unknown
        self.parse(accepted, groups)

    @classmethod
    def vector(cls, text, count):
        """An argument that points at `count` numbers."""
        arg = cls(text, {})
        arg.count = count
        return arg

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
                    token, _, feature = word.partition("?")
                    self.accepted.append(token)
                    if feature:
                        self.features[token] = feature
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
    """One entry point: its C signature, and how its arguments are passed to the function of the family."""

    def __init__(self, family, name, params, body, tries):
        self.family, self.name, self.params, self.body, self.tries = family, name, params, body, tries

    @property
    def prototype(self):
        return f"{self.family.returns} GLAPIENTRY {self.name}({self.c_params})"

    @property
    def needs(self):
        """The optional systems that this entry point needs. Each is a condition of the preprocessor."""
        features = [self.family.feature] if self.family.feature else []
        features += [self.family.data["and"]] if "and" in self.family.data else []
        features += ["FIXED_POINT"] if re.search(r"xv?OES$", self.name) else []
        return tuple(" || ".join(f"SPANGLE_FEATURE_{word}" for word in feature.split("|")) for feature in features)

    @property
    def c_params(self):
        return ", ".join(f"{t} {n}" for t, n in self.params) or "void"


class Family:
    def __init__(self, data, groups, by_name, shares=False):
        self.name, self.row, self.does = data["name"], data["row"], data["does"]
        self.shares = data.get("shares", shares)
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
        self.image = data.get("image", False)
        self.pnames = dict(by_name[data["of"]].pnames if "of" in data else {}, **data.get("pnames", {}))
        self.pnames.pop(data.get("without"), None)
        self.entries = list(getattr(self, "entries_" + self.kind)())

    @staticmethod
    def type_suffix(word):
        code, colon, suffix = word.partition(":")
        return code, suffix if colon else ("xOES" if code in ("x", "cx") else code)

    # --- entry points ------------------------------------------------------------------------------------------

    def entry(self, name, params, call, tries, null=None, body=None):
        """Makes an entry point. `call` has its canonical arguments; `null` names a pointer that must not be null; `body` replaces both."""
        text = ", ".join(call)
        guard = self.null_guard(name, null) if null else ""
        verb = "return ask" if self.returns != "void" else "issue"
        return Entry(self, name, params, body or f"{guard}    {verb}<family::{self.name}>({text});\n", tries)

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
            if self.image:
                call = [self.image_command()]
            reals = len(params) > 1 and all(arg.type == "real" for arg in self.args)
            body = self.array(C_TYPES[code], [n for _, n in params]) + self.reals_at(code, len(params), "nullptr") if reals else None
            if self.args and self.args[-1].array and len(params) <= 3:
                body = f"    issue_array<family::{self.name}>({', '.join(n for _, n in params)}, {ARRAY_TYPES[code]});\n"
            yield self.entry("gl" + self.name + suffix, params, call, tries, body=body)
            if self.data.get("vector"):
                vector, value = suffix.replace("x", "xv", 1) if code == "x" else suffix + "v", Arg.vector("real value", len(self.args))
                yield self.entry("gl" + self.name + vector, [(f"const {C_TYPES[code]}*", "v")],
                                 [cast(code, f"v[{i}]") for i in range(len(self.args))], [("values", value)], "v",
                                 body=self.reals_at(code, len(params), self.null_text("gl" + self.name + vector)) if reals else None)

    def image_command(self):
        """The ImageCommand of a texture image. It has the same members for any number of dimensions."""
        names = [a.name for a in self.args]
        sizes = [n for n in ("width", "height", "depth") if n in names]
        beside = ["static_cast<GLint>(target)"] + [n for n in names[1:] if n not in (*sizes, "format", "type", "pixels")]
        beside += ["0"] * (5 - len(beside)) # every member gets a value, so that no memory is cleared first
        size = ", ".join(sizes + ["1"] * (3 - len(sizes)))
        volume = ", true" if len(sizes) == 3 else ", false"
        return f"ImageCommand{{{{{', '.join(beside)}}}, {{{size}}}, format, type, pixels{volume}}}"

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
                # Most loops over vertices call entry points that take floats or single integers, so these convert their arguments inline.
                often = self.listing == "attribute"
                forms = [len(pad) > 1 and ("reals" if often and code in ("fi", "f")[vectorial] else "components") for vectorial in (0, 1)]
                kind = element(code, convert)
                wide = widened(code, convert)
                yield self.entry(stem + suffix, leading + [(c, n) for n in names[:size]], one, first_tries + [("real", value)] * size,
                                 body=forms[0] and self.array(C_TYPES[wide], names[:size]) +
                                      self.components_at(forms[0], first, element(wide, convert), size, "nullptr"))
                yield self.entry(stem + vector, leading + [(f"const {c}*", "v")], many, first_tries + [("values", Arg.vector("real v", size))], "v",
                                 body=forms[1] and self.components_at(forms[1], first, kind, size, self.null_text(stem + vector)))

    def components_at(self, form, first, kind, size, null):
        """The call for components that lie in memory at v. If `null` is "nullptr", the entry point takes them as single arguments."""
        place = "v" if null != "nullptr" else "given"
        if form == "reals":
            return f"    issue_reals<family::{self.name}, {kind}, {size}>({place}, {null});\n"
        return f"    issue_components<family::{self.name}>({', '.join([*first, f'{place}, convert::components({kind}, {size})', null])});\n"

    @staticmethod
    def array(c_type, names):
        return f"    const {c_type} given[] = {{{', '.join(names)}}};\n"

    def null_guard(self, name, null):
        return f"    if ({null} == nullptr)\n        return refuse_null({self.null_text(name, null)});\n"

    @staticmethod
    def null_text(name, arg="v"):
        return f'SPANGLE_TEXT("{name}: {arg} is a null pointer")'

    def reals_at(self, code, count, null):
        """The call for a family of reals whose arguments all lie in memory at v."""
        return self.components_at("reals", [], element(code), count, null)

    def entries_flag(self):
        yield self.entry("gl" + self.name, [("GLboolean", "flag")], ["flag != 0"], [("boolean", Arg("boolean flag", {}))])
        yield self.entry(f"gl{self.name}v", [("const GLboolean*", "flag")], ["*flag != 0"], [("values", Arg.vector("boolean flag", 1))], "flag")

    def entries_rect(self):
        for code, suffix in self.types:
            c, value = C_TYPES[code], Arg("real value", {})
            vector = suffix.replace("x", "xv", 1) if code == "x" else suffix + "v"
            names = ["x1", "y1", "x2", "y2"]
            yield self.entry("glRect" + suffix, [(c, n) for n in names], [], [("real", value)] * 4,
                             body=self.array(C_TYPES[widened(code)], names) + self.reals_at(widened(code), 4, "nullptr"))
            corners = f"v1, v2, convert::components({element(code)}, 2), {self.null_text('glRect' + vector, 'v1 or v2')}"
            yield self.entry("glRect" + vector, [(f"const {c}*", "v1"), (f"const {c}*", "v2")], [], [("values", Arg.vector("real v", 2))] * 2,
                             body=f"    issue_corners<family::{self.name}>({corners});\n")

    def entries_matrix(self):
        for code, suffix in self.types:
            name = f"gl{self.name}{suffix}"
            yield self.entry(name, [(f"const {C_TYPES[code]}*", "m")], [], [("values", Arg.vector("real m", 16))],
                             body=f"    issue_matrix<family::{self.name}, {element(code)}>(m, {self.null_text(name, 'm')});\n")

    def entries_plane(self):
        leading = [(a.c_type, a.name) for a in self.args]
        call = [n for _, n in leading]
        for code, suffix in self.types:
            name = f"gl{self.name}{suffix}"
            yield self.entry(name, leading + [(f"const {C_TYPES[code]}*", "equation")], [],
                             [(a.type, a) for a in self.args] + [("values", Arg.vector("real equation", 4))],
                             body=f"    issue_components<family::{self.name}>({', '.join(call)}, equation, "
                                  f"convert::components({element(code)}, 4), {self.null_text(name, 'equation')});\n")

    def entries_params(self):
        leading = [(a.c_type, a.name) for a in self.args] + [("GLenum", "pname")]
        call = [n for _, n in leading]
        tries = [("enum", a) for a in self.args] + [("pname", None)]
        for code, suffix in self.types:
            c, form = C_TYPES[code], f"convert::Number::{CONVERT_AS.get(code, code)}"
            place = ", ".join(call)
            single = form if code != "d" else "convert::Number::f"
            yield Entry(self, f"gl{self.name}{suffix}", leading + [(c, "param")],
                        f"    issue_param<family::{self.name}, shape::{self.name}>({place}, convert::word(param), {single});\n", tries + [("pvalue", None)])
            if not self.data.get("scalar_only"):
                name = f"gl{self.name}" + (suffix.replace("x", "xv", 1) if code == "x" else suffix + "v")
                yield Entry(self, name, leading + [(f"const {c}*", "params")],
                            f"    issue_params<family::{self.name}, shape::{self.name}>({place}, params, {form}, SPANGLE_TEXT(\"{name}: params is a null pointer\"));\n",
                            tries + [("pvalues", None)])

    def entries_get_params(self):
        leading = [(a.c_type, a.name) for a in self.args] + [("GLenum", "pname")]
        call = [n for _, n in leading]
        tries = [(a.type, a) for a in self.args] + [("pname", None), ("out", None)]
        for code, suffix in self.types:
            name = f"gl{self.name}" + (suffix.replace("x", "xv", 1) if code == "x" else suffix + "v")
            body = (f"    fetch_params<family::{self.name}, shape::{self.name}>({', '.join(call)}, params, convert::Number::{CONVERT_AS.get(code, code)}, "
                    f"SPANGLE_TEXT(\"{name}: params is a null pointer\"));\n")
            yield Entry(self, name, leading + [(f"{C_TYPES[code]}*", "params")], body, tries)

    @property
    def component_names(self):
        known = {"Color": ["red", "green", "blue", "alpha"], "SecondaryColor": ["red", "green", "blue"], "TexCoord": list("strq"), "MultiTexCoord": list("strq"),
                 "Index": ["index"], "FogCoord": ["coord"]}
        return known.get(self.name, list("xyzw")[:len(self.data["pad"].split())])

    # --- the handwritten function ------------------------------------------------------------------------------

    @property
    def canonical(self):
        """The parameters of cmd::Name, without the context."""
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
        given = [("const ImageCommand&", "image")] if self.image else self.canonical
        params = ["Context& context"] + [f"{t} {n}".replace("* ", "* ") for t, n in given]
        return ", ".join(params)


def cast(code, name):
    return f"convert::cast_{CONVERT_AS.get(code, code)}({name})"


def normalize(code, name):
    return f"convert::unit_{code}({name})" if code in INTEGERS else cast(code, name)


def element(code, convert=cast):
    """The convert::Element of an array. It stands for the type of the elements and for their conversion."""
    return "convert::Element::" + convert(code, "").removeprefix("convert::").removesuffix("()")


def widened(code, convert=cast):
    """The type with which an argument is stored in an array. Registers hold words, so shorts are stored as words."""
    return "i" if code == "s" and convert is cast else code


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
            family = Family(row, groups, by_name, data.get("shares", False))
            by_name[family.name] = family
            families.append(family)
        chapters.append((data, families))
    for family in by_name.values():
        for arg in family.args:
            for token in arg.accepted:
                if token not in tokens:
                    sys.exit(f"{family.name}: token {token} has no value")
    return chapters, tokens
