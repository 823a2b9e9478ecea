# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Figures of the report: curves, and the wall as it stands with its open joints."""
import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "voussoir", "font.size": 9})
import matplotlib.pyplot as plt
import numpy as np

from measures import results

MEASURED = ["#7a7a7a", "#b0a08a", "#8aa0b0", "#a0b08a"]
COMPUTED = "#c1272d"


def save(figure, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None, "Creator": None} if path.suffix == ".svg" else {}, dpi=90)
    plt.close(figure)


def thinned(u, f, most=500):
    """At most this many points, which keeps a figure small."""
    step = max(1, len(u) // most)
    return u[::step], f[::step]


def curves(path, wall, measured, computed, levels, peaks):
    """measured: {test: (u, f)}; computed: (u, f); levels: {words: N} drawn as dotted lines; peaks: [(u, f)] of tests without a curve."""
    figure, axes = plt.subplots(figsize=(5.2, 3.4), layout="constrained")
    for (test, (u, f)), colour in zip(measured.items(), MEASURED):
        axes.plot(1e3 * np.asarray(u), 1e-3 * np.asarray(f), color=colour, linewidth=1.1, label=f"measured, {test}")
    u, f = thinned(np.asarray(computed[0]), np.asarray(computed[1]))
    axes.plot(1e3 * u, 1e-3 * f, color=COMPUTED, linewidth=1.4, label="computed")
    if peaks:
        axes.plot([1e3 * u for u, _ in peaks], [1e-3 * f for _, f in peaks], linestyle="none", marker="o", markersize=4.0, color=MEASURED[0],
                  label="measured, peaks")
    for words, force in levels.items():
        axes.axhline(1e-3 * force, color="#444444", linewidth=0.7, linestyle=":", label=words)
    axes.set(xlabel="displacement, mm", ylabel="force, kN", title=wall.name)
    axes.legend(frameon=False, fontsize=7)
    axes.grid(alpha=0.3)
    save(figure, path)


def wall_as_it_stands(path, run, index, factor):
    """The front of the wall in a frame, with displacements enlarged by a factor."""
    x0 = run.file["model/element/position0"][:]
    position = x0 + results.displacement_of(run.file, index)
    figure, axes = plt.subplots(figsize=(3.2, 3.2 * min(2.0, 1.15 * run.wall.height / run.wall.length)), layout="constrained")
    for element, corners in run.frame(index):
        shift = (factor - 1.0) * (position[element] - x0[element])
        beam = x0[element][2] > run.wall.height
        axes.fill(corners[:, 0] + shift[0], corners[:, 2] + shift[2], facecolor="#c8c8c8" if beam else "#e9d8b8", edgecolor="#333333", linewidth=0.6)
    if run.wall.bond:
        centre = {int(e): (factor - 1.0) * (position[e] - x0[e]) + position[e] - x0[e] for e in range(len(x0))}
        rows = run.rows_of("cracks")
        at, of = run.cracks()[0], run.file["cracks/element_a"][:rows]
        moved = np.array([p + centre[int(e)] for p, e in zip(at, of)]).reshape(-1, 3)
        axes.plot(moved[:, 0], moved[:, 2], linestyle="none", marker=".", markersize=2.0, color=COMPUTED)
    axes.axhline(0.0, color="#333333", linewidth=1.2)
    axes.set_aspect("equal")
    axes.axis("off")
    save(figure, path)
