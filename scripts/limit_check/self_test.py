# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The reference against closed forms, against another way of finding a mechanism, and against itself: moved, turned, scaled, shuffled."""
import dataclasses
import itertools
import math
import random

import numpy

import models
import plane_kinds
from arch_hinges import Arch
from contacts import area_of, clipped, hull
from reference import FALLS, STANDS, UNBOUNDED, solve
from shapes import Block, Load, Model, across, turned, upright_box

TIGHT = 1e-9


class Tally:
    def __init__(self):
        self.passed = self.failed = 0

    def near(self, what, found, right, allowed=TIGHT):
        good = found is not None and abs(found - right) <= allowed * max(1.0, abs(right))
        self.that(what, good, f"{found!r}, should be {right!r}")

    def that(self, what, good, words=""):
        self.passed += good
        self.failed += not good
        if not good:
            print(f"FAILED {what}: {words}")


def tan(angle):
    return math.tan(math.radians(angle))


def box_model(width, height, friction, **more):
    return Model("block", [upright_box("a", (0, 0, 0), (width, 1, height))], friction=friction, **more)


def single_blocks(tally):
    for friction in (10.0, 21.8, 22.0, 40.0):
        for how in ({"plane": True}, {"plane": False}):
            tally.near(f"block at {friction}, {how}", solve(box_model(0.4, 1.0, friction), **how).multiplier, min(0.4, tan(friction)))
    tally.near("block pushed along y", solve(box_model(0.4, 1.0, 60.0, direction=90.0)).multiplier, 1.0)
    oblique = solve(box_model(0.4, 1.0, 60.0, direction=30.0)).multiplier  # about the edge across x: 0.4 / (cos 30)
    tally.near("block pushed at 30 degrees", oblique, 0.4 / math.cos(math.radians(30.0)))
    for theta in (3.0, -3.0):  # turned about y by theta the base sends gravity to +x
        model = box_model(1.0, 0.5, 20.0, tilt=(0.0, theta))
        tally.near(f"block on a base tilted by {theta}", solve(model).multiplier,
                   tan(20.0) * math.cos(math.radians(theta)) - math.sin(math.radians(theta)))
    tally.that("a block slides off a tilted base", solve(box_model(1.0, 0.2, 20.0, tilt=(0.0, 21.0))).verdict == FALLS)
    weight, push = 2300.0 * 9.8 * 0.4, 5000.0
    loaded = box_model(0.4, 1.0, 70.0, loads=[Load("a", (0.0, 0.0, -push), at=(0.3, 0.5, 1.0))])
    tally.near("block with an eccentric load", solve(loaded).multiplier, (weight * 0.2 + push * 0.1) / (weight * 0.5))
    turning = box_model(0.4, 1.0, 70.0, loads=[Load("a", (0.0, 0.0, 0.0), moment=(0.0, 500.0, 0.0))])  # about +y: its top towards +x
    tally.near("block with a moment", solve(turning).multiplier, (weight * 0.2 - 500.0) / (weight * 0.5))
    centres = box_model(0.4, 1.0, 60.0, rule="centres", size=0.1)
    tally.near("block of four segments, centres", solve(centres).multiplier, 0.75 * 0.4)


def facets(tally):
    """A block of low friction on a base that tilts across the push: the polygon of shears decides."""
    theta, friction = math.radians(6.0), 20.0
    for n, cone in itertools.product((8, 12, 16), ("inner", "outer")):
        model = box_model(3.0, 0.1, friction, tilt=(6.0, 0.0), facets=n, cone=cone)
        across_it, limit = math.sin(theta), tan(friction) * math.cos(theta)  # shear along y, shear that the circle allows
        shift, apothem = (0.5, math.cos(math.pi / n)) if cone == "inner" else (0.0, 1.0)
        right = min((apothem * limit - across_it * abs(math.sin(a))) / math.cos(a)
                    for a in (2.0 * math.pi * (k + shift) / n for k in range(n)) if math.cos(a) > 1e-9
                    for across_it in (math.sin(theta), -math.sin(theta)))
        tally.near(f"{n} facets, {cone}", solve(model).multiplier, right)


def notched(tally):
    """A stone with an arm rotates about the edges of its foot."""
    pieces = [upright_box("foot", (0, 0, 0), (1, 1, 2)), upright_box("arm", (1, 0, 1.5), (1.6, 1, 2))]
    for piece in pieces:
        piece.stone = "stone"
    x, z = (2.0 * 0.5 + 0.3 * 1.3) / 2.3, (2.0 * 1.0 + 0.3 * 1.75) / 2.3
    for direction, right in ((0.0, (1.0 - x) / z), (180.0, x / z)):
        tally.near("a stone with an arm", solve(Model("notched", pieces, friction=60.0, direction=direction)).multiplier, right)


