#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the scenes of known colour into a folder (default: colour/ beside this file). Their colours can be computed without
a ray, so they show whether the renderer's numbers are right (tests/accuracy, and the page /docs/colour):

    colorchecker-<illuminant>.json   the chart's 24 patches, lit straight on: radiance is reflectance x illuminant
    metamers-<illuminant>.json       two tiles that are one colour under D65 and two under A
    wedge-law.json                   1, 2, 3, 5 and 10 mm of amber glass, seen straight on; its index is 1: nothing but absorption
    wedge.json                       the same thicknesses as a stepped wedge that looks like glass: index 1.5, a lamp behind
    still-life-F11.json              figure 4(d) of the paper under a fluorescent lamp, whose light comes in narrow bands

Standard library only; colour-matching functions and illuminants come from the renderer's own tables.
"""

import json
import pathlib
import sys

import make_figures
from make_figures import matt, move, pretty, quad, thing

TABLES = pathlib.Path(__file__).resolve().parents[2] / "renderer" / "spectrum" / "data"

# As on the chart: four rows of six, from the top left.
PATCHES = """
dark-skin light-skin blue-sky foliage blue-flower bluish-green
orange purplish-blue moderate-red purple yellow-green orange-yellow
blue green red yellow magenta cyan
white-9.5 neutral-8 neutral-6.5 neutral-5 neutral-3.5 black-2
""".split()
THICKNESSES_MM = [1, 2, 3, 5, 10]
GLASS = "ILA400"  # amber at 1 mm, dark red at 10: the colour turns with the thickness


def diffuse(spectrum):
    """With k_sr 1 and n' 1 a surface under light straight on has the radiance reflectance x irradiance: (L.N) is 1."""
    return {"type": "hall", "reflectance": spectrum, "k_sr": 1, "n": 1}


def straight_on(height, resolution):
    """Looks along -z, without perspective: every pixel of a face shows the same."""
    return {"type": "orthographic", "from": [0, 0, 100], "at": [0, 0, 0], "height": height, "resolution": resolution}


def light_along_view(illuminant):
    return [{"type": "directional", "direction": [0, 0, -1], "irradiance": illuminant}]


def card(x0, y0, x1, y1, z=0):
    """A rectangle that faces the camera of straight_on()."""
    return quad([x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z])


# ---- the chart ----


def colorchecker(illuminant):
    """Patches 4 cm wide every 4.5 cm on a black board of 28.5 x 19.5 cm."""
    objects = [thing("board", card(-14.25, -9.75, 14.25, 9.75, -0.1), "board")]
    for i, patch in enumerate(PATCHES):
        x, y = -13.25 + 4.5 * (i % 6), 8.75 - 4.5 * (i // 6)
        objects.append(thing(patch, card(x, y - 4, x + 4, y), patch))
    return {
        "format": "bouguer-scene/1", "name": f"ColorChecker under {illuminant}", "units": "cm",
        "camera": straight_on(19.5, [570, 390]),
        "materials": {"board": diffuse(0.02), **{p: diffuse(f"ColorChecker-{p}") for p in PATCHES}},
        "objects": objects, "lights": light_along_view(illuminant),
    }


# ---- metamers ----


def read_columns(table, *names):
    """Columns of one of the renderer's tables as functions of the wavelength, linear between its rows."""
    lines = [line for line in (TABLES / table).read_text().splitlines() if not line.startswith("#")]
    heading, rows = lines[0].split(","), [[float(x) for x in line.split(",")] for line in lines[1:]]
    wavelengths = [row[0] for row in rows]
    return [linear(wavelengths, [row[heading.index(name)] for row in rows]) for name in names]


def linear(wavelengths, values):
    def at(w):
        if w <= wavelengths[0]:
            return values[0]
        for i in range(1, len(wavelengths)):
            if w <= wavelengths[i]:
                t = (w - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1])
                return (1 - t) * values[i - 1] + t * values[i]
        return values[-1]
    return at


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def without(vector, directions):
    """What is left of a vector once its parts along orthogonal directions are taken off."""
    for d in directions:
        share = dot(vector, d) / dot(d, d)
        vector = [x - share * y for x, y in zip(vector, d)]
    return vector


def tristimulus_weights(nodes, illuminant, observer):
    """Three vectors: what a reflectance of 1 at each node (linear between them, as the renderer has it) adds to X, Y, Z."""
    weights = [[0.0] * len(nodes) for _ in observer]
    hats = [linear(nodes, [float(i == j) for i in range(len(nodes))]) for j in range(len(nodes))]
    for w in range(360, 831):
        light = illuminant(w)
        for row, bar in zip(weights, observer):
            for j, hat in enumerate(hats):
                row[j] += light * bar(w) * hat(w)
    return weights


def metamers(nodes):
    """A grey, and the same plus a metameric black: a spectrum that D65 gives no X, Y or Z. Of all of them it is the one along
    which illuminant A sees most change of X for its size: A's weights for X, less their parts along D65's three."""
    observer = read_columns("observer_cie_1931_2.csv", "x", "y", "z")
    [d65], [a] = read_columns("illuminants_daylight.csv", "D65"), read_columns("illuminants_a_e.csv", "A")
    unseen = []  # D65's weights, made orthogonal
    for row in tristimulus_weights(nodes, d65, observer):
        unseen.append(without(row, unseen))
    black = without(tristimulus_weights(nodes, a, observer)[0], unseen)
    size = max(abs(x) for x in black)
    grey, depth = 0.4, 0.35
    return grey, [round(grey + depth * x / size, 5) for x in black]


