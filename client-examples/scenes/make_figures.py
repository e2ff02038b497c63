#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes figure-4a.json to figure-4f.json into a folder (default: lee/ beside this file): the figures of the seed
paper [Lee et al.] as scenes of ours.

4(a) to 4(d) are one scene; what differs is the shading model, so one function makes them:

    4(a) by RGB triples (render it with the integrator `rgb`)    4(b) by spectra, no absorption
    4(c) with Bouguer-Beer absorption                            4(d) with the neighbours' ambient light, too

4d-explicit and 4d-constant are 4(d) with the weights of equation 2 given by hand, the same at every point, and with the
constant ambient term that it replaces.
4(e) and 4(f) show meshes and primitives together over a mesh background; run make_meshes.py first.
The numbers of the paper's Table 1 stand in glass() and lamp(). Standard library only.
"""

import json
import math
import pathlib
import sys

WAVELENGTHS_NM = [400, 430, 460, 490, 520, 550, 580, 610, 640, 670, 700]
# Spectral transmittances of coloured glasses, smooth as measured filters are.
TRANSMITTANCES = {
    "amber": [0.10, 0.14, 0.22, 0.36, 0.58, 0.80, 0.92, 0.96, 0.97, 0.97, 0.97],
    "ruby": [0.42, 0.36, 0.26, 0.17, 0.13, 0.15, 0.34, 0.76, 0.93, 0.96, 0.97],
    "emerald": [0.22, 0.32, 0.52, 0.78, 0.91, 0.88, 0.66, 0.38, 0.24, 0.22, 0.28],
    "cobalt": [0.93, 0.95, 0.93, 0.80, 0.56, 0.34, 0.22, 0.20, 0.26, 0.40, 0.55],
    "aqua": [0.60, 0.74, 0.88, 0.95, 0.93, 0.80, 0.54, 0.32, 0.24, 0.22, 0.24],
    "violet": [0.90, 0.88, 0.78, 0.60, 0.42, 0.36, 0.44, 0.64, 0.82, 0.90, 0.93],
}

# Equation 2 with k_i by hand: about what each wall and floor covers of the hemisphere in the middle of the room.
WEIGHTS = {"light tiles": 0.22, "dark tiles": 0.22, "back wall": 0.14, "left wall": 0.13, "right wall": 0.13}


def samples(values):
    return {"wavelengths_nm": WAVELENGTHS_NM, "values": values}


def spectra(*names, absorbs=True):
    """The glasses' own colours; `<name>-unit`, of those that absorb, is what one unit of thickness lets through, 95 % at
    its best."""
    made = {}
    for name in names:
        values = TRANSMITTANCES[name]
        made[name] = samples(values)
        if not absorbs:
            continue
        # Table 1: a Bouguer-Beer factor of 95 % per unit thickness, here at the colour's clearest wavelength.
        made[f"{name}-unit"] = samples([round(0.95 * (v / max(values)) ** 0.3, 4) for v in values])
    return made


def glass(name, absorbs):
    """Table 1: k_st 0.9, k_sr 0.1, n' 20, index of refraction 1.3."""
    material = {"type": "hall", "reflectance": 1, "transmittance": name, "k_sr": 0.1, "k_st": 0.9, "n": 20, "ior": 1.3}
    if absorbs:
        material["absorption"] = {"transmittance": f"{name}-unit", "thickness": 1}
    return material


def matt(*srgb, k_sr=0.8):
    return {"type": "hall", "reflectance": {"srgb": list(srgb)}, "k_sr": k_sr, "n": 1}


def lamp(position, scale):
    """Table 1: illuminant D65."""
    return {"type": "point", "position": position, "intensity": {"spectrum": "D65", "scale": scale}}


def sky(scale):
    return {"type": "constant", "radiance": {"spectrum": "D65", "scale": scale}}


def tiles(parity, size, low, high):
    """Every second square of a floor at y = 0 between the corners `low` and `high`, as one mesh."""
    positions, triangles = [], []
    columns, rows = round((high[0] - low[0]) / size), round((high[1] - low[1]) / size)
    for i in range(rows):
        for j in range(columns):
            if (i + j) % 2 != parity:
                continue
            x, z, base = low[0] + j * size, low[1] + i * size, len(positions)
            positions += [[x, 0, z], [x, 0, z + size], [x + size, 0, z + size], [x + size, 0, z]]
            triangles += [[base, base + 1, base + 2], [base, base + 2, base + 3]]
    return {"type": "mesh", "positions": positions, "triangles": triangles}


