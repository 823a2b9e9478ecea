# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A random model by its seed and number: a kind of structure, and what a user may do to it: size, place, turn, order, digits, friction, loads.
Coordinates are rounded first; the reference reads the rounded ones."""
import math
import random

import numpy

import plane_kinds
import space_kinds
from contacts import Doubtful, find_contacts
from shapes import BOX_FACES, Block, Tie, turned, unit, upright_box, volume_and_centroid

MOST_BLOCKS = 60
LEAST_TIE = 0.02  # m


def mirrored(model):
    for block in model.blocks:
        block.vertices = block.vertices * (-1.0, 1.0, 1.0)
        block.faces = tuple(face[::-1] for face in block.faces)
        if block.box:
            (x0, y0, z0), (x1, y1, z1) = block.box
            rebuilt = upright_box(block.name, (-x1, y0, z0), (-x0, y1, z1), block.material, block.fixed)
            block.vertices, block.faces, block.box = rebuilt.vertices, rebuilt.faces, rebuilt.box
    for outline in model.outlines:
        outline.vertices, outline.faces = outline.vertices * (-1.0, 1.0, 1.0), tuple(face[::-1] for face in outline.faces)
    for load in model.loads:
        load.force = (-load.force[0], *load.force[1:])


def on_slab(rng, model):
    """Replaces the base by a fixed block."""
    low = numpy.min([b.vertices.min(axis=0) for b in model.blocks], axis=0)
    high = numpy.max([b.vertices.max(axis=0) for b in model.blocks], axis=0)
    more = rng.uniform(0.0, 1.0)
    flush = model.plane or rng.random() < 0.3
    side = 0.0 if flush else more
    model.blocks.append(upright_box("slab", (low[0] - more, low[1] - side, low[2] - 0.7), (high[0] + more, high[1] + side, low[2]), fixed=True))
    model.base = None


def rub(rng, model):
    """Sets friction by one of the keys for it."""
    angle = lambda: round(math.degrees(math.atan(rng.choice([rng.uniform(0.15, 0.3), rng.uniform(0.15, 0.5), rng.uniform(0.4, 1.0)]))), 2)
    model.friction = angle()
    if model.base is not None and rng.random() < 0.2:
        model.between.append(("base", "stone", angle()))
    if rng.random() < 0.1:
        model.law_friction = angle()


def load_points(rng, model):
    """Moves some loads beside the centroid, or gives them a moment; in a plane model both stay in the plane."""
    for load in model.loads:
        block = next(b for b in model.blocks if b.name == load.block)
        if rng.random() < 0.5:
            middle = block.vertices.mean(axis=0)
            at = middle + rng.uniform(0.0, 0.6) * (rng.choice(list(block.vertices)) - middle)
            load.at = (at[0], middle[1] if model.plane else at[1], at[2])
        if rng.random() < 0.3:
            load.moment = (0.0, rng.uniform(-0.2, 0.2), 0.0)


def rounded(points, digits):
    return numpy.array([[round(float(x), digits) + 0.0 for x in p] for p in points])


def put(block, change, digits):
    """A block with its corners changed and rounded."""
    out = Block(block.name, rounded(change(block.vertices), digits), block.faces, block.material, block.fixed, stone=block.stone)
    corners = out.vertices
    if block.box and (corners[0] <= corners[6]).all() and upright_box("", corners[0], corners[6]).vertices.tolist() == corners.tolist():
        out.box, out.faces = (tuple(corners[0]), tuple(corners[6])), BOX_FACES
    return out


def place(rng, model, scale):
    """Sets size, place and rotation: in the coordinates, or by keys."""
    way = rng.choice(["as it is", "as it is", "quarter", "turned", "key", "stones"])
    if way == "stones" and len(model.density) > 1:
        way = "key"
    if model.outlines:
        way = "stones"
    angle = {"as it is": 0.0, "quarter": rng.choice([90.0, 180.0, 270.0])}.get(way, round(rng.uniform(-180.0, 180.0), 2))
    exact = model.exact or way == "turned"
    largest = min(1e6, 1e5 * scale) if angle % 90.0 or exact else 1e6
    far = rng.choice([0.0, 1.0, 100.0, 1e4, 1e6])
    digits = (11 if exact else rng.choice([3, 4, 5])) - math.floor(math.log10(scale))
    height = rng.choice([0.0, round(rng.uniform(-20.0, 80.0), 2)])
    origin = numpy.array([round(rng.uniform(-1.0, 1.0) * min(far, largest), 3) for _ in range(2)] + [height])
    by_keys = way in ("key", "stones")
    shift = numpy.zeros(3) if way == "stones" else origin
    change = lambda points: turned(numpy.asarray(points) * scale, 0.0 if by_keys else angle) + shift
    model.written = [put(block, change, digits) for block in model.blocks]
    model.outlines = [put(block, change, digits) for block in model.outlines]
    model.turn, model.form = ((angle, tuple(origin)) if by_keys else None), ("stones" if way == "stones" else "blocks")
    last = lambda points: turned(points, angle) + origin if way == "stones" else turned(points, angle, origin) if by_keys else points
    model.blocks = [Block(b.name, numpy.asarray(last(b.vertices)), b.faces, b.material, b.fixed, stone=b.stone) for b in model.written]
    if model.base is not None:
        model.base = float(origin[2])
    weight = 2300.0 * model.gravity * scale**3
    for load in model.loads:
        load.force = tuple(turned([load.force], angle)[0] * weight)
        load.moment = tuple(turned([load.moment], angle)[0] * weight * scale)
        if load.at is not None:
            load.at = tuple((turned([numpy.array(load.at) * scale], angle) + origin)[0])
            if model.plane:  # in the middle of the block as rounded
                middle = next(b for b in model.blocks if b.name == load.block).vertices.mean(axis=0)
                normal = unit(angle + 90.0)
                load.at = tuple(load.at - normal * ((numpy.array(load.at) - middle) @ normal))
    return angle


def on_part(rng, model, angle):
    """Lowers the base and puts all blocks on a part of it: a rectangle along the axes."""
    if model.base is None or (model.turn and model.turn[0] % 90.0) or rng.random() > 0.2:
        return
    corners = numpy.concatenate([b.vertices for b in model.blocks])
    low, high = corners.min(axis=0), corners.max(axis=0)
    level = float(f"{rng.uniform(0.1, 1.0) * (high - low)[2]:.3g}")
    size = (high - low)[:2]
    more = [0.0 if model.plane and abs(unit(angle)[k]) < 0.5 else rng.uniform(0.0, 0.2) for k in (0, 1)]
    low, high = low[:2] - more * size, high[:2] + more * size
    base = model.base - level
    top = base + level
    model.blocks.append(upright_box("ground", (*low, base), (*high, top), "base", fixed=True))
    model.blocks[-1].ground = True
    model.base = base


def aim(rng, model, angle):
    """Sets the direction of the live force, and a tilt of the base."""
    if model.plane:
        model.direction = angle + rng.choice([0.0, 180.0])
        level, about = angle % 90.0 == 0.0, ("x" if angle % 180.0 else "y")
    else:
        model.direction = rng.choice([0.0, 90.0, 180.0, 270.0, angle, round(rng.uniform(0.0, 360.0), 1), round(rng.uniform(0.0, 360.0), 1)])
        level, about = True, rng.choice("xyb")
    if model.base is not None and level and rng.random() < (0.1 if model.plane else 0.25):
        model.tilt = tuple(round(rng.uniform(-8.0, 8.0), 2) if about in (axis, "b") else 0.0 for axis in "xy")
    model.direction = (model.direction + 180.0) % 360.0 - 180.0
    if not model.plane:
        model.facets, model.cone = rng.choice([8, 8, 8, 12, 16]), rng.choice(["inner", "inner", "outer"])


def choose_points(rng, model, scale):
    """Chooses the rule of contact points; `centres` only if the documents determine the points."""
    if rng.random() < 0.3:
        model.size = round(scale * rng.uniform(0.12, 0.6), 3 - math.floor(math.log10(scale)))
    if rng.random() > 0.3 or model.outlines:
        return
    middle = model.blocks[0].vertices[0]
    near = [Block(b.name, b.vertices - middle, b.faces, b.material, b.fixed, ground=b.ground) for b in model.blocks]
    try:
        find_contacts(near, None if model.base is None else model.base - middle[2], "centres", model.size)
        model.rule = "centres"
    except Doubtful:
        pass


def tie_up(rng, model):
    """Ties between middles of blocks, or from one to the base. They take a plane model out of its plane."""
    solid = [b for b in model.blocks if not b.stone and not b.ground]
    weight = model.gravity * sum(volume_and_centroid(b.vertices, b.faces)[0] * model.density[b.material] for b in solid if not b.fixed)
    if len(solid) < 2:
        return
    least = max(LEAST_TIE, 0.1 * numpy.ptp(solid[0].vertices, axis=0).max())
    for _ in range(rng.randint(1, 4)):
        one, other = rng.sample(solid, 2)
        ends, names = [one.vertices.mean(axis=0), other.vertices.mean(axis=0)], [one.name, other.name]
        if model.base is not None and not any(b.ground for b in model.blocks) and rng.random() < 0.4:
            at = ends[0] + numpy.ptp(ends[0] - one.vertices, axis=0).max() * numpy.array([rng.uniform(-2, 2), rng.uniform(-2, 2), 0.0])
            ends[1], names[1] = numpy.array([at[0], at[1], model.base]), None
        if numpy.linalg.norm(ends[1] - ends[0]) < least or (one.fixed and (names[1] is None or other.fixed)):
            continue
        most = None if rng.random() < 0.15 else float(f"{weight * 10.0**rng.uniform(-2.5, 0.3):.4g}")
        model.ties.append(Tie(tuple(names), tuple(tuple(float(x) for x in end) for end in ends), most, rng.random() < 0.2))
    model.plane = model.plane and not model.ties


def make(seed, number, share=None, ties=False):
    """share: "plane" or "space"; None: either. ties: with some, where blocks are large enough and are no file of stones."""
    rng = random.Random(f"{seed}:{number}")
    while True:
        kinds = {"plane": plane_kinds.KINDS, "space": space_kinds.KINDS}[share or rng.choice(["plane", "space"])]
        model = rng.choice(kinds)(rng)
        if len(model.blocks) < MOST_BLOCKS:
            break
    model.density["stone"] = 2300.0
    model.gravity = rng.choice([9.8, 9.8, 9.8, round(rng.uniform(1.6, 15.0), 2)])
    scale = float(f"{10.0**rng.uniform(-2.2, 0.5):.2g}")
    if rng.random() < 0.5:
        mirrored(model)
    if model.base is not None and rng.random() < 0.2:
        on_slab(rng, model)
    rub(rng, model)
    load_points(rng, model)
    angle = place(rng, model, scale)
    order = list(range(len(model.blocks)))
    rng.shuffle(order)
    model.blocks, model.written = [model.blocks[i] for i in order], [model.written[i] for i in order]
    if angle % 90.0 == 0.0:
        on_part(rng, model, angle)
    aim(rng, model, angle)
    choose_points(rng, model, scale)
    if ties and model.form == "blocks" and len(model.blocks) > 1:
        tie_up(random.Random(f"ties {seed}:{number}"), model)
    return model
