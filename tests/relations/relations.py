# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The relations: each makes another case of a case, and says how every number of the first must be found in the second."""
import dataclasses
import math
import random

import numpy

import plans
from data import UNITS

BITS, ROUND_OFF = "bits", "round-off"
# Of pieces of the top of a wall of about a metre, whatever the scale; pieces of a wall are one or several.
DRIFTS_OF_PIECES = ("summary: peak_drift", "summary: residual_drift", "summary: peak_in_plane_drift", "peak_drift", "residual_drift", "peak_in_plane_drift",
                    "curves: Out-of-plane drift", "curves: In-plane drift")
AFTER_RUN = ("run", "summary", "assess", "report")


@dataclasses.dataclass
class Change:
    """What is expected: turned by `turn` (an orthogonal matrix), `scale` times as long; equal to the last bit, or but for round-off."""
    turn: numpy.ndarray = dataclasses.field(default_factory=lambda: numpy.eye(3))
    scale: float = 1.0
    equal: str = ROUND_OFF
    more: dict = dataclasses.field(default_factory=dict)  # words for the commands
    leave_out: tuple = ()  # beginnings of names of numbers that are others
    commands: tuple = ("check", "view", "limit", "modes", "run", "summary", "assess", "report", "capacity")
    detail: str = ""
    rewritten: bool = False


def points_moved(case, move):
    """All points of the case by a function of points."""
    for b in case.blocks:
        b.vertices = move(b.vertices)
        b.about = None if b.about is None else move(b.about)
    for load in case.loads + case.growing:
        load.at = None if load.at is None else move(load.at)
    for tie in case.ties:
        tie.start, tie.end = move(tie.start), move(tie.end)
    case.points = {name: move(p) for name, p in case.points.items()}
    case.cuts = [(name, move(p), n) for name, p, n in case.cuts]
    case.pivot = move(case.pivot)
    if case.plan:
        plans.points_moved(case, move)


def shifted(case, d):
    out = case.copy()
    points_moved(out, lambda p: p + d)
    if out.base is not None:
        out.base += d[2]
    out.ground = [(x0 + d[0], x1 + d[0], y0 + d[1], y1 + d[1], level) for x0, x1, y0, y1, level in out.ground]
    if out.house:
        out.house["[house]"]["origin"] = [float(d[0]), float(d[1])]
    return out


def moved(rng, case, far):
    """Moved by a whole or a broken vector of about this length; no component of gravity, record or load changes."""
    d = numpy.array([rng.uniform(-1.0, 1.0) * far, rng.uniform(-1.0, 1.0) * far, rng.uniform(-0.1, 0.3) * min(far, 3000.0)])
    d = numpy.round(d) if rng.random() < 0.5 else numpy.round(d * 1024.0) / 1024.0  # sums with both are exact (generator.on_raster)
    out = shifted(case, d)
    return out, Change(detail=f"by ({d[0]:.10g}, {d[1]:.10g}, {d[2]:.10g})")


def turn_all(case, R):
    out = case.copy()
    points_moved(out, lambda p: p @ R.T)
    out.gravity, out.live = R @ out.gravity, R @ out.live
    axial = numpy.linalg.det(R) * R
    for load in out.loads + out.growing:
        load.force = R @ load.force
        load.moment = None if load.moment is None else axial @ load.moment
    out.samples = None if out.samples is None else out.samples @ R.T
    out.cuts = [(name, p, R @ n) for name, p, n in out.cuts]
    if out.capacity and "direction" in out.capacity:
        out.capacity["direction"] = [float(x) for x in (R @ numpy.array([*out.capacity["direction"], 0.0]))[:2]]
    if out.plan:
        plans.turned(out, R)
    for b in out.blocks:
        b.faces = b.faces if numpy.linalg.det(R) > 0.0 else tuple(f[::-1] for f in b.faces)
        b.velocity = None if b.velocity is None else R @ b.velocity
        b.spin = None if b.spin is None else axial @ b.spin
        if b.motion is not None:
            b.motion = numpy.hstack([b.motion[:, :1], b.motion[:, 1:4] @ R.T, b.motion[:, 4:] @ axial.T])
    return out


def rotation(degrees):
    quarter = round(degrees / 90.0)
    if degrees == 90.0 * quarter:
        c, s = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][quarter % 4]
    else:
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return numpy.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def ground_turned(case, R):
    out = []
    for x0, x1, y0, y1, level in case.ground:
        corners = numpy.array([(x0, y0, 0.0), (x1, y1, 0.0)]) @ R.T
        low, high = corners.min(axis=0), corners.max(axis=0)
        out.append((low[0], high[0], low[1], high[1], level))
    return out


