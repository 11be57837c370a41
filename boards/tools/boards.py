#!/usr/bin/env python3
"""Builds the firmware of every board, runs it in QEMU, and compares each frame with the board's simulated twin.

usage: ./dev boards [BOARD...] [--frames N] [--list] [--hardware] [--update] [--document]

A board is a folder of boards/ with a board.json. The program prints one row for each board; a cell with slashes has a value for each of the
board's scenes. The exit status is 1 if a frame differs, if an image holds what it must not, or if a board costs more than 3 % above
boards/golden.json. It is 77 (skipped) if a compiler or emulator is missing.
"""
import argparse
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import document  # noqa: E402
import firmware  # noqa: E402
import golden  # noqa: E402
import look  # noqa: E402
import profile  # noqa: E402
import twin  # noqa: E402
from firmware import outfile  # noqa: E402

ROOT = firmware.ROOT
HANDLER_STACK = 512  # bytes beside the program's stack, as hal/mcu/sections.ld has it
FRAMES = 30
LOOKED_AT = 3  # frames of each scene whose picture on the display is compared, too
FEATURES, LIMITS = profile.features(), [f"SPANGLE_{limit}" for limit in ("OPTIMIZE", *profile.limits())]


@dataclasses.dataclass(frozen=True)
class Board:
    """The fields of a board.json. `left_out` names the scenes that do not fit the board, and why."""
    name: str
    target: str
    machine: tuple
    scenes: tuple
    features: tuple = None  # the optional systems in the board's library; None: all
    limits: dict = dataclasses.field(default_factory=dict)  # {"SPANGLE_TEXTURE_UNITS": 1}
    small: bool = False  # whether every file is built for size
    left_out: dict = dataclasses.field(default_factory=dict)
    trace: dict = None  # how the display's lines are wired, for the trace of register writes
    screen: dict = None  # how to take pictures from the emulator, if it draws the display itself
    sources: tuple = ()  # sources beside those of the board's folder, from the root of the repository
    folder: pathlib.Path = None

    @property
    def defines(self):
        """The definitions of the board's library, where they are not the usual ones."""
        unknown = set(self.features or ()) - set(FEATURES)
        if unknown:
            raise ValueError(f"{self.name}: no feature {', '.join(unknown)} in cmake/Features.cmake")
        unknown = set(self.limits) - set(LIMITS)
        if unknown:
            raise ValueError(f"{self.name}: no limit {', '.join(unknown)} in cmake/Limits.cmake")
        off = [] if self.features is None else [f"-DSPANGLE_FEATURE_{f}=0" for f in FEATURES if f not in self.features]
        numbers = profile.numbers({name.removeprefix("SPANGLE_"): value for name, value in self.limits.items()})
        return off + [f"-DSPANGLE_{name}={number}" for name, number in numbers.items()]


@dataclasses.dataclass
class Frame:
    hash: str
    drawing: int  # instructions of drawing the frame; those of presenting it are in `presenting`
    presenting: int
    bytes: int  # bytes sent to the display since the program began


@dataclasses.dataclass
class Run:
    scenes: dict  # {id: [Frame]}
    memory: dict  # {"arena": bytes, "peak": bytes, "stack": bytes}
    problems: list


def read_board(path):
    data = {key: tuple(value) if isinstance(value, list) else value for key, value in json.loads(path.read_text()).items()}
    return Board(path.parent.name, folder=path.parent, **data)


def discover():
    return {path.parent.name: read_board(path) for path in sorted((ROOT / "boards").glob("*/board.json"))}