def quad(a, b, c, d):
    return {"type": "mesh", "positions": [a, b, c, d], "triangles": [[0, 1, 2], [0, 2, 3]]}


def thing(name, shape, material, *steps):
    made = {"name": name, "shape": shape, "material": material}
    if steps:
        made["transform"] = list(steps)
    return made


def move(x, y, z):
    return {"translate": [x, y, z]}


def turn(angle_deg, axis=(0, 1, 0)):
    return {"rotate": {"axis": list(axis), "angle_deg": angle_deg}}


def still_life(name, absorbs, weights=None):
    """Figures 4(a) to 4(d): coloured glass in the corner of a room with two coloured walls."""
    glasses = ["amber", "ruby", "emerald", "cobalt"]
    scene = {
        "format": "bouguer-scene/1", "name": name, "units": "cm",
        "camera": {"type": "perspective", "from": [0.5, 13, 23], "at": [0, 1.6, 0.3], "up": [0, 1, 0], "fov_deg": 31,
                   "resolution": [640, 480]},
        "spectra": spectra(*glasses, absorbs=absorbs),
        "materials": {**{g: glass(g, absorbs) for g in glasses},
                      "light tile": matt(0.93, 0.91, 0.87), "dark tile": matt(0.42, 0.44, 0.48),
                      "plaster": matt(0.92, 0.91, 0.89), "red wall": matt(0.85, 0.33, 0.22),
                      "blue wall": matt(0.20, 0.47, 0.75)},
        "objects": [
            thing("light tiles", tiles(0, 2, (-10, -8), (10, 18)), "light tile"),
            thing("dark tiles", tiles(1, 2, (-10, -8), (10, 18)), "dark tile"),
            thing("back wall", quad([-10, 0, -8], [10, 0, -8], [10, 14, -8], [-10, 14, -8]), "plaster"),
            thing("left wall", quad([-10, 0, 18], [-10, 0, -8], [-10, 14, -8], [-10, 14, 18]), "red wall"),
            thing("right wall", quad([10, 0, -8], [10, 0, 18], [10, 14, 18], [10, 14, -8]), "blue wall"),
            thing("amber ball", {"type": "sphere", "center": [-3.4, 2.7, -1.2], "radius": 2.7}, "amber"),
            thing("emerald column", {"type": "cylinder", "from": [3.1, 0.001, -3.6], "to": [3.1, 6.4, -3.6], "radius": 1.5},
                  "emerald"),
            thing("cobalt block", {"type": "box", "min": [-1.35, 0.001, -1.35], "max": [1.35, 2.7, 1.35]}, "cobalt",
                  turn(28), move(2.7, 0, 2.4)),
            thing("ruby ball", {"type": "sphere", "center": [-0.9, 1.35, 4.1], "radius": 1.35}, "ruby"),
            thing("plaster ball", {"type": "sphere", "center": [6.9, 1.6, 0.2], "radius": 1.6}, "plaster"),
            thing("small plaster ball", {"type": "sphere", "center": [-7.4, 1.1, 2.6], "radius": 1.1}, "plaster"),
        ],
        "lights": [lamp([9, 13.5, 3.5], 1.0), lamp([-7, 12, 11], 0.25)],
        "environment": sky(2),
    }
    if weights:
        scene["ambient"] = {"k_a": 0.08, "weights": weights}
    return scene


def meshes_e():
    """Figure 4(e): a knot and a goblet of glass with primitives, before a lattice, on a waving ground."""
    glasses = ["aqua", "ruby", "amber"]
    return {
        "format": "bouguer-scene/1", "name": "Lee et al., figure 4(e)", "units": "cm",
        "camera": {"type": "perspective", "from": [0, 7.5, 21], "at": [0, 3.0, 0], "up": [0, 1, 0], "fov_deg": 32,
                   "resolution": [640, 480]},
        "spectra": spectra(*glasses),
        "materials": {**{g: glass(g, True) for g in glasses},
                      "ground": matt(0.70, 0.60, 0.50), "backdrop": matt(0.50, 0.60, 0.72), "bars": matt(0.93, 0.92, 0.90)},
        "objects": [
            thing("ground", {"type": "file", "path": "cloth.obj"}, "ground"),
            thing("backdrop", quad([-14, -1, -8], [14, -1, -8], [14, 15, -8], [-14, 15, -8]), "backdrop"),
            thing("lattice", {"type": "file", "path": "lattice.ply"}, "bars", move(0, 0, -7.2)),
            thing("knot", {"type": "file", "path": "torus-knot.ply"}, "aqua", turn(68, (1, 0, 0)), turn(15), move(-2.6, 4.0, 0)),
            thing("goblet", {"type": "file", "path": "goblet.ply"}, "amber", move(3.5, 0.45, -0.6)),
            thing("ruby ball", {"type": "sphere", "center": [1.3, 1.5, 3.8], "radius": 1.2}, "ruby"),
        ],
        "lights": [lamp([8, 10, 2], 1.0), lamp([-8, 12, 12], 0.4)],
        "environment": sky(1.5),
        "ambient": {"k_a": 0.08, "weights": "hemisphere"},
    }


