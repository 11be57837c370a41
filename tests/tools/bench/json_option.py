"""The option --json of measuring tools: it names a file for the figures, or `-` for standard output."""
import contextlib
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "host_sim/tools"))
import outfile  # noqa: E402


def add(parser):
    parser.add_argument("--json", metavar="FILE", help="write the figures as one JSON object; - is standard output, and tables go to standard error")


def check(parser, name):
    """Refuses a file that cannot be written before a long measurement begins."""
    if name not in (None, "-") and not pathlib.Path(name).resolve().parent.is_dir():
        parser.error(f"--json {name}: no such folder")


def tables(name):
    """Returns where tables are printed: standard output holds nothing but JSON if JSON goes there."""
    return contextlib.redirect_stdout(sys.stderr if name == "-" else sys.stdout)


def write(name, figures):
    if name is None:
        return
    text = json.dumps(figures, indent=2) + "\n"
    if name == "-":
        sys.stdout.write(text)
    else:
        outfile.write(name, text)
