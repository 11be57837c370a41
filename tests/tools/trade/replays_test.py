#!/usr/bin/env python3
"""Tests `spangle trade` with traces and programs of other authors.

usage: replays_test.py SPANGLE traces|programs|more_programs|errors

traces: figures, broken promises and bytes of the traces in tests/system/programs/traces are golden, as those of trade_test.py; they
need apitrace.
programs: a program under Xvfb is recorded once and measured like a trace. more_programs: the same with times and scenes, for a program of
EGL, and for a program that calls a missing function. errors: what cannot be measured is reported in one sentence.
"""
import csv
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from trade_test import HERE, SPANGLE, check, held, same_hashes, trade

sys.path.insert(0, str(HERE.parents[1] / "system/programs"))
from harness import SKIPPED, xvfb  # noqa: E402

TRACES = sorted((HERE.parents[1] / "system/programs/traces").glob("*.trace"))
SAVER = pathlib.Path("/usr/libexec/xscreensaver/gears")


def need(*programs):
    for program in programs:
        if shutil.which(str(program)) is None:
            print(f"skipped: there is no {program}; ./dev setup --programs installs it")
            sys.exit(SKIPPED)


def rows_of(folder, out):
    return list(csv.DictReader((folder / out / "accuracy.csv").open()))


def traces(folder):
    need("apitrace", "eglretrace")
    words = [word for trace in TRACES for word in ("--trace", str(trace))]
    held(folder, "_traces", *words)
    same_hashes(folder, HERE / "bytes_traces.txt", *words, "--formats", "565,8888,444,grey4", "--frames", "2")


def on_a_display(part):
    """Runs the part with a display of its own."""
    def with_display(folder):
        need("apitrace", "eglretrace", "Xvfb", "glxgears")
        with xvfb() as display:
            os.environ["DISPLAY"] = display
            part(folder)
        del os.environ["DISPLAY"]
    return with_display


def gears(folder, *words, frames):
    """Measures glxgears behind the scenes of `words`."""
    trade(folder, *words, "--frames", str(frames), "--size", "160x120", "--out", "game", "--", "glxgears", "-info")
    rows = rows_of(folder, "game")
    scenes = [word for word in words if not word.startswith("-")]
    check([row["scene"] for row in rows] == [scene for scene in [*scenes, "glxgears"] for _ in range(3)], f"other programs were measured: {rows}")
    drawn = rows[-3:]
    check({(row["frames"], row["format"]) for row in drawn} == {(str(frames), "565")}, f"frames are missing: {drawn}")
    check(all(int(row["covered"]) > 1000 and row["off_own"] == "0" for row in drawn), f"nothing is covered: {drawn}")
    check(float(drawn[0]["identical"]) >= 99.99 and float(drawn[2]["identical"]) < 100, f"tiers are not those: {drawn}")
    check(len({row["covered"] for row in drawn}) == 1, "tiers draw other frames of a program that goes by the clock")


@on_a_display
def programs(folder):
    gears(folder, "--no-times", frames=2)


@on_a_display
def more_programs(folder):
    gears(folder, "S5", frames=4)
    costs = list(csv.DictReader((folder / "game/cost.csv").open()))
    check(all(float(row["microseconds"]) > 0 for row in costs), f"no times: {costs}")
    check("glxgears" in (folder / "game/index.html").read_text(), "the page has no program")
    if SAVER.exists():  # a program of EGL, which the first tracer does not see
        trade(folder, "--no-times", "--frames", "2", "--size", "160x120", "--out", "saver", "--", str(SAVER))
        check(all(int(row["covered"]) > 100 for row in rows_of(folder, "saver")), "a program of EGL draws nothing")
    (folder / "later.c").write_text(LATER)
    pair = SPANGLE.parent / "dropin"
    built = subprocess.run(["cc", "later.c", "-o", "later", f"-L{pair}", "-lGL", "-lspangle-dropin", "-l:libglut.so.3.12"], cwd=folder, capture_output=True,
                           text=True)
    check(built.returncode == 0, f"the program is not built: {built.stderr}")
    said = trade(folder, "--frames", "2", "--out", "x", "--", "./later", status=2).stderr
    check("later: it calls glCreateShader, which Spangle does not have" in said, f"a missing function is not named: {said}")


# A program in a window of freeglut. It calls a function that Spangle has by name alone.
LATER = """void glutInit(int*, char**); void glutInitDisplayMode(unsigned); int glutCreateWindow(const char*);
void glutDisplayFunc(void (*)(void)); void glutMainLoop(void); void glutSwapBuffers(void); void glutPostRedisplay(void);
unsigned glCreateShader(unsigned); void glRectf(float, float, float, float);
static void draw(void) {
    glCreateShader(0x8B31);
    glRectf(-1, -1, 0, 1);
    glutSwapBuffers();
    glutPostRedisplay();
}
int main(int count, char** words) {
    glutInit(&count, words);
    glutInitDisplayMode(2);
    glutCreateWindow("later");
    glutDisplayFunc(draw);
    glutMainLoop();
    return 0;
}
"""


def errors(folder):
    os.environ.pop("DISPLAY", None)
    trace = str(TRACES[0])
    (folder / "tools").mkdir()
    for tool in ("sh", "timeout"):
        (folder / "tools" / tool).symlink_to(shutil.which(tool))
    done = subprocess.run([SPANGLE, "trade", "--trace", trace, "--out", "x"], cwd=folder, capture_output=True, text=True,
                          env=dict(os.environ) | {"PATH": str(folder / "tools")})
    check(done.returncode == 2 and "eglretrace is not installed; `./dev setup --programs` installs it" in done.stderr,
          f"a missing retracer: {done.returncode} {done.stderr}")
    need("apitrace", "eglretrace")
    (folder / "empty.trace").write_text("")
    (folder / "words.trace").write_text("This is no trace.\n")
    (folder / "cut.trace").write_bytes(pathlib.Path(trace).read_bytes()[:3000])
    for words, says in ((["--trace", "none.trace"], "cannot read the trace 'none.trace'"),
                        (["--trace", "empty.trace"], "cannot read the trace 'empty.trace'"),
                        (["--trace", "words.trace"], "words: eglretrace cannot replay it: "),
                        (["--trace", "cut.trace"], "cut: it shows no frame"),
                        (["--bytes", "--trace", "cut.trace"], "cut: it shows no frame"),
                        (["--", "no-such-program"], "no-such-program: there is no such program"),
                        (["--", "false"], "false: it ended with 1 before it drew"),
                        (["S3", "--"], "name a program after --"),
                        (["S99", "--", "true"], "no scene 'S99'"),
                        (["--", "true"], "true: it ended with 0 before it drew")):
        said = trade(folder, "--frames", "2", "--out", "x", *words, status=2).stderr
        check(says in said and said.count("\n") == 1, f"{' '.join(words)} says {said}")


def main():
    parts = {"traces": traces, "programs": programs, "more_programs": more_programs, "errors": errors}
    if len(sys.argv) != 3 or sys.argv[2] not in parts:
        sys.exit(__doc__.strip())
    for name in [name for name in os.environ if name.startswith(("SPANGLE_", "MESA_", "LIBGL_")) and name != "SPANGLE_UPDATE_GOLDEN"]:
        del os.environ[name]
    with tempfile.TemporaryDirectory() as folder:
        parts[sys.argv[2]](pathlib.Path(folder))


if __name__ == "__main__":
    main()
