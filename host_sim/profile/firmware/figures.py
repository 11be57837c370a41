"""Reads the figures of the images that measure.py builds: their flash, and the lines that they print."""
import collections
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "boards/tools"))
import firmware  # noqa: E402

TARGET, BOARD = "cortex-m4", "mps2_an386"
MACHINE = ["qemu-system-arm", "-M", BOARD.replace("_", "-")]
NS_PER_TICK = 40


def flash_of(image):
    """Returns the bytes in flash: all, and by folder of the sources. Shared constants and start-up code are `others`."""
    out = collections.Counter()
    text = pathlib.Path(f"{image}.map").read_text().partition("\nLinker script and memory map\n")[2]
    for address, size, path in re.findall(r"^ \.(?:text|rodata|data|vectors|init_array)\S*\s+0x([0-9a-f]+)\s+0x([0-9a-f]+) (\S+)$", text, re.M):
        name = pathlib.PurePath(path).name
        room = next((room for room in sorted(firmware.CORE, key=len, reverse=True) if name.startswith(room.replace("/", "_") + "_")), None)
        out[room or ("the program" if "/objects/" in path and "hal_mcu" not in name else "others")] += int(size, 16)
    sizes = firmware.sizes(TARGET, image)
    total = sizes.get(".text", 0) + sizes.get(".data", 0)
    out["others"] += total - sum(out.values())
    return total, {room: size for room, size in out.most_common() if size}


def run(image):
    """Runs an image and reads what it prints.

    Returns [(instructions, hash)], {kind of memory: bytes}, [(address, command, calls, ticks)], [(calls, pixels, ticks, key)].
    """
    frames, memory, lines, keys = [], {}, [], []
    for words in map(str.split, firmware.emulate(MACHINE, image, options=("-icount", "shift=0"), timeout=600).splitlines()):
        if words[:1] == ["frame"]:
            frames.append((int(words[1]), words[2]))
        elif words[:1] == ["line"]:
            lines.append(tuple(map(int, words[1:])))
        elif words[:1] == ["key"]:
            keys.append((*map(int, words[1:4]), " ".join(words[4:])))
        elif len(words) == 2 and words[1].isdigit():
            memory[words[0]] = int(words[1])
    return frames, memory, lines, keys


def keys_of(image, frames):
    """Returns the cost of each state key in a frame: {key: {"pixels", "instructions_a_pixel"}}."""
    *_, counted = run(image)
    calls, _, ticks, _ = counted[0]
    overhead, sums = ticks / max(calls, 1), collections.defaultdict(lambda: [0, 0.0])
    for calls, pixels, ticks, words in counted[1:]:
        sums[words][0] += pixels
        sums[words][1] += max(ticks - calls * overhead, 0) * NS_PER_TICK
    return {words: {"pixels": round(pixels / frames), "instructions_a_pixel": round(instructions / pixels, 1)}
            for words, (pixels, instructions) in sums.items() if pixels}


def lines_of(image, commands, frames, trace):
    """Returns the cost of each line in a frame, the most expensive first: [{"line", "command", "calls", "instructions"}].

    The lines of a trace are its calls.
    """
    _, _, counted, _ = run(image)
    nothing = [(calls, ticks) for address, command, calls, ticks in counted if command == 0 and address]
    overhead = sum(t for _, t in nothing) / max(sum(c for c, _ in nothing), 1) * NS_PER_TICK
    counted = [line for line in counted if line[1] != 0 or line[0] == 0]
    said = subprocess.run(["arm-none-eabi-addr2line", "-e", str(image)], input="\n".join(hex(address - 2) for address, *_ in counted),
                          capture_output=True, text=True, check=True).stdout.split("\n")
    sums = collections.defaultdict(lambda: [0, 0.0])
    for (address, command, calls, ticks), place in zip(counted, said):
        path, _, number = re.sub(r" \(discriminator.*", "", place).rpartition(":")
        place = f"{trace.name if trace else firmware.source_of(path)}:{number}" if address else "others"
        name = commands[command] if address else "commands without a place in the count"
        sums[place, name][0] += calls
        sums[place, name][1] += max(ticks * NS_PER_TICK - calls * overhead, 0)
    rows = [{"line": place, "command": command, "calls": round(calls / frames, 2), "instructions": round(instructions / frames)}
            for (place, command), (calls, instructions) in sums.items()]
    return sorted(rows, key=lambda row: (-row["instructions"], row["line"], row["command"]))
