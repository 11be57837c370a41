"""Computes how times scatter: the median of several runs, and the quartiles, between which half of the runs lie."""
import statistics

RUNS = 5  # fewer runs do not show how times scatter


def spread(values):
    """Returns {"lower", "median", "upper", "runs"} of at least five figures."""
    if len(values) < RUNS:
        raise ValueError(f"{len(values)} runs: quartiles take {RUNS}")
    lower, median, upper = statistics.quantiles(values, n=4)
    return {"lower": lower, "median": median, "upper": upper, "runs": len(values)}


def scatter(of):
    """Returns how far the middle half of the runs reaches to either side, as a share of the median."""
    return (of["upper"] - of["lower"]) / 2 / of["median"]


def text(of, digits=2):
    """Returns the median as text, with the quartiles in brackets."""
    return f"{of['median']:.{digits}f} ({of['lower']:.{digits}f} .. {of['upper']:.{digits}f})"
