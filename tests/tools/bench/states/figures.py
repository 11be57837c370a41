"""Computes percentiles, shares, neighbours and inversions of measured states. Nothing is measured here.

A state is what `bench_states SEED list` prints: {"number": n, "key": n, "words": {word: [choice, work, pass]}}. `cost` is a dictionary from
numbers of states to instructions per fragment.
"""
PERCENTILES = (10, 50, 80, 90, 95)
UNORDERED = -1  # work of a choice that is neither less nor more than another choice's
VARIANTS = ("surface", "tier")  # the words that are not part of a key


def percentile(values, share):
    """Returns the value below which `share` percent of the values lie, interpolated between two values."""
    ordered = sorted(values)
    place = (len(ordered) - 1) * share / 100
    below = int(place)
    above = min(below + 1, len(ordered) - 1)
    return ordered[below] + (ordered[above] - ordered[below]) * (place - below)


def percentiles(values):
    return {f"p{share}": percentile(values, share) for share in PERCENTILES}


def choice(state, word):
    return state["words"][word][0]


def variant(state):
    return tuple(choice(state, word) for word in VARIANTS)


def shape_class(state):
    """Returns the row of the table: triangles by their perspective, and the other shapes."""
    shape = choice(state, "shape")
    return f"{shape}, {choice(state, 'view')}" if shape == "triangles" else shape


def groups(states, of):
    """Returns {of(state): [states]} in the order of the first state of each."""
    out = {}
    for state in states:
        out.setdefault(of(state), []).append(state)
    return out


def differing(a, b):
    """Returns the words that apply to both states and have different choices."""
    return [word for word in a["words"] if word in b["words"] and choice(a, word) != choice(b, word)]


def neighbours(states):
    """Returns (a, b, word) of every two states that differ in one word."""
    out = []
    for i, a in enumerate(states):
        for b in states[:i]:
            # States of two keys are compared in the same variant only, states of one key only if one word of the variant differs.
            same_key, same_variant = a["key"] == b["key"], variant(a) == variant(b)
            if not same_key and not same_variant:
                continue
            words = differing(a, b)
            if len(words) == 1:
                out.append((b, a, words[0]))
    return out


def less_work(a, b, word):
    """Returns whether a asks for some of the work of b, and for nothing else."""
    of_a, of_b = a["words"][word][1], b["words"][word][1]
    return UNORDERED not in (of_a, of_b) and of_a != of_b and of_a & of_b == of_a


def far_apart(pairs, cost, times=2.0):
    """Returns (ratio, cheap, dear, word), the worst first, of neighbours of which one takes more than `times` the other."""
    out = []
    for a, b, word in pairs:
        if a["number"] not in cost or b["number"] not in cost:
            continue
        low, high = sorted((a, b), key=lambda s: cost[s["number"]])
        ratio = cost[high["number"]] / cost[low["number"]]
        if ratio > times:
            out.append((ratio, low, high, word))
    return sorted(out, key=lambda found: -found[0])


def adds_pass(a, b, word):
    """Returns whether the word adds a texture, a filter or another pass; such neighbours may be far apart."""
    return a["words"][word][2]


def inversions(pairs, cost, slack=1.05):
    """Returns (ratio, less, more, word), the worst first, of states that cost more than `slack` times a neighbour with more work."""
    out = []
    for a, b, word in pairs:
        if a["number"] not in cost or b["number"] not in cost:
            continue
        for less, more in ((a, b), (b, a)):
            ratio = cost[less["number"]] / cost[more["number"]]
            if less_work(less, more, word) and ratio > slack:
                out.append((ratio, less, more, word))
    return sorted(out, key=lambda found: -found[0])


def worst(states, cost, count=10):
    """Returns the dearest state of each key, the worst first, at most `count`."""
    out = []
    for state in sorted((s for s in states if s["number"] in cost), key=lambda s: -cost[s["number"]]):
        if state["key"] not in {kept["key"] for kept in out}:
            out.append(state)
        if len(out) == count:
            break
    return out


def slower(ratios):
    """Returns the share of states that are slower than llvmpipe; `ratios` are times as fast."""
    return sum(ratio < 1 for ratio in ratios) / len(ratios)


def readable(state, without=()):
    """Returns a state in words; words that are off are left out."""
    short = ("surface", "tier", "shape", "view", "shade", "alpha", "samples")
    said = []
    for word, (name, _, _) in state["words"].items():
        if name and word not in without:
            said.append(name if word in short else f"{word} {name}" if name != "on" else word)
    return ", ".join(said)
