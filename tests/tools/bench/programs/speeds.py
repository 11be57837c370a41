"""Computes from times of frames how many times as fast as llvmpipe Spangle is, and makes the tables of `./dev bench programs`."""
import pathlib
import statistics
import sys

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1])]
from spread import spread, text  # noqa: E402

REPLAYER, LLVMPIPE = "replayer", "llvmpipe"
TIERS = ("balanced", "exact")
# Goals in times as fast as llvmpipe: the first line is for programs of other authors, the second for the two of clients.c.
GOALS = {"real": {"balanced": 1.0, "exact": 0.8}, "own": {"balanced": 1.0, "exact": 1.0}}


def goal(kind, tier):
    return GOALS["own" if kind == "own" else "real"][tier]


def speed(of, tier):
    """Returns how many times as fast as llvmpipe a tier is in one round. The replayer's own time is subtracted on both sides."""
    ours, theirs = of[tier] - of[REPLAYER], of[LLVMPIPE] - of[REPLAYER]
    if ours <= 0 or theirs <= 0:
        raise ValueError(f"a frame takes less than its replayer: {of}")
    return theirs / ours


def row(name, kind, frames, rounds):
    """Returns {"program", "kind", "frames", "ms": {name: median}, "speed": {tier: spread}, "missed": [tier]}."""
    speeds = {tier: spread([speed(of, tier) for of in rounds]) for tier in TIERS}
    return {"program": name, "kind": kind, "frames": frames, "ms": {by: statistics.median(of[by] for of in rounds) for by in rounds[0]},
            "speed": speeds, "missed": [tier for tier in TIERS if speeds[tier]["median"] < goal(kind, tier)]}


def missed(rows, tier):
    return [of["program"] for of in rows if tier in of["missed"]]


def verdict(rows):
    """Returns sentences that say which goals are reached and which are not."""
    out = []
    for tier in TIERS:
        names = missed(rows, tier)
        reached = f"{tier}: {len(rows) - len(names)} of {len(rows)} programs reach their goal"
        out.append(reached + (f"; these do not: {', '.join(names)}." if names else "."))
    return out


HEADS = ("program", "kind", "frame", "replayer ms", "llvmpipe ms", "balanced ms", "exact ms", "balanced", "exact")


def cells(of):
    return [of["program"], of["kind"], str(of["frames"]), *(f"{of['ms'][by]:.3f}" for by in (REPLAYER, LLVMPIPE, *TIERS)),
            *(text(of["speed"][tier]) + (" *" if tier in of["missed"] else "") for tier in TIERS)]


def table(rows):
    """Returns lines of text; a star marks a missed goal."""
    lines = [list(HEADS), *(cells(of) for of in rows)]
    widths = [max(len(line[k]) for line in lines) for k in range(len(HEADS))]
    sides = (str.ljust, str.ljust, *[str.rjust] * (len(HEADS) - 2))
    return ["  ".join(to(cell, width) for to, cell, width in zip(sides, line, widths)) for line in lines]


def markdown(rows):
    """Returns the tables of docs/programs-speed.md."""
    lines = ["| " + " | ".join(HEADS) + " |", "|---|---" + "|--:" * (len(HEADS) - 2) + "|"]
    lines += ["| " + " | ".join(cell.replace("*", "\\*") for cell in cells(of)) + " |" for of in rows]
    return "\n".join([*lines, "", *(f"* {sentence}" for sentence in verdict(rows))])
