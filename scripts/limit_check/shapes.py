# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Blocks and models as plain data. Lengths in m, forces in N, angles in degrees, z up."""
import dataclasses

import numpy

BOX_FACES = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))  # -x +x -y +y -z +z, from outside


@dataclasses.dataclass
class Block:
    """A convex polyhedron: corners, and faces as loops of corner numbers, counter-clockwise seen from outside."""
    name: str
    vertices: numpy.ndarray
    faces: tuple
    material: str = "stone"
    fixed: bool = False
    box: tuple = None  # two opposite corners, where it is an upright box
    ground: bool = False  # a part of the base: joints with it have the points of the other block alone
    stone: str = None  # what it is a convex piece of, where the stone is not convex; pieces of a stone never part


@dataclasses.dataclass
class Load:
    block: str
    force: tuple
    moment: tuple = (0.0, 0.0, 0.0)
    at: tuple = None  # none: the centroid


@dataclasses.dataclass
class Tie:
    """A straight bar between two points, each in a block (its name) or on the base (None)."""
    blocks: tuple
    points: tuple
    most: float  # N, at which it yields; None: never
    compression: bool = False


@dataclasses.dataclass
class Model:
    """The contents of a case file. Coordinates are those that the program reads, after all rotations."""
    kind: str
    blocks: list
    plane: bool = False  # prisms across one vertical plane, equally thick, and all forces lie in it
    density: dict = dataclasses.field(default_factory=lambda: {"stone": 2300.0})
    friction: float = 35.0
    between: list = dataclasses.field(default_factory=list)  # (material, material, angle of friction); "base" is one
    law_friction: float = None  # residual friction of the joint law of all joints; none: dry
    base: float = 0.0  # height; none: no base
    tilt: tuple = (0.0, 0.0)
    gravity: float = 9.8
    loads: list = dataclasses.field(default_factory=list)
    ties: list = dataclasses.field(default_factory=list)
    direction: float = 0.0  # of the live force, from x towards y
    rule: str = "rim"
    size: float = None
    facets: int = 8
    cone: str = "inner"
    exact: bool = False  # faces are plane only if corners have many digits
    outlines: list = dataclasses.field(default_factory=list)  # the stones that are not convex, as the file has them
    written: list = None  # the blocks as the file has them: before the turn that its keys ask for
    turn: tuple = None  # angle and point of that turn, or for a file of stones angle and place
    form: str = "blocks"  # or "stones": a file of geometry


def upright_box(name, low, high, material="stone", fixed=False):
    (x0, y0, z0), (x1, y1, z1) = low, high
    corners = [(x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0), (x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)]
    return Block(name, numpy.array(corners, float), BOX_FACES, material, fixed, (tuple(low), tuple(high)))


def between_loops(name, low, high, material="stone", fixed=False):
    """The block between two plane loops with equal numbers of corners, corner by corner."""
    n = len(low)
    faces = [(i, (i + 1) % n, (i + 1) % n + n, i + n) for i in range(n)] + [tuple(range(n))[::-1], tuple(range(n, 2 * n))]
    block = Block(name, numpy.array(list(low) + list(high), float), tuple(faces), material, fixed)
    if volume_and_centroid(block.vertices, block.faces)[0] < 0.0:
        block.faces = tuple(face[::-1] for face in faces)
    return block


def across(name, section, y0, y1, **more):
    """A prism along y; section: its corners (x, z)."""
    return between_loops(name, [(x, y0, z) for x, z in section], [(x, y1, z) for x, z in section], **more)


def standing(name, plan, z0, z1, **more):
    """A prism along z; plan: its corners (x, y)."""
    return between_loops(name, [(x, y, z0) for x, y in plan], [(x, y, z1) for x, y in plan], **more)


def volume_and_centroid(vertices, faces):
    """Volume and centroid of the polyhedron, by tetrahedra about its first corner."""
    origin = vertices[0]
    six, moment = 0.0, numpy.zeros(3)
    for face in faces:
        a = vertices[face[0]] - origin
        for i, k in zip(face[1:], face[2:]):
            b, c = vertices[i] - origin, vertices[k] - origin
            part = float(numpy.dot(a, numpy.cross(b, c)))
            six += part
            moment += part * (a + b + c) / 4.0
    return six / 6.0, origin + moment / six


def unit(direction):
    """The horizontal unit vector of a direction in degrees; quarter turns are exact."""
    quarter = round(direction / 90.0)
    if abs(direction - 90.0 * quarter) < 1e-12:
        return numpy.array([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, -1.0, 0.0)][quarter % 4])
    return numpy.array([numpy.cos(numpy.radians(direction)), numpy.sin(numpy.radians(direction)), 0.0])


def turned(points, angle, about=(0.0, 0.0, 0.0)):
    """Points rotated about the vertical axis through `about`."""
    c, s = unit(angle)[:2]
    return numpy.asarray(about) + (numpy.asarray(points, float) - numpy.asarray(about)) @ numpy.array([(c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0)])
