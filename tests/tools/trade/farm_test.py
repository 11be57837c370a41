#!/usr/bin/env python3
"""Runs the shards of a sweep on several workers: by GNU parallel here, and by ssh on this machine as if it were several.

usage: farm_test.py SPANGLE parallel|ssh

The merged folder must have the CSV and the page of one run. The ssh server is the test's own, on a port of its own, with keys that are
thrown away; it lives as long as the test.
"""
import getpass
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time

from trade_test import SPANGLE, check, trade

SKIPPED = 77
SECONDS = 300
SWEEP = ["S4r", "S5", "S7", "SHADOW", "CUTOUT", "--formats", "565,444", "--frames", "2", "--size", "96x64", "--no-times"]
SHARDS = 4


def need(*programs):
    """Ends the test as skipped if one of these programs is missing. Returns their paths."""
    path = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
    found = [shutil.which(program, path=path) for program in programs]
    for program, where in zip(programs, found):
        if where is None:
            print(f"skipped: there is no {program}; ./dev setup --programs installs it")
            sys.exit(SKIPPED)
    return found


def spread(folder, *options):
    """Runs all shards by GNU parallel, and merges their results."""
    home = folder / "parallel-home"
    home.mkdir(exist_ok=True)
    numbers = [str(i + 1) for i in range(SHARDS)]
    command = " ".join(["cd", str(folder), "&&", str(SPANGLE), "trade", *SWEEP, "--shard", f"{{}}/{SHARDS}", "--out", "part{}"])
    done = subprocess.run(["parallel", "--will-cite", *options, command, ":::", *numbers], cwd=folder, capture_output=True, text=True,
                          timeout=SECONDS, env=dict(os.environ) | {"PARALLEL_HOME": str(home)})
    check(done.returncode == 0, f"parallel ends with {done.returncode}: {done.stdout[-500:]}{done.stderr[-1000:]}")
    trade(folder, "merge", *(f"part{i}" for i in numbers), "--out", "merged")


def same(folder):
    """Checks that the merged folder is the folder of one run, byte by byte."""
    trade(folder, *SWEEP, "--out", "whole")
    files = {out: sorted(p.relative_to(folder / out) for p in (folder / out).rglob("*") if p.is_file()) for out in ("whole", "merged")}
    check(files["whole"] == files["merged"] and len(files["whole"]) > 10, f"other files: {files}")
    for name in files["whole"]:
        check((folder / "whole" / name).read_bytes() == (folder / "merged" / name).read_bytes(), f"{name} has other bytes")
    for shard in range(1, SHARDS + 1):
        check(len((folder / f"part{shard}/accuracy.csv").read_text().splitlines()) > 1, f"shard {shard} measured nothing")


def local(folder):
    need("parallel")
    spread(folder, "--jobs", "2")
    same(folder)


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


def answers(port, server):
    """Waits until the server takes connections."""
    for _ in range(100):
        if server.poll() is not None:
            return False
        try:
            with socket.create_connection(("127.0.0.1", port), timeout=1):
                return True
        except OSError:
            time.sleep(0.1)
    return False


def by_ssh(folder):
    _, sshd, ssh, keygen = need("parallel", "sshd", "ssh", "ssh-keygen")
    keys = folder / "keys"
    keys.mkdir(mode=0o700)
    for name in ("host", "user"):
        subprocess.run([keygen, "-q", "-t", "ed25519", "-N", "", "-f", str(keys / name)], check=True)
    (keys / "authorized").write_bytes((keys / "user.pub").read_bytes())
    port = free_port()
    (keys / "known").write_text(f"[127.0.0.1]:{port},[localhost]:{port} " + (keys / "host.pub").read_text())
    (keys / "config").write_text(f"""ListenAddress 127.0.0.1
Port {port}
HostKey {keys}/host
AuthorizedKeysFile {keys}/authorized
PidFile none
StrictModes no
UsePAM no
PasswordAuthentication no
KbdInteractiveAuthentication no
PermitRootLogin prohibit-password
MaxStartups 20
LogLevel VERBOSE
""")
    if os.geteuid() == 0:
        pathlib.Path("/run/sshd").mkdir(mode=0o755, exist_ok=True)  # sshd separates its privileges in this folder
    log = folder / "sshd.log"
    server = subprocess.Popen([sshd, "-D", "-f", str(keys / "config"), "-E", str(log)], stdin=subprocess.DEVNULL)
    try:
        check(answers(port, server), f"the ssh server does not answer: {log.read_text() if log.exists() else ''}")
        client = f"{ssh} -4 -F none -p {port} -i {keys}/user -o IdentitiesOnly=yes -o UserKnownHostsFile={keys}/known -o BatchMode=yes"
        # Two workers on one machine each take one shard at a time.
        spread(folder, "--ssh", client, *(word for host in ("127.0.0.1", "localhost")
                                          for word in ("--sshlogin", f"1/{getpass.getuser()}@{host}")))
        logins = log.read_text().count("Accepted publickey")
        check(logins >= SHARDS, f"{logins} logins are fewer than shards")
        same(folder)
    finally:
        server.terminate()
        try:
            server.wait(timeout=10)
        except subprocess.TimeoutExpired:
            server.kill()
            server.wait()


def main():
    parts = {"parallel": local, "ssh": by_ssh}
    if len(sys.argv) != 3 or sys.argv[2] not in parts:
        sys.exit(__doc__.strip())
    with tempfile.TemporaryDirectory() as folder:
        parts[sys.argv[2]](pathlib.Path(folder))


if __name__ == "__main__":
    main()
