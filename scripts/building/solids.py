# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Surfaces of triangles seen as walls are: along a line in plan, and upwards. Lengths in metres."""
from __future__ import annotations

import bisect
import dataclasses
import math

Point = tuple[float, float]


@dataclasses.dataclass
class Surface:
    """Corners (x, y, z), and triangles as their numbers."""
    corners: list[tuple[float, float, float]]
    triangles: list[tuple[int, int, int]]

    @staticmethod
    def of(element: dict) -> "Surface":
        c, t = element["corners"], element["triangles"]
        return Surface(list(zip(c[::3], c[1::3], c[2::3])), list(zip(t[::3], t[1::3], t[2::3])))

    @property
    def low(self) -> float:
        return min(z for _, _, z in self.corners)

    @property
    def high(self) -> float:
        return max(z for _, _, z in self.corners)

    def volume(self) -> float:
        """By the divergence theorem; right where the surface is closed."""
        x0, y0, z0 = self.corners[0]
        total = 0.0
        for triangle in self.triangles:
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = ((x - x0, y - y0, z - z0) for x, y, z in (self.corners[i] for i in triangle))
            total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
        return abs(total) / 6.0


@dataclasses.dataclass
class Rectangle:
    """In plan: its middle, a unit vector along its longer side, both lengths."""
    middle: Point
    along: Point
    length: float
    width: float

    @property
    def across(self) -> Point:
        """To the left of `along`."""
        return (-self.along[1], self.along[0])

    def place(self, p: Point) -> Point:
        """A point along and across, from the middle."""
        x, y = p[0] - self.middle[0], p[1] - self.middle[1]
        return (x * self.along[0] + y * self.along[1], x * self.across[0] + y * self.across[1])

    def point(self, along: float, across: float) -> Point:
        return (self.middle[0] + along * self.along[0] + across * self.across[0], self.middle[1] + along * self.along[1] + across * self.across[1])

    def corners(self) -> list[Point]:
        a, b = 0.5 * self.length, 0.5 * self.width
        return [self.point(x, y) for x, y in ((-a, -b), (a, -b), (a, b), (-a, b))]


def hull(points: list[Point]) -> list[Point]:
    """Corners of the convex hull, counter-clockwise (Andrew's chains)."""
    points = sorted({(round(x, 6), round(y, 6)) for x, y in points})
    if len(points) < 3:
        return points
    chains = []
    for row in (points, points[::-1]):
        chain: list[Point] = []
        for p in row:
            while len(chain) > 1 and (chain[-1][0] - chain[-2][0]) * (p[1] - chain[-2][1]) <= (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-2][0]):
                chain.pop()
            chain.append(p)
        chains += chain[:-1]
    return chains


def area(polygon: list[Point]) -> float:
    return 0.5 * abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(polygon, polygon[1:] + polygon[:1])))


def rectangle(points: list[Point]) -> Rectangle | None:
    """The smallest rectangle around points; none where they lie on a line."""
    corners = hull(points)
    best: Rectangle | None = None
    for a, b in zip(corners, corners[1:] + corners[:1]):
        length = math.dist(a, b)
        if length < 1e-6 or len(corners) < 3:
            continue
        u = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
        s = [p[0] * u[0] + p[1] * u[1] for p in corners]
        n = [p[1] * u[0] - p[0] * u[1] for p in corners]
        sides = (max(s) - min(s), max(n) - min(n))
        if best and sides[0] * sides[1] >= best.length * best.width * (1.0 - 1e-9):
            continue
        ms, mn = 0.5 * (max(s) + min(s)), 0.5 * (max(n) + min(n))
        middle = (ms * u[0] - mn * u[1], ms * u[1] + mn * u[0])
        along = u if sides[0] >= sides[1] else (-u[1], u[0])
        if along[0] < -1e-9 or (abs(along[0]) <= 1e-9 and along[1] < 0):
            along = (-along[0], -along[1])
        best = Rectangle(middle, along, max(sides), min(sides))
    return best if best and best.width > 1e-6 else None


class Section:
    """Where a surface is cut square to the longer side of a rectangle."""

    def __init__(self, surface: Surface, r: Rectangle) -> None:
        places = [(r.place((x, y))[0], z) for x, y, z in surface.corners]
        edges = {tuple(sorted((places[t[i]], places[t[j]]))) for t in surface.triangles for i, j in ((0, 1), (1, 2), (2, 0))}
        self.edges = sorted(edges)
        self.longest = max((b - a for (a, _), (b, _) in self.edges), default=0.0)

    def top(self, s: float) -> float:
        """Height of the top there."""
        found = -math.inf
        first = bisect.bisect_left(self.edges, ((s - self.longest - 1e-9, -math.inf),))
        for (a, za), (b, zb) in self.edges[first:]:
            if a > s:
                break
            if b >= s:
                found = max(found, za, zb) if a == b else max(found, za + (zb - za) * (s - a) / (b - a))
        return found


def simplified(line: list[Point], within: float) -> list[Point]:
    """Leaves out points nearer than `within` to the line without them (Douglas and Peucker)."""
    if len(line) < 3:
        return line
    (a, za), (b, zb) = line[0], line[-1]
    off = [abs(z - (za + (zb - za) * (s - a) / (b - a) if b > a else za)) for s, z in line]
    k = max(range(len(line)), key=off.__getitem__)
    if off[k] <= within:
        return [line[0], line[-1]]
    return simplified(line[:k + 1], within)[:-1] + simplified(line[k:], within)


def top_line(surface: Surface, r: Rectangle, gaps: list[tuple[float, float]]) -> list[Point]:
    """The top as (place along the rectangle from its lower end, height), in turn; straight from one to the next.

    gaps: ranges of places that do not count, as where an opening reaches the top. Neither do the ends, where neighbours cut into it: as far as it is
    thick the line goes on straight.
    """
    half, near = 0.5 * r.length, 1e-4
    end = half - (r.width if r.length > 3.0 * r.width else near)
    section = Section(surface, r)
    corners = {s for s in (round(r.place((x, y))[0], 4) for x, y, _ in surface.corners) if abs(s) < end - near}
    places = sorted({-end, end} | {s + d for s in corners for d in (-near, near)})
    places = [s for s in places if not any(a - near < s < b + near for a, b in gaps)]
    line = simplified([(s + half, section.top(s)) for s in places], 0.01)
    if len(line) < 2:
        return [(0.0, z) for _, z in line]
    (a, za), (b, zb) = line[0], line[1]
    (c, zc), (d, zd) = line[-2], line[-1]
    first, last = za + (za - zb) * a / (b - a), zd + (zd - zc) * (r.length - d) / (d - c)
    return [(round(s, 4), round(z, 4)) for s, z in [(0.0, first), *line[1:-1], (r.length, last)]]
