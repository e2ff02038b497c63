#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the meshes of the example scenes: python3 make_meshes.py [FOLDER] (default: lee/ beside this file).

Standard library only; the same files every time. All meshes are closed, with triangles counter-clockwise seen from
outside, except the cloth and the lattice's ground. Units are the scenes' (cm).
"""

import math
import pathlib
import struct
import sys


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def smooth_normals(positions, triangles):
    """Area-weighted means of the normals of the faces around each vertex."""
    sums = [[0.0, 0.0, 0.0] for _ in positions]
    for triangle in triangles:
        a, b, c = (positions[i] for i in triangle)
        n = cross(sub(b, a), sub(c, a))
        for i in triangle:
            for k in range(3):
                sums[i][k] += n[k]
    return [unit(n) for n in sums]


def grid_triangles(rows, columns, close_rows=False, close_columns=False):
    """Two triangles a cell of a rows x columns lattice of vertices, vertex (i, j) at i * columns + j."""
    triangles = []
    for i in range(rows if close_rows else rows - 1):
        for j in range(columns if close_columns else columns - 1):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            c, d = ((i + 1) % rows) * columns + j, ((i + 1) % rows) * columns + (j + 1) % columns
            triangles += [(a, c, b), (b, c, d)]
    return triangles


def torus_knot(p=2, q=3, radius=2.0, tube=0.62, along=320, around=24):
    """A tube along the (p, q) torus knot, its axis the y axis."""
    def centre(t):
        r = radius + 0.9 * math.cos(q * t)
        return (r * math.cos(p * t), 0.9 * math.sin(q * t), r * math.sin(p * t))

    positions = []
    for i in range(along):
        t = 2 * math.pi * i / along
        here, tangent = centre(t), unit(sub(centre(t + 1e-4), centre(t - 1e-4)))
        # A frame that the knot itself gives, so that it closes: away from the y axis' ring at this angle.
        ring = (radius * math.cos(p * t), 0.0, radius * math.sin(p * t))
        side = unit(cross(tangent, sub(here, ring)))
        up = cross(side, tangent)
        for j in range(around):
            angle = 2 * math.pi * j / around
            positions.append(tuple(h + tube * (math.cos(angle) * u + math.sin(angle) * s)
                                   for h, u, s in zip(here, up, side)))
    triangles = [(a, c, b) for a, b, c in grid_triangles(along, around, close_rows=True, close_columns=True)]
    return positions, smooth_normals(positions, triangles), triangles


def lathe(profile, around=72):
    """Turns a profile [(radius, y)] about the y axis; it begins and ends on the axis, so that the body is closed."""
    positions = [(0.0, profile[0][1], 0.0)]
    inner = profile[1:-1]
    for r, y in inner:
        for j in range(around):
            angle = 2 * math.pi * j / around
            positions.append((r * math.cos(angle), y, r * math.sin(angle)))
    positions.append((0.0, profile[-1][1], 0.0))
    last = len(positions) - 1
    body = [tuple(1 + i for i in t) for t in grid_triangles(len(inner), around, close_columns=True)]
    first_ring, last_ring = 1, 1 + (len(inner) - 1) * around
    caps = []
    for j in range(around):
        k = (j + 1) % around
        caps += [(0, first_ring + j, first_ring + k), (last, last_ring + k, last_ring + j)]
    triangles = caps + body
    return positions, smooth_normals(positions, triangles), triangles


def spline(points, steps):
    """A Catmull-Rom curve through the points, so that a few numbers make a smooth profile."""
    curve = []
    padded = [points[0], *points, points[-1]]
    for p0, p1, p2, p3 in zip(padded, padded[1:], padded[2:], padded[3:]):
        for k in range(steps):
            t = k / steps
            curve.append(tuple(
                0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - 3 * c + d - a) * t ** 3)
                for a, b, c, d in zip(p0, p1, p2, p3)))
    return curve + [points[-1]]


def goblet_inside():
    """The profile of a goblet's bowl from the rim down to the axis."""
    return [*spline([(1.42, 6.6), (1.7, 5.3), (1.6, 4.25), (1.0, 3.5), (0.35, 3.15)], 6), (0.0, 3.08)]


def goblet():
    """A wine glass of solid stem: foot, stem, outside of the bowl, rim, inside of the bowl."""
    outside = spline([(1.75, 0.0), (1.8, 0.1), (1.0, 0.32), (0.3, 0.75), (0.24, 1.8), (0.34, 2.6), (1.1, 3.25),
                      (1.75, 4.2), (1.85, 5.3), (1.55, 6.6)], 6)
    rim = [(1.53, 6.66), (1.48, 6.68), (1.43, 6.64)]
    return lathe([(0.0, 0.0), *outside, *rim, *goblet_inside()])


