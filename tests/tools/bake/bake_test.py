#!/usr/bin/env python3
"""Tests `spangle bake` as a user meets it.

usage: bake_test.py SPANGLE fresh|errors|headers COMPILER LIBRARY...
"""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "boards/tools")]
import firmware  # noqa: E402
from checks import check, failures  # noqa: E402

MODELS = ROOT / "boards/scenes/models"
SPANGLE, COMPILER, LIBRARIES = sys.argv[1], sys.argv[3], sys.argv[4:]
INCLUDES = [f"-I{ROOT / room}" for room in ("gl/include", "hal/include", "raster/include", "raster/format/include")]
DUCK = pathlib.Path("/usr/share/assimp/models/Collada/duck.dae")


def run(*words, cwd=None):
    return subprocess.run([SPANGLE, *words], capture_output=True, text=True, cwd=cwd)


def fresh():
    """The headers of the scenes are what the command in their first line writes, and the model is what its program makes."""
    headers = sorted(MODELS.glob("*.hpp"))
    check(headers, "there are baked models")
    with tempfile.TemporaryDirectory() as folder:
        for header in headers:
            words = re.search(r"Written by `spangle (bake .*)`", header.read_text()).group(1).split()
            words[1] = str(MODELS / words[1])
            done = run(*words, cwd=folder)
            check(done.returncode == 0, f"{header.name}: {done.stderr.strip()}")
            check((pathlib.Path(folder) / header.name).read_text() == header.read_text(), f"{header.name} is not what `spangle {' '.join(words)}` writes")
        kept = {path: path.read_bytes() for path in MODELS.glob("rocket.*") if path.suffix != ".hpp"}
        program = pathlib.Path(folder) / "boards/scenes/models/rocket.py"
        program.parent.mkdir(parents=True)
        program.write_bytes(kept[MODELS / "rocket.py"])
        (pathlib.Path(folder) / "host_sim").symlink_to(ROOT / "host_sim")
        subprocess.run([sys.executable, program], check=True)
        for path, content in kept.items():
            check((program.parent / path.name).read_bytes() == content, f"{path.name} is not what rocket.py makes")