def quarter_turn(rng, case):
    """Turned by 90, 180 or 270 degrees about the upright axis of the case."""
    degrees = rng.choice([90.0, 180.0, 270.0])
    R = rotation(degrees)
    out = turn_all(case, R)
    out.ground = ground_turned(case, R)
    if case.house:
        out.house["[house]"]["turn"] = int(degrees)  # about the origin of the house
    return out, Change(turn=R, detail=f"by {degrees:.0f} degrees")


def any_turn(rng, case):
    """Turned by any angle about the upright axis: boxes become polyhedra, corners are rounded."""
    if case.house or case.ground:
        return None
    degrees = round(rng.uniform(5.0, 85.0) + 90.0 * rng.randrange(4), 2)
    R = rotation(degrees)
    return turn_all(case, R), Change(turn=R, detail=f"by {degrees} degrees")


def two_grids_are_possible(case):
    """Whether a face has two longest edges, neither parallel nor square to each other.

    With "centres" the grid of the face follows one of them, and that of its mirror image the other.
    """
    for block in case.blocks:
        for face in block.faces:
            corners = numpy.asarray(block.vertices)[list(face)]
            edges = numpy.roll(corners, -1, axis=0) - corners
            lengths = numpy.linalg.norm(edges, axis=1)
            longest = edges[lengths > (1.0 - 1e-6) * lengths.max()] / lengths.max()
            cosines = numpy.abs(longest @ longest[0])
            if ((cosines > 1e-6) & (cosines < 1.0 - 1e-6)).any():
                return True
    return False


def mirrored(rng, case):
    """Its mirror image: x, or y, with the other sign."""
    if case.house or (case.rule == "centres" and (case.plan or two_grids_are_possible(case))):
        return None
    R = numpy.diag(rng.choice([(-1.0, 1.0, 1.0), (1.0, -1.0, 1.0)]))
    out = turn_all(case, R)
    out.ground = ground_turned(case, R)
    return out, Change(turn=R, detail="x" if R[0, 0] < 0.0 else "y")


def other_order(rng, case):
    """Blocks, corners of each, and its faces in another order."""
    if case.house:
        return None
    out = case.copy()
    if out.plan:
        plans.in_other_order(rng, out)
    rng.shuffle(out.blocks)
    rng.shuffle(out.loads)
    out.growing.reverse()
    if out.rule != "centres":  # with "centres" the grid begins at the first corner of a face
        for b in out.blocks:
            order = list(range(len(b.vertices)))
            rng.shuffle(order)
            b.vertices = b.vertices[order]
            b.faces = [tuple(order.index(i) for i in face) for face in b.faces]
            rng.shuffle(b.faces)
            b.faces = tuple(face[k:] + face[:k] for face in b.faces for k in [rng.randrange(len(face))])
    return out, Change()


def other_unit(rng, case):
    """The file of stones in another unit."""
    if not case.unit:
        return None
    out = case.copy()
    out.unit = rng.choice([u for u in UNITS if u != "m"])
    return out, Change(detail=out.unit)


def other_names(rng, case):
    """Other names of blocks, ties, followed points and cuts."""
    if case.house or case.plan:
        return None
    out = case.copy()
    new = {b.name: f"stone {i} of {rng.randrange(1000)}" for i, b in enumerate(out.blocks)}
    for b in out.blocks:
        b.name = new[b.name]
    for load in out.loads + out.growing:
        load.block = new[load.block]
    return out, Change(equal=BITS)


def in_two(loads, k):
    """These loads with a quarter and three quarters of one of them in its place, at the end."""
    rest, load = loads[:k] + loads[k + 1:], loads[k]
    return rest + [dataclasses.replace(load, force=share * load.force, moment=None if load.moment is None else share * load.moment) for share in (0.25, 0.75)]


def split_load(rng, case):
    """A load in two parts on the same block; of a cyclic test one that grows."""
    if not case.loads and not case.growing:
        return None
    out = case.copy()
    if out.loads:
        out.loads = in_two(out.loads, rng.randrange(len(out.loads)))
    if out.growing:
        out.growing = in_two(out.growing, 0)
    return out, Change()


def far_building(rng, case):
    """The same again 30 m to the side, or where it casts no shadow: the first one is as it was alone."""
    if case.house or case.plan or case.unit:
        return None
    out = case.copy()
    size = numpy.ptp(numpy.concatenate([b.vertices for b in case.blocks]), axis=0).max()
    d = numpy.array([round(4.0 * size + 10.0) + 0.0, -round(size), 0.0])
    second = shifted(case, d)
    for b in second.blocks:
        b.name = "second " + b.name
    out.blocks += second.blocks
    out.ground += second.ground
    left_out = ("energy", "base", "elements", "joints", "volume", "mass", "damage", "summary", "cracks", "cut", "weight", "bits", "points")
    return out, Change(leave_out=left_out, commands=("run",), detail=f"by ({d[0]:.0f}, {d[1]:.0f}, 0)")


