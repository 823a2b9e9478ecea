#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Counts the stones of a file, and the pairs of faces that touch: opposite normals, planes within a millimetre, an area in common.

usage: count_joints.py FILE...   (OBJ with a stone an `o`, or an assembly of COMPAS)

Written to judge `voussoir`, and shares nothing with it: plain Python, every pair of stones, the common area by cutting polygons in space.
"""
import itertools
import json
import sys

GAP, TURN, AREA = 1e-3, 1e-3, 1e-6  # m, -, m2


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def vector_area(points):
    total = (0.0, 0.0, 0.0)
    for p, q in zip(points[1:], points[2:]):
        c = cross(sub(p, points[0]), sub(q, points[0]))
        total = tuple(t + 0.5 * x for t, x in zip(total, c))
    return total


def read_obj(path):
    points, stones = [], []
    for line in open(path):
        words = line.split()
        if not words:
            continue
        if words[0] == "o":
            stones.append([])
        elif words[0] == "v":
            points.append(tuple(float(w) for w in words[1:4]))
        elif words[0] == "f":
            stones[-1].append([points[int(w.split("/")[0]) - 1] for w in words[1:]])
    return stones


def read_compas(path):
    nodes = json.load(open(path))["data"]["graph"]["data"]["node"]
    stones = []
    for node in nodes.values():
        data = node["block"]["data"]
        at = {key: (v["x"], v["y"], v["z"]) for key, v in data["vertex"].items()}
        stones.append([[at[str(v)] for v in loop] for loop in data["face"].values()])
    return stones


def common_area(a, b, normal):
    """Of two convex faces; b runs the other way round."""
    rest = a
    b = b[::-1]
    for p, q in zip(b, b[1:] + b[:1]):
        outward = cross(sub(q, p), normal)
        kept = []
        for u, v in zip(rest, rest[1:] + rest[:1]):
            hu, hv = dot(sub(u, p), outward), dot(sub(v, p), outward)
            if hu <= 0:
                kept.append(u)
            if hu * hv < 0:
                f = hu / (hu - hv)
                kept.append(tuple(x + f * (y - x) for x, y in zip(u, v)))
        rest = kept
        if len(rest) < 3:
            return 0.0
    return abs(dot(vector_area(rest), normal))


def faces_of(stone):
    out = []
    for points in stone:
        area = vector_area(points)
        length = dot(area, area) ** 0.5
        out.append((points, tuple(x / length for x in area)))
    return out


def count(stones):
    joints = 0
    for one, other in itertools.combinations([faces_of(s) for s in stones], 2):
        for (a, na), (b, nb) in itertools.product(one, other):
            if max(abs(x + y) for x, y in zip(na, nb)) > TURN:
                continue
            if max(abs(dot(sub(p, a[0]), na)) for p in b) > GAP:
                continue
            joints += common_area(a, b, na) > AREA
    return joints


if __name__ == "__main__":
    for name in sys.argv[1:]:
        found = read_obj(name) if name.endswith(".obj") else read_compas(name)
        print(len(found), count(found))
