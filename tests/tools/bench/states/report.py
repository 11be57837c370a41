"""Prints the tables of `./dev bench states` from figures, and makes those of docs/states.md."""
import figures
from figures import PERCENTILES, choice, groups, percentile, readable, shape_class

CLASSES = {"all": lambda s: True, "triangles": lambda s: choice(s, "shape") == "triangles",
           "small triangles": lambda s: choice(s, "shape") == "small triangles", "lines": lambda s: choice(s, "shape") in ("lines", "wide lines"),
           "points": lambda s: choice(s, "shape") in ("points", "large points"), "sprites": lambda s: choice(s, "shape") == "sprites"}
SPEEDS = (50, 20, 5)  # percentiles of the times as fast: half, 80 % and 95 % of the states reach them


def cost_of(counts):
    """Returns {number: instructions per fragment}."""
    return {number: of["instructions"] / of["fragments"] for number, of in counts.items()}


def rows(states, cost, ratios):
    """Returns [{"class", "surface", "tier", "states", "p10".., "fast50".., "slower"}], with shares of speed if there are times."""
    out = []
    for name, belongs in CLASSES.items():
        for (surface, tier), members in sorted(groups([s for s in states if belongs(s)], figures.variant).items()):
            numbers = [s["number"] for s in members if s["number"] in cost]
            if not numbers:
                continue
            row = {"class": name, "surface": surface, "tier": tier, "states": len(numbers), **figures.percentiles([cost[n] for n in numbers])}
            timed = [ratios[n] for n in numbers if n in ratios]
            if timed:
                row |= {f"fast{share}": percentile(timed, share) for share in SPEEDS} | {"slower": figures.slower(timed)}
            out.append(row)
    return out


def hot(of):
    return "; ".join(f"{name} {share:.0%}" for name, share in of.get("hot", []))


def worst_states(states, counts, count=10):
    """Returns [{"cost", "state", "hot"}]."""
    cost = cost_of(counts)
    return [{"cost": cost[s["number"]], "number": s["number"], "state": readable(s), "hot": hot(counts[s["number"]])} for s in figures.worst(states, cost, count)]


def print_rows(table):
    timed = any("slower" in row for row in table)
    print("\nInstructions per fragment by percentile of the states" + ("; times as fast as llvmpipe that half, 80 % and 95 % of them reach; share that is slower" if timed else "") + ".")
    print(f"{'shapes':<17}{'surface':<12}{'tier':<10}{'states':>7}" + "".join(f"{f'{share} %':>9}" for share in PERCENTILES)
          + ("".join(f"{title:>8}" for title in ("50 %", "80 %", "95 %", "slower")) if timed else ""))
    for row in table:
        line = f"{row['class']:<17}{row['surface']:<12}{row['tier']:<10}{row['states']:>7}" + "".join(f"{row[f'p{share}']:>9.1f}" for share in PERCENTILES)
        if "slower" in row:
            line += "".join(f"{row[f'fast{share}']:>8.2f}" for share in SPEEDS) + f"{row['slower']:>8.0%}"
        print(line)


def print_worst(found):
    print("\nThe dearest states, one of each key, in instructions per fragment" + (", and the functions that take most:" if any(of["hot"] for of in found) else ":"))
    for of in found:
        print(f"{of['cost']:>9.0f}  state {of['number']}: {of['state']}" + (f"\n           {of['hot']}" if of["hot"] else ""))


def print_pair(ratio, first, second, word, cost):
    shared = {w for w in first["words"] if w in second["words"] and choice(first, w) == choice(second, w)}
    names = [choice(s, word) or f"no {word}" for s in (first, second)]
    print(f"{ratio:>7.2f} x  {word}: {names[0]} {cost[first['number']]:.0f}, {names[1]} {cost[second['number']]:.0f}"
          f"  (states {first['number']} and {second['number']}: {readable(first, set(first['words']) - shared)})")


def print_pairs(states, cost, most=20):
    """Prints neighbours that are far apart, and inversions. Returns how many there are of each."""
    pairs = figures.neighbours(states)
    apart = figures.far_apart(pairs, cost)
    plain = [found for found in apart if not figures.adds_pass(*found[1:]) and cost[found[2]["number"]] > 2 * cost[found[1]["number"]] + 10]
    print(f"\n{len(pairs)} pairs of states differ in one word; {len(apart)} are more than 2 times apart, {len(plain)} of them by more than 10 instructions "
          f"without a texture, a filter or a pass that the word adds:")
    for found in plain[:most]:
        print_pair(*found, cost)
    inverted = figures.inversions(pairs, cost)
    print(f"\n{len(inverted)} inversions: a state with less work takes more than 5 % more than its neighbour with more.")
    for found in inverted[:most]:
        print_pair(*found, cost)
    for name, count in (("such pairs", len(plain)), ("inversions", len(inverted))):
        if count > most:
            print(f"           ({most} of {count} {name} are shown; --json has the figures of all states)")
    return {"pairs": len(pairs), "apart": len(apart), "apart_without_pass": len(plain), "inversions": len(inverted)}


def markdown(recorded):
    """Returns the tables of docs/states.md from tests/tools/bench/states/measured.json."""
    out = []
    for target, of in recorded.items():
        timed = any("slower" in row for row in of["rows"])
        heads = ["shapes", "surface", "tier", "states", *(f"{share} %" for share in PERCENTILES)] + (["half", "80 %", "95 %", "slower"] if timed else [])
        out += [f"Target {target}, seed {of['seed']}, {of['states']} states: instructions per fragment by percentile"
                + ("; times as fast as llvmpipe that half, 80 % and 95 % of the states reach, and the share that is slower." if timed else "."), "",
                "| " + " | ".join(heads) + " |", "|---|---|---" + "|--:" * (len(heads) - 3) + "|"]
        for row in of["rows"]:
            cells = [row["class"], row["surface"], row["tier"], row["states"], *(f"{row[f'p{share}']:.0f}" for share in PERCENTILES)]
            if timed:
                cells += [*(f"{row[f'fast{share}']:.2f}" for share in SPEEDS), f"{row['slower']:.0%}"]
            out.append("| " + " | ".join(map(str, cells)) + " |")
        pairs = of["pairs"]
        out += ["", f"Of {pairs['pairs']} pairs of states that differ in one word, {pairs['apart']} are more than 2 times apart; in {pairs['apart_without_pass']} of them the word adds "
                f"no texture, filter or pass. There are {pairs['inversions']} inversions. The dearest states:", ""]
        out += [f"* {of_state['cost']:.0f}: {of_state['state']}" + (f" ({of_state['hot']})" if of_state["hot"] else "") for of_state in of["worst"]]
        out.append("")
    return "\n".join(out).rstrip()
