#!/usr/bin/env python3
"""Tests how the tools in Python write: host_sim/tools/outfile.py with files, devices and full disks, and that every tool uses it."""
import os
import pathlib
import re
import resource
import stat
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parents[3]
TOOLS = ROOT / "host_sim/tools"
sys.path[:0] = [str(ROOT / "tests/support"), str(TOOLS)]
import outfile  # noqa: E402
from checks import check, failures  # noqa: E402

WRITE = "import sys; sys.path.insert(0, {tools!r}); import outfile; outfile.write({path!r}, 'x' * {size})"
PRINT = "import sys; sys.path.insert(0, {tools!r}); import outfile; sys.exit(outfile.checked(lambda: print('x' * {size}) or {status}))"


def program(text, limit=None, **streams):
    """Runs the program in a process of its own, in which no file may be longer than the limit."""
    def bound():
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    return subprocess.run([sys.executable, "-c", text], stderr=subprocess.PIPE, text=True, preexec_fn=bound, **streams)


def write_in_program(path, size=100000, limit=None):
    return program(WRITE.format(tools=str(TOOLS), path=str(path), size=size), limit)


def one_line(done, words, what):
    lines = done.stderr.splitlines()
    check(done.returncode == 1 and len(lines) == 1 and words in lines[0], f"{what}: {done.returncode} {done.stderr!r}")


def regular(folder):
    """Files are written as a whole, with the permissions that they had before; links stay links."""
    path = folder / "file"
    old = os.umask(0o027)
    outfile.write(path, "one\n")
    os.umask(old)
    check(path.read_text() == "one\n" and stat.S_IMODE(path.stat().st_mode) == 0o640, "a new file, as open() makes it")
    path.chmod(0o755)
    outfile.write(path, b"\x00two")
    check(path.read_bytes() == b"\x00two" and stat.S_IMODE(path.stat().st_mode) == 0o755, "its permissions stay")
    link = folder / "link"
    link.symlink_to("file")
    outfile.write(link, "three")
    check(link.is_symlink() and path.read_text() == "three", "a link stays one")
    outfile.write_table(path, [["a", "b"], ["1,2", 'x"y']])
    check(path.read_text() == 'a,b\n"1,2","x""y"\n', "a table of cells")
    check(sorted(p.name for p in folder.iterdir()) == ["file", "link"], "nothing else lies there")


def whole_at_any_time(folder):
    """A reader that reads while a file is written sees one of its two contents."""
    path, contents, end = folder / "file", ("a" * 100000, "b" * 200000), threading.Event()
    outfile.write(path, contents[0])
    seen = set()

    def look():
        while not end.is_set():
            seen.add(path.read_text())
    reader = threading.Thread(target=look)
    reader.start()
    for i in range(200):
        outfile.write(path, contents[i % 2])
    end.set()
    reader.join()
    check(seen <= set(contents), f"parts of a file are seen: {sorted(len(text) for text in seen)}")


def no_room(folder):
    """If a file does not fit, nothing of it is left, and the file before it stays as it was."""
    path, fresh = folder / "file", folder / "fresh"
    path.write_text("old")
    for target in (path, fresh):
        one_line(write_in_program(target, limit=4096), f"cannot write '{target}': File too large", "a disk without room")
    check(path.read_text() == "old" and [p.name for p in folder.iterdir()] == ["file"], "nothing half-written")
    one_line(write_in_program(folder / "none/file"), "No such file or directory", "a folder that is not there")
    one_line(write_in_program(folder), "Is a directory", "a folder")


def devices(folder):
    """A path that is no regular file is written to, and stays what it is."""
    one_line(write_in_program("/dev/full"), "cannot write '/dev/full': No space left on device", "a full device")
    check(write_in_program("/dev/null").returncode == 0 and stat.S_ISCHR(os.stat("/dev/null").st_mode), "/dev/null")
    pipe, read = folder / "pipe", []
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: read.append(pipe.read_text()))
    reader.start()
    outfile.write(pipe, "through")
    reader.join()
    check(read == ["through"] and stat.S_ISFIFO(pipe.stat().st_mode), "a pipe stays one")


def standard_output():
    """Lost lines make the status 1; otherwise the program's own status counts."""
    def printed(size, status, **streams):
        return program(PRINT.format(tools=str(TOOLS), size=size, status=status), **streams)
    for size in (10, 1000000):  # sizes below and above the interpreter's buffer
        with open("/dev/full", "w") as full:
            one_line(printed(size, 0, stdout=full), "cannot write standard output: No space left on device", "a full device")
    reader, writer = os.pipe()
    os.close(reader)
    one_line(printed(10, 0, stdout=writer), "cannot write standard output: Broken pipe", "nobody reads")
    os.close(writer)
    for status in (0, 3):
        check(printed(10, status, stdout=subprocess.PIPE).returncode == status, "the program's own status")


# Files that tests make in folders of their own, which are deleted with the test, and logs that grow while a program runs.
OWN = re.compile(r"tests/[^/]+/[^/]+/\w+_test\.py|tests/(quality/(packaging|calls)|system/boards|tools/readme/(new_board|first_triangle))\b.*|"
                 r"host_sim/tools/outfile\.py")
LINES = {("tests/tools/bench/features.py", "sizes.write_text(SIZES)"), ("tests/tools/profiles/profiles.py", "script.write_text("),
         ("tests/system/programs/gallery.py", '(home / ".asoundrc").write_text('),
         ("tests/system/programs/piglit.py", 'options.state.open("a")'),
         ("tests/system/fuzz/run.py", 'open(log, "w")'), ("tests/system/fuzz/run.py", '-replay.log", "w")'),
         ("tests/quality/mutants/run.py", 'lock", "w")'),
         ("tests/tools/page/chromium.py", 'path.write_bytes(base64.b64decode(self.call("Page.captureScreenshot"')}
PLAIN = re.compile(r"""\.write_(text|bytes)\(|open\([^)]*["'][wax]b?\+?["']|shutil\.copy(file|2)?\(|os\.(rename|replace)\(""")


def every_tool():
    """No tool writes a lasting file in another way."""
    seen = 0
    # A fresh machine may have the tree without git.
    rooms = [room for room in ROOT.iterdir() if room.is_dir() and room.name != "build" and not room.name.startswith(".")]
    for path in sorted(path for room in rooms for path in room.rglob("*.py")):
        name = str(path.relative_to(ROOT))
        if OWN.fullmatch(name):
            continue
        text = path.read_text()
        seen += "outfile.write" in text
        for line in text.splitlines():
            if PLAIN.search(line) and not any(name == file and known in line for file, known in LINES):
                check(False, f"{name}: {line.strip()} does not go through host_sim/tools/outfile.py")
    check(seen > 15, f"only {seen} tools write files: what is looked for?")


def main():
    for part in (regular, whole_at_any_time, no_room, devices):
        with tempfile.TemporaryDirectory() as folder:
            part(pathlib.Path(folder))
    standard_output()
    if (ROOT / ".git").exists():
        every_tool()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
