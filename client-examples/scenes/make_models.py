#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes vase-*.json into a folder (default: lee/ beside this file): one vase in every model of reflection that the seed
paper names, in the same light. Run make_meshes.py first. Standard library only.

The copper vases are what the paper tells of Cook: a metal whose highlight shifts its colour. The glass vases are Hall's
model, as it was and as the paper improves it.
"""

import pathlib
import sys

from make_figures import glass, lamp, matt, move, pretty, quad, sky, spectra, thing, tiles

COPPER = {"hex": "#c98963"}  # about the colour that copper has in daylight

MODELS = {
    "phong": {"type": "phong", "diffuse": COPPER, "k_d": 0.5, "k_s": 0.5, "n": 30},
    "blinn": {"type": "blinn", "diffuse": COPPER, "k_d": 0.5, "k_s": 1, "c3": 0.25, "ior": 2.5},
    "cook-torrance": {"type": "cook_torrance", "metal": "Cu", "k_s": 0.5, "m": 0.35},
    "hall-greenberg": {"type": "hall_greenberg", "diffuse": COPPER, "k_dr": 0.25, "metal": "Cu", "k_sr": 0.75, "n": 30},
    "hall-greenberg-glass": {"type": "hall_greenberg", "transmittance": "cobalt", "k_sr": 1, "k_st": 1, "ior": "N-BK7",
                             "n": 200},
    "hall": glass("cobalt", False),
    "improved-hall": glass("cobalt", True),
}


def vase(model):
    """The constant ambient term of older models stands where the paper's improvement does not."""
    is_improved = model == "improved-hall"
    is_glass = "transmittance" in MODELS[model]
    scene = {
        "format": "bouguer-scene/1", "name": f"vase: {model}", "units": "cm",
        "camera": {"type": "perspective", "from": [1, 6.2, 17], "at": [0, 3.1, 0], "fov_deg": 27, "resolution": [360, 480]},
        "spectra": spectra("cobalt", absorbs=is_improved),
        "materials": {"vase": MODELS[model], "light tile": matt(0.80, 0.78, 0.74), "dark tile": matt(0.36, 0.38, 0.42),
                      "backdrop": matt(0.62, 0.60, 0.56)},
        "objects": [
            thing("light tiles", tiles(0, 1.5, (-12, -9), (12, 12)), "light tile"),
            thing("dark tiles", tiles(1, 1.5, (-12, -9), (12, 12)), "dark tile"),
            thing("backdrop", quad([-16, 0, -9], [16, 0, -9], [16, 15, -9], [-16, 15, -9]), "backdrop"),
            thing("vase", {"type": "file", "path": "vase.ply"}, "vase", move(0, 0.02, 0)),
        ],
        "lights": [lamp([-9, 12, 9], 1.0), lamp([10, 9, 4], 0.5)],
        "environment": sky(6),
        "ambient": {"k_a": 0.15, "weights": "hemisphere" if is_improved else "constant"},
    }
    if not is_glass:
        del scene["spectra"]
    return scene


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "lee"
    for model in MODELS:
        (folder / f"vase-{model}.json").write_text(pretty(vase(model)) + "\n")


if __name__ == "__main__":
    main()
