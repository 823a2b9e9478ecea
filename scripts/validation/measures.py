# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What is read off a curve of force against displacement, measured or computed, and off a run."""
import dataclasses
import math
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "python"))
from voussoir import results

ELASTIC = 0.3    # share of the peak up to which the secant counts as the stiffness
DROP = 0.8       # of the force so far: below it the wall has dropped
SMOOTHED = 0.04  # of the largest displacement: a force counts as dropped by its mean over so much


@dataclasses.dataclass
class Curve:
    """One direction: displacement [m] and force [N], both positive in the direction of the push."""
    displacement: np.ndarray
    force: np.ndarray

    @property
    def peak(self):
        return float(self.force.max())

    @property
    def at_peak(self):
        """m: the first displacement with 99 % of the peak, since a plateau has no sharper one."""
        return float(self.displacement[np.argmax(self.force >= 0.99 * self.peak)])

    @property
    def stiffness(self):
        """N/m, secant at ELASTIC of the peak."""
        i = int(np.argmax(self.force >= ELASTIC * self.peak))
        if i == 0 or self.displacement[i] <= 0.0:
            return float(self.force[i] / self.displacement[i]) if self.displacement[i] > 0.0 else math.nan
        return float(self.force[i] / self.displacement[i])

    @property
    def first_drop(self):
        """m: displacement at which the mean force has fallen by a fifth from its maximum so far; NaN: nowhere."""
        if len(self.displacement) < 3:
            return math.nan
        half = 0.5 * SMOOTHED * float(self.displacement.max())
        order = np.argsort(self.displacement, kind="stable")
        u, f = self.displacement[order], self.force[order]
        low, high = np.searchsorted(u, u - half), np.searchsorted(u, u + half, side="right")
        sums = np.concatenate([[0.0], np.cumsum(f)])
        mean = (sums[high] - sums[low]) / (high - low)
        fallen = mean < DROP * np.maximum.accumulate(mean)
        return float(u[np.argmax(fallen)]) if fallen.any() else math.nan


def both_ways(displacement, force):
    """Curves of push and pull from a curve with both, each from small displacements to large."""
    u, f = np.asarray(displacement, float), np.asarray(force, float)
    out = []
    for sign in (1.0, -1.0):
        part = sign * u > 0.0
        order = np.argsort(sign * u[part], kind="stable")
        out.append(Curve(sign * u[part][order], sign * f[part][order]))
    return out


def first_rise(displacement, force):
    """The curve up to the first turn back."""
    back = np.flatnonzero(np.diff(np.asarray(displacement, float)) < 0.0)
    end = int(back[0]) + 1 if len(back) else len(displacement)
    return Curve(np.asarray(displacement[:end], float), np.asarray(force[:end], float))


def envelope(displacement, force, bins=120):
    """The largest force in either direction at each displacement: the envelope of loops as (displacement, force), from − to +."""
    u, f = np.asarray(displacement, float), np.asarray(force, float)
    points = []
    for sign in (-1.0, 1.0):
        away = sign * u > 0.0
        if not away.any():
            continue
        edges = np.linspace(0.0, (sign * u[away]).max(), bins + 1)
        which = np.clip(np.digitize(sign * u[away], edges) - 1, 0, bins - 1)
        for b in np.unique(which):
            here = which == b
            k = np.argmax(sign * f[away][here])
            points.append((u[away][here][k], f[away][here][k]))
    points.sort()
    return np.array([p[0] for p in points]), np.array([p[1] for p in points])


def mean_error(measured, computed):
    """Mean of |computed − measured| over the mean measured force, over the displacements that both reach, beyond a tenth of them."""
    top = min(measured.displacement.max(), computed.displacement.max())
    at = np.linspace(0.1 * top, top, 60)
    m = np.interp(at, measured.displacement, measured.force)
    c = np.interp(at, computed.displacement, computed.force)
    return float(np.abs(c - m).mean() / m.mean())


