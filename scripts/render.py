#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws frames of a run as pictures.

usage: scripts/render.py DIR [-o out.png] [--time T ...] [--azimuth A] [--elevation E]
Needs python3-h5py, python3-numpy, python3-matplotlib. Bricks are light, timber is brown; the redder an element, the more of its bonds are broken.
"""

import argparse

import numpy as np
from matplotlib.collections import PolyCollection

import run_file
from run_file import plt
from voussoir.results import displacement_of, rotation_matrices

# Faces of VTK's tetrahedron (10), hexahedron (12) and wedge (13), outward.
FACES = {
    10: [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)],
    12: [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)],
    13: [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)],
}
ADOBE, WOOD, BROKEN = np.array([0.87, 0.80, 0.68]), np.array([0.55, 0.38, 0.22]), np.array([0.80, 0.16, 0.10])


class Run:
    def __init__(self, folder):
        f = run_file.open_results(folder)
        self.time = run_file.frame_times(f)
        self.file, self.frames = f, f["frames"]
        self.reference = f["model/vertex"][:]
        self.cells, self.kinds = f["model/cells"][:], f["model/cell_type"][:]
        self.element = f["model/cell_element"][:]
        self.start = f["model/element/position0"][:]
        material = f["model/element/material"][:]
        names = [n.decode() for n in f["model/material/name"][:]]
        self.wood = np.array(["wood" in n for n in names])[material]

    def position(self, frame):
        """Of all centroids in a frame, m, relative to the run's origin."""
        return self.start + displacement_of(self.file, frame)

    def polygons(self, frame):
        """Corners of all faces (list of k×3), colour of each."""
        x, q = self.position(frame), self.frames["quaternion"][frame]
        broken = self.frames["broken"][frame]
        turn = rotation_matrices(q)
        polygons, colours = [], []
        for cell, kind, e in zip(self.cells, self.kinds, self.element):
            corners = self.reference[cell[cell >= 0]] - self.start[e]
            corners = corners @ turn[e].T + x[e]
            base = WOOD if self.wood[e] else ADOBE
            colour = base + (BROKEN - base) * min(1.0, 1.3 * float(broken[e]))
            for face in FACES[int(kind)]:
                polygons.append(corners[list(face)])
                colours.append(colour)
        return polygons, colours


def view(azimuth, elevation):
    """View axes as rows: right, up, towards the viewer."""
    a, e = np.radians(azimuth), np.radians(elevation)
    toward = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    return np.stack([right, np.cross(toward, right), toward])


def draw(axes, run, frame, axis, light=np.array([0.35, -0.55, 0.76])):
    polygons, colours = run.polygons(frame)
    shown = []
    for corners, colour in zip(polygons, colours):
        n = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        n /= np.linalg.norm(n) + 1e-30
        if n @ axis[2] <= 0:
            continue
        projected = corners @ axis.T
        shade = 0.62 + 0.38 * max(0.0, n @ light)
        shown.append((projected[:, 2].mean(), projected[:, :2], np.clip(colour * shade, 0, 1)))
    shown.sort(key=lambda item: item[0])
    axes.add_collection(PolyCollection([s[1] for s in shown], facecolors=[s[2] for s in shown], edgecolors="#00000055", linewidths=0.2))
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.set_title(f"{run.time[frame]:.2f} s", fontsize=9)


def window(places, at_first):
    """Range of a picture: all initial positions, and all elements but the last few, one of which may fly anywhere."""
    low, high = np.quantile(places, [0.002, 0.998])
    return min(low, at_first.min()) - 0.3, max(high, at_first.max()) + 0.3


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("folder")
    p.add_argument("-o", "--output", default="frames.png")
    p.add_argument("--time", type=float, nargs="*", help="s; default four moments of the run")
    p.add_argument("--azimuth", type=float, default=-60.0)
    p.add_argument("--elevation", type=float, default=22.0)
    a = p.parse_args()
    run = Run(a.folder)
    times = a.time or list(np.linspace(run.time[0], run.time[-1], 4))
    axis = view(a.azimuth, a.elevation)
    columns = min(2, len(times))
    rows = (len(times) + columns - 1) // columns
    figure, grid = plt.subplots(rows, columns, figsize=(5.0 * columns, 3.3 * rows), squeeze=False)
    for axes in grid.flat:
        axes.set_axis_off()
    first = run.position(0) @ axis.T
    everything = np.concatenate([run.position(int(np.argmin(abs(run.time - t)))) for t in times]) @ axis.T
    for axes, t in zip(grid.flat, times):
        draw(axes, run, int(np.argmin(abs(run.time - t))), axis)
        axes.set_xlim(*window(everything[:, 0], first[:, 0]))
        axes.set_ylim(*window(everything[:, 1], first[:, 1]))
    figure.tight_layout()
    figure.savefig(a.output, dpi=110)


if __name__ == "__main__":
    main()
