"""Returns what a compiler sees of a source file: its tokens, without comments and layout.

The record of caught defects has hashes of these tokens, not of bytes. So a comment that is rewritten, or a line that is
broken elsewhere, makes no record stale. Of a C++ file it hashes only the declaration with the defect, for instance one
function, because a change of another function does not affect the defect.
"""
import bisect
import functools
import io
import re
import tokenize

CPP = {".cpp", ".hpp", ".c", ".h"}
# Comments come before operators and raw strings before names; a number holds its digit separators. A directive of the
# preprocessor is one token.
TOKEN = re.compile(r"""
    (?P<left> //(?:[^\n\\]|\\.|\\\n)* | /\*.*?\*/ | \s+ | \\\n)
  | (?P<directive> ^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*)
  | (?:u8|[uUL])?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"
  | (?:u8|[uUL])?"(?:[^"\\\n]|\\.)*"
  | (?:u8|[uUL])?'(?:[^'\\\n]|\\.)*'
  | \.?[0-9](?:'?[0-9A-Za-z_.])*
  | [A-Za-z_]\w*
  | .
""", re.X | re.S | re.M)
OPENS, CLOSES = {"(", "[", "{"}, {")", "]", "}"}
CONTAINERS = {"namespace", "extern", "class", "struct", "union"}


def cpp(text):
    return "\0".join(" ".join(found.group().split("//")[0].split()) if found["directive"] else found.group()
                     for found in TOKEN.finditer(text) if found["left"] is None)


def python(text):
    """Raises SyntaxError or tokenize.TokenError where the text is no Python, as a defect may make it."""
    words = tokenize.generate_tokens(io.StringIO(text).readline)
    return "\0".join(f"{word.type} {word.string}" for word in words if word.type not in (tokenize.COMMENT, tokenize.NL))


def code(suffix, text):
    """Returns the tokens of a text whose file name ends in suffix, with zeros between them. Of other languages returns the text."""
    if suffix in CPP:
        return cpp(text)
    if suffix == ".py":
        try:
            return python(text)
        except (SyntaxError, tokenize.TokenError):
            return text
    return text


def contains(words):
    """Returns whether the brace behind these tokens opens a namespace or a class, whose members are separate declarations."""
    words = [word for word in words if word != "inline"]
    while words[:2] == ["template", "<"]:
        depth = at = 1
        while depth and at + 1 < len(words):
            at += 1
            depth += {"<": 1, ">": -1}.get(words[at], 0)
        words = words[at + 1:]
    return bool(words) and words[0] in CONTAINERS and "=" not in words


@functools.lru_cache(maxsize=256)
def declarations(text):
    """Returns where the declarations of a C++ file begin and end: functions, constants, directives, heads of classes."""
    spans, words, begin, stack = [], [], None, []

    def ends(at):
        nonlocal words, begin
        if begin is not None:
            spans.append((begin, at))
        words, begin = [], None

    for found in TOKEN.finditer(text):
        if found["left"] is not None:
            continue
        word = found.group()
        if found["directive"]:
            if begin is None:
                spans.append(found.span())
            continue
        if not stack and word == "}":  # the end of a namespace or of a class
            ends(found.start())
            continue
        begin = found.start() if begin is None else begin
        if word in OPENS:
            if word == "{" and not stack and contains(words):
                ends(found.end())
                continue
            stack.append(word)
        elif word in CLOSES and stack:
            stack.pop()
            if word == "}" and not stack and not (words and words[-1] == "="):
                ends(found.end())
                continue
        elif word == ";" and not stack:
            ends(found.end())
            continue
        words.append(word)
    ends(len(text))
    return spans


def declaration(text, at):
    """Returns the text of the declaration at this place, or the whole text where there is none."""
    spans = declarations(text)
    number = bisect.bisect(spans, (at, len(text))) - 1
    if number < 0 or spans[number][1] <= at:
        return text
    return text[slice(*spans[number])]
