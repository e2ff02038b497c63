#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a scene and the picture that it names: python3 make_textures.py [FOLDER] (default: textures/ beside this file).

An image, a chequerboard and a grid, on what is reflected, what goes through and what shines. Standard library only; the
same files every time.
"""

import json
import pathlib
import struct
import sys
import zlib

SIDE = 64


def poster(x, y):
    """The 8-bit colour at column x, row y from the top: an F, so that it is seen which way is up, on a field that goes
    from blue on the left to orange on the right, within a white frame."""
    if min(x, y, SIDE - 1 - x, SIDE - 1 - y) < 3:
        return 240, 240, 240
    stem = 16 <= x < 24 and 12 <= y < 52
    arms = 24 <= x < 48 and 12 <= y < 20 or 24 <= x < 40 and 28 <= y < 36
    if stem or arms:
        return 30, 30, 35
    share = x / (SIDE - 1)
    return tuple(round(a + share * (b - a)) for a, b in ((50, 235), (90, 130), (200, 30)))


def png(pixels):
    """The bytes of an 8-bit RGB file of at most 64 KiB; pixels: rows of triples. One stored block: compressors differ."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + bytes(value for pixel in row for value in pixel) for row in pixels)
    header = struct.pack(">IIBBBBB", len(pixels[0]), len(pixels), 8, 2, 0, 0, 0)
    stored = b"\x78\x01\x01" + struct.pack("<HH", len(rows), len(rows) ^ 0xFFFF) + rows + struct.pack(">I", zlib.adler32(rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", stored) + chunk(b"IEND", b"")


def quad(left, bottom, width, height, z):
    """An upright rectangle that faces +z, with u to the right and v up."""
    right, top = left + width, bottom + height
    return {"type": "mesh", "positions": [[left, bottom, z], [right, bottom, z], [right, top, z], [left, top, z]],
            "uvs": [[0, 0], [1, 0], [1, 1], [0, 1]], "triangles": [[0, 1, 2], [0, 2, 3]]}


def scene():
    return {
        "format": "bouguer-scene/1", "name": "textures", "units": "m",
        "camera": {"type": "perspective", "from": [0, 2.2, 9], "at": [0, 1.4, 0], "fov_deg": 36, "resolution": [640, 400]},
        "textures": {
            "poster": {"type": "image", "path": "poster.png"},
            "tiles": {"type": "grid", "line": 0.15, "ground": {"srgb": [0.85, 0.83, 0.8]}, "width": 0.06},
            "board": {"type": "checker", "a": {"srgb": [0.75, 0.12, 0.1]}, "b": 0.9, "scale": [8, 4]},
            "blind": {"type": "checker", "a": 0.95, "b": {"srgb": [0.1, 0.5, 0.2]}, "scale": 3, "rotate_deg": 45},
        },
        "materials": {
            "wall": {"type": "hall", "reflectance": {"texture": "poster"}, "k_sr": 0.9},
            "floor": {"type": "hall", "reflectance": {"texture": "tiles"}, "k_sr": 0.8},
            "ball": {"type": "hall", "reflectance": {"texture": "board"}, "k_sr": 0.9},
            "pane": {"type": "hall", "transmittance": {"texture": "blind"}, "k_sr": 0.05, "k_st": 0.95, "mirror": False},
            "screen": {"type": "hall", "reflectance": 0.05, "k_sr": 1,
                       "emission": {"texture": "poster", "times": {"spectrum": "D65", "scale": 0.6}}},
        },
        "objects": [
            {"name": "floor", "shape": {"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}, "material": "floor"},
            {"name": "poster", "shape": quad(-3.3, 0.3, 2.4, 2.4, -1.5), "material": "wall"},
            {"name": "screen", "shape": quad(0.9, 0.3, 2.4, 2.4, -1.5), "material": "screen"},
            {"name": "pane", "shape": quad(1.5, 0.05, 1.4, 1.4, 0.8), "material": "pane"},
            {"name": "ball", "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 0.9}, "material": "ball",
             "transform": [{"translate": [-0.3, 0.9, 0.6]}]},
        ],
        "lights": [{"type": "point", "position": [-3, 6, 7], "intensity": {"spectrum": "D65", "scale": 60}}],
        "ambient": {"k_a": 0.2, "weights": "hemisphere"},
    }


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "textures"
    folder.mkdir(exist_ok=True)
    (folder / "poster.png").write_bytes(png([[poster(x, y) for x in range(SIDE)] for y in range(SIDE)]))
    (folder / "textures.json").write_text(json.dumps(scene(), indent=1) + "\n")


if __name__ == "__main__":
    main()
