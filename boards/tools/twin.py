"""Asks the simulated twin of a board (host_sim/boards) for its frames, and for its verdict on an emulated board."""
import dataclasses
import subprocess


@dataclasses.dataclass
class Frame:
    hash: str
    fragments: int


def play(program, board, frames):
    """Returns {scene: [Frame]} of the twin."""
    done = subprocess.run([str(program), "play", board.name, str(frames), *board.scenes], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{board.name}: its twin failed: {done.stderr}")
    scenes, scene = {}, None
    for words in map(str.split, done.stdout.splitlines()):
        if words[0] == "scene":
            scene = scenes.setdefault(words[1], [])
        else:
            scene.append(Frame(words[1], int(words[2])))
    return scenes


def _wire(value):
    return ":".join(map(str, value)) if isinstance(value, list) else str(value)


class Replay:
    """A twin that reads a trace of register writes while the emulator writes it."""

    def __init__(self, program, board, frames, trace, pictures):
        wires = [f"{key}={_wire(value)}" for key, value in board.trace.items()]
        self.process = subprocess.Popen([str(program), "replay", board.name, str(frames), str(trace), pictures, *wires, "--", *board.scenes],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def verdict(self, sent):
        """Returns lines that say what is wrong. `sent` holds the bytes sent until the end of each frame."""
        out, _ = self.process.communicate("\n".join(map(str, sent)))
        return out.splitlines() or ([] if self.process.returncode == 0 else ["the replay failed"])


def screens(program, board, frames, folder, pictures):
    """Returns lines that say what is wrong with the screens in the folder."""
    done = subprocess.run([str(program), "screens", board.name, str(frames), str(folder), pictures, str(board.screen["scale"]), *board.scenes],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.stdout.splitlines() or ([] if done.returncode == 0 else ["looking at the screens failed"])