def later_record(rng, case):
    """Other samples before the record, which `motion.from` leaves out."""
    if case.samples is None:
        return None
    out = case.copy()
    n = rng.randrange(1, 40)
    before = numpy.array([[rng.uniform(-5.0, 5.0) for _ in range(3)] for _ in range(n)])
    out.samples, out.start = numpy.concatenate([before, case.samples]), n * case.dt
    return out, Change(equal=BITS, commands=AFTER_RUN, detail=f"by {n} samples")


def threads(rng, case):
    """Two threads in place of one."""
    return case.copy(), Change(equal=BITS, more={"threads": 2})


def reference_kernels(rng, case):
    """The plain kernels in place of the fast ones."""
    return case.copy(), Change(more={"run": ["--kernels", "reference"]}, commands=AFTER_RUN)


def stopped(rng, case):
    """Stopped in the middle, and resumed with two threads; a cyclic test after some of its iterations."""
    frames = round(case.times["duration"] / case.times["frame"])
    more = {"stop": rng.randrange(1, frames) * case.times["frame"], "resumed by": 2, "stop capacity": round(10.0 ** random.Random(f"stop {case.kind}").uniform(-1.0, 1.0), 2)}
    return case.copy(), Change(equal=BITS, more=more, commands=AFTER_RUN + (("capacity",) if case.growing else ()))


def rewritten(rng, case):
    """The case that a run has written beside its results, with all keys."""
    return case.copy(), Change(equal=BITS, rewritten=True)


def scaled(rng, case):
    """Froude's law: lengths by a factor, times by its root, stresses and moduli as lengths, stiffness of joints as it is."""
    if case.house or case.unit:
        return None
    # Runs: a factor whose root is exact, so that settling ends with the same step, and upwards, since a ramp below 0.05 s is damped as one of
    # 0.05 s. It is looked for rest every 0.01 s, whatever the size: capacities begin at another time.
    factor = rng.choice([4.0, 4.0, round(rng.uniform(0.2, 5.0), 2)])
    commands = ("check", "view", "limit", "modes") + (AFTER_RUN if factor == 4.0 else ())
    out, root = case.copy(), math.sqrt(factor)
    points_moved(out, lambda p: factor * p)
    if out.plan:
        plans.scaled(out, factor)
    if out.base is not None:
        out.base *= factor
    out.ground = [tuple(factor * v for v in part) for part in out.ground]
    for load in out.loads:
        load.force = factor**3 * load.force
        load.moment = None if load.moment is None else factor**4 * load.moment
    for tie in out.ties:  # E A as a force
        tie.area, tie.young, tie.pretension = tie.area * factor**2, tie.young * factor, tie.pretension * factor**3
        tie.yields = None if tie.yields is None else tie.yields * factor
    for m in out.materials.values():
        m["young"] *= factor
    powers = {"tension": 1, "cohesion": 1, "compression": 1, "young": 1, "thickness": 1, "fracture_energy_tension": 2, "fracture_energy_shear": 2}
    for law in out.laws.values():
        law.update({k: law[k] * factor**n for k, n in powers.items() if k in law})
    out.times = {k: v * root for k, v in case.times.items()}
    out.dt, out.alpha = case.dt * root, case.alpha / root
    out.size = None if case.size is None else case.size * factor
    for b in out.blocks:
        b.velocity = None if b.velocity is None else b.velocity * root
        b.spin = None if b.spin is None else b.spin / root
        if b.motion is not None:
            b.motion = b.motion * numpy.array([root, factor, factor, factor, 1.0, 1.0, 1.0])
    absolute = ("summary: settled", "settled", "summary: touching", "summary: deep", "summary: debris", "acceleration ")  # the last: below 50 Hz
    if case.plan:
        absolute += ("joint area", "element mass", "element inertia")  # bricks end on whole nanometres, whatever the scale
        absolute += ("summary: damage_grade", "damage_grade")  # by widths of cracks in millimetres
        absolute += DRIFTS_OF_PIECES + plans.sides(case)
    return out, Change(scale=factor, detail=f"by {factor}", commands=commands, leave_out=absolute)


RELATIONS = {"moved 1 m": lambda r, c: moved(r, c, 1.0), "moved 100 m": lambda r, c: moved(r, c, 100.0),
             "moved 10 km": lambda r, c: moved(r, c, 1e4), "moved 10000 km": lambda r, c: moved(r, c, 9.99e6),
             "turned by quarters": quarter_turn, "turned": any_turn, "mirrored": mirrored, "another order": other_order, "another unit": other_unit,
             "other names": other_names, "a load in two": split_load, "a far building": far_building, "record later": later_record,
             "two threads": threads, "reference kernels": reference_kernels, "stopped": stopped, "rewritten": rewritten, "scaled": scaled}
