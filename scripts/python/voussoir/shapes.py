# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""From vertices and faces, as meshes have them, to what a case file takes."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import InputError

_SAME = 1e-9  # of the block's size: coordinates that differ by less are the same


def shape_of(name: str, vertices: ArrayLike, faces: Sequence[Sequence[int]] | None = None) -> dict[str, Any]:
    """Keys of a [[block]] for a convex block.

    vertices: n x 3, m. Without faces: the eight corners of a hexahedron in VTK's order (four of one face, then the four above).
    faces: corners of each face, rows of `vertices`, in order around it, in either sense; triangles of one plane need not be merged.
    Raises InputError for a damaged mesh; the program checks whether it is convex and closed.
    """
    points = np.asarray(vertices, dtype=float)
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"block \"{name}\": vertices have the shape {points.shape}; wanted n x 3")
    if not np.isfinite(points).all():
        raise InputError(f"block \"{name}\": a vertex is not finite")
    if faces is None:
        if len(points) != 8:
            raise InputError(f"block \"{name}\": {len(points)} vertices without faces; wanted the 8 of a hexahedron, or also faces")
        return {"vertices": points.tolist()}
    sides = _merged(name, points, faces)
    hexahedron = _hexahedron(sides)
    if hexahedron is not None:
        return {"vertices": points[hexahedron].tolist()}
    prism = _prism(points, sides)
    if prism is not None:
        return prism
    used = sorted({k for side in sides for k in side})
    number = {k: i for i, k in enumerate(used)}
    return {"vertices": points[used].tolist(), "faces": [[number[k] for k in side] for side in sides]}


def _normal(loop: NDArray[Any]) -> NDArray[Any]:
    """Twice the area times the normal of a polygon, by Newell's method."""
    normal: NDArray[Any] = np.cross(loop, np.roll(loop, -1, axis=0)).sum(axis=0)
    return normal


def _merged(name: str, points: NDArray[Any], faces: Sequence[Sequence[int]]) -> list[list[int]]:
    """Faces with triangles of one plane merged to polygons, all counter-clockwise seen from outside. Unused vertices are ignored."""
    for face in faces:
        if len(face) < 3 or len(set(face)) != len(face) or not all(0 <= k < len(points) for k in face):
            raise InputError(f"block \"{name}\": face {list(face)} is not three or more different vertices of 0 to {len(points) - 1}")
    used = sorted({k for face in faces for k in face})
    centre, size = points[used].mean(axis=0), float(np.ptp(points[used], axis=0).max())
    planes: list[tuple[NDArray[Any], float, list[list[int]]]] = []
    for face in faces:
        loop = list(face)
        normal = _normal(points[loop] - centre)
        length = float(np.linalg.norm(normal))
        if length <= _SAME * size * size:
            raise InputError(f"block \"{name}\": face {list(face)} has no area")
        normal /= length
        distance = float(normal @ (points[loop].mean(axis=0) - centre))
        if distance < 0.0:
            normal, distance, loop = -normal, -distance, loop[::-1]
        for other, at, loops in planes:
            if np.abs(other - normal).max() < 1e-6 and abs(at - distance) < 1e-6 * size:
                loops.append(loop)
                break
        else:
            planes.append((normal, distance, [loop]))
    return [_outline(name, points, loops) for _, _, loops in planes]


def _outline(name: str, points: NDArray[Any], loops: list[list[int]]) -> list[int]:
    """The polygon around faces of one plane: the edges of only one of the faces. Corners on a straight line are dropped."""
    edges = {(a, b) for loop in loops for a, b in zip(loop, loop[1:] + loop[:1])}
    after = {a: b for a, b in edges if (b, a) not in edges}
    start = next(iter(after), None)
    if start is None:
        raise InputError(f"block \"{name}\": faces of one plane cover each other")
    ring = [start]
    while after.get(ring[-1]) not in (None, start) and len(ring) <= len(after):
        ring.append(after[ring[-1]])
    if len(ring) != len(after):
        raise InputError(f"block \"{name}\": faces of one plane are not one polygon: the mesh is open, or its faces are in different senses")
    kept = []
    for k, corner in enumerate(ring):
        before, behind = points[corner] - points[ring[k - 1]], points[ring[(k + 1) % len(ring)]] - points[corner]
        if np.linalg.norm(np.cross(before, behind)) > 1e-9 * np.linalg.norm(before) * np.linalg.norm(behind):
            kept.append(corner)
    return kept


def _hexahedron(sides: list[list[int]]) -> list[int] | None:
    """Corners in VTK's order, or None if the shape is not six faces of four corners with three edges at each of eight corners."""
    if len(sides) != 6 or any(len(s) != 4 for s in sides) or len({k for s in sides for k in s}) != 8:
        return None
    bottom = sides[0][::-1]  # seen from inside counter-clockwise, as VTK has the first face
    edges = {frozenset(pair) for s in sides for pair in zip(s, s[1:] + s[:1])}
    top = []
    for corner in bottom:
        above = [k for e in edges if corner in e for k in e if k != corner and k not in bottom]
        if len(above) != 1:
            return None
        top.append(above[0])
    return bottom + top


def _prism(points: NDArray[Any], sides: list[list[int]]) -> dict[str, Any] | None:
    """Polygon and extrude, or None if the two ends are not planes of constant x and copies of each other."""
    used = sorted({k for s in sides for k in s})
    size = float(np.ptp(points[used], axis=0).max())
    low, high = points[used, 0].min(), points[used, 0].max()
    ends = [s for s in sides if np.ptp(points[s, 0]) <= _SAME * size]
    if len(ends) != 2 or len(sides) != 2 + len(ends[0]) or len(used) != 2 * len(ends[0]):
        return None
    first, second = sorted(ends, key=lambda s: float(points[s[0], 0]))
    for corner in first:  # each has its twin straight across
        if np.linalg.norm(points[second][:, 1:] - points[corner, 1:], axis=1).min() > _SAME * size:
            return None
    polygon = points[second][:, 1:]  # from +x: counter-clockwise in y, z
    return {"polygon": polygon.tolist(), "extrude": [float(low), float(high)]}
