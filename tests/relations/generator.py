# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A small random model by seed and number: structures of scripts/limit_check, arches and walls with ties, huts; dry, bonded or both; loads,
parts of the base, gravity that leans, a short record. Nothing is alike on both sides, so that events have one order."""
import itertools
import math
import pathlib
import random
import sys

import numpy

import plans
from data import Block, Case, Load, Tie
from relations import points_moved

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent.parent / "scripts/limit_check"))
import plane_kinds
import space_kinds

KINDS = tuple(k for k in plane_kinds.KINDS if k is not plane_kinds.notched) + tuple(k for k in space_kinds.KINDS if k is not space_kinds.boulder)
MOST_BLOCKS = 24


def rounded(points, exact, rng_dyadic, size):
    """Coordinates as users write them, or multiples of a power of two, which no offset of this kind rounds."""
    if exact:
        return numpy.asarray(points, float)
    if rng_dyadic:
        step = 2.0**-20
        return numpy.round(numpy.asarray(points, float) / step) * step + 0.0
    return numpy.round(numpy.asarray(points, float), 5) + 0.0


def laws(rng, case, strong):
    """Bonds: strong ones stay whole, weak ones crack under the record."""
    stress = 1e6 if strong else 10.0 ** rng.uniform(3.0, 4.3)
    law = {"tension": stress, "cohesion": stress * rng.uniform(1.0, 2.0), "friction": round(rng.uniform(25.0, 40.0), 2), "compression": 1e3 * stress}
    if rng.random() < 0.5:
        law |= {"normal_stiffness": 10.0 ** rng.uniform(9.5, 10.5)}
        law |= {"shear_stiffness": 0.4 * law["normal_stiffness"]}
        if not strong and rng.random() < 0.5:
            law |= {"fracture_energy_tension": 5.0 + stress**2 / law["normal_stiffness"], "fracture_energy_shear": 50.0 + 8.0 * stress**2 / law["shear_stiffness"]}
    elif rng.random() < 0.5:
        law |= {"thickness": 0.01, "young": 1e9, "poisson": 0.2}
    case.laws["mortar"] = law


def joints(rng, case):
    way = rng.choice(["dry", "strong", "weak", "mixed"])
    case.kind += ", " + way
    if way == "dry":
        return
    laws(rng, case, way == "strong")
    case.default = "mortar"
    if way == "mixed" and case.base is not None:
        case.between.append(("stone", "base", "dry"))


def record(rng, case, strength):
    """Random accelerations that begin and end at rest, linear from sample to sample."""
    n = max(2, round(case.times["duration"] / case.dt))
    t = numpy.arange(n + 1) / n
    wave = lambda: sum(rng.uniform(-1.0, 1.0) * numpy.sin(math.pi * k * t) for k in range(1, 5))
    case.samples = strength * numpy.array([wave(), wave(), 0.3 * wave()]).T
    case.samples[[0, -1]] = 0.0


def set_times(rng, case):
    case.times = {"ramp": 0.06, "settle": 0.0, "duration": 0.06, "history": 0.002, "frame": 0.01, "ledger": 0.01}
    case.dt, case.alpha = 0.002, round(rng.uniform(20.0, 120.0), 1)


def load_some(rng, case, weight):
    free = [b for b in case.blocks if not b.fixed]
    for block in rng.sample(free, min(len(free), rng.randint(0, 2))):
        part = weight / len(free)
        force = numpy.array([rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), -rng.uniform(0.1, 1.0)]) * part
        load = Load(block.name, force)
        if rng.random() < 0.4:
            load.at = block.middle() + 0.3 * rng.random() * (block.vertices[rng.randrange(len(block.vertices))] - block.middle())
        if rng.random() < 0.3:
            load.moment = numpy.array([rng.uniform(-0.05, 0.05) for _ in range(3)]) * part * numpy.ptp(block.vertices, axis=0).min()
        load.follows = rng.random() < 0.2
        case.loads.append(load)


def tie_some(rng, case, weight):
    free = [b for b in case.blocks if not b.fixed]
    if len(free) < 3 or rng.random() < 0.6:
        return
    one, other = rng.sample(free, 2)
    tie = Tie("rod", one.middle(), other.middle(), 1e-4, 2e11, pretension=rng.choice([0.0, 200.0]), compression=rng.random() < 0.3)
    strength = random.Random(one.name + other.name).uniform(-0.5, 0.5) * weight  # of half of the rods; drawn aside, so that no other number changes
    if strength > tie.pretension:
        tie.yields = strength / tie.area
    case.ties.append(tie)
    case.kind += ", tied" if tie.yields is None else ", tied by a rod that yields"


def on_part(rng, case):
    corners = numpy.concatenate([b.vertices for b in case.blocks])
    low, high = corners.min(axis=0), corners.max(axis=0)
    if case.base is None or low[2] != case.base or rng.random() > 0.2:
        return
    case.base -= 0.5
    case.ground.append((low[0] - 0.25, high[0] + 0.5, low[1] - 0.25, high[1] + 0.25, 0.5))
    case.kind += ", on a part"


def follow(case):
    """The highest free block and the free block that is nearest to the foot."""
    free = sorted((b for b in case.blocks if not b.fixed), key=lambda b: (b.middle()[2], b.name))
    case.points = {"top": free[-1].middle(), "foot": free[0].middle()}
    corners = numpy.concatenate([b.vertices for b in case.blocks])
    low, high = corners.min(axis=0), corners.max(axis=0)
    cut, normal = low + (high - low) * numpy.array([0.4, 0.45, 0.37]), numpy.array([0.1, 0.2, 1.0])
    heights = [float((b.vertices.mean(axis=0) - cut) @ normal) for b in case.blocks] + ([-1.0] if case.base is not None else [])
    margin = 0.02 * (high - low)[2]  # the mean of the corners is not the centroid
    if min(heights) < -margin and max(heights) > margin:  # else it may lie between no two blocks
        case.cuts = [("across", cut, normal)]
    case.pivot = low


def structure(rng):
    """Blocks of a kind of limit_check, smaller and turned to no axis of symmetry."""
    while True:
        model = rng.choice(KINDS)(rng)
        if 1 <= sum(not b.fixed for b in model.blocks) and len(model.blocks) <= MOST_BLOCKS:
            break
    scale = float(f"{10.0**rng.uniform(-0.7, 0.0):.2g}")
    dyadic = rng.random() < 0.5
    case = Case(model.kind, base=model.base)
    for b in model.blocks:
        case.blocks.append(Block(b.name, rounded(b.vertices * scale, model.exact, dyadic, scale), tuple(tuple(f) for f in b.faces), "stone", b.fixed))
    case.materials["stone"] = {"density": round(rng.uniform(1600.0, 2600.0)), "young": round(rng.uniform(2.0, 8.0), 2) * 1e9, "poisson": 0.2}
    case.friction = round(rng.uniform(25.0, 40.0), 2)
    return case, scale


def hut(rng):
    """A house of large bricks, in mortar, with an opening or none."""
    case = Case("hut")
    dry = rng.random() < 0.3
    case.materials = {"stone": {"density": 1800, "young": 2e9, "poisson": 0.2}, "wood": {"density": 600, "young": 1e10, "poisson": 0.3}}
    stress = 10.0 ** rng.uniform(3.5, 5.5)
    case.laws["mortar"] = {"tension": stress, "cohesion": 1.5 * stress, "friction": 35.0, "compression": 1e3 * stress, "thickness": 0.01, "young": 1e9, "poisson": 0.2}
    case.laws["timber"] = {"tension": 1e7, "cohesion": 1e7, "friction": 35.0, "compression": 1e8}
    size = [rng.choice([1.2, 1.6]), rng.choice([1.2, 1.6])]
    house = {"inner_size": size, "height": rng.choice([0.8, 1.2]), "brick": [0.4, 0.2, 0.2], "bond": "running", "material": "stone",
             "joint": "dry" if dry else "mortar", "bearing_wall": 0.2, "nonbearing_wall": 0.2, "origin": [0.0, 0.0], "turn": 0,
             "walls": rng.choice([["front", "right", "rear", "left"], ["front", "right", "rear"]])}
    case.house = {"[house]": house, "[house.wood]": {"material": "wood", "within_member": "timber", "between_members": "mortar"}}
    if rng.random() < 0.6:
        case.house["[[house.opening]]"] = [{"wall": "front", "from": 0.6, "width": 0.4, "sill": 0.0, "height": 0.4, "lintel": {"length": 0.8, "height": 0.2, "element": 0.4}}]
    case.friction = 32.0
    case.points = {"top": numpy.array([0.35, 0.1, house["height"] - 0.1]), "foot": numpy.array([0.7, size[1] + 0.3, 0.3])}
    case.cuts = [("across", numpy.array([0.3, 0.4, 0.45]), numpy.array([0.0, 0.0, 1.0]))]
    case.pivot = numpy.zeros(3)
    case.kind += ", dry" if dry else ", bonded"
    return case


def load_slowly(rng, case):
    """Some small models have a capacity, too."""
    if not case.house and not case.plan and len(case.blocks) <= 8 and rng.random() < 0.3:
        angle = rng.uniform(0.0, 2.0 * math.pi)
        case.capacity = {"kind": rng.choice(["pushover", "tilt"]), "direction": [math.cos(angle), math.sin(angle)]}


def move_a_support(rng, case):
    """A support of some models moves a little, and turns about its centroid or about a point."""
    fixed = [b for b in case.blocks if b.fixed]
    if case.house or case.unit or case.capacity or not fixed or rng.random() < 0.6:
        return
    block, size = rng.choice(fixed), max(float(numpy.ptp(b.vertices, axis=0).max()) for b in case.blocks)
    times = [case.times["duration"] * k / 4.0 for k in range(5)]
    rows = [[t] + [rng.uniform(-1e-4, 1e-4) * (size if k < 3 else 1.0) for k in range(6)] for t in times]
    rows[0][1:] = [0.0] * 6
    block.motion = numpy.array(rows)
    if rng.random() < 0.5:
        block.about = block.vertices.mean(axis=0) + numpy.array([rng.uniform(-size, size) for _ in range(3)])
    case.kind += ", a support turns"


def move_slowly(rng, case):
    """Small models whose support moves are also led from one state of rest to the next while it does."""
    if any(b.motion is not None for b in case.blocks) and len(case.blocks) <= 24:
        case.capacity = {"kind": rng.choice(["rest", "settlement"])}


def push_to_and_fro(case):
    """Small models that are led through nothing else are pushed to and fro, some at two blocks. Drawn aside, so that no other number changes."""
    rng = random.Random(f"to and fro {case.kind} {case.pivot}")
    free = sorted((b for b in case.blocks if not b.fixed), key=lambda b: (b.middle()[2], b.name))
    if case.capacity or case.house or case.plan or len(free) > 16 or any(b.motion is not None for b in case.blocks) or rng.random() < 0.5:
        return
    angle, height = rng.uniform(0.0, 2.0 * math.pi), float(numpy.ptp(numpy.concatenate([b.vertices for b in case.blocks])[:, 2]))
    direction = [math.cos(angle), math.sin(angle)]
    weight = sum(float(numpy.prod(numpy.ptp(b.vertices, axis=0))) for b in free) * 2e4
    for block in [free[-1]] + (rng.sample(free, 1) if rng.random() < 0.3 else []):
        case.growing.append(Load(block.name, numpy.array([*direction, 0.0]) * weight / (1 + len(case.growing))))
    if rng.random() < 0.4:
        case.growing[0].at = free[-1].middle() + 0.3 * rng.random() * (free[-1].vertices[0] - free[-1].middle())
    first = float(f"{height * 10.0**rng.uniform(-4.5, -3.0):.3g}")
    case.capacity = {"kind": "cyclic", "direction": direction, "amplitudes": [first, 2.0 * first], "cycles": rng.choice([1, 2])}


def on_raster(case):
    """All points on a raster so fine that a point moved by 10,000 km is still a double without rounding."""
    def nearest(p):
        return numpy.round(p * 2.0**29) / 2.0**29
    points_moved(case, nearest)
    case.ground = [tuple(float(nearest(v)) for v in strip) for strip in case.ground]


def faces_are_plane(case):
    """Whether the raster has left all faces as plane as the program asks, with a margin
    (geometry/validate.cpp: 1e-9 of the block's size)."""
    for block in case.blocks:
        points = numpy.asarray(block.vertices)
        allowed = 0.8e-9 * numpy.ptp(points, axis=0).max()
        for face in block.faces:
            corners = points[list(face)] - points[list(face)].mean(axis=0)
            normal = numpy.cross(corners, numpy.roll(corners, -1, axis=0)).sum(axis=0)
            if numpy.abs(corners @ normal).max() > allowed * numpy.linalg.norm(normal):
                return False
    return True


def make(seed, number, plan=False):
    """The first model of this number whose faces are plane; the raster bends those of some leaning ones. plan: walls of any plan."""
    if plan:
        return drawn_plan(random.Random(f"plans {seed}:{number}"))
    for draw in itertools.count():
        case = drawn(random.Random(f"relations {seed}:{number}" + (f":{draw}" if draw else "")))
        if faces_are_plane(case):
            return case


def drawn_plan(rng):
    """Walls of any plan with floors and roofs, in mortar or dry, under a record."""
    case = plans.plan(rng)
    set_times(rng, case)
    joints(rng, case)
    finish(rng, case)
    on_raster(case)
    divide_bricks(case)
    return case


def divide_bricks(case):
    """Cells of the bricks of four plans in ten, drawn aside, so that no other number changes; strong ones, or ones that crack."""
    rng = random.Random(f"cells {[(w['thickness'], w['height']) for w in case.plan['wall']]}")
    if rng.random() < 0.6:
        return
    case.kind += ", cells"
    stress = 10.0 ** rng.uniform(3.5, 5.5)
    case.laws["brick"] = {"tension": stress, "cohesion": 2.0 * stress, "friction": 40.0, "compression": 20.0 * stress}
    case.materials["stone"]["inside"] = "brick"
    for w in case.plan["wall"]:
        w["cells"] = rng.choice([[2, 1, 1], [2, 1, 2], [3, 2, 1], [1, 2, 2]])


def finish(rng, case):
    """Gravity, segments, a record, and the direction of a live load."""
    case.gravity = numpy.array([0.0, 0.0, -9.8])
    if rng.random() < 0.3:
        case.gravity += numpy.array([rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5), 0.0])
    case.rule = rng.choice(["centres", "rim"])
    # Without a draw, so that models of all seeds stay as they were.
    if case.rule == "rim" and ", dry" in case.kind and not case.house and len(case.blocks) % 2:
        case.rule = "corners"
    record(rng, case, 10.0 ** rng.uniform(-0.3, 0.7))
    angle = math.radians(rng.uniform(0.0, 360.0))
    case.live = numpy.array([math.cos(angle), math.sin(angle), 0.0])


def drawn(rng):
    """A model; its points lie on the raster, its faces may not be plane."""
    if rng.random() < 0.12:
        case = hut(rng)
        set_times(rng, case)
    else:
        case, scale = structure(rng)
        set_times(rng, case)
        joints(rng, case)
        volume = sum(float(numpy.prod(numpy.ptp(b.vertices, axis=0))) for b in case.blocks)
        load_some(rng, case, volume * 2000.0 * 9.8)
        tie_some(rng, case, volume * 2000.0 * 9.8)
        on_part(rng, case)
        follow(case)
        if rng.random() < 0.25:
            case.unit = "m"
            case.kind += ", stones"
    finish(rng, case)
    load_slowly(rng, case)
    move_a_support(rng, case)
    move_slowly(rng, case)
    push_to_and_fro(case)
    on_raster(case)
    return case
