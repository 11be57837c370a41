"""Compares what boards cost now with boards/golden.json, which holds what they cost when it was last written."""
import json

import firmware
from firmware import outfile

FILE = firmware.ROOT / "boards/golden.json"
SLACK = 1.03


def costs(rows):
    """Returns {"mps2_an386 HUD": {"drawing": n, "presenting": n}, "mps2_an386": {"flash": n, "ram": n, "stack": n}}."""
    out = {}
    for row in rows:
        out[row["board"]] = {kind: row[kind] for kind in ("flash", "ram", "stack")}
        for scene, values in row["scenes"].items():
            out[f"{row['board']} {scene}"] = {kind: values[kind] for kind in ("drawing", "presenting")}
    return out


def read():
    return json.loads(FILE.read_text()) if FILE.exists() else {}


def update(rows):
    """Writes the costs of these boards; the costs of other boards stay."""
    known = {**read(), **costs(rows)}
    outfile.write(FILE, "{\n" + ",\n".join(f"  {json.dumps(name)}: {json.dumps(known[name])}" for name in sorted(known)) + "\n}\n")


def grown(rows):
    """Returns a line for each cost that is more than 3 % above the written one."""
    known, lines = read(), []
    for name, now in costs(rows).items():
        if name not in known:
            lines.append(f"{name}: not in boards/golden.json (--update writes it)")
            continue
        lines += [f"{name}: {kind} {value:,} was {known[name][kind]:,}" for kind, value in now.items() if value > known[name][kind] * SLACK]
    return lines