def two_tiles(illuminant):
    nodes = list(range(390, 731, 10))
    plain, other = metamers(nodes)
    return {
        "format": "bouguer-scene/1", "name": f"A metameric pair under {illuminant}", "units": "cm",
        "camera": straight_on(11, [320, 220]),
        "spectra": {"grey": plain, "its metamer": {"first_nm": nodes[0], "step_nm": nodes[1] - nodes[0], "values": other}},
        "materials": {"board": diffuse(0.02), "left": diffuse("grey"), "right": diffuse("its metamer")},
        "objects": [thing("board", card(-8, -5.5, 8, 5.5, -0.1), "board"),
                    thing("left tile", card(-7, -4.5, 0, 4.5), "left"), thing("right tile", card(0, -4.5, 7, 4.5), "right")],
        "lights": light_along_view(illuminant),
    }


# ---- glass of 1, 2, 3, 5 and 10 mm ----


def absorbing_glass(ior, k_sr):
    return {"type": "hall", "reflectance": 1, "transmittance": 1, "k_sr": k_sr, "k_st": 1 - k_sr, "n": 20, "ior": ior,
            "absorption": {"transmittance": GLASS, "thickness": 1}}


def wedge_law():
    """A bare environment behind plates that neither bend nor reflect: what arrives is t^d times its radiance."""
    plates = [thing(f"{d} mm", {"type": "box", "min": [10 * i - 25, -5, -d], "max": [10 * i - 15, 5, 0]}, "glass")
              for i, d in enumerate(THICKNESSES_MM)]
    return {
        "format": "bouguer-scene/1", "name": "1, 2, 3, 5 and 10 mm of amber glass without faces", "units": "mm",
        "camera": straight_on(20, [300, 100]), "materials": {"glass": absorbing_glass(1, 0)},
        "objects": plates, "environment": {"type": "constant", "radiance": "D65"},
    }


def staircase(width, height):
    """A closed mesh: steps as thick as THICKNESSES_MM, each `width` wide and `height` high, upright with a flat back in z = 0."""
    outline = [[0, 0]]  # x, z from the thin end along the steps; all of it can be seen from the last corner
    for i, d in enumerate(THICKNESSES_MM):
        outline += [[i * width, d], [(i + 1) * width, d]]
    outline.append([len(THICKNESSES_MM) * width, 0])
    n = len(outline)
    triangles = []
    for i in range(n):
        j = (i + 1) % n
        triangles += [[i, j, n + j], [i, n + j, n + i]]
        if n - 1 not in (i, j):
            triangles += [[n - 1, j, i], [2 * n - 1, n + i, n + j]]
    return {"type": "mesh", "positions": [[x, y, z] for y in (0, height) for x, z in outline], "triangles": triangles}


def wedge():
    """On a white table between two lamps: the one behind throws the five colours forward onto the table."""
    width, height = 9, 22
    lines = [thing(f"line {i}", card(-200, y, 200, y + 1.2, -109.9), "ink") for i, y in enumerate(range(4, 140, 9))]
    return {
        "format": "bouguer-scene/1", "name": "A stepped wedge of amber glass", "units": "mm",
        "camera": {"type": "perspective", "from": [-30, 48, 95], "at": [0, 8, 4], "up": [0, 1, 0], "fov_deg": 30,
                   "resolution": [640, 440]},
        "materials": {"glass": absorbing_glass(1.5, 0.06), "table": matt(0.88, 0.88, 0.88), "paper": matt(0.93, 0.93, 0.91),
                      "ink": matt(0.2, 0.22, 0.25)},
        "objects": [thing("table", {"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}, "table"),
                    thing("paper", card(-200, 0, 200, 140, -110), "paper"), *lines,
                    thing("wedge", staircase(width, height), "glass", move(-2.5 * width, 0.01, 0))],
        "lights": [{"type": "point", "position": [6, 52, -44], "intensity": {"spectrum": "D65", "scale": 0.006}},
                   {"type": "point", "position": [-60, 90, 80], "intensity": {"spectrum": "D65", "scale": 0.0012}}],
        "environment": {"type": "constant", "radiance": {"spectrum": "D65", "scale": 0.05}},
    }


# ---- figure 4(d) under another lamp ----


def under(scene, illuminant):
    """The scene with every D65 in it replaced."""
    text = json.dumps(scene)
    return json.loads(text.replace('"D65"', f'"{illuminant}"'))


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "colour"
    still_life = make_figures.still_life("Figure 4(d) under a fluorescent lamp", True, "hemisphere")
    scenes = {f"colorchecker-{i}": colorchecker(i) for i in ("D65", "D50", "A", "F11")}
    scenes.update({f"metamers-{i}": two_tiles(i) for i in ("D65", "A")})
    scenes.update({"wedge": wedge(), "wedge-law": wedge_law(), "still-life-F11": under(still_life, "F11")})
    folder.mkdir(parents=True, exist_ok=True)
    for name, scene in scenes.items():
        (folder / f"{name}.json").write_text(pretty(scene) + "\n")


if __name__ == "__main__":
    main()
