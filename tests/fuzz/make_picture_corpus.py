#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes small pictures and ICC profiles of every kind into a folder, for image_decode_fuzz.

    tests/fuzz/make_picture_corpus.py FOLDER

Needs Pillow for JPEG and profiles, and oiiotool (openimageio-tools) for OpenEXR.
"""
import io
import pathlib
import struct
import subprocess
import sys
import zlib

from PIL import Image, ImageCms


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(width, height, depth, colour_type, chunks=(), interlaced=0):
    """A picture of one byte over and over."""
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[colour_type]
    row = 1 + (width * channels * depth + 7) // 8
    palette = [chunk(b"PLTE", bytes(range(12)))] if colour_type == 3 else []
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, colour_type, 0, 0, interlaced))
            + b"".join(chunk(*c) for c in chunks) + b"".join(palette)
            + chunk(b"IDAT", zlib.compress(bytes(row * height))) + chunk(b"IEND", b""))


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    profiles = {"srgb": ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()}
    files = {f"{name}.icc": data for name, data in profiles.items()}
    exif = b"MM\0*\0\0\0\x08\0\1\1\x12\0\3\0\0\0\1\0\6\0\0\0\0\0\0"
    said = {
        "gama": [(b"gAMA", struct.pack(">I", 45455))],
        "chrm": [(b"cHRM", struct.pack(">8I", 31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000))],
        "srgb": [(b"sRGB", b"\0")],
        "cicp": [(b"cICP", bytes([12, 13, 0, 1]))],
        "iccp": [(b"iCCP", b"p\0\0" + zlib.compress(profiles["srgb"], 0))],
        "exif": [(b"eXIf", exif)],
    }
    for name, chunks in said.items():
        files[f"{name}.png"] = png(3, 2, 8, 2, chunks)
    for depth, colour_type in [(1, 0), (8, 0), (16, 0), (16, 2), (2, 3), (8, 4), (16, 6)]:
        files[f"kind-{depth}-{colour_type}.png"] = png(3, 2, depth, colour_type)
    files["interlaced.png"] = png(5, 5, 8, 2, interlaced=1)
    colours = Image.new("RGB", (17, 9), (200, 100, 50))
    for name, picture, options in [
        ("plain", colours, {}), ("progressive", colours, {"progressive": True}), ("grey", colours.convert("L"), {}),
        ("cmyk", colours.convert("CMYK"), {}), ("profile", colours, {"icc_profile": profiles["srgb"]}),
        ("exif", colours, {"exif": b"Exif\0\0" + exif}), ("restarts", colours, {"restart_marker_blocks": 1}),
    ]:
        out = io.BytesIO()
        picture.save(out, "JPEG", **options)
        files[f"{name}.jpg"] = out.getvalue()
    for name, data in files.items():
        (folder / name).write_bytes(data)
    for name, options in [
        ("none", []), ("zip", ["--compression", "zip"]), ("piz", ["--compression", "piz"]), ("rle", ["--compression", "rle"]),
        ("b44", ["--compression", "b44"]), ("dwaa", ["--compression", "dwaa"]), ("pxr24", ["--compression", "pxr24"]),
        ("tiled", ["--tile", "8", "8"]),
        ("p3", ["--attrib:type=float[8]", "chromaticities", ".68,.32,.265,.69,.15,.06,.3127,.329"]),
    ]:
        subprocess.run(["oiiotool", "--pattern", "constant:color=.2,.3,.4", "9x7", "3", "-d", "half", *options, "-o",
                        str(folder / f"{name}.exr")], check=True)


main()
