"""What the simulated twin of a board says, host_sim/boards."""
import dataclasses
import subprocess


@dataclasses.dataclass
class Frame:
    hash: str
    fragments: int
    bytes: int


def play(host, board, frames):
    """{scene: [Frame]}"""
    done = subprocess.run([str(host), "play", board.name, str(frames), *board.scenes], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{board.name}: its twin failed: {done.stderr}")
    scenes, scene = {}, None
    for words in map(str.split, done.stdout.splitlines()):
        if words[0] == "scene":
            scene = scenes.setdefault(words[1], [])
        else:
            scene.append(Frame(words[1], int(words[2]), int(words[3])))
    return scenes