def meshes_f():
    """Figure 4(f): a vase and cut stones of glass with a column, over a floor of tiles before a lattice."""
    glasses = ["cobalt", "emerald", "violet", "amber"]
    return {
        "format": "bouguer-scene/1", "name": "Lee et al., figure 4(f)", "units": "cm",
        "camera": {"type": "perspective", "from": [-4, 8, 20], "at": [0, 2.8, 0], "up": [0, 1, 0], "fov_deg": 32,
                   "resolution": [640, 480]},
        "spectra": spectra(*glasses),
        "materials": {**{g: glass(g, True) for g in glasses},
                      "light tile": matt(0.80, 0.76, 0.70), "dark tile": matt(0.50, 0.28, 0.20),
                      "backdrop": matt(0.86, 0.80, 0.66), "bars": matt(0.35, 0.33, 0.32)},
        "objects": [
            thing("light tiles", tiles(0, 1.5, (-15, -9), (15, 15)), "light tile"),
            thing("dark tiles", tiles(1, 1.5, (-15, -9), (15, 15)), "dark tile"),
            thing("backdrop", quad([-16, 0, -9], [16, 0, -9], [16, 15, -9], [-16, 15, -9]), "backdrop"),
            thing("lattice", {"type": "file", "path": "lattice.ply"}, "bars", move(0, 0, -8.6)),
            thing("vase", {"type": "file", "path": "vase.ply"}, "cobalt", move(-2.6, 0.02, -1)),
            thing("column", {"type": "cylinder", "from": [4.4, 0.001, -3], "to": [4.4, 5, -3], "radius": 1.2}, "violet"),
            thing("emerald", {"type": "file", "path": "gem.obj"}, "emerald", turn(-45.7, (0, 0, 1)), turn(20), move(2.3, 1.55, 2.2)),
            thing("topaz", {"type": "file", "path": "gem.obj"}, "amber", {"scale": 0.6}, turn(-45.7, (0, 0, 1)), turn(130),
                  move(-0.6, 0.93, 4.6)),
        ],
        "lights": [lamp([-10, 17, 1], 1.0), lamp([10, 10, 12], 0.3)],
        "environment": sky(1.5),
        "ambient": {"k_a": 0.08, "weights": "hemisphere"},
    }


def pretty(value, indent=0, width=110):
    """JSON with an object or list on one line where it fits."""
    line = json.dumps(value)
    if len(line) + indent <= width or not isinstance(value, (dict, list)) or not value:
        return line
    inside, outside = " " * (indent + 2), " " * indent
    if isinstance(value, dict):
        rows = [f"{json.dumps(k)}: {pretty(v, indent + 2)}" for k, v in value.items()]
        return "{\n" + ",\n".join(inside + row for row in rows) + f"\n{outside}}}"
    if not any(isinstance(row, dict) for row in value):
        per_line = max(1, math.floor((width - indent) / (max(len(json.dumps(row)) for row in value) + 2)))
        rows = [", ".join(json.dumps(row) for row in value[i:i + per_line]) for i in range(0, len(value), per_line)]
    else:
        rows = [pretty(row, indent + 2) for row in value]
    return "[\n" + ",\n".join(inside + row for row in rows) + f"\n{outside}]"


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "lee"
    figures = {
        "4a": still_life("Lee et al., figure 4(a): by RGB triples", False),
        "4b": still_life("Lee et al., figure 4(b): by spectra", False),
        "4c": still_life("Lee et al., figure 4(c): with Bouguer-Beer absorption", True),
        "4d": still_life("Lee et al., figure 4(d): with the neighbours' ambient light", True, "hemisphere"),
        "4d-explicit": still_life("Figure 4(d) with weights by hand", True, WEIGHTS),
        "4d-constant": still_life("Figure 4(d) with a constant ambient term", True, "constant"),
        "4e": meshes_e(),
        "4f": meshes_f(),
    }
    for name, scene in figures.items():
        (folder / f"figure-{name}.json").write_text(pretty(scene) + "\n")


if __name__ == "__main__":
    main()
