#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws error against run time of the wavelength quadrature, the picture of /docs/colour, from what `quadrature` printed:

    quadrature client-examples/scenes/lee/figure-4d.json 120 90 4 5 > tests/accuracy/data/quadrature-figure-4d.csv   (likewise the others)
    python3 plot_quadrature.py                                                        (needs matplotlib)
"""

import csv
from pathlib import Path

import matplotlib.pyplot as plt

HERE = Path(__file__).parent
PICTURE = HERE.parents[1] / "server" / "web" / "docs" / "pictures" / "quadrature.png"
PANELS = {
    "Smooth: D65": [("ColorChecker", "colorchecker-D65"), ("figure 4(d)", "figure-4d")],
    "Spiky: F11, a fluorescent lamp": [("ColorChecker", "colorchecker-F11"), ("figure 4(d) under F11", "still-life-F11")],
}


def draw(axes, label, name, colour):
    rows = list(csv.DictReader((HERE / "data" / f"quadrature-{name}.csv").open()))
    steps = [r for r in rows if r["basis"] == "wavelengths" and r["step_nm"] != "1"]
    axes.plot([float(r["time_ratio"]) for r in steps], [float(r["delta_e_mean"]) for r in steps], "o-", color=colour, label=label)
    for r in steps:
        axes.annotate(f"{r['step_nm']} nm", (float(r["time_ratio"]), float(r["delta_e_mean"])), (5, 4), textcoords="offset points",
                      fontsize=7, color=colour)
    [rgb] = [r for r in rows if r["basis"] == "rgb"]
    axes.plot(float(rgb["time_ratio"]), float(rgb["delta_e_mean"]), "s", color=colour, mfc="white")
    axes.annotate("RGB", (float(rgb["time_ratio"]), float(rgb["delta_e_mean"])), (-24, 4), textcoords="offset points", fontsize=7,
                  color=colour)


def main():
    figure, panels = plt.subplots(1, 2, figsize=(8.6, 3.6), sharey=True)
    for axes, (title, scenes) in zip(panels, PANELS.items()):
        for (label, name), colour in zip(scenes, ("#b96a00", "#2b6a9d")):
            draw(axes, label, name, colour)
        axes.axhline(1, color="0.7", linewidth=0.8, zorder=0)
        axes.set(yscale="log", xlim=(0.3, 0.85), ylim=(8e-4, 5), xlabel="run time, that at 1 nm being 1", title=title)
        axes.grid(which="major", color="0.92")
        axes.legend(fontsize=8, loc="lower left", frameon=False)
    panels[0].set_ylabel("mean CIEDE2000 against 1 nm")
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=100, metadata={"Software": None})


if __name__ == "__main__":
    main()
