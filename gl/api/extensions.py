"""The extensions that GL_EXTENSIONS names, and the commands that they add (commands/extensions.json).

Each row is an extension whose whole functionality exists in core commands. A row has these fields:
  name       the name in GL_EXTENSIONS
  features   optional systems that the extension needs apart from those of its commands
  commands   families, or single entry points ("glPointParameterf"), that have further names with a suffix
  suffix     the suffix of these names, if the name of the extension does not begin with it
"""
import json
import sys
from typing import NamedTuple

from command_table import API
from emit_code import NOTICE, both


class Alias(NamedTuple):
    name: str
    entry: object

    @property
    def row(self):
        """One line of aliases.inc."""
        arguments = ", ".join(n for _, n in self.entry.params)
        return f"ALIAS({self.entry.family.returns}, {self.name}, {self.entry.name}, ({self.entry.c_params}), ({arguments}))\n"


class Extension:
    def __init__(self, data, families, entries):
        self.name = data["name"]
        suffix = data.get("suffix", self.name.split("_")[1])
        self.aliases = []
        for word in data.get("commands", "").split():
            found = [entries[word]] if word in entries else families[word].entries if word in families else []
            if not found:
                sys.exit(f"{self.name}: there is no command {word}")
            self.aliases += [Alias(e.name + suffix, e) for e in found if not e.name.endswith("OES")]
        self.needs = {f"SPANGLE_FEATURE_{feature}" for feature in data.get("features", "").split()}
        self.needs |= {need for alias in self.aliases for need in alias.entry.needs}

    @property
    def condition(self):
        """The conditions under which a build names the extension. Only eglGetProcAddress finds names with a suffix."""
        return both(sorted(self.needs | ({"SPANGLE_FEATURE_GET_PROC_ADDRESS"} if self.aliases else set())))


def load_extensions(chapters):
    families = {f.name: f for _, group in chapters for f in group}
    entries = {e.name: e for f in families.values() for e in f.entries}
    rows = json.loads((API / "commands" / "extensions.json").read_text())
    found = [Extension(row, families, entries) for row in rows]
    if [e.name for e in found] != sorted(e.name for e in found):
        sys.exit("extensions.json: the names are not in order")
    return found


def aliases(extensions):
    """All names with a suffix, without repetitions."""
    found = {alias.name: alias for extension in extensions for alias in extension.aliases}
    return [found[name] for name in sorted(found)]


def aliases_list(extensions):
    return ("// Names with a suffix, by which extensions call core commands: ALIAS(returns, name, command, parameters, arguments).\n"
            + NOTICE + "".join(alias.row for alias in aliases(extensions)))


def extensions_header(extensions):
    out = ["// The extensions that GL_EXTENSIONS names: each that this build has the whole of.\n", NOTICE,
           "#pragma once\n\n#include \"gl/context/features.hpp\"\n\nnamespace spangle::gl {\n\n"
           "inline constexpr const char* extensions = \"\"\n"]
    for extension in extensions:
        text = f"    \"{extension.name} \"\n"
        out.append(f"#if {extension.condition}\n{text}#endif\n" if extension.condition else text)
    out.append("    ;\n\n} // namespace spangle::gl\n")
    return "".join(out)
