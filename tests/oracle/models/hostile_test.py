#!/usr/bin/env python3
"""Reads files that were made to harm their reader, through `spangle bake` and `spangle run --model`.

usage: hostile_test.py SPANGLE

Whatever a file holds, the program must end with status 0 or 2 within seconds and within its memory, print one line, and leave no unfinished
file behind.
"""
import base64
import json
import os
import pathlib
import random
import resource
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/support"))
from checks import check, failures  # noqa: E402

SPANGLE = str(pathlib.Path(sys.argv[1]).resolve())
SECONDS, MEMORY = 30, 2300 << 20  # the reader's own limit of memory is 2 GiB
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def png(width, height, rows, depth=8, color=2, extra=b""):
    head = struct.pack(">IIBBBBB", width, height, depth, color, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + extra + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


def bomb(size):
    """Returns zeros that deflate to a thousandth of their size."""
    deflate = zlib.compressobj(9)
    return b"".join([deflate.compress(bytes(1 << 20)) for _ in range(size >> 20)] + [deflate.flush()])


def tga(width, height, content=b""):
    return struct.pack("<BBBHHBHHHHBB", 0, 0, 10, 0, 0, 0, 0, 0, width, height, 24, 0) + content


def bmp(width, height):
    return b"BM" + struct.pack("<IHHI", 54, 0, 0, 54) + struct.pack("<IiiHHIIiiII", 40, width, height, 1, 24, 0, 0, 0, 0, 0, 0) + b"\xff" * 64


def gltf(**parts):
    corners = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    model = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
             "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
             "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + base64.b64encode(corners).decode()}],
             "bufferViews": [{"buffer": 0, "byteLength": 36}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]}
    return json.dumps({**model, **parts}).encode()