def stacks(tally):
    for count, width, height, friction in ((5, 1.0, 0.5, 50.0), (5, 1.0, 0.1, 15.0), (3, 0.3, 0.4, 30.0)):
        blocks = [upright_box(f"b{i}", (0, 0, i * height), (width, 1, i * height + height)) for i in range(count)]
        right = min(tan(friction), width / (count * height))
        tally.near(f"stack of {count}", solve(Model("stack", blocks, friction=friction, plane=True)).multiplier, right)
    for over, verdict in ((0.499, STANDS), (0.501, FALLS)):
        blocks = [upright_box("a", (0, 0, 0), (1, 1, 1)), upright_box("b", (over, 0, 1), (1 + over, 1, 2))]
        for plane in (True, False):
            tally.that(f"overhang of {over}", solve(Model("two", blocks, plane=plane)).verdict == verdict)
    locked = [upright_box("a", (0, 0, 0), (1, 1, 1)), upright_box("stop", (1, 0, 0), (2, 1, 2), fixed=True)]
    locked[0] = upright_box("a", (0, 0, 0), (1, 1, 0.1))
    tally.that("a flat block against a fixed one", solve(Model("stop", locked, friction=45.0, plane=True)).verdict == UNBOUNDED)


def inclined(tally):
    """A block on a fixed wedge of 20 degrees: it slides down if friction is less; pushed up it slides at tan(phi + 20)."""
    rise = tan(20.0)
    wedge = across("wedge", [(0, -1), (1, -1), (1, rise), (0, 0)], 0, 1, fixed=True)
    block = across("block", [(0, 0), (1, rise), (1, rise + 0.1), (0, 0.1)], 0, 1)
    for friction in (19.9, 20.1, 30.0):
        for plane in (True, False):
            answer = solve(Model("wedge", [wedge, block], plane=plane, base=None, friction=friction))
            if friction < 20.0:
                tally.that("a block slides down a wedge", answer.verdict == FALLS, answer.verdict)
            else:
                tally.near(f"a block pushed up a wedge, {friction}", answer.multiplier, tan(friction + 20.0))


def towers(tally):
    """Stacks of boxes that do not slide, rotated and pushed in any direction: the line of the forces on all boxes above a bed must meet the common
    area of its two boxes, a rectangle bounded by the ends of the boxes."""
    rng = random.Random(2)
    for number in range(30):
        angle, push, z, boxes = rng.choice([0.0, rng.uniform(0.0, 360.0)]), rng.uniform(0.0, 360.0), 0.0, []
        shift, flush = (rng.uniform(-5000.0, 5000.0), rng.uniform(-5000.0, 5000.0), 0.0), rng.random() < 0.5  # flush: ends on one line
        for i in range(rng.randint(1, 6)):
            x, y = rng.uniform(-0.2, 0.2), 0.0 if flush else rng.uniform(-0.2, 0.2)
            w, d = rng.uniform(0.8, 2.0), 1.0 if flush else rng.uniform(0.8, 2.0)
            boxes.append(((x - w / 2, y - d / 2, z), (x + w / 2, y + d / 2, z + rng.uniform(0.5, 1.5))))
            z = boxes[-1][1][2]
        blocks = [upright_box(f"t{i}", *box) for i, box in enumerate(boxes)]
        for block in blocks:
            block.vertices = turned(block.vertices, angle) + shift
        right = overturning(boxes, turned([(math.cos(math.radians(push)), math.sin(math.radians(push)), 0.0)], -angle)[0])
        answer = solve(Model("tower", blocks, friction=75.0, direction=push))
        if right < 0.0:
            tally.that(f"tower {number} falls", answer.verdict == FALLS, answer.verdict)
        else:
            tally.near(f"tower {number}", answer.multiplier, right, 1e-8)


def overturning(boxes, push):
    """The least multiplier over all beds and their edges; negative if the centroid of the boxes above a bed lies beside the bed."""
    best = math.inf
    for k, (low, high) in enumerate(boxes):
        below = boxes[k - 1] if k else (low, high)
        volumes = [math.prod(numpy.subtract(h, l)) for l, h in boxes[k:]]
        centre = sum(v * (numpy.array(l) + h) / 2.0 for v, (l, h) in zip(volumes, boxes[k:])) / sum(volumes)
        for axis in (0, 1):
            gaps = (min(high[axis], below[1][axis]) - centre[axis], centre[axis] - max(low[axis], below[0][axis]))
            if min(gaps) < 0.0:
                return -1.0
            best = min([best] + [gap / (sign * push[axis] * (centre[2] - low[2])) for gap, sign in zip(gaps, (1, -1)) if sign * push[axis] > 1e-12])
    return best


