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


def limits():
    """Returns {limit: usual value}."""
    return dict(re.findall(r"^spangle_limit\((\w+) (\w+) ", (ROOT / "cmake/Limits.cmake").read_text(), re.M))


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
    return out + [f"SPANGLE_{limit}={says[limit]}" for limit in known(list(says), "limit", limits())]


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--check-ranges"]
    if len(words) != 1:
        print(__doc__.strip())
        sys.exit(2)
    print("\n".join(definitions(words[0], len(words) != len(sys.argv) - 1)))
