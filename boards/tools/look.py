"""Looks at the display of an emulated board, either through the trace of its register writes or at the emulator's own screen."""
import os
import pathlib
import socket
import subprocess
import tempfile
import time

import firmware
import twin

TIMEOUT = 120  # seconds that one program may take


def through_trace(program, board, image, frames, pictures, read_run):
    """Replays what the program sent into Spangle's model of the display controller. Returns lines that say what is wrong."""
    with tempfile.TemporaryDirectory() as name:
        trace = pathlib.Path(name) / "trace"
        os.mkfifo(trace)
        replay = twin.Replay(program, board, frames, trace, pictures)
        try:
            text = firmware.emulate(board.machine, image, (str(frames),), ("-trace", "memory_region_ops_write", "-D", str(trace)), timeout=TIMEOUT)
        except RuntimeError as error:
            replay.process.kill()
            return str(error).splitlines()
        run = read_run(text)
        return replay.verdict([frame.bytes for scene in board.scenes for frame in run.scenes.get(scene, [])])


class Monitor:
    """QEMU's monitor on a socket."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(TIMEOUT)
        for _ in range(500):
            try:
                self.socket.connect(str(path))
                break
            except OSError:
                time.sleep(0.02)
        self.answer()

    def answer(self):
        text = b""
        while not text.endswith(b"(qemu) "):
            part = self.socket.recv(4096)
            if not part:
                return
            text += part

    def command(self, line):
        self.socket.sendall(line.encode() + b"\n")
        self.answer()


def at_screen(program, board, image, frames, pictures):
    """Dumps the emulator's screen while the program waits after each frame. Returns lines that say what is wrong."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        command = firmware.qemu(board.machine, image, (str(frames), "wait"), ("-monitor", "unix:monitor,server,nowait"))
        process = subprocess.Popen(["timeout", str(TIMEOUT), *command], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                   env=firmware.ENVIRONMENT)
        monitor, seen = None, 0
        for line in process.stdout:
            if line.startswith("frame "):
                seen += 1
                monitor = monitor or Monitor(folder / "monitor")
                monitor.command(f"screendump {seen}.ppm")
                (folder / f"next-{seen}").touch()
        process.wait()
        return twin.screens(program, board, frames, folder, pictures)
