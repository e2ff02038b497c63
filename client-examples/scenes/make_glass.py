#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes scenes of glass that touches things into a folder (default: glass/ beside this file): python3 make_glass.py

    goblet-on-table          a goblet with wine: its foot lies on the table, the wine on the inside of the bowl
    gem-on-table             cut stones that lie on one of their faces
    tumbler                  a thick glass with water and ice, of overlapping primitives: where bodies overlap the one with
                             the higher priority is there, so that a body of air hollows out the glass
    bottle-shared-wall       a bottle with oil whose surface is, up to its level, the inside of the bottle
    bottle-overlap           the same with oil that reaches into the glass, which counts more: the same picture

Nothing is moved apart: faces in one place are in optical contact. Units are cm. Standard library only; the same files
every time.
"""

import math
import pathlib
import sys

from make_figures import TRANSMITTANCES, lamp, matt, move, pretty, samples, sky, thing, turn
from make_meshes import gem, goblet, goblet_inside, lathe, spline, write_obj, write_ply

COLOURS = {
    **TRANSMITTANCES,
    "wine": [0.90, 0.55, 0.25, 0.08, 0.05, 0.10, 0.55, 0.93, 0.97, 0.98, 0.98],
    "oil": [0.30, 0.40, 0.60, 0.85, 0.95, 0.97, 0.97, 0.96, 0.95, 0.94, 0.94],
    "water": [0.998, 0.998, 0.998, 0.997, 0.996, 0.993, 0.985, 0.965, 0.96, 0.95, 0.94],
    "bottle": [0.88, 0.90, 0.93, 0.96, 0.975, 0.975, 0.965, 0.95, 0.94, 0.93, 0.92],
}


def body(ior, colour=None, thickness=1.0):
    """Something clear; `colour` is what `thickness` cm let through."""
    material = {"type": "hall", "reflectance": 1, "transmittance": 1, "k_sr": 0.04, "k_st": 0.96, "n": 400, "ior": ior}
    if colour:
        material["absorption"] = {"transmittance": colour, "thickness": thickness}
    return material


def scene(name, camera, colours, materials, objects):
    """Objects on a round table of wood before a wall."""
    return {
        "format": "bouguer-scene/1", "name": name, "units": "cm",
        "camera": {"type": "perspective", "fov_deg": 30, "resolution": [400, 480], **camera},
        "spectra": {c: samples(COLOURS[c]) for c in colours},
        "textures": {"planks": {"type": "grid", "line": {"srgb": [0.36, 0.25, 0.18]}, "ground": {"srgb": [0.66, 0.5, 0.36]},
                                "width": 0.03, "scale": 12}},
        "materials": {**materials, "wood": {"type": "hall", "reflectance": {"texture": "planks"}, "k_sr": 0.9, "n": 1},
                      "wall": matt(0.80, 0.79, 0.76)},
        "objects": [
            *objects,
            thing("table", {"type": "disk", "center": [0, 0, 0], "normal": [0, 1, 0], "radius": 14}, "wood"),
            thing("wall", {"type": "plane", "point": [0, 0, -14], "normal": [0, 0, 1]}, "wall"),
        ],
        "lights": [lamp([-9, 15, 9], 1.2), lamp([10, 12, 3], 0.5)],
        "environment": sky(4),
    }


def liquid(inside, level):
    """The profile of what fills a hollow up to a level. `inside`: [(radius, y)] from the opening down to the axis."""
    below = [(r, y) for r, y in inside if y < level]
    (r0, y0), (r1, y1) = next((a, b) for a, b in zip(inside, inside[1:]) if a[1] >= level > b[1])
    at_level = r0 + (r1 - r0) * (y0 - level) / (y0 - y1)
    return [*reversed(below), (at_level, level), (0.0, level)]


def corner(radius, r, y):
    """A quarter of a circle about (r, y), from below to the side."""
    return [(r + radius * math.sin(t), y - radius * math.cos(t)) for t in (math.pi / 2 * k / 8 for k in range(9))]


def oil(level, by):
    """The profile of what stands in the bottle; its wall reaches into the glass by so many cm."""
    return [(0.0, 0.4 - by), *corner(0.4 + by, 1.8, 0.8), (2.2 + by, level), (0.0, level)]


def bottle_glass():
    neck = [(0.85, 8.0), (0.8, 8.6), (0.8, 9.2)]
    outside = [*corner(0.4, 2.0, 0.4), *spline([(2.4, 4.2), (2.3, 5.2), (1.75, 6.2), (1.1, 7.1), *neck], 6)]
    inside = [(r - 0.2, y - 0.06) for r, y in spline([(2.4, 4.2), (2.3, 5.2), (1.75, 6.2), (1.1, 7.1), *neck], 6)]
    return [(0.0, 0.0), *outside, *reversed(inside), *reversed(corner(0.4, 1.8, 0.8)), (0.0, 0.4)]


def bottle(name, oil_file):
    return scene(name, {"from": [1, 9, 22], "at": [0, 4.2, 0]}, ["bottle", "oil"],
                 {"glass": {**body(1.52, "bottle"), "priority": 1}, "oil": body(1.47, "oil")},
                 [thing("bottle", {"type": "file", "path": "bottle.ply"}, "glass"),
                  thing("oil", {"type": "file", "path": oil_file}, "oil")])


def goblet_on_table():
    return scene("goblet on a table", {"from": [1, 8, 20], "at": [0, 3.2, 0]}, ["wine"],
                 {"glass": {**body(1.52), "priority": 1}, "wine": body(1.34, "wine")},
                 [thing("goblet", {"type": "file", "path": "goblet.ply"}, "glass"),
                  thing("wine", {"type": "file", "path": "wine.ply"}, "wine")])


def gem_on_table():
    """One stone on its table, one on a facet of its pavilion."""
    lies_on_facet = math.degrees(math.atan2(2.2, 2.2 * math.cos(math.pi / 8)))
    apothem = 2.2 * 2.2 * math.cos(math.pi / 8) / math.hypot(2.2, 2.2 * math.cos(math.pi / 8))
    return scene("stones on a table", {"from": [2, 9, 18], "at": [0, 1.2, 0]}, ["aqua", "amber"],
                 {"aquamarine": body(1.58, "aqua", 3), "topaz": body(1.62, "amber", 3)},
                 [thing("topaz", {"type": "file", "path": "gem.obj"}, "topaz", turn(180, (1, 0, 0)), move(-2.3, 1, 0.4)),
                  thing("aquamarine", {"type": "file", "path": "gem.obj"}, "aquamarine", turn(22.5),
                        turn(-lies_on_facet, (0, 0, 1)), turn(-60), move(2.2, apothem, 0.2))])


def tumbler():
    def cylinder(radius, low, high):
        return {"type": "cylinder", "from": [0, low, 0], "to": [0, high, 0], "radius": radius}

    return scene("tumbler of primitives", {"from": [1, 10, 20], "at": [0, 3.6, 0]}, ["water"],
                 {"glass": body(1.52), "air": {**body(1.0), "priority": 1}, "water": {**body(1.333, "water", 100), "priority": 2},
                  "ice": {**body(1.31), "priority": 3}},
                 [thing("glass", cylinder(3.0, 0, 8), "glass"), thing("hollow", cylinder(2.7, 0.7, 8), "air"),
                  thing("water", cylinder(2.7, 0.7, 5.6), "water"),
                  thing("ice", {"type": "box", "min": [-0.9, -0.9, -0.9], "max": [0.9, 0.9, 0.9]}, "ice",
                        turn(24), turn(17, (1, 0, 0.4)), move(-0.6, 5.1, 0.5))])


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "glass"
    folder.mkdir(exist_ok=True)
    write_ply(folder / "goblet.ply", *goblet())
    write_ply(folder / "bottle.ply", *lathe(bottle_glass()))
    write_obj(folder / "gem.obj", *gem())
    for liquid_name, profile in (("wine", liquid(goblet_inside(), 5.6)), ("oil", oil(3.6, 0)), ("wide-oil", oil(3.6, 0.1))):
        positions, _, triangles = lathe(profile)
        write_ply(folder / f"{liquid_name}.ply", positions, None, triangles)  # flat faces: its level meets its wall sharply
    scenes = {"goblet-on-table": goblet_on_table(), "gem-on-table": gem_on_table(), "tumbler": tumbler(),
              "bottle-shared-wall": bottle("bottle and oil that share a wall", "oil.ply"),
              "bottle-overlap": bottle("bottle and oil that overlap", "wide-oil.ply")}
    for name, made in scenes.items():
        (folder / f"{name}.json").write_text(pretty(made) + "\n")


if __name__ == "__main__":
    main()