def add_image(build, board, report):
    """Adds a board's demo to the build, and returns the path of its ELF file. `report` is "semihosting" or "silent"."""
    variant = board.name if board.defines else ""
    library = build.library(board.target, board.defines, variant, hot=() if board.small else firmware.HOT)
    demo = [*board.defines, "-DDEMO_SCENES=" + ",".join(f"&scenes::{firmware.SCENES[scene]}" for scene in board.scenes)]
    paths = [ROOT / "boards/demo/main.cpp", ROOT / "boards/demo/demo.cpp", ROOT / f"boards/demo/report_{report}.cpp",
             *sorted(board.folder.glob("*.cpp")), *(ROOT / source for source in board.sources)]
    paths += [path for path in firmware.startup(board.target) if report == "semihosting" or path.parent.name != "emulated"]
    own = [build.compile(board.target, "-Os", path, demo, board.name) for path in paths]
    name = board.name + (".elf" if report == "semihosting" else ".hardware.elf")
    return build.image(board.target, [*own, *library], board.folder / "memory.ld", name)


def read_run(text):
    run, scene = Run({}, {}, []), None
    for words in map(str.split, text.splitlines()):
        if words[:1] == ["scene"]:
            scene = run.scenes.setdefault(words[1], [])
        elif words[:1] == ["frame"] and len(words) == 5:
            scene.append(Frame(words[1], *map(int, words[2:])))
        elif len(words) == 2 and words[1].isdigit():
            run.memory[words[0]] = int(words[1])
        elif words:
            run.problems.append(" ".join(words))
    return run


def per_scene(board, value):
    """Returns one cell: a value for each scene of the board, and `-` for each scene that is left out."""
    return "/".join([value(scene) for scene in board.scenes] + ["-" for _ in board.left_out])


def short(n):
    return f"{n / 1e6:.2f}M" if n >= 1e5 else f"{n / 1e3:.1f}k" if n >= 1e4 else str(round(n))


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def handler_stack(board):
    """Returns the bytes beside the program's stack that the board's linker script reserves."""
    own = re.search(r"^handler_stack_size = (\d+);", (board.folder / "memory.ld").read_text(), re.M)
    return int(own[1]) if own else HANDLER_STACK


def check(board, image, host, frames, pictures):
    """Returns the row of a board, and a list of what is wrong. The last compared picture of each scene is drawn into `pictures`, a folder.
    """
    try:
        run = read_run(firmware.emulate(board.machine, image, (str(frames),), ("-icount", "shift=0")))
    except RuntimeError as error:
        run = Run({}, {}, str(error).splitlines())
    wrong = list(run.problems)
    expected = twin.play(host, board, frames)
    for scene in board.scenes:
        ours, theirs = [f.hash for f in run.scenes.get(scene, [])], [f.hash for f in expected[scene]]
        if ours != theirs:
            first = next((i for i, pair in enumerate(zip(ours, theirs)) if pair[0] != pair[1]), min(len(ours), len(theirs)))
            wrong.append(f"{scene}: frame {first} differs from the simulated board's")
    drawn = str(pictures / board.name)
    if board.trace and not run.problems:
        wrong += look.through_trace(host, board, image, LOOKED_AT, drawn, read_run)
    if board.screen and not run.problems:
        wrong += look.at_screen(host, board, image, LOOKED_AT, drawn)
    wrong += [f"the image holds {name}" for name in firmware.forbidden(board.target, image)]
    size = firmware.sizes(board.target, image)
    if 4 * run.memory.get("stack", 0) > 3 * (size[".stack"] - handler_stack(board)):
        wrong.append(f"{run.memory['stack']} bytes of stack were used: more than three quarters of it")
    flash = sum(size.get(s, 0) for s in (".text", ".ARM.exidx", ".data"))
    ram = sum(size.get(s, 0) for s in (".data", ".bss", ".noinit")) - run.memory.get("arena", 0) + run.memory.get("peak", 0)

    def steady(scene):  # the first frame of a scene sends all of the panel
        return run.scenes[scene][1:] or run.scenes[scene]

    row = {"board": board.name, "flash": flash, "ram": ram, "stack": run.memory.get("stack", 0), "scenes": {}}
    for scene in board.scenes:
        if run.scenes.get(scene):
            fragments = mean(f.fragments for f in expected[scene])
            sent = [b.bytes - a.bytes for a, b in zip(run.scenes[scene], run.scenes[scene][1:])]
            row["scenes"][scene] = {"drawing": round(mean(f.drawing for f in run.scenes[scene])),
                                    "presenting": round(mean(f.presenting for f in steady(scene))),
                                    "fragments": round(fragments), "bus_bytes": round(mean(sent or [0])), "frames": len(run.scenes[scene])}
    return row, wrong


