"""The feature matrix: which rows of GL 1.3 work, and what is missing."""
import json
import re

from command_table import API, ROOT


def matrix(chapters):
    """The rows of the matrix. Each has an id, a name, commands, a state and a note."""
    rows = json.loads((API / "commands" / "rows.json").read_text())
    entries = {}
    for _, families in chapters:
        for f in families:
            entries.setdefault(f.row, []).extend(e.name for e in f.entries if not e.name.endswith("OES"))
    record = ROOT / "tests/quality/mutants/caught.txt"
    caught = set(re.findall(r"^\S+ (\w+)\b", record.read_text(), re.M)) if record.exists() else set()
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
            "row is caught by the tests. *partly*: what is missing is said. *not yet*: nothing of it exists, or it is untested.\n"
            "[memory.md](memory.md#what-each-optional-system-costs) says what each optional system costs,\n"
            "and [limits.md](limits.md) what there is not.\n\n"
            "| row | system | commands | state | note |\n|---|---|---|---|---|\n"
            + "".join(f"| {' | '.join(row)} |\n" for row in rows) + f"\n{totals(rows)}.\n")