def overlaps(tally):
    """Rectangles with edges on one line, and columns of points, up to round-off."""
    rng = random.Random(3)
    for number in range(200):
        noise = lambda points: [tuple(x * (1.0 + rng.uniform(-4e-16, 4e-16)) for x in turned([(s, t, 0.0)], turn)[0][:2] + shift) for s, t in points]
        turn, end = rng.choice([0.0, rng.uniform(0.0, 360.0)]), rng.uniform(1.1, 3.0)
        shift = numpy.array([rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0)])
        both = clipped(noise([(0, 0), (2, 0), (2, 1), (0, 1)]), noise([(1, 0), (end, 0), (end, 1), (1, 1)]))
        tally.near(f"overlap {number}", area_of(both), min(end, 2.0) - 1.0, 1e-8)
        corners = hull(noise([(s, t) for s in range(4) for t in range(3)]))
        tally.near(f"hull {number}", area_of(corners), 6.0, 1e-8)


def section_of(block):
    """Corners (x, z) of a voussoir of plane_kinds.ring: inner, outer, outer, inner."""
    return [(x, z) for x, y, z in block.vertices[:4]]


def arches(tally):
    """Arches against all mechanisms of four hinges. Friction is high, so that nothing slides."""
    rng = random.Random(1)
    for number in range(6):
        half, thickness, count = rng.uniform(1.1, 0.5 * math.pi), rng.uniform(0.6, 1.0), rng.randint(6, 11)
        at = plane_kinds.angles(rng, 0.5 * math.pi - half, 0.5 * math.pi + half, count)
        stones = plane_kinds.ring("v", 0.0, 5.0 - thickness / 2, 5.0 + thickness / 2, at, 0.0, 1.0)
        ends = [section_of(stones[0])[:2], section_of(stones[-1])[2:]]
        feet = [across(f"foot{k}", [*pair, *(((x, z - 2.0) for x, z in pair[::-1]))], 0.0, 1.0, fixed=True) for k, pair in enumerate(ends)]
        model = Model("arch", stones + feet, friction=85.0, base=None, plane=True, direction=180.0 * (number % 2))
        right = Arch([section_of(s) for s in stones]).multiplier(1.0 if number % 2 == 0 else -1.0)
        tally.near(f"arch {number} of {count} voussoirs", solve(model).multiplier, right)
    known = plane_kinds.ring("v", 0.0, 1.375, 1.625, [math.pi * i / 25 for i in range(26)], 0.0, 0.5)
    known[0].fixed = known[-1].fixed = True
    right = Arch([section_of(s) for s in known[1:-1]]).multiplier(1.0)
    for plane in (True, False):
        tally.near("round arch of 25", solve(Model("arch", known, friction=45.0, base=None), plane=plane).multiplier, right)


def moved(model, scale, angle, shift):
    """The model in another size, turned about z and moved."""
    change = lambda points: turned(numpy.asarray(points) * scale, angle) + numpy.asarray(shift)
    blocks = [Block(b.name, change(b.vertices), b.faces, b.material, b.fixed, ground=b.ground, stone=b.stone) for b in model.blocks]
    loads = [Load(q.block, tuple(turned([q.force], angle)[0] * scale**3), tuple(turned([q.moment], angle)[0] * scale**4),
                  None if q.at is None else tuple(change([q.at])[0])) for q in model.loads]
    base = None if model.base is None else model.base * scale + shift[2]
    blocks = [b for b in blocks[::-1] if not b.ground] + [b for b in blocks if b.ground]
    return dataclasses.replace(model, blocks=blocks, loads=loads, base=base, direction=model.direction + angle)


def invariance(tally):
    """Random models in other sizes and places, rotated, with blocks in another order: same answer. Plane ones also in space."""
    for number in range(40):
        model = models.make("invariance", number)
        model.rule = "rim"
        if any(model.tilt):
            model.tilt = (0.0, 0.0)
        size = max((b.vertices.max(axis=0) - b.vertices.min(axis=0)).max() for b in model.blocks)
        home = moved(model, 10.0 / size, 0.0, -10.0 / size * model.blocks[0].vertices.mean(axis=0))
        first = solve(home)
        others = [("moved", moved(home, 3.0, 0.0, (700.0, -300.0, 40.0)), {}), ("turned", moved(home, 0.5, 77.0, (3.0, 4.0, 0.0)), {})]
        others += [("in space", home, {"plane": False, "cone": "inner"})] if model.plane else []
        for name, other, how in others:
            second = solve(other, **how)
            what = f"{model.kind} {number} {name}"
            tally.that(what, first.verdict == second.verdict, f"{first.verdict}, {second.verdict}")
            if first.verdict == second.verdict == STANDS:
                tally.near(what, second.multiplier, first.multiplier, 1e-7)


def main():
    tally = Tally()
    for part in (single_blocks, facets, notched, stacks, inclined, overlaps, towers, arches, invariance):
        part(tally)
    print(f"{tally.passed} passed, {tally.failed} failed")
    return 1 if tally.failed else 0
