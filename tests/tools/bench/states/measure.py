"""Measures states: instructions per fragment by callgrind and in QEMU, and times beside llvmpipe's."""
import concurrent.futures
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import mcu  # noqa: E402

TARGETS = {"host": None, "host-base": None, "m4": "m4", "m3": "m3", "m0plus": "m0+"}  # besides the host, the boards of mcu.py
HOSTS = [target for target, board in TARGETS.items() if board is None]
CHUNK = 24  # states of one run, after which progress is printed
# An environment for Mesa without threads, without a window system and without other drivers.
MESA = {"PATH": "/usr/bin:/bin", "LP_NUM_THREADS": "0", "LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "llvmpipe", "MESA_SHADER_CACHE_DISABLE": "true"}


def say(text):
    """Prints a line of progress, which replaces the line before on a terminal."""
    print(text, file=sys.stderr, end="\r" if sys.stderr.isatty() else "\n", flush=True)


def environment(target):
    """Returns the environment of Spangle's programs. The target host-base leaves out instructions that only some processors have."""
    return dict(os.environ, SPANGLE_INSTRUCTIONS="base") if target == "host-base" else None


def lines_of(numbers):
    return "".join(f"{number}\n" for number in numbers)


def listed(runner, seed, numbers):
    """Returns the states of these numbers; `runner` is bench_states."""
    done = subprocess.run([str(runner), str(seed), "list"], input=lines_of(numbers), capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def functions(dump):
    """Returns {function: its own instructions} from a dump of callgrind with uncompressed names."""
    out, current, inclusive = {}, None, False
    for line in dump.splitlines():
        if line.startswith("fn="):
            current = line[3:]
        elif line.startswith("calls="):
            inclusive = True  # the next line is what the callee took
        elif line[:1].isdigit():
            if inclusive:
                inclusive = False
            elif current is not None:
                out[current] = out.get(current, 0) + int(line.split()[1])
    return out


def short_name(function):
    """Returns a function's name without arguments, return type and namespaces."""
    function = function.split("'")[0]
    depth, plain = 0, ""
    for letter in function:
        depth += letter == "<"
        if depth == 0 and letter == "(" and not plain.endswith("operator"):
            break
        plain += letter if depth == 0 else ""
        depth -= letter == ">"
    arguments = function[len(plain):] if "<" in function else ""
    inner = re.findall(r"(\w+)(?=[<,>])", arguments.split("(")[0])[:4] if arguments else []
    return plain.split()[-1].rsplit("::", 1)[-1] + (f"<{', '.join(inner)}>" if inner else "")


def hottest(costs, count=3):
    """Returns [(function, share)] of the functions that take most."""
    total = sum(costs.values())
    names = {}
    for function, cost in costs.items():
        names[short_name(function)] = names.get(short_name(function), 0) + cost
    return [(name, cost / total) for name, cost in sorted(names.items(), key=lambda item: (-item[1], item[0]))[:count]]


def read_counts(output):
    """Returns {number: (instructions or None, fragments, picture)} of what the programs print."""
    out = {}
    for words in map(str.split, output.splitlines()):
        number, *counted, fragments, picture = words
        out[int(number)] = (int(counted[0]) if counted else None, int(fragments), picture)
    return out


def count_chunk_on_host(target, runner, seed, numbers):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(["valgrind", "--tool=callgrind", "--instr-atstart=no", "--compress-strings=no", "--compress-pos=no", "--dump-line=no",
                               f"--callgrind-out-file={folder}/out", str(runner), str(seed), "count"],
                              input=lines_of(numbers), capture_output=True, text=True, env=environment(target))
        if done.returncode != 0:
            raise RuntimeError(f"bench_states ends with {done.returncode}\n{done.stderr[-2000:]}")
        counts, out = read_counts(done.stdout), {}
        for i, number in enumerate(numbers):
            costs = functions(pathlib.Path(f"{folder}/out.{i + 1}").read_text())
            _, fragments, picture = counts[number]
            if fragments:
                out[number] = {"instructions": sum(costs.values()), "fragments": fragments, "picture": picture, "hot": hottest(costs)}
    return out


class Boards:
    """One image that draws any states, on one board."""

    def __init__(self, target, folder):
        self.programs = mcu.Programs(TARGETS[target], folder)
        build, cpu = self.programs.build, self.programs.cpu
        own = [build.compile(cpu, "-Os", HERE / name) for name in ("mcu_main.cpp", "words.cpp", "grammar.cpp", "apply.cpp", "shapes.cpp", "textures.cpp")]
        self.image = build.image(cpu, [*own, *self.programs.library], self.programs.script, "states.elf")
        build.run()

    def count(self, seed, numbers):
        words = [str(seed), *map(str, numbers)]
        output = mcu.firmware.emulate(self.programs.machine, self.image, words, ("-icount", "shift=0"), timeout=600)
        return {number: {"instructions": instructions, "fragments": fragments, "picture": picture}
                for number, (instructions, fragments, picture) in read_counts(output).items() if fragments}


def count(target, runner, seed, numbers, folder):
    """Returns {number: {"instructions", "fragments", "picture"}} of the states that the target has. Firmware is built in the folder."""
    chunks = [numbers[i:i + CHUNK] for i in range(0, len(numbers), CHUNK)]
    out = {}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        if target in HOSTS:
            def one(chunk):
                return count_chunk_on_host(target, runner, seed, chunk)
        else:
            say(f"{target}: building the firmware")
            boards = Boards(target, folder)

            def one(chunk):
                return boards.count(seed, chunk)
        done = 0
        for chunk, found in zip(chunks, pool.map(one, chunks)):
            out.update(found)
            done += len(chunk)
            say(f"{target}: {done} of {len(numbers)} states counted")
    return out


class Timer:
    """A program that times one state after another."""

    def __init__(self, program, seed, environment=None):
        self.process = subprocess.Popen([str(program), str(seed), "time"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)

    def time(self, number):
        """Returns the microseconds of a frame, or a negative number if there is no such context."""
        self.process.stdin.write(f"{number}\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            raise RuntimeError(f"{self.process.args[0]} ended at state {number}")
        return float(line.split()[1])

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def time(target, build, seed, states, rounds):
    """Returns {number: times as fast as llvmpipe}, the median of the rounds. In a round both programs draw one state right after each
    other.
    """
    ours, mesa = Timer(build / "bench_states", seed, environment(target)), Timer(build / "bench_states_mesa", seed, MESA)
    ratios = {}
    by_picture = {}  # llvmpipe has no tiers, so it draws each key once on each surface
    for state in states:
        by_picture.setdefault((state["key"], state["words"]["surface"][0]), []).append(state["number"])
    try:
        for turn in range(rounds):
            for done, numbers in enumerate(by_picture.values()):
                theirs = mesa.time(numbers[0])
                for number in numbers:
                    own = ours.time(number)
                    if theirs > 0 and own > 0:
                        ratios.setdefault(number, []).append(theirs / own)
                if done % 32 == 31:
                    say(f"round {turn + 1} of {rounds}: {done + 1} of {len(by_picture)} pictures timed")
    finally:
        ours.close()
        mesa.close()
    return {number: statistics.median(found) for number, found in ratios.items()}
