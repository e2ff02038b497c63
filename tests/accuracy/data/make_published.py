#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes colorchecker_published.csv: the colours that are published for the ColorChecker's patches, which the tests hold
renders against. Only the table is read by tests.

    python3 -m venv venv && venv/bin/pip install colour-science==0.4.7 && venv/bin/python make_published.py

colour-science has them as x, y, Y with the chart's white, D50; here they are L*a*b* relative to it.
"""

import re
from pathlib import Path

import colour

CHARTS = [
    ("babelcolor-average", "BabelColor Average", "BabelColor, mean of 30 charts measured; the spectra of our library are its own"),
    ("x-rite-before-2014", "ColorChecker24 - Before November 2014", "X-Rite, reference values for charts made before November 2014"),
    ("x-rite-after-2014", "ColorChecker24 - After November 2014", "X-Rite, reference values for charts made from November 2014 on"),
]


def slug(patch):
    return re.sub(r"[^a-z0-9.]+", "-", re.sub(r" \(.*\)", "", patch).lower()).strip("-")


def main():
    lines = [f"# {name}: {source}; from colour-science 0.4.7, CCS_COLOURCHECKERS['{key}']" for name, key, source in CHARTS]
    lines.append("chart,patch,L,a,b")
    for name, key, _ in CHARTS:
        chart = colour.CCS_COLOURCHECKERS[key]
        for patch, xyY in chart.data.items():
            lab = colour.XYZ_to_Lab(colour.xyY_to_XYZ(xyY), chart.illuminant)
            lines.append(",".join([name, slug(patch)] + [f"{v:.3f}" for v in lab]))
    (Path(__file__).parent / "colorchecker_published.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