def accessor(**changes):
    return gltf(accessors=[{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", **changes}])


def chain_of_nodes(depth):
    return gltf(nodes=[{"children": [n + 1]} for n in range(depth)] + [{"mesh": 0}])


def laughs(levels, each):
    """Returns nodes that hold the next node several times over: each ** levels instances of a mesh."""
    nodes = "".join(f'<node id="n{n}">' + f'<instance_node url="#n{n + 1}"/>' * each + "</node>" for n in range(levels))
    return collada(nodes + f'<node id="n{levels}"><instance_geometry url="#g"/></node>')


def collada(nodes):
    return ('<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><library_geometries><geometry id="g"><mesh>'
            '<source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor source="#a" count="3" stride="3">'
            '<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>'
            '<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p>'
            f'</triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s">{nodes}</visual_scene></library_visual_scenes>'
            '<scene><instance_visual_scene url="#s"/></scene></COLLADA>').encode()


def ply(vertices, faces, tail="0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"):
    return (f"ply\nformat ascii 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\nelement face {faces}\n"
            f"property list uchar int vertex_indices\nend_header\n{tail}").encode()


# name: content, and what the line says, or None if the file can be drawn. Where bake and run differ, each has its own text. Two files end
# libassimp 5.2 itself by recursion; only its own process ends then.
PICTURES = {
    "truncated.png": (png(64, 64, zlib.compress(bytes(64 * 193)))[:60], "cannot read picture"),
    "header-only.png": (png(64, 64, b"")[:33], "cannot read picture"),
    "huge.png": (png(0x7FFFFFFF, 0x7FFFFFFF, zlib.compress(b"")), "at most 16384 pixels a side"),
    "wide.png": (png(16385, 1, zlib.compress(bytes(16385 * 3 + 1))), "it is 16385x1"),
    "many-pixels.png": (png(16384, 16384, bomb(4 << 20), 1, 0), "it is 16384x16384"),
    "no-pixels.png": (png(0, 7, zlib.compress(b"")), "cannot read picture"),
    "more-rows.png": (png(4, 4, bomb(64 << 20)), None),
    "text-bomb.png": (png(1, 1, zlib.compress(bytes(4)), extra=chunk(b"zTXt", b"a\0\0" + bomb(256 << 20))), None),
    "deep-bomb.png": (png(8192, 8192, bomb(193 << 20)), None),
    "bad-crc.png": (png(4, 4, zlib.compress(bytes(52)))[:-20] + bytes(20), "cannot read picture"),
    "huge.bmp": (bmp(0x7FFFFFFF, 0x7FFFFFFF), "cannot read picture"),
    "upside-down.bmp": (bmp(30000, -30000), "cannot read picture"),
    "huge.tga": (tga(65535, 65535), "cannot read picture"),
    "huge.gif": (b"GIF89a" + struct.pack("<HHBBB", 65535, 65535, 0x80, 0, 0) + bytes(6) + b"," + struct.pack("<HHHHB", 0, 0, 65535, 65535, 0) + b"\x02\x02\x44\x01\x00;", "cannot read picture"),
    "empty.png": (b"", "cannot read picture"),
    "noise.jpg": (b"\xff\xd8\xff\xe0" + random.Random(3).randbytes(4096), "cannot read picture"),
    "nul\nline.png": (b"\x89PNG", "cannot read picture"),
}
MODELS = {
    "no-vertices.obj": (b"f 1 2 3\n", "cannot read model"),
    "beyond.obj": ((TRIANGLE + "f 1 2 4000000000\n").encode(), "cannot read model"),
    "negative.obj": ((TRIANGLE + "f -1 -2 -9\n").encode(), "cannot read model"),
    "most-negative.obj": ((TRIANGLE + "f -2147483648 -1 -2\n").encode(), "cannot read model"),
    "zero.obj": ((TRIANGLE + "f 0 1 2\n").encode(), "cannot read model"),
    "nan.obj": (b"v nan nan nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "no extent"),
    "all-nan.obj": (b"v nan 0 0\nv 0 nan 0\nv 0 0 nan\nf 1 2 3\n", "no extent"),
    "infinite.obj": (b"v inf 0 0\nv 1e39 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n", None),
    "largest.obj": (b"v 3e38 0 0\nv -3e38 0 0\nv 0 3e38 -3e38\nvt 3e38 1e-45\nvt -3e38 nan\nvt 1e-45 inf\nvn nan inf 0\nf 1/1/1 2/2/1 3/3/1\n", None),
    "least.obj": (b"v 1e-45 0 0\nv 0 1e-45 0\nv 0 0 1e-45\nf 1 2 3\n", ("is left", None)),
    "long-line.obj": ((TRIANGLE + "# " + "x" * (8 << 20) + "\nf 1 2 3\n").encode(), None),
    "long-number.obj": (("v " + "9" * 100000 + " 0 0\n" + TRIANGLE + "f 2 3 4\n").encode(), None),
    "many-corners.obj": ((TRIANGLE + "f" + " 1 2 3" * 20000 + "\n").encode(), "cannot read model"),
    "own-material.obj": ((TRIANGLE + "mtllib own-material.obj\nusemtl x\nf 1 2 3\n").encode(), None),
    "zero-device.obj": ((TRIANGLE + "mtllib ../../../../../../../../dev/zero\nf 1 2 3\n").encode(), None),
    "shared-edge.obj": (("".join(f"v {x % 97} {x % 89} {x % 83}\n" for x in range(2000)) + "".join(f"f 1 2 {n}\n" for n in range(3, 2000))).encode(), None),
    "broken-texture.obj": ((TRIANGLE + "vt 0 0\nmtllib broken-texture.mtl\nusemtl m\nf 1/1 2/1 3/1\n").encode(), None),
    "own-child.gltf": (gltf(nodes=[{"children": [0], "mesh": 0}]), "cannot read model"),
    "cycle.gltf": (gltf(nodes=[{"children": [1]}, {"children": [0], "mesh": 0}]), "cannot read model"),
    "deep.gltf": (chain_of_nodes(100000), "cannot read model"),
    "no-node.gltf": (gltf(scenes=[{"nodes": [7]}]), "cannot read model"),
    "count.gltf": (accessor(count=4000000000), "cannot read model"),
    "offset.gltf": (accessor(byteOffset=4294967290), "cannot read model"),
    "type.gltf": (accessor(componentType=77), "cannot read model"),
    "length.gltf": (gltf(buffers=[{"byteLength": 1 << 40, "uri": "length.gltf"}]), "cannot read model"),
    "device.gltf": (gltf(buffers=[{"byteLength": 36, "uri": "/dev/zero"}]), "cannot read model"),
    "short.glb": (b"glTF" + struct.pack("<II", 2, 0xFFFFFFFF) + struct.pack("<II", 0xFFFFFFF0, 0x4E4F534A), "cannot read model"),
    "own-node.dae": (collada('<node id="n0"><instance_node url="#n0"/><instance_geometry url="#g"/></node>'), "crashes its reader"),
    "laughs.dae": (laughs(24, 4), "model"),
    "few-laughs.dae": (laughs(4, 4), None),
    "entities.dae": (b'<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a "aaaaaaaaaa">' + b"".join(
        f'<!ENTITY {chr(98 + n)} "{"&" + chr(97 + n) + ";" * 1}{("&" + chr(97 + n) + ";") * 9}">'.encode() for n in range(12)) + b"]><COLLADA>&m;</COLLADA>", "cannot read model"),
    "deep.dae": (collada("<node>" * 100000 + "</node>" * 100000), "cannot read model"),
    "many.ply": (ply(4000000000, 1), "cannot read model"),
    "faces.ply": (ply(3, 4000000000), "cannot read model"),
    "index.ply": (ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 4000000000\n"), "cannot read model"),
    "minus.ply": (ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 -7\n"), "cannot read model"),
    "many.stl": (bytes(80) + struct.pack("<I", 0xFFFFFFFF) + bytes(200), "cannot read model"),
    "many.off": (b"OFF\n4000000000 6 0\n0 0 0\n", "cannot read model"),
    "many.md2": (b"IDP2" + struct.pack("<16i", 8, *([0x7FFFFFFF] * 15)), "cannot read model"),
    "magic.3ds": (struct.pack("<HI", 0x4D4D, 0xFFFFFFFF) + struct.pack("<HI", 0x3D3D, 0xFFFFFFFF) * 1000, "cannot read model"),
    "empty.obj": (b"", "cannot read model"),
    "escape.obj": (b"\x1b]0;owned\x07\n\x1b[2J", "cannot read model"),
}
COMPANIONS = {"broken-texture.mtl": b"newmtl m\nKd nan inf -1\nNs nan\nd nan\nmap_Kd \x1b[2Jhuge.png\n"}


def run(folder, *words):
    """Returns the status, standard error, and the processor seconds of the program and its reader, because the machine may be busy."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process = subprocess.Popen([SPANGLE, *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)
    try:
        error = process.communicate(timeout=10 * SECONDS)[1]
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        error = process.communicate()[1]
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return process.returncode, error.decode(errors="replace"), seconds


def held(folder, name, says, *words):
    status, error, seconds = run(folder, *words)
    what = f"{name!r} by {words[0]}"
    lines = [line for line in error.split("\n") if line]
    check(status == (0 if says is None else 2), f"{what}: exit status {status}: {error[:300]!r}")
    check(says is None or (len(lines) == 1 and says in lines[0]), f"{what}: {error[:300]!r} is one line that says {says!r}")
    check(len(lines) <= 1 and all(ord(c) >= 32 for line in lines for c in line), f"{what}: {error[:300]!r} is a line that a terminal bears")
    check(seconds < SECONDS, f"{what}: {seconds:.1f} s")


def corrupted(folder, source, tries, seed):
    """Reads sound files in which some bytes were changed: each must be read or refused, and nothing else."""
    generator, content = random.Random(seed), source.read_bytes()
    for n in range(tries):
        bad = bytearray(content[:generator.randrange(len(content))] if n % 4 == 0 else content)
        for _ in range(generator.randrange(1, 20)):
            if bad:
                bad[generator.randrange(len(bad))] = generator.choice((0, 255, 45, 57, generator.randrange(256)))
        path = folder / f"corrupted-{n}{source.suffix}"
        path.write_bytes(bad)
        status, error, seconds = run(folder, "bake", path.name, "-o", "corrupted.hpp")
        lines = [line for line in error.split("\n") if line]
        check(status in (0, 2) and seconds < SECONDS and (status == 0 or len(lines) == 1), f"{source.name}, corruption {n}: {status} after {seconds:.1f} s: {error[:300]!r}")
        path.unlink()


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file, content in COMPANIONS.items():
            (folder / file).write_bytes(content)
        for file, (content, says) in {**PICTURES, **MODELS}.items():
            baked, drawn = says if isinstance(says, tuple) else (says, says)
            (folder / file).write_bytes(content)
            held(folder, file, baked, "bake", file, "-o", "out.hpp")
            check((folder / "out.hpp").exists() == (baked is None), f"{file!r}: a header where there is something to write")
            (folder / "out.hpp").unlink(missing_ok=True)
            if file in MODELS:
                held(folder, file, drawn, "run", "--model", file, "--size", "32x32", "--shot", "shot.png")
                check((folder / "shot.png").exists() == (drawn is None), f"{file!r}: a picture where there is something to draw")
                (folder / "shot.png").unlink(missing_ok=True)
            if file != "huge.png":
                (folder / file).unlink()
        for source, seed in ((ROOT / "boards/scenes/models/rocket.obj", 1), (ROOT / "boards/scenes/models/rocket.png", 2)):
            corrupted(folder, source, 12, seed)
        left = sorted(path.name for path in folder.iterdir() if path.name not in (*COMPANIONS, "huge.png", "corrupted.hpp"))
        check(not left, f"{left} are left behind")
    most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss << 10
    check(most < MEMORY, f"{most >> 20} MiB were in use")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