def cells(board, row, wrong):
    def of(key):
        return per_scene(board, lambda scene: key(row["scenes"][scene]) if scene in row["scenes"] else "?")

    return [board.name, str(row["flash"]), str(row["ram"]), str(row["stack"]), of(lambda s: short(s["drawing"] + s["presenting"])),
            of(lambda s: f"{s['drawing'] / max(s['fragments'], 1):.0f}"), of(lambda s: short(s["bus_bytes"])), of(lambda s: str(s["frames"])),
            "no" if wrong else "yes"]


HEADER = ["board", "flash", "ram", "stack", "instr_per_frame", "instr_per_fragment", "bus_bytes", "frames", "equal"]


def print_table(rows):
    widths = [max(len(line[i]) for line in [HEADER, *rows]) for i in range(len(HEADER))]
    for line in [HEADER, *rows]:
        print("  ".join(cell.ljust(width) if i == 0 else cell.rjust(width) for i, (cell, width) in enumerate(zip(line, widths))))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("boards", nargs="*", metavar="BOARD")
    parser.add_argument("--host", required=True, type=pathlib.Path, help="the program spangle_twin")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/boards", help="where images go")
    parser.add_argument("--frames", type=int, default=FRAMES, help="of each scene")
    parser.add_argument("--list", action="store_true", help="only names the boards")
    parser.add_argument("--update", action="store_true", help="writes what boards cost now to boards/golden.json")
    parser.add_argument("--document", action="store_true", help="writes table and pictures to docs/boards.md (all boards)")
    parser.add_argument("--hardware", action="store_true", help="only builds images for real boards, without reports")
    arguments = parser.parse_args()
    known = discover()
    unknown = [name for name in arguments.boards if name not in known]
    if unknown:
        parser.error(f"no board {', '.join(unknown)}; there are {', '.join(known)}")
    boards = [known[name] for name in arguments.boards or known]
    if arguments.list:
        print("\n".join(board.name for board in boards))
        return 0
    missing = firmware.missing({board.target for board in boards})
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (./dev setup --all installs them)")
        return 77
    build = firmware.Build(arguments.build)
    hardware = [add_image(build, board, "silent") for board in boards]
    images = {} if arguments.hardware else {board.name: add_image(build, board, "semihosting") for board in boards}
    build.run()
    if arguments.hardware:
        print("\n".join(map(str, hardware)))
        return 0

    with tempfile.TemporaryDirectory() as name:
        return report(boards, images, arguments, pathlib.Path(name))


def report(boards, images, arguments, pictures):
    """Runs the boards, prints the table and what is wrong, and returns the exit status."""
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", os.cpu_count()))) as pool:
        results = list(pool.map(lambda board: check(board, images[board.name], arguments.host.resolve(), arguments.frames, pictures), boards))
    table = [cells(board, row, wrong) for board, (row, wrong) in zip(boards, results)]
    print_table(table)
    notes = [f"{board.name}: {scene} is left out: {why}" for board in boards for scene, why in board.left_out.items()]
    problems = [f"{board.name}: {problem}" for board, (_, wrong) in zip(boards, results) for problem in wrong]
    rows = [row for row, _ in results]
    if arguments.update and not problems:
        golden.update(rows)
    if arguments.frames == FRAMES:
        problems += golden.grown(rows)
    print("\n".join(notes + problems))
    if arguments.document and not problems:
        document.write(HEADER, table, notes, document.keep_pictures(boards, pictures))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
