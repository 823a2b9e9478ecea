# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Where blocks touch: pairs of faces, what they share, and the contact points of it. Written from geometry/README.md and the comments of
geometry/assembly.h, without the code behind them."""
import dataclasses
import math

import numpy

from shapes import Block

NEAR, OPPOSITE, LEAST_AREA, LEAST_WIDTH = 1e-6, 1e-6, 1e-8, 2e-6  # m, -, m2, m
SMALL_PIECE = 0.01  # of a cell: such a piece goes to its largest neighbour
BASE = -1


class Doubtful(Exception):
    """The documented rules do not determine the contact points of this model."""


@dataclasses.dataclass
class Contact:
    """a and b are numbers of blocks, b may be BASE. normal: from a to b. points: corners of the convex hull of the contact points."""
    a: int
    b: int
    normal: numpy.ndarray
    points: numpy.ndarray


def normal_of(points):
    """The unit normal of a loop of corners, by Newell."""
    middle = points.mean(axis=0)
    ahead = numpy.roll(points, -1, axis=0)
    total = numpy.cross(points - middle, ahead - middle).sum(axis=0)
    return total / numpy.linalg.norm(total)


def area_of(polygon):
    """Signed area of corners (s, t)."""
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(polygon, polygon[1:] + polygon[:1]))


def centroid_of(polygon):
    s0, t0 = polygon[0]
    total = sum_s = sum_t = 0.0
    for (as_, at), (bs, bt) in zip(polygon[1:], polygon[2:]):
        part = (as_ - s0) * (bt - t0) - (bs - s0) * (at - t0)
        total += part
        sum_s += part * (as_ + bs - 2.0 * s0) / 3.0
        sum_t += part * (at + bt - 2.0 * t0) / 3.0
    return (s0 + sum_s / total, t0 + sum_t / total)


def clipped(polygon, other):
    """The intersection of two convex polygons, both counter-clockwise. A corner within a 1e-9 of the size of an edge's line is on its inner side,
    since the crossing of two edges on one line is undetermined."""
    size = max(math.dist(other[0], corner) for corner in other)
    for (ps, pt), (qs, qt) in zip(other, other[1:] + other[:1]):
        ds, dt = qs - ps, qt - pt
        sides = [ds * (t - pt) - dt * (s - ps) + 1e-9 * size * math.hypot(ds, dt) for s, t in polygon]
        kept = []
        for i, (here, side) in enumerate(zip(polygon, sides)):
            before, side_before = polygon[i - 1], sides[i - 1]
            if (side < 0.0) != (side_before < 0.0):
                u = side_before / (side_before - side)
                kept.append((before[0] + u * (here[0] - before[0]), before[1] + u * (here[1] - before[1])))
            if side >= 0.0:
                kept.append(here)
        polygon = kept
        if len(polygon) < 3:
            return []
    return polygon


def hull(points):
    """The corners of the convex hull, counter-clockwise. Computed on a raster of 1e-10 of its size, so that the order of points in a
    column does not depend on round-off."""
    low = [min(p[k] for p in points) for k in (0, 1)]
    step = 1e-10 * max(math.dist(low, p) for p in points) or 1.0
    at = {tuple(round((p[k] - low[k]) / step) for k in (0, 1)): p for p in points}
    points = sorted(at)
    corners = []
    for half in (points, points[::-1]):
        chain = []
        for p in half:
            while len(chain) > 1 and (chain[-1][0] - chain[-2][0]) * (p[1] - chain[-2][1]) <= (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-2][0]):
                chain.pop()
            chain.append(p)
        corners += chain[:-1]
    return [at[corner] for corner in corners or points]


def least_width(polygon):
    """Least width over all directions perpendicular to an edge."""
    widths = []
    for (ps, pt), (qs, qt) in zip(polygon, polygon[1:] + polygon[:1]):
        length = math.hypot(qs - ps, qt - pt)
        if length > 1e-9:
            widths.append(max(((qs - ps) * (t - pt) - (qt - pt) * (s - ps)) / length for s, t in polygon))
    return min(widths)


class Face:
    """A face in its own coordinates (s, t): s runs along its longest edge, t = normal x s, from a corner of its bounding rectangle."""

    def __init__(self, corners):
        self.corners = corners
        self.normal = normal_of(corners)
        edges = numpy.roll(corners, -1, axis=0) - corners
        lengths = numpy.linalg.norm(edges, axis=1)
        longest = edges[lengths >= lengths.max() * (1.0 - 1e-6)]
        along = longest[0]
        self.one_grid = all(min(abs(numpy.dot(along, e)), numpy.linalg.norm(numpy.cross(along, e))) < 1e-6 * lengths.max()**2 for e in longest)
        along = along - numpy.dot(along, self.normal) * self.normal
        self.s = along / numpy.linalg.norm(along)
        self.t = numpy.cross(self.normal, self.s)
        flat = numpy.column_stack([(corners - corners[0]) @ self.s, (corners - corners[0]) @ self.t])
        low = flat.min(axis=0)
        self.origin = corners[0] + low[0] * self.s + low[1] * self.t
        self.polygon = [tuple(p) for p in flat - low]
        self.width, self.height = flat.max(axis=0) - low

    def flat(self, points):
        return [tuple(p) for p in numpy.column_stack([(points - self.origin) @ self.s, (points - self.origin) @ self.t])]

    def space(self, flat):
        return numpy.array([self.origin + s * self.s + t * self.t for s, t in flat])


def cells_along(extent, size):
    n = extent / size
    if abs(n % 1.0 - 0.5) < 1e-6:
        raise Doubtful("half a cell")
    return max(1, math.floor(n + 0.5))


def cell_points(face, overlap, size):
    """Centroids of the intersections of a face's cells with the overlap, in the face's coordinates (segments.rule = "centres")."""
    if not face.one_grid:
        raise Doubtful("which of equal edges a grid runs along")
    columns, rows = cells_along(face.width, size), cells_along(face.height, size)
    w, h = face.width / columns, face.height / rows
    pieces = {}
    for i in range(columns):
        for k in range(rows):
            part = clipped(overlap, [(i * w, k * h), ((i + 1) * w, k * h), ((i + 1) * w, (k + 1) * h), (i * w, (k + 1) * h)])
            area = area_of(part) if part else 0.0
            if area > 1e-9 * w * h:
                if 0.5 * SMALL_PIECE < area / (w * h) < 2.0 * SMALL_PIECE:
                    raise Doubtful("a piece of about a hundredth of a cell")
                pieces[i, k] = [area, *centroid_of(part)]
    return [(s, t) for _, s, t in merged(pieces, SMALL_PIECE * w * h)]


def merged(pieces, small):
    """Pieces with small ones merged into their largest neighbour of eight."""
    out = {key: list(piece) for key, piece in pieces.items()}
    for (i, k), (area, s, t) in pieces.items():
        if area >= small:
            continue
        near = [(i + di, k + dk) for di in (-1, 0, 1) for dk in (-1, 0, 1) if (di or dk) and (i + di, k + dk) in pieces]
        if any(pieces[n][0] < small for n in near):
            raise Doubtful("two small pieces side by side")
        if not near:
            continue
        areas = sorted((pieces[n][0], n) for n in near)
        if len(areas) > 1 and areas[-1][0] < areas[-2][0] * (1.0 + 1e-6):
            raise Doubtful("two neighbours alike")
        to = out[areas[-1][1]]
        total = to[0] + area
        to[1], to[2], to[0] = (to[0] * to[1] + area * s) / total, (to[0] * to[2] + area * t) / total, total
        del out[i, k]
    return out.values()


def size_of(block, size):
    """Segment size: the model's, or a quarter of the least distance between a face and the corner farthest behind it."""
    if size is not None:
        return size
    faces = [block.vertices[list(loop)] for loop in block.faces]
    return 0.25 * min(max((face[0] - block.vertices) @ normal_of(face)) for face in faces)


