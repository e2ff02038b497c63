#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the tables of this folder again. The build and the programs read the tables only, never Python.

    python3 -m venv venv && venv/bin/pip install colour-science==0.4.7 numpy scipy
    venv/bin/python make_data.py

A table: comment lines `# name | description | source`, one a column; a heading; then one row a wavelength. To add a
spectrum, add it here (a column of a table, or a table and its name in ../CMakeLists.txt).
"""

from pathlib import Path

import colour
import numpy as np
from colour.colorimetry import SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES as D_SERIES

COLOUR_VERSION = "0.4.7"
HERE = Path(__file__).parent


def number(x):
    """Shortest text that reads back as the value, after the rounding noise of Python's arithmetic is cut."""
    return f"{float(x):.10g}"


def write_table(filename, wavelengths_nm, columns):
    """columns: (name, description, source, values), values one a wavelength."""
    lines = [f"# Made by make_data.py from colour-science {COLOUR_VERSION}."]
    lines += [f"# {name} | {description} | {source}" for name, description, source, _ in columns]
    lines.append(",".join(["wavelength_nm"] + [name for name, *_ in columns]))
    for i, w in enumerate(wavelengths_nm):
        lines.append(",".join([number(w)] + [number(values[i]) for *_, values in columns]))
    (HERE / filename).write_text("\n".join(lines) + "\n")


def observer(filename, name, key, description, source):
    cmfs = colour.MSDS_CMFS[key]
    assert cmfs.shape.interval == 1
    columns = [(f"{name}-{axis}", f"{description}, {axis}-bar", source, cmfs.values[:, i]) for i, axis in enumerate("xyz")]
    write_table(filename, cmfs.wavelengths, columns)


def d_illuminant(name):
    """The published table, 300 to 780 nm at 5 nm, and on to 830 nm by the CIE's own rule for the D series (the
    characteristic vectors at 10 nm with the two weights rounded to three decimals, linear in between), which gives the
    published part back to the last digit printed."""
    t = {"D50": 5000, "D55": 5500, "D65": 6500, "D75": 7500}[name] * 1.4388 / 1.4380
    if t <= 7000:
        x = -4.6070e9 / t**3 + 2.9678e6 / t**2 + 0.09911e3 / t + 0.244063
    else:
        x = -2.0064e9 / t**3 + 1.9018e6 / t**2 + 0.24748e3 / t + 0.237040
    y = -3 * x * x + 2.87 * x - 0.275
    m = 0.0241 + 0.2562 * x - 0.7341 * y
    m1 = round((-1.3515 - 1.7703 * x + 5.9114 * y) / m, 3)
    m2 = round((0.03 - 31.4424 * x + 30.0717 * y) / m, 3)
    tens = np.arange(300, 831, 10)
    s0, s1, s2 = (np.array([D_SERIES[k][w] for w in tens]) for k in ("S0", "S1", "S2"))
    wavelengths = np.arange(300, 831, 5)
    values = np.interp(wavelengths, tens, s0 + m1 * s1 + m2 * s2)
    published = colour.SDS_ILLUMINANTS[name]
    for i, w in enumerate(wavelengths):
        if w <= 780:
            assert abs(values[i] - published[w]) < 1e-3
            values[i] = published[w]
    return np.round(values, 4)


def illuminants():
    wavelengths = np.arange(300, 831, 5)
    source = "CIE 15:2018; above 780 nm by its rule for the D series"
    columns = [
        ("D50", "CIE illuminant D50: daylight, 5003 K", source, d_illuminant("D50")),
        ("D55", "CIE illuminant D55: daylight, 5503 K", source, d_illuminant("D55")),
        ("D65", "CIE standard illuminant D65: average daylight, 6504 K", source, d_illuminant("D65")),
        ("D75", "CIE illuminant D75: north sky daylight, 7504 K", source, d_illuminant("D75")),
    ]
    write_table("illuminants_daylight.csv", wavelengths, columns)

    wavelengths = np.arange(300, 831, 1)
    a = 100 * (560 / wavelengths) ** 5 * np.expm1(1.435e7 / (2848 * 560)) / np.expm1(1.435e7 / (2848 * wavelengths))
    published = colour.SDS_ILLUMINANTS["A"]
    assert all(abs(a[i] - published[w]) < 1e-3 for i, w in enumerate(wavelengths) if w % 5 == 0 and w <= 780)
    columns = [
        ("A", "CIE standard illuminant A: tungsten lamp, 2856 K", "CIE 15:2018, by its formula", a),
        ("E", "Equal energy", "CIE 15:2018", np.full(len(wavelengths), 100.0)),
    ]
    write_table("illuminants_a_e.csv", wavelengths, columns)


def main():
    assert colour.__version__ == COLOUR_VERSION, f"made with colour-science {COLOUR_VERSION}"
    cie_2_1931 = ("cie1931", "CIE 1931 2 Degree Standard Observer", "CIE 1931 2-degree standard observer", "CIE 018:2019")
    observer("observer_cie_1931_2.csv", *cie_2_1931)
    illuminants()


if __name__ == "__main__":
    main()
