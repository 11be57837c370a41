#!/usr/bin/env python3
"""Makes rocket.obj, rocket.mtl and rocket.png, the model of boards/scenes/rocket.cpp, beside this file.

usage: rocket.py

The model is a body turned around the y axis, a nozzle, and three fins. The picture is wound around the body, with t from the tail to the
nose. `spangle bake rocket.obj -o rocket.hpp --no-mipmaps --cache 24 --normals short` makes the header of these files.
"""
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "host_sim/tools"))
import outfile
import png

AROUND = 12
WIDTH, HEIGHT = 64, 64
# Radius and height of the body's rings, from the tail to the nose.
PROFILE = [(0.16, -1.00), (0.22, -0.86), (0.28, -0.60), (0.33, -0.25), (0.34, 0.10), (0.30, 0.45), (0.20, 0.75), (0.09, 0.93), (0.0, 1.0)]
# The corners of a fin in its plane, as distance from the axis and height. The fin is thin and has two sides.
FIN = [(0.24, -0.45), (0.27, -0.72), (0.52, -1.10), (0.56, -0.86)]
THICKNESS = 0.025

RED, WHITE, GREY, BLUE, DARK, YELLOW = (208, 44, 40), (255, 255, 255), (150, 154, 162), (90, 170, 226), (44, 52, 70), (244, 196, 64)


def pixel(s, t):
    """Returns the colour at texture coordinates: red nose and tail, white body with a yellow belt and two round windows."""
    for window in (0.25, 0.75):
        d = math.hypot((s - window) * 4.2, (t - 0.62) * 4.0)
        if d < 0.30:
            return BLUE if d < 0.19 else DARK
    if t > 0.80:
        return RED
    if t < 0.09:
        return DARK
    if t < 0.22:
        return RED if int(s * 12) % 2 else GREY
    if 0.40 < t < 0.45:
        return YELLOW
    return WHITE


def turned():
    """Returns positions, normals, texture coordinates and faces of the body's rings. Their seam is double, with s from 0 to 1."""
    v, vn, vt, faces = [], [], [], []
    low, high = PROFILE[0][1], PROFILE[-1][1]
    for i, (radius, y) in enumerate(PROFILE):
        (r0, y0), (r1, y1) = PROFILE[max(i - 1, 0)], PROFILE[min(i + 1, len(PROFILE) - 1)]
        length = math.hypot(r1 - r0, y1 - y0)
        across, up = (y1 - y0) / length, (r0 - r1) / length
        for k in range(AROUND + 1):
            angle = 2 * math.pi * k / AROUND
            c, s = math.cos(angle), math.sin(angle)
            v.append((radius * c, y, -radius * s))
            vn.append((across * c, up, -across * s))
            vt.append((k / AROUND, (y - low) / (high - low)))
    ring = AROUND + 1
    for i in range(len(PROFILE) - 1):
        for k in range(AROUND):
            a, b, c, d = i * ring + k, i * ring + k + 1, (i + 1) * ring + k + 1, (i + 1) * ring + k
            faces.append([a, b, c])
            if i < len(PROFILE) - 2:
                faces.append([a, c, d])
    return v, vn, vt, faces


def nozzle(mesh):
    """Adds the dark disc at the tail."""
    v, vn, vt, faces = mesh
    first, (radius, y) = len(v), PROFILE[0]
    for k in range(AROUND):
        angle = 2 * math.pi * k / AROUND
        v.append((radius * math.cos(angle), y, -radius * math.sin(angle)))
        vn.append((0, -1, 0))
        vt.append((0.5 + 0.3 * math.cos(angle), 0.03))
    for k in range(1, AROUND - 1):
        faces.append([first, first + k + 1, first + k])


def fin(mesh, angle):
    v, vn, vt, faces = mesh
    c, s = math.cos(angle), math.sin(angle)
    for side in (1, -1):
        first = len(v)
        for n, (out, y) in enumerate(FIN):
            thick = side * THICKNESS if n < 2 else 0
            v.append((out * c + thick * s, y, -out * s + thick * c))
            vn.append((side * s, 0, side * c))
            vt.append((0.04 + 0.03 * n, 0.9))
        order = [0, 1, 2, 3] if side > 0 else [0, 3, 2, 1]
        faces.append([first + order[0], first + order[1], first + order[2]])
        faces.append([first + order[0], first + order[2], first + order[3]])


def write_model(mesh):
    v, vn, vt, faces = mesh
    lines = ["# made by rocket.py", "mtllib rocket.mtl", "usemtl skin"]
    lines += ["v %.5f %.5f %.5f" % p for p in v] + ["vn %.5f %.5f %.5f" % n for n in vn] + ["vt %.5f %.5f" % t for t in vt]
    lines += ["f " + " ".join(f"{i + 1}/{i + 1}/{i + 1}" for i in face) for face in faces]
    outfile.write(HERE / "rocket.obj", "\n".join(lines) + "\n")
    outfile.write(HERE / "rocket.mtl", "newmtl skin\nKd 1 1 1\nKs 0 0 0\nmap_Kd rocket.png\n")


def main():
    mesh = turned()
    nozzle(mesh)
    for n in range(3):
        fin(mesh, 2 * math.pi * (n / 3 + 0.25))
    write_model(mesh)
    rows = [[pixel((x + 0.5) / WIDTH, 1 - (y + 0.5) / HEIGHT) for x in range(WIDTH)] for y in range(HEIGHT)]
    outfile.write(HERE / "rocket.png", png.write(rows))
    return 0


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
