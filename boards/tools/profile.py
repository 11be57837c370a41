#!/usr/bin/env python3
"""Prints the compiler definitions of a scene profile, for builds without CMake (cmake/Profile.cmake says what they mean).

usage: profile.py [--check-ranges] PROFILE

PROFILE is a file of cmake/profiles without its ending, or a path. With --check-ranges the definitions are those of a build that stops a
program which goes farther than the recorded program did.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROFILES = ROOT / "cmake/profiles"


def features():
    return re.findall(r"^spangle_feature\((\w+) ", (ROOT / "cmake/Features.cmake").read_text(), re.M)


def rows(kind):
    """Returns the arguments of each row of this kind in cmake/Limits.cmake, without quotes."""
    text = (ROOT / "cmake/Limits.cmake").read_text()
    return [[word.strip('"') for word in re.findall(r'"[^"]*"|[^\s"]+', row)] for row in re.findall(rf"^{kind}\(([^)\"]*(?:\"[^\"]*\"[^)\"]*)*)\)$", text, re.M)]


def named_lists():
    """Returns {limit: (the number of the empty set or None, [names from bit 0 up, "-" where a bit has none])}."""
    return {name: (None if empty == "-" else int(empty.partition("=")[2]), names) for name, empty, _, *names in rows("spangle_names")}


def ways():
    """Returns {limit: {"speed": value, "size": value}} of the limits that SPANGLE_OPTIMIZE chooses."""
    return {name: {"speed": speed, "size": size} for name, speed, size, *_ in rows("spangle_ways")}


def sum_of(limit, words):
    """Returns the number that the code is compiled with for a list of names."""
    empty, names = named_lists()[limit]
    valid = (["none"] if empty is not None else []) + ["all"] + [name for name in names if name != "-"]
    wanted = known(re.split(r"[ ;\n]+", words.strip()), f"name of SPANGLE_{limit}", valid)
    if len(wanted) > 1 and {"all", "none"} & set(wanted):
        raise SystemExit(f"profile.py: 'all' and 'none' must stand alone in SPANGLE_{limit}")
    return (empty or 0) + sum(1 << bit for bit, name in enumerate(names) if name != "-" and (name in wanted or "all" in wanted))


def limits():
    """Returns {limit: usual number}, as the code is compiled with it."""
    return ({name: usual for name, usual, *_ in rows("spangle_limit")} | {name: str(sum_of(name, "all")) for name in named_lists()}
            | {name: of["speed"] for name, of in ways().items()})


def numbers(says):
    """Returns {limit: number} of options as a user sets them: lists of names, SPANGLE_OPTIMIZE, and plain numbers."""
    says = {name: str(value) for name, value in says.items()}
    optimize = says.pop("OPTIMIZE", None)
    if optimize not in (None, "speed", "size"):
        raise SystemExit(f"profile.py: SPANGLE_OPTIMIZE is '{optimize}', but must be speed or size")
    lists = named_lists()
    out = {name: str(sum_of(name, says[name])) if name in lists else says[name] for name in known(list(says), "limit", limits())}
    chosen = {name: of[optimize] for name, of in ways().items()} if optimize else {}
    return chosen | out


def ranges():
    return re.findall(r"^RANGE\((\w+),", (ROOT / "gl/context/ranges.inc").read_text(), re.M)


def find(name, folder, ending, beside=pathlib.Path()):
    for path in (folder / f"{name}.{ending}", beside / name, pathlib.Path(name)):
        if path.is_file():
            return path.resolve()
    raise SystemExit(f"profile.py: no profile '{name}': neither {(folder / name).relative_to(ROOT)}.{ending} nor a path")


def known(names, what, among):
    unknown = sorted(set(names) - set(among))
    if unknown:
        raise SystemExit(f"profile.py: no {what} {', '.join(unknown)}")
    return names


def definitions(name, checks=False):
    """Returns [NAME=VALUE]. With `checks` the list has the definitions of a build that stops a program beyond the recorded ranges, too."""
    file = find(name, PROFILES, "cmake")
    text = file.read_text()
    says = dict(re.findall(r"^set\(SPANGLE_(\w+) ([^)]*)\)", text, re.M))
    out = []
    on = says.pop("PROFILE_FEATURES", "all")
    if on != "all":
        wanted = known(on.split(), "feature", features())
        out += [f"SPANGLE_FEATURE_{feature}=0" for feature in features() if feature not in wanted]
    if "FUSED" in says:
        out.append(f'SPANGLE_FUSED="{find(says.pop("FUSED"), PROFILES / "spans", "inc", file.parent)}"')
    reached = dict(word.split("=") for word in says.pop("RANGES", "").split())
    known(list(reached), "range", ranges())
    if checks:
        out += ["SPANGLE_CHECK_RANGES=1", *(f"SPANGLE_RANGE_{name}={most}" for name, most in reached.items())]
    # A definition with the usual number says nothing.
    usual = limits()
    return out + [f"SPANGLE_{limit}={number}" for limit, number in numbers(says).items() if number != usual[limit]]


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--check-ranges"]
    if len(words) != 1:
        print(__doc__.strip())
        sys.exit(2)
    print("\n".join(definitions(words[0], len(words) != len(sys.argv) - 1)))
