#!/usr/bin/env python3
"""Tests that `./dev demo` shows how far its build is while it builds. The build tool's output must come through the pipe at once, and
standard output must hold only what the demo itself prints.

dev runs in a folder of its own, with programs on PATH that stand for cmake and the package manager. The build prints two lines, and waits
after each until this test has read it, so a build whose output is held back never gets on.
"""
import os
import pathlib
import select
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/support"))
from checks import check, failures  # noqa: E402

PATIENCE = 20  # seconds, enough for a busy machine
PROGRAMS = {
    "dpkg-query": "echo installed",
    "cmake": """case $1 in
--build)
    for line in '[1/2] first.cpp' '[2/2] second.cpp'; do
        echo "$line"
        read -r go < {pipe} && [ "$go" = on ] || exit 7
    done
    printf '#!/bin/sh\\necho "the demo: $*"\\n' > "$2/spangle"
    chmod +x "$2/spangle" ;;
*) echo configured; mkdir -p build/host ;;
esac""",
}


def line_of(stream, seconds):
    """Returns the next bytes that come within the time, which are one line."""
    ready, _, _ = select.select([stream], [], [], seconds)
    return os.read(stream.fileno(), 4096).decode() if ready else "nothing"


def start(folder):
    """Starts dev as in a clone, with a build that waits for words through the pipe."""
    shutil.copy(ROOT / "dev", folder / "dev")
    (folder / "bin").mkdir()
    pipe = folder / "go"
    os.mkfifo(pipe)
    for name, script in PROGRAMS.items():
        (folder / "bin" / name).write_text("#!/bin/sh\n" + script.replace("{pipe}", str(pipe)) + "\n")
        (folder / "bin" / name).chmod(0o755)
    environment = os.environ | {"PATH": f"{folder / 'bin'}:{os.environ['PATH']}", "JOBS": "1"}
    words = os.open(pipe, os.O_RDWR)  # opened both ways, so that neither side waits for the other
    return subprocess.Popen([str(folder / "dev"), "demo", "--out", "pictures"], env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, start_new_session=True), words


def main():
    with tempfile.TemporaryDirectory() as name:
        demo, words = start(pathlib.Path(name))
        try:
            for expected in ("[1/2] first.cpp\n", "[2/2] second.cpp\n"):
                said = line_of(demo.stderr, PATIENCE)
                check(said == expected and demo.poll() is None, f"while it builds: {said!r}, not {expected!r}")
                if failures:
                    return 1
                os.write(words, b"on\n")
            said, rest = demo.communicate(timeout=PATIENCE)
            check(demo.returncode == 0 and said == b"the demo: demo --out pictures\n" and rest == b"", f"at the end: {demo.returncode} {said!r} {rest!r}")
        finally:
            if demo.returncode is None:
                os.killpg(demo.pid, signal.SIGKILL)  # also ends a build that still waits
                demo.wait()
            os.close(words)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