def errors():
    """An error prints one line that says what to do, exits with status 2, and writes nothing."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "noise.obj").write_bytes(b"\x00\x01 no model \xff")
        (folder / "speck.obj").write_text("".join(f"v {x} {y} 0\n" for x, y in ((0, 0), (0.001, 0), (0, 0.001), (9, 9), (9.001, 9), (9, 9.001))) + "f 1 2 3\nf 4 5 6\n")
        rocket = str(MODELS / "rocket.obj")
        for words, advice in ((["nothing.obj", "-o", "x.hpp"], "no such file"), (["noise.obj", "-o", "x.hpp"], "cannot read model"),
                              (["."], "output"), ([rocket, "-o", "no/such/folder/x.hpp"], "cannot write"), ([rocket, "-o", "x.hpp", "--positions", "float"], "--positions"),
                              ([rocket, "-o", "x.hpp", "--texture", "rgb31"], "--texture"), ([rocket, "-o", "x.hpp", "--cache", "0"], "--cache"),
                              ([rocket, "-o", "x.hpp", "--texture-size", "9000"], "--texture-size"), ([rocket, "-o", "-.hpp"], "--name"),
                              (["speck.obj", "-o", "x.hpp", "--positions", "byte"], "lost a corner"), ([rocket], "--output")):
            done = run("bake", *words, cwd=folder)
            text = " ".join(words)
            check(done.returncode == 2, f"'{text}': exit status {done.returncode}")
            check(advice in done.stderr and len(done.stderr.strip().splitlines()) == 1, f"'{text}': {done.stderr!r} says '{advice}'")
            check(done.stdout == "", f"'{text}': nothing on stdout")
        check(sorted(p.name for p in folder.iterdir()) == ["noise.obj", "speck.obj"], "nothing was written")
    text = run("bake", "--help").stdout
    check(all(word in text for word in ("no loading, no RAM", "--positions", "etc1", "SPANGLE_VERTEX_CACHE")), "a help worth reading")


def picture(folder, header, name, *defines):
    """Returns the pixels that a header draws. The header is compiled with every warning."""
    program = folder / f"draw_{name}"
    done = subprocess.run([COMPILER, *firmware.sound_calls(COMPILER), "-std=c++20", "-O1", "-Wall", "-Wextra", "-Wconversion", "-Werror", *INCLUDES, f'-DBAKED_HEADER="{header}"', f"-DBAKED_NAME={name}",
                           *(f"-D{define}" for define in defines), str(ROOT / "tests/tools/bake/draw_baked.cpp"), *LIBRARIES, "-o", str(program)], capture_output=True, text=True)
    check(done.returncode == 0, f"{name} does not compile: {done.stderr[:2000]}")
    if done.returncode != 0:
        return b""
    done = subprocess.run([program], capture_output=True)
    check(done.returncode == 0, f"{name}: exit {done.returncode}: {done.stderr.decode()}")
    return done.stdout.split(b"\n", 1)[1]


def psnr(a, b):
    squares = sum((x - y) ** 2 for x, y in zip(a, b))
    return 99.0 if squares == 0 else 10 * math.log10(255 ** 2 * len(a) / squares)


def headers():
    """Headers of every kind compile without a warning, draw without an error, and look like the finest one."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def bake(source, label, *words):
            done = run("bake", str(source), "-o", str(folder / f"{label}.hpp"), "--json", *words)
            check(done.returncode == 0, f"{label}: {done.stderr}")
            return json.loads(done.stdout)

        duck = DUCK if DUCK.exists() else MODELS / "rocket.obj"
        bake(duck, "finest", "--positions", "fixed", "--normals", "short", "--texcoords", "fixed", "--texture", "rgb888", "--strips", "never")
        finest = picture(folder, folder / "finest.hpp", "finest")
        check(len(set(finest[i:i + 3] for i in range(0, len(finest), 3))) > 100, "there is something to see")
        for label, least, words in (("usual", 30, []), ("strip", 30, ["--strips", "always", "--cache", "16"]), ("small", 24, ["--positions", "byte", "--texture", "p8-rgb565"]),
                                    ("blocks", 28, ["--texture", "etc1", "--normals", "fixed"]), ("unlit", 5, ["--no-normals", "--texture", "l8", "--no-mipmaps"])):
            figures = bake(duck, label, *words)
            mesh, texture = figures["mesh"], figures["textures"][0]
            db = psnr(finest, picture(folder, folder / f"{label}.hpp", label))
            check(db >= least, f"{label}: {db:.1f} dB from the finest")
            check(mesh["cache_misses"] <= mesh["cache_misses_before"], f"{label}: {mesh}")
            check(mesh["vertex_bytes"] + mesh["index_bytes"] < 0.65 * mesh["float_bytes"], f"{label}: {mesh}")
            check(texture["psnr_db"] > 20 and texture["levels"] == (1 if label == "unlit" else 9 if DUCK.exists() else 7), f"{label}: {texture}")
        bake(MODELS / "rocket.png", "skin", "--texture", "p4-rgb565", "--texture-size", "32")
        check(len(set(picture(folder, folder / "skin.hpp", "skin", "BAKED_TEXTURE_ONLY"))) > 5, "a picture by itself")
        table = run("bake", str(MODELS / "rocket.obj"), "-o", str(folder / "t.hpp"), "--name", "other").stdout
        check("namespace spangle::baked::other" in table and "cache of 80" in table and "PSNR" in table, table)


def main():
    parts = {"fresh": fresh, "errors": errors, "headers": headers}
    if sys.argv[2] not in parts:
        print(__doc__.strip())
        return 2
    parts[sys.argv[2]]()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