def vase():
    """A full-bodied closed vase, for solid glass and for metal-like surfaces."""
    return lathe([(0.0, 0.0), *spline([(1.2, 0.0), (1.3, 0.08), (1.55, 0.9), (2.1, 2.1), (2.2, 3.0), (1.7, 4.1), (0.85, 5.0),
                                       (0.7, 5.6), (0.95, 6.2), (1.2, 6.5)], 8), (1.1, 6.56), (0.0, 6.5)])


def gem(sides=8):
    """A cut stone with flat faces: table, crown, girdle, pavilion. Vertices are not shared, faces are flat."""
    def ring(r, y, turn):
        return [(r * math.cos(2 * math.pi * (j + turn) / sides), y, r * math.sin(2 * math.pi * (j + turn) / sides))
                for j in range(sides)]

    table, crown, girdle = ring(1.3, 1.0, 0), ring(2.0, 0.45, 0.5), ring(2.2, 0.0, 0)
    tip, top = (0.0, -2.2, 0.0), (0.0, 1.0, 0.0)
    faces = []
    for j in range(sides):
        k = (j + 1) % sides
        faces += [(top, table[k], table[j]), (table[j], table[k], crown[j]), (table[k], crown[k], crown[j]),
                  (crown[j], crown[k], girdle[k]), (crown[j], girdle[k], girdle[j]), (girdle[j], girdle[k], tip)]
    positions = [vertex for face in faces for vertex in face]
    return positions, None, [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(faces))]


def cloth(size=26.0, cells=72):
    """A waving ground: a height field over a square."""
    positions = []
    for i in range(cells + 1):
        for j in range(cells + 1):
            x, z = size * (j / cells - 0.5), size * (i / cells - 0.5)
            positions.append((x, 0.4 * math.sin(0.9 * x + 0.8 * math.sin(0.5 * z)), z))
    triangles = grid_triangles(cells + 1, cells + 1)
    return positions, smooth_normals(positions, triangles), triangles


def lattice(width=26.0, height=13.0, pitch=1.0, bar=0.09):
    """The bars of a grid in the plane z = 0: the `mesh background`. Boxes of one mesh, flat faces."""
    positions, triangles = [], []

    def box(low, high):
        base = len(positions)
        for corner in range(8):
            positions.append(tuple((high if corner >> k & 1 else low)[k] for k in range(3)))
        for quad in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            a, b, c, d = (base + i for i in quad)
            triangles.extend([(a, b, c), (a, c, d)])

    columns, rows = round(width / pitch), round(height / pitch)
    for i in range(columns + 1):
        x = -width / 2 + i * pitch
        box((x - bar / 2, 0.0, -bar / 2), (x + bar / 2, height, bar / 2))
    for j in range(rows + 1):
        y = j * pitch
        box((-width / 2, y - bar / 2, -bar / 2 - 0.02), (width / 2, y + bar / 2, bar / 2 + 0.02))
    return positions, None, triangles


def write_ply(path, positions, normals, triangles):
    """Binary little-endian PLY, single precision."""
    properties = ["x", "y", "z"] + (["nx", "ny", "nz"] if normals else [])
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(positions)}"]
    header += [f"property float {name}" for name in properties]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header", ""]
    rows = (p + n for p, n in zip(positions, normals)) if normals else positions
    path.write_bytes("\n".join(header).encode()
                     + b"".join(struct.pack(f"<{len(properties)}f", *row) for row in rows)
                     + b"".join(struct.pack("<B3i", 3, *triangle) for triangle in triangles))


def write_obj(path, positions, normals, triangles):
    """Wavefront OBJ; indices count from 1."""
    lines = ["v " + " ".join(f"{x:.4f}" for x in p) for p in positions]
    if normals:
        lines += ["vn " + " ".join(f"{x:.3f}" for x in n) for n in normals]
    corner = (lambda i: f"{i + 1}//{i + 1}") if normals else (lambda i: str(i + 1))
    lines += ["f " + " ".join(corner(i) for i in triangle) for triangle in triangles]
    path.write_text("\n".join(lines) + "\n")


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "lee"
    folder.mkdir(parents=True, exist_ok=True)
    write_ply(folder / "torus-knot.ply", *torus_knot())
    write_ply(folder / "goblet.ply", *goblet())
    write_ply(folder / "vase.ply", *vase())
    write_ply(folder / "lattice.ply", *lattice())
    write_obj(folder / "gem.obj", *gem())
    write_obj(folder / "cloth.obj", *cloth())


if __name__ == "__main__":
    main()
