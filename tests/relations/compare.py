# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What is expected of the second case, and how far from it the second is."""
import numpy
from scipy.spatial import cKDTree

from measure import AXIAL, COUNT, PEAKS, SIDED, VECTOR

BITS = "bits"


def exponent(value):
    """By Froude's law: mass as the cube of a length, time as its root."""
    mass, length, time = value.dimension
    return 3 * mass + length + 0.5 * time


def expected(value, change):
    """The numbers of the first case as the second must have them."""
    data = value.data
    if value.kind == COUNT:
        return data
    factor = change.scale ** exponent(value)
    if value.kind == SIDED:
        factor *= numpy.sign(numpy.linalg.det(change.turn))
    turn = change.turn if value.kind == VECTOR else numpy.linalg.det(change.turn) * change.turn if value.kind == AXIAL else None
    if value.kind == PEAKS:
        return factor * (numpy.abs(change.turn) @ data)
    return factor * (data if turn is None else data @ turn.T)


def matching(first, second, name, change):
    """Which rows of the second are the first's, by their places. A row a place."""
    places, found = expected(first[name], change), second[name].data
    distance, rows = cKDTree(found).query(places)
    size = max(first[name].floor * change.scale, 1e-300)
    if distance.max(initial=0.0) > 1e-4 * size or len(set(rows)) != len(rows):
        return None
    return rows


def pairs(first, second, change):
    """name -> (expected, found, value) of all numbers that both must have."""
    rows = {}
    for places in ("element position", "place"):
        if places in first:
            rows["element"] = matching(first, second, places, change)
    if "joint centre" in first and len(first["joint centre"].data):
        rows["joint"] = matching(first, second, "joint centre", change)
    for name, value in first.items():
        if name.startswith(change.leave_out) or (name in ("bits", "joint sides") and change.equal != BITS):
            continue
        if value.kind == PEAKS and not numpy.isin(change.turn, (-1.0, 0.0, 1.0)).all():
            continue  # each axis has a peak of its own
        if name not in second:
            yield name, None, None, value
            continue
        found = second[name].data
        axis, kind = (value.joint, "joint") if value.element is None else (value.element, "element")
        if axis is None or change.equal == BITS or not len(found):
            yield name, expected(value, change), found, value
        elif rows.get(kind) is None:
            yield f"{kind}s are not where they must be", None, None, value
        else:
            yield name, expected(value, change), numpy.take(found, rows[kind], axis=axis), value


def differences(first, second, change):
    """name -> how far apart, beside the largest of its group; inf: not comparable."""
    out, groups = {}, {}
    for name, want, found, value in pairs(first, second, change):
        if want is None or numpy.shape(want) != numpy.shape(found):
            out[name] = numpy.inf
            continue
        if change.equal == BITS:
            out[name] = 0.0 if numpy.array_equal(numpy.asarray(want), numpy.asarray(found), equal_nan=want.dtype != object) else numpy.inf
            continue
        if value.kind == COUNT:
            out[name] = float(numpy.abs(numpy.asarray(want, float) - numpy.asarray(found, float)).max(initial=0.0))
            continue
        floor = value.floor * change.scale ** exponent(value)
        apart, largest = float(numpy.abs(want - found).max(initial=0.0)), max(float(numpy.abs(want).max(initial=0.0)), floor)
        group = value.group or name
        a, b = groups.get(group, (0.0, 0.0))
        groups[group] = (max(a, apart), max(b, largest))
    for group, (apart, largest) in groups.items():
        out[group] = apart / largest if largest else (0.0 if not apart else numpy.inf)
    return out
