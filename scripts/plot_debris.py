#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Where the debris lies: plans of several runs side by side, to one scale (the paper's Figs. 34 to 37).

usage: scripts/plot_debris.py [LABEL=]DIR ... [--time T] [--below 1.0] [-o debris.png]

A plan is cut: it shows what lies or stands lower than --below, so that the roof does not hide the floor. Bricks that have fallen are red,
fallen timber and voussoirs brown, what stands is grey; the line is the outline of all elements at first.
"""

import math

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Rectangle

import run_file
from render import FACES
from voussoir.results import displacement_of, rotation_matrices

STANDS, MASONRY, ROOF = "#d9d9d9", "#c08a3e", "#8a5f38"
ROOF_TAGS = ("roof beam", "vault ring", "lintel", "column")  # and "left ring beam", ...


class Plan:
    """One frame of a run, seen from above."""

    def __init__(self, run, time, below):
        file = run.file
        times = run_file.frame_times(file)
        frame = len(times) - 1 if time is None else int(np.argmin(abs(times - time)))
        self.title = f"{run.label}, {times[frame]:.2f} s"
        self.start = file["model/element/position0"][:]
        self.now = self.start + displacement_of(file, frame)
        sunk = self.start[:, 2] - self.now[:, 2]
        height = self.start[:, 2] - run.base()
        fallen = sunk > np.where(height > 0.0, np.minimum(0.5 * height, 1.0), 1.0)  # as solver/run/collapse.h has it
        is_roof = np.array([tag.startswith(ROOF_TAGS) or tag.endswith("ring beam") for tag in file["model/element/tag"].asstr()[:]])
        self.colour = np.where(fallen, np.where(is_roof, ROOF, MASONRY), STANDS)
        self.turn = rotation_matrices(file["frames/quaternion"][frame])
        self.vertices = file["model/vertex"][:]
        self.cells = [(cell, kind, e) for cell, kind, e in
                      zip(file["model/cells"][:], file["model/cell_type"][:], file["model/cell_element"][:]) if self.now[e, 2] < below]

    def outside(self):
        """Low and high corner of the walls in their initial position."""
        return self.vertices[:, :2].min(axis=0), self.vertices[:, :2].max(axis=0)

    def polygons(self):
        """(height, corners, colour) of the upward faces, the lowest first."""
        shown = []
        for cell, kind, e in self.cells:
            corners = (self.vertices[cell[cell >= 0]] - self.start[e]) @ self.turn[e].T + self.now[e]
            for face in FACES[int(kind)]:
                c = corners[list(face)]
                if np.cross(c[1] - c[0], c[2] - c[0])[2] > 1e-9:
                    shown.append((c[:, 2].mean(), c[:, :2], self.colour[e]))
        return sorted(shown, key=lambda item: item[0])

    def draw(self, axes):
        shown = self.polygons()
        axes.add_collection(PolyCollection([s[1] for s in shown], facecolors=[s[2] for s in shown], edgecolors="#00000055", linewidths=0.2))
        low, high = self.outside()
        axes.add_patch(Rectangle(low, *(high - low), fill=False, linewidth=0.8))
        axes.set_title(self.title, loc="left")
        axes.set_aspect("equal")


def extent(plans):
    """Range of everything drawn, with a margin of half a metre."""
    points = np.concatenate([*(np.array([plan.now[e, :2] for _, _, e in plan.cells]) for plan in plans if plan.cells),
                             *(np.array(plan.outside()) for plan in plans)])
    return points.min(axis=0) - 0.5, points.max(axis=0) + 0.5


def main():
    p = run_file.parser(__doc__, "debris.png")
    p.add_argument("run", nargs="+", help="folder of a run, or LABEL=folder")
    p.add_argument("--time", type=float, help="s (default: the last frame)")
    p.add_argument("--below", type=float, default=1.0, help="height of the cut above z = 0, m (default 1)")
    a = p.parse_args()
    plans = [Plan(run_file.Run(argument), a.time, a.below) for argument in a.run]
    low, high = extent(plans)
    columns = min(2, len(plans))
    rows = math.ceil(len(plans) / columns)
    width = a.width / columns
    height = (width - 1.0) * (high[1] - low[1]) / (high[0] - low[0]) + 1.5
    figure, grid = run_file.plt.subplots(rows, columns, figsize=(a.width / 2.54, height * rows / 2.54), squeeze=False)
    for axes in grid.flat[len(plans):]:
        axes.set_axis_off()
    for axes, plan in zip(grid.flat, plans):
        plan.draw(axes)
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x, m", ylabel="y, m")
    run_file.save(figure, a.output)


if __name__ == "__main__":
    main()
