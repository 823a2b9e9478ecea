# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The multiplier of associated flow by the static theorem (solver/limit/LIMIT.md), one linear programme for HiGHS.

Unknowns: a force >= 0 along each edge of the polygonal cone of each contact point, and the multiplier. Equations: balance of each body,
divided by the mean weight and, for moments about the centroid, by the body's radius. All lengths are taken from the model's own middle.
"""
import dataclasses

import numpy
import scipy.optimize
import scipy.sparse

from contacts import BASE, find_contacts
from shapes import Block, Model, unit, volume_and_centroid

STANDS, FALLS, MARGINAL, UNBOUNDED, UNSURE = "stands", "falls", "marginal", "unbounded", "unsure"
FALLING, RESTING = 1e-6, 1e-9  # power of the dead forces under velocities up to 1, in mean weights: falls above, stands below
LARGEST = 999.0  # the program's own bound is 1,000
GAP = 1e-8  # that the two bounds of a result may differ by, relative to 1 + multiplier


@dataclasses.dataclass
class Answer:
    verdict: str
    multiplier: float = None
    error: float = 0.0  # how far the two bounds (of forces, of velocities) are apart
    contacts: int = 0
    velocities: numpy.ndarray = None  # of the free bodies, six each: the mechanism, or the fall


def friction_of(model, contact):
    """Tangent of the angle of friction of a contact."""
    if model.law_friction is not None:
        return numpy.tan(numpy.radians(model.law_friction))
    pair = {model.blocks[contact.a].material, "base" if contact.b == BASE else model.blocks[contact.b].material}
    angle = next((angle for one, two, angle in model.between if {one, two} == pair), model.friction)
    return numpy.tan(numpy.radians(angle))


def gravity_of(model):
    """Gravity in axes of the base, which is rotated about x, then about y."""
    g = numpy.array([0.0, 0.0, -model.gravity])
    if model.base is None:
        return g
    ax, ay = numpy.radians(model.tilt)
    g = numpy.array([0.0, g[2] * numpy.sin(ax), g[2] * numpy.cos(ax)])
    return numpy.array([-g[2] * numpy.sin(ay), g[1], g[2] * numpy.cos(ay)])


def shears(normal, live, facets, cone):
    """Corners of the polygon of unit shears in a joint: one in the direction of the live force, projected on the joint."""
    first = live - numpy.dot(live, normal) * normal
    if numpy.linalg.norm(first) < 1e-6:
        first = numpy.array([0.0, 0.0, 1.0]) - normal[2] * normal
    first = first / numpy.linalg.norm(first)
    second = numpy.cross(normal, first)
    radius, shift = (1.0, 0.0) if cone == "inner" else (1.0 / numpy.cos(numpy.pi / facets), 0.5)
    return [radius * (numpy.cos(a) * first + numpy.sin(a) * second) for a in 2.0 * numpy.pi * (numpy.arange(facets) + shift) / facets]


def ends_in_plane(points, normal, live):
    """The two outermost contact points of a joint seen across the plane, and its two shears."""
    along = live - numpy.dot(live, normal) * normal
    if numpy.linalg.norm(along) < 1e-6:
        along = numpy.array([0.0, 0.0, 1.0])
    along = along / numpy.linalg.norm(along)
    places = points @ along
    return points[[int(places.argmin()), int(places.argmax())]], [along, -along]


def first_pieces(blocks):
    """For each block, the number of the first piece of its stone, which represents the body."""
    firsts = {}
    return [firsts.setdefault(block.stone or block.name, i) for i, block in enumerate(blocks)]


class Programme:
    """Columns: unit forces along the edges of all cones. dead, live: forces on the free bodies. Rows: three per body in a plane, else six."""

    def __init__(self, model: Model, plane=None, facets=None, cone=None):
        plane = model.plane if plane is None else plane
        facets, cone = facets or model.facets, cone or model.cone
        middle = numpy.round(numpy.mean([block.vertices.mean(axis=0) for block in model.blocks], axis=0), 3)
        blocks = [Block(b.name, b.vertices - middle, b.faces, b.material, b.fixed, ground=b.ground, stone=b.stone) for b in model.blocks]
        self.contacts = find_contacts(blocks, None if model.base is None else model.base - middle[2], model.rule, model.size)
        self.direction = unit(model.direction)
        self.body = first_pieces(blocks)
        self.free = [i for i, block in enumerate(blocks) if not block.fixed and self.body[i] == i]
        self.row = {i: 6 * n for n, i in enumerate(self.free)}
        self.masses, self.centres, self.radii = {}, {}, {}
        for i in self.free:
            pieces = [block for block, body in zip(blocks, self.body) if body == i]
            parts = [volume_and_centroid(block.vertices, block.faces) for block in pieces]
            volume = sum(v for v, _ in parts)
            self.centres[i] = sum(v * c for v, c in parts) / volume
            self.masses[i] = volume * model.density[blocks[i].material]
            self.radii[i] = max(numpy.linalg.norm(block.vertices - self.centres[i], axis=1).max() for block in pieces)
        self.unit_force = model.gravity * sum(self.masses.values()) / len(self.free)
        self._forces(model, blocks, middle)
        self._columns(model, plane, facets, cone)
        self._ties(model, middle, {block.name: body for block, body in zip(blocks, self.body)})
        self.keep = None  # what of six velocities a body is left in a plane
        if plane:
            self._keep_plane()

    def _forces(self, model, blocks, middle):
        gravity = gravity_of(model)
        self.dead, self.live = numpy.zeros(6 * len(self.free)), numpy.zeros(6 * len(self.free))
        for i in self.free:
            r = self.row[i]
            self.dead[r:r + 3] += self.masses[i] * gravity / self.unit_force
            self.live[r:r + 3] += self.masses[i] * model.gravity * self.direction / self.unit_force
        number = {block.name: i for i, block in enumerate(blocks)}
        for load in model.loads:
            i = number[load.block]
            r, force = self.row[i], numpy.array(load.force)
            arm = numpy.zeros(3) if load.at is None else numpy.array(load.at) - middle - self.centres[i]
            self.dead[r:r + 3] += force / self.unit_force
            self.dead[r + 3:r + 6] += (numpy.array(load.moment) + numpy.cross(arm, force)) / (self.unit_force * self.radii[i])

    def _columns(self, model, plane, facets, cone):
        rows, columns, values, count = [], [], [], 0
        for contact in self.contacts:
            one, other = self.body[contact.a], BASE if contact.b == BASE else self.body[contact.b]
            if one == other:
                continue
            tan = friction_of(model, contact)
            if plane:
                points, corners = ends_in_plane(contact.points, contact.normal, self.direction)
            else:
                points, corners = contact.points, shears(contact.normal, self.direction, facets, cone)
            for point in points:
                for shear in corners:
                    force = contact.normal - tan * shear  # of a on b; N = 1
                    for body, f in ((other, force), (one, -force)):
                        if body not in self.row:
                            continue
                        moment = numpy.cross(point - self.centres[body], f) / self.radii[body]
                        rows += range(self.row[body], self.row[body] + 6)
                        columns += [count] * 6
                        values += [*f, *moment]
                    count += 1
        self.matrix = scipy.sparse.csr_matrix((values, (rows, columns)), shape=(6 * len(self.free), count))

    def _ties(self, model, middle, body_of):
        """A column for the tension of each tie, and one for its compression where it bears any; `most` of each, inf: no limit."""
        pulls, self.most = [], []
        for tie in model.ties:
            ends = [numpy.array(p) - middle for p in tie.points]
            along = (ends[1] - ends[0]) / numpy.linalg.norm(ends[1] - ends[0])
            pull = numpy.zeros(6 * len(self.free))
            for name, end, force in zip(tie.blocks, ends, (along, -along)):
                body = None if name is None else body_of[name]
                if body in self.row:
                    r = self.row[body]
                    pull[r:r + 3] += force
                    pull[r + 3:r + 6] += numpy.cross(end - self.centres[body], force) / self.radii[body]
            for sign in (1.0, -1.0)[:1 + tie.compression]:
                pulls.append(sign * pull)
                self.most.append(numpy.inf if tie.most is None else tie.most / self.unit_force)
        self.pulls = numpy.array(pulls).reshape(len(pulls), 6 * len(self.free)).T
        self.most = numpy.array(self.most)

    def _keep_plane(self):
        """Force along the direction, force upwards, moment about the normal of the plane."""
        across = numpy.cross(numpy.array([0.0, 0.0, 1.0]), self.direction)
        along = scipy.sparse.csr_matrix(numpy.array([[*self.direction, 0, 0, 0], [0, 0, 1.0, 0, 0, 0], [0, 0, 0, *across]]))
        self.keep = scipy.sparse.block_diag([along] * len(self.free)).tocsr()
        self.matrix, self.dead, self.live = (self.keep @ self.matrix).tocsr(), self.keep @ self.dead, self.keep @ self.live
        self.pulls = self.keep @ self.pulls


def linprog(*args, method="highs-ds", **kwargs):
    options = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
    return scipy.optimize.linprog(*args, method=method, options=options, **kwargs)


def fall_of(p):
    """Velocities (at most 1) admissible at all contacts with the greatest power of the dead forces, less what ties take; and that power,
    checked. Further unknowns: the speeds at which ties give way."""
    n, ties = p.matrix.shape[0], p.pulls.shape[1]
    contacts = scipy.sparse.hstack([-p.matrix.T, scipy.sparse.csr_matrix((p.matrix.shape[1], ties))])
    giving = scipy.sparse.hstack([scipy.sparse.csr_matrix(-p.pulls.T), -scipy.sparse.identity(ties)])
    most = numpy.where(numpy.isinf(p.most), 0.0, p.most)
    speeds = [(0.0, 0.0 if numpy.isinf(m) else None) for m in p.most]
    result = linprog(numpy.concatenate([-p.dead, most]), A_ub=scipy.sparse.vstack([contacts, giving]).tocsr(),
                     b_ub=numpy.zeros(p.matrix.shape[1] + ties), bounds=[(-1.0, 1.0)] * n + speeds)
    if result.status != 0:
        return None, None
    velocities = result.x[:n]
    closing = min(0.0, float((p.matrix.T @ velocities).min(initial=0.0)))
    return float(p.dead @ velocities) - taken(p, velocities) + 1e3 * closing, velocities


def taken(p, velocities):
    """Power that ties take; a tie without a limit that gives way counts 1,000 mean weights."""
    giving = numpy.maximum(0.0, -(p.pulls.T @ velocities))
    return float(numpy.where(numpy.isinf(p.most), 1e3, p.most) @ giving)


def bounds_of(p, result):
    """The gap between the multiplier and the bound by its velocities, with the violations of both."""
    columns = p.matrix.shape[1]
    forces, pulls, multiplier, velocities = result.x[:columns], result.x[columns:-1], result.x[-1], result.eqlin.marginals
    power = float(p.live @ velocities)
    if power == 0.0:
        return numpy.inf, None
    velocities = velocities / power  # the live force has the power 1
    off_balance = p.matrix @ forces + p.pulls @ pulls + p.dead + multiplier * p.live
    closing = min(0.0, float((p.matrix.T @ velocities).min()))
    upper = taken(p, velocities) - float(p.dead @ velocities)
    return abs(upper - multiplier) + abs(closing) * forces.sum() + numpy.abs(off_balance) @ numpy.abs(velocities), velocities


def solve(model: Model, **how) -> Answer:
    """The multiplier of associated flow, or a verdict that there is none."""
    p = Programme(model, **how)
    power, velocities = fall_of(p)
    if power is None:
        return Answer(UNSURE, contacts=len(p.contacts))
    if power > FALLING:
        return Answer(FALLS, contacts=len(p.contacts), velocities=velocities)
    if power > RESTING:
        return Answer(MARGINAL, contacts=len(p.contacts))
    columns = p.matrix.shape[1]
    limits = [(0.0, None if numpy.isinf(m) else m) for m in p.most]
    cost = numpy.zeros(columns + len(limits) + 1)
    cost[-1] = -1.0
    matrix = scipy.sparse.hstack([p.matrix, scipy.sparse.csr_matrix(p.pulls), p.live.reshape(-1, 1)]).tocsr()
    best = Answer(UNSURE, contacts=len(p.contacts), error=numpy.inf)
    for method in ("highs-ds", "highs-ipm"):
        result = linprog(cost, A_eq=matrix, b_eq=-p.dead, bounds=[(0.0, None)] * columns + limits + [(0.0, 10.0 * LARGEST)], method=method)
        if result.status == 2:
            return Answer(MARGINAL, contacts=len(p.contacts))
        if result.status != 0:
            continue
        if result.x[-1] > LARGEST:
            return Answer(UNBOUNDED, contacts=len(p.contacts))
        error, velocities = bounds_of(p, result)
        if error < best.error:
            verdict = STANDS if error < GAP * (1.0 + result.x[-1]) else UNSURE
            best = Answer(verdict, float(result.x[-1]), float(error), len(p.contacts), velocities)
        if best.verdict == STANDS:
            break
    return best