def touch(face, other, rule, sizes, of_both=True):
    """Corners of the hull of the contact points of two faces (of_both: of the points of either; else of the first), or none."""
    if numpy.abs(face.normal + other.normal).max() > OPPOSITE:
        return None
    if abs(numpy.dot(other.corners.mean(axis=0) - face.corners.mean(axis=0), face.normal)) > NEAR:
        return None
    overlap = clipped(face.polygon, face.flat(other.corners)[::-1])
    if not overlap or area_of(overlap) <= LEAST_AREA or least_width(overlap) <= LEAST_WIDTH:
        return None
    if rule == "rim":
        return face.space(hull(overlap))
    points = cell_points(face, overlap, sizes[0])
    if of_both:
        points = points + face.flat(other.space(cell_points(other, other.flat(face.space(overlap))[::-1], sizes[1])))
    return face.space(hull(points))


def of_base(face, base, rule, size):
    """Corners of the hull of the contact points of a face that stands on the base."""
    if face.normal[2] > -1.0 + OPPOSITE**2 or abs(face.corners[:, 2].mean() - base) > NEAR:
        return None
    return face.space(hull(face.polygon if rule == "rim" else cell_points(face, face.polygon, size)))


def find_contacts(blocks: list[Block], base, rule, size):
    """All contacts but those between two fixed blocks. A part of the base is the last block."""
    faces = [[Face(block.vertices[list(loop)]) for loop in block.faces] for block in blocks]
    low = [block.vertices.min(axis=0) - NEAR for block in blocks]
    high = [block.vertices.max(axis=0) + NEAR for block in blocks]
    sizes = [size_of(block, size) for block in blocks]
    out = []
    for a, block in enumerate(blocks):
        if base is not None and not block.fixed:
            for face in faces[a]:
                points = of_base(face, base, rule, sizes[a])
                if points is not None:
                    out.append(Contact(a, BASE, face.normal, points))
        for b in range(a + 1, len(blocks)):
            if (block.fixed and blocks[b].fixed) or (low[a] > high[b]).any() or (low[b] > high[a]).any():
                continue
            for face in faces[a]:
                for other in faces[b]:
                    points = touch(face, other, rule, (sizes[a], sizes[b]), not blocks[b].ground)
                    if points is not None:
                        out.append(Contact(a, b, face.normal, points))
    return out
