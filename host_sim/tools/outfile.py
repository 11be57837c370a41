"""Writes files and standard output for the tools in Python, by the rules of host_sim/output.

A regular file is written whole or not at all: a new file takes its place when everything is in it. Devices and pipes are
written to as they are, and never replaced. If something cannot be written, the program ends with one line and status 1.
"""
import contextlib
import csv
import errno
import io
import os
import pathlib
import stat
import sys
import tempfile

LOST = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EPIPE, errno.EBADF)


def refuse(name, error):
    raise SystemExit(f"{pathlib.Path(sys.argv[0]).name}: cannot write {name}: {error.strerror}") from None


def write(path, content):
    """Makes text or bytes the whole content of a file, which keeps its permissions. Symbolic links are followed."""
    data = content.encode() if isinstance(content, str) else content
    target = pathlib.Path(os.path.realpath(path))
    try:
        mode = target.stat().st_mode if target.exists() else None
        if mode is None or stat.S_ISREG(mode):
            replace(target, data, mode)
        else:
            put(os.open(target, os.O_WRONLY), data)
    except OSError as error:
        refuse(f"'{path}'", error)


def put(descriptor, data):
    with open(descriptor, "wb") as file:
        file.write(data)


def replace(target, data, mode):
    """Replaces a file. The new file is written beside the old one, so that it can take the old one's place in one step."""
    descriptor, unfinished = tempfile.mkstemp(prefix=f".{target.name}.", dir=target.parent)
    try:
        os.fchmod(descriptor, usual_mode() if mode is None else stat.S_IMODE(mode))
        put(descriptor, data)
        os.replace(unfinished, target)
    except BaseException:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(unfinished)
        raise


def usual_mode():
    """Returns the permissions that open() would give a new file. The mask can only be read by setting it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return 0o666 & ~mask


def write_table(path, rows):
    """Writes rows of cells as comma-separated values."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    write(path, text.getvalue())


def checked(main):
    """Runs a program's main function. Lost lines of standard output make its status 1."""
    try:
        try:
            return main()
        finally:
            sys.stdout.flush()
    except OSError as error:
        if error.filename is not None or error.errno not in LOST:
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # at its end the interpreter tries again to write what it has kept
        refuse("standard output", error)