class RunOfWall:
    """Results of a finished run."""

    def __init__(self, folder, wall):
        self.wall = wall
        self.file = results.open_results(folder)
        rows = int(self.file.attrs["rows_assessment"])
        table = self.file["assessment"]
        self.displacement = table["displacement"][:rows] * 1.0  # m, of the beam's centroid: at H0, or above the wall
        self.force = 1000.0 * table["factor"][:rows]             # N, of the actuator
        self.shear = table["base_shear"][:rows] * 1.0            # N, at the base
        self.attributes = dict(self.file["assessment"].attrs)

    def rows_of(self, name):
        return int(self.file.attrs["rows_" + name])

    @property
    def finished(self):
        return int(self.file["summary"].attrs.get("finished", 0)) == 1

    @property
    def peak_residual(self):
        rows = self.rows_of("energy")
        return float(np.abs(self.file["energy/residual"][:rows]).max())

    def frame(self, index):
        """Displaced corners of all faces that look at the front, with the number of the element."""
        m = self.file["model"]
        q, x0 = self.file["frames/quaternion"][index], m["element/position0"][:]
        position = x0 + results.displacement_of(self.file, index)
        vertex, first, corners = m["vertex"][:], m["face/first_corner"][:], m["face/corners"][:]
        element, normal = m["face/element"][:], m["face/normal"][:]
        ends = np.append(first[1:], len(corners))
        out = []
        for face in np.flatnonzero(normal[:, 1] < -0.9):
            e = element[face]
            points = vertex[corners[first[face]:ends[face]]] - x0[e]
            out.append((int(e), position[e] + np.array([rotated(q[e], p) for p in points])))
        return out

    def slip_share(self, index):
        """Share of the top's displacement in a frame due to sliding of courses over each other; the rest is due to their rotation."""
        m = self.file["model"]
        x0 = m["element/position0"][:]
        position, q = x0 + results.displacement_of(self.file, index), self.file["frames/quaternion"][index]
        turn = 2.0 * np.arctan2(q[:, 2], q[:, 0])
        levels = np.unique(np.round(x0[:, 2], 6))
        step = self.wall.height / round(self.wall.height / self.wall.unit[1])
        slid, below = 0.0, None
        for level in levels:
            here = np.abs(x0[:, 2] - level) < 1e-5
            foot = level - (0.5 * step if level < self.wall.height else level - self.wall.height)
            head = level + 0.5 * step
            u = position[here, 0] - x0[here, 0]
            at_foot = float(np.mean(u - (level - foot) * np.sin(turn[here])))
            slid += at_foot - (0.0 if below is None else below)
            below = float(np.mean(u + (head - level) * np.sin(turn[here])))
        top = float(position[np.argmax(x0[:, 2]), 0] - x0[np.argmax(x0[:, 2]), 0])
        return slid / top if abs(top) > 1e-6 else math.nan

    def cracks(self):
        """For each broken segment: position [m], area [m2], the limit it reached first (1 tension, 2 shear, 3 compression)."""
        rows, table = self.rows_of("cracks"), self.file["cracks"]
        return table["position"][:rows], table["area"][:rows], table["first_mode"][:rows]

    def first_modes(self):
        """Area [m2] of bonds by the limit that they reached first, for laws with a bond only."""
        _, area, mode = self.cracks()
        return {name: float(area[mode == k].sum()) for k, name in ((1, "tension"), (2, "shear"), (3, "compression"))}

    def time_of_peak(self):
        """Time of the largest force in either direction, s."""
        rows = len(self.force)
        return float(self.file["assessment/time"][:rows][np.argmax(np.abs(self.force))])

    def inner_share(self, until=math.inf):
        """Share of the area broken by then outside the lowest and the highest fifth of the wall; NaN: nothing is broken."""
        position, area, _ = self.cracks()
        before = self.file["cracks/time"][:len(area)] <= until
        position, area = position[before], area[before]
        inner = np.abs(position[:, 2] / self.wall.height - 0.5) < 0.3
        return float(area[inner].sum() / area.sum()) if len(area) else math.nan

    def unit_share(self):
        """Broken share of the units' cuts at mid-length; NaN: the units cannot crack."""
        joint, names = self.file["model/joint"], [n.decode() for n in self.file["model/law/name"][:]]
        if "unit" not in names:
            return math.nan
        own = joint["law"][:] == names.index("unit")
        rows = self.rows_of("cracks")
        table = self.file["cracks"]
        return float(table["area"][:rows][own[table["joint"][:rows]]].sum() / joint["area"][:][own].sum())


def rotated(q, p):
    w, v = q[0], q[1:]
    return p + 2.0 * np.cross(v, np.cross(v, p) + w * p)
