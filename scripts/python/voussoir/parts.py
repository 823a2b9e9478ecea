# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
# Made by scripts/python/make_parts from `voussoir keys --format json`; do not edit.
"""Cases as objects: each table of the case file is a class, and its keys are keyword arguments, by the same words.

    from voussoir.parts import Case, Wall, WallOpening

Keys that are words of Python have "_" behind them: from_, yield_. A wrong word is a TypeError; values are checked by the program alone. What is
None is not written, so that it has its default, or what an included case says. Model.add puts objects into a model; a Case is one by itself.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal

from .part import Part


@dataclass(kw_only=True, slots=True)
class HouseLeavesThrough(Part):
    """[house.leaves.through]: stones through both leaves, a brick's width along the wall and a course high; none where an opening, a corner or a beam
    is in the way.

    spacing, m: along the wall, at least two bricks; those of the next row lie between them; > 0, usually 0.1 to 100, possible 1e-4 to 1e5; default
      1.0
    every: course with such stones; in [2, 1000]; default 4
    material: none: that of the bricks; not empty
    """

    _table: ClassVar[str] = "house.leaves.through"

    spacing: float | None = None
    every: int | None = None
    material: str | None = None


@dataclass(kw_only=True, slots=True)
class HouseFloorAnchor(Part):
    """[house.floor.anchor]: what holds the ends of beams to the walls.

    every: beam that has one: 1 for all, 2 for every second; in [1, 100]; default 1
    reach, m: from the face of the wall into the room, where it holds the beam; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.3
    area, m2: of its section; > 0, usually 1e-7 to 0.1, possible 9.999999999999999e-11 to 100; needed
    young, Pa: modulus; the default is that of steel; > 0, usually 1e7 to 1e12, possible 10000 to 1e15; default 210000000000.0
    yield_, Pa: stress at which it yields; none: elastic; > 0, usually 1e5 to 5e9, possible 100 to 5e12
    hardening, Pa: slope of stress over strain beyond yield; >= 0, usually 10000 to 1e12, at most 1e15; default 0.0
    elongation: strain at which it breaks; none: never; > 0, usually 0.001 to 1, possible 1e-6 to 1000
    pretension, N: force that it would have if its ends did not move; put on with gravity, or at once without settling; >= 0, usually 50 to 1e7, at
      most 1e10; default 0.0
    compression: bears compression, too, without buckling; else it goes slack; default False
    plate, m, 2 values: width and height of the anchor plates that spread its force over the faces they cover; none: each end holds one element; > 0,
      usually 0.01 to 2, possible 1e-5 to 2000
    """

    _table: ClassVar[str] = "house.floor.anchor"

    every: int | None = None
    reach: float | None = None
    area: float | None = None
    young: float | None = None
    yield_: float | None = None
    hardening: float | None = None
    elongation: float | None = None
    pretension: float | None = None
    compression: bool | None = None
    plate: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class HouseFloorDeck(Part):
    """[house.floor.deck]: boards or a slab on the beams as a shear panel (diagonal bars between neighbouring beams) and bars across the beams, from
    the middle of the first element of the beams between the walls to that of the last.

    shear_stiffness, N/m: shear flow over shear angle, G t; > 0, usually 100 to 1e10, possible 0.1 to 1e13; needed
    shear_strength, N/m: shear flow at which it yields; none: elastic; > 0, usually 10 to 1e8, possible 0.01 to 1e11
    stiffness, N/m: force over strain of a strip one metre wide, across the beams; > 0, usually 100 to 1e10, possible 0.1 to 1e13; needed
    strength, N/m: force at which such a strip yields; none: elastic; > 0, usually 10 to 1e8, possible 0.01 to 1e11
    """

    _table: ClassVar[str] = "house.floor.deck"

    shear_stiffness: float | None = None
    shear_strength: float | None = None
    stiffness: float | None = None
    strength: float | None = None


@dataclass(kw_only=True, slots=True)
class HouseRoofTie(Part):
    """[house.roof.tie]: a rod or beam from foot to foot of each pair of rafters, which takes their thrust; none: the walls do.

    area, m2: of its section; > 0, usually 1e-7 to 0.1, possible 9.999999999999999e-11 to 100; needed
    young, Pa: modulus; the default is that of steel; > 0, usually 1e7 to 1e12, possible 10000 to 1e15; default 210000000000.0
    yield_, Pa: stress at which it yields; none: elastic; > 0, usually 1e5 to 5e9, possible 100 to 5e12
    hardening, Pa: slope of stress over strain beyond yield; >= 0, usually 10000 to 1e12, at most 1e15; default 0.0
    elongation: strain at which it breaks; none: never; > 0, usually 0.001 to 1, possible 1e-6 to 1000
    pretension, N: force that it would have if its ends did not move; put on with gravity, or at once without settling; >= 0, usually 50 to 1e7, at
      most 1e10; default 0.0
    compression: bears compression, too, without buckling; else it goes slack; default False
    plate, m, 2 values: width and height of the anchor plates that spread its force over the faces they cover; none: each end holds one element; > 0,
      usually 0.01 to 2, possible 1e-5 to 2000
    """

    _table: ClassVar[str] = "house.roof.tie"

    area: float | None = None
    young: float | None = None
    yield_: float | None = None
    hardening: float | None = None
    elongation: float | None = None
    pretension: float | None = None
    compression: bool | None = None
    plate: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class HouseRoofDeck(Part):
    """[house.roof.deck]: boards or a slab on the beams as a shear panel (diagonal bars between neighbouring beams) and bars across the beams, from
    the middle of the first element of the beams between the walls to that of the last.

    shear_stiffness, N/m: shear flow over shear angle, G t; > 0, usually 100 to 1e10, possible 0.1 to 1e13; needed
    shear_strength, N/m: shear flow at which it yields; none: elastic; > 0, usually 10 to 1e8, possible 0.01 to 1e11
    stiffness, N/m: force over strain of a strip one metre wide, across the beams; > 0, usually 100 to 1e10, possible 0.1 to 1e13; needed
    strength, N/m: force at which such a strip yields; none: elastic; > 0, usually 10 to 1e8, possible 0.01 to 1e11
    """

    _table: ClassVar[str] = "house.roof.deck"

    shear_stiffness: float | None = None
    shear_strength: float | None = None
    stiffness: float | None = None
    strength: float | None = None


@dataclass(kw_only=True, slots=True)
class HouseOpeningLintel(Part):
    """[house.opening.lintel]: timber over an opening, centred on it.

    length, m: along the wall; > 0, usually 0.02 to 30, possible 2e-5 to 30000; needed
    height, m: height; > 0, usually 0.05 to 20, possible 5e-5 to 20000; default 0.1
    element, m: length of an element of it; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.2
    """

    _table: ClassVar[str] = "house.opening.lintel"

    length: float | None = None
    height: float | None = None
    element: float | None = None


@dataclass(kw_only=True, slots=True)
class HouseOpeningArch(Part):
    """[house.opening.arch]: an arch of voussoirs over an opening, upon its lintel if it has one; its wedges reach up to the course above, and a
    springer of one piece stands at either end.

    rise, m: of its soffit above the top of the opening or of the lintel, at most half the width; 0: a flat arch; >= 0, usually 0.02 to 30, at most
      30000; default 0.0
    thickness, m: at the crown, half a course or more; the top ends a course; > 0, usually 0.01 to 2, possible 1e-5 to 2000; needed
    springer, m: that it reaches beyond the opening at either side, half a brick or more; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.1
    voussoirs: number; none: odd, each about a brick's width at the soffit; in [3, 101]
    material: none: that of the bricks; not empty
    """

    _table: ClassVar[str] = "house.opening.arch"

    rise: float | None = None
    thickness: float | None = None
    springer: float | None = None
    voussoirs: int | None = None
    material: str | None = None


@dataclass(kw_only=True, slots=True)
class HouseMeshConnectors(Part):
    """[house.mesh.connectors]: bars through the wall that join the two faces of a mesh at its nodes, in tension and compression.

    every: nodes, along and up, from one to the next; in [1, 1000]; default 2
    area, m2: of the section; > 0, usually 1e-7 to 0.1, possible 9.999999999999999e-11 to 100; needed
    young, Pa: modulus; the default is that of steel; > 0, usually 1e7 to 1e12, possible 10000 to 1e15; default 210000000000.0
    yield_, Pa: stress at which they yield; none: elastic; > 0, usually 1e5 to 5e9, possible 100 to 5e12
    elongation: strain at which they break; none: never; > 0, usually 0.001 to 1, possible 1e-6 to 1000
    """

    _table: ClassVar[str] = "house.mesh.connectors"

    every: int | None = None
    area: float | None = None
    young: float | None = None
    yield_: float | None = None
    elongation: float | None = None


@dataclass(kw_only=True, slots=True)
class WallOpeningLintel(Part):
    """[wall.opening.lintel]: one piece over an opening, as thick as the wall.

    bearing, m: on the wall at either side, a fifth of a brick or more; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.2
    height, m: height; > 0, usually 0.05 to 20, possible 5e-5 to 20000; default 0.1
    material: a name of materials; none: that of the wall; not empty
    """

    _table: ClassVar[str] = "wall.opening.lintel"

    bearing: float | None = None
    height: float | None = None
    material: str | None = None


@dataclass(kw_only=True, slots=True)
class WallOpeningArch(Part):
    """[wall.opening.arch]: an arch of voussoirs over an opening, upon its lintel if it has one; its wedges reach up to the course above, and a
    springer of one piece stands at either end.

    rise, m: of its soffit above the top of the opening or of the lintel, at most half the width; 0: a flat arch; >= 0, usually 0.02 to 30, at most
      30000; default 0.0
    thickness, m: at the crown, half a course or more; the top ends a course; > 0, usually 0.01 to 2, possible 1e-5 to 2000; needed
    springer, m: that it reaches beyond the opening at either side, half a brick or more; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.1
    voussoirs: number; none: odd, each about a brick's width at the soffit; in [3, 101]
    material: none: that of the bricks; not empty
    """

    _table: ClassVar[str] = "wall.opening.arch"

    rise: float | None = None
    thickness: float | None = None
    springer: float | None = None
    voussoirs: int | None = None
    material: str | None = None


@dataclass(kw_only=True, slots=True)
class BasePartMotion(Part):
    """[base.part.motion]: motion of a fixed block, of fixed stones, or of a part of the base: velocity, file, or its end.

    velocity, m/s, 3 values: constant velocity; usually 1e-9 to 100, at most 1e5 in magnitude
    file: CSV of t, x, y, z in s and m, from where the support stands; a first row away from zero is a jump. Three more columns rx, ry, rz turn it: a
      rotation vector, axis times angle, in rad (turn is in degrees), zero in the first row. In settlement and rest t gives only the order and
      proportion in which supports move, not how fast; not empty
    to, m, 3 values: settlement and rest: how far it moves at the end, straight, in place of file; usually 1e-7 to 1, at most 1000 in magnitude
    turn, degrees, 3 values: settlement and rest: how far it turns at the end, a rotation vector (axis times angle), beside or in place of to; at most
      1e6 in magnitude
    about, m, 3 values: point about which the support turns, in axes of the case; to, or x, y, z of the file, move this point. Needs turn, or a file
      with rx, ry, rz; none: the centroid of the block or stone; at most 1e9 in magnitude
    """

    _table: ClassVar[str] = "base.part.motion"

    velocity: Sequence[float] | None = None
    file: str | None = None
    to: Sequence[float] | None = None
    turn: Sequence[float] | None = None
    about: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class JointsBetween(Part):
    """[[joints.between]]: the law between two materials.

    materials, 2 values: the two materials; "base" counts as one; not empty; needed
    law: a name of joint_laws, or "dry"; not empty; needed
    """

    _table: ClassVar[str] = "joints.between"
    _array: ClassVar[bool] = True

    materials: Sequence[str]
    law: str


@dataclass(kw_only=True, slots=True)
class ContactBetween(Part):
    """[[contact.between]]: friction of two materials, whether they were joined or not.

    materials, 2 values: the two materials; "base" counts as one; a pair may stand once; not empty; needed
    friction, degrees: angle of friction; in [0, 90), usually 5 to 75; needed
    """

    _table: ClassVar[str] = "contact.between"
    _array: ClassVar[bool] = True

    materials: Sequence[str]
    friction: float


@dataclass(kw_only=True, slots=True)
class MotionIntensity(Part):
    """[motion.intensity]: a level that the motion is brought to, after scale.

    measure: peak ground acceleration, peak ground velocity, or spectral acceleration at `period` with 5 % of damping, of the horizontal components (L
      and T, wherever `direction` sends them, or x and y); needed
    level: PGA: m/s2 (not g), usually 0.5 to 45; PGV: m/s, usually 0.01 to 5; Sa: m/s2; > 0, possible 1e-6 to 10000; needed
    period, s: of the oscillator: of Sa alone; in [0.01, 20]
    components: what is brought to the level. each: both horizontal components, each by a factor of its own, and the vertical one by the geometric
      mean of these factors; design codes prescribe one spectrum for both. The others use one factor for all three components, and bring to the level
      the geometric mean of the two horizontal values, the median over all horizontal directions, or the larger value; default "each"
    """

    _table: ClassVar[str] = "motion.intensity"

    measure: Literal["PGA", "PGV", "Sa"] | None = None
    level: float | None = None
    period: float | None = None
    components: Literal["each", "geometric mean", "RotD50", "larger"] | None = None


@dataclass(kw_only=True, slots=True)
class OutputHistory(Part):
    """[[output.history]]: an element whose motion is written.

    name: its name in the results: /history/<name>; not empty; needed
    point, m, 3 values: the element whose centroid is nearest at the start is followed; at most 1e9 in magnitude; needed
    """

    _table: ClassVar[str] = "output.history"
    _array: ClassVar[bool] = True

    name: str
    point: Sequence[float]


@dataclass(kw_only=True, slots=True)
class OutputCut(Part):
    """[[output.cut]]: a plane; the force and the moment that pass it are written.

    name: its name in the results: /cuts/<name>; not empty; needed
    point, m, 3 values: a point of the plane; moments are about it; at most 1e9 in magnitude; needed
    normal, 3 values: across the plane, need not be a unit vector; what lies there (by centroids) acts on what lies behind; default [0.0, 0.0, 1.0]
    box, m, 2 values: two opposite corners: only pairs of elements across the plane with their midpoint in the box count; none: all; at most 1e9 in
      magnitude
    """

    _table: ClassVar[str] = "output.cut"
    _array: ClassVar[bool] = True

    name: str
    point: Sequence[float]
    normal: Sequence[float] | None = None
    box: Sequence[Sequence[float]] | None = None


@dataclass(kw_only=True, slots=True)
class HouseRubble(Part):
    """[house.rubble]: convex stones about the size of a brick for bond = "rubble", in courses of random height, their joints askew; level beds and
    upright ends at corners, openings, floors and ends of storeys.

    seed: another seed, other stones; default 1
    irregularity: 0: rectangular stones of one size; 1: the most; in [0, 1]; default 0.5
    through: share of the stones that go through the wall; walls of two leaves have those of house.leaves.through alone; in [0, 1]; default 0.2
    """

    _table: ClassVar[str] = "house.rubble"

    seed: int | None = None
    irregularity: float | None = None
    through: float | None = None


@dataclass(kw_only=True, slots=True)
class HouseLeaves(Part):
    """[house.leaves]: outer walls of two leaves, each in the house's bond; storeys whose walls are too thin for two leaves have one.

    walls: front, right, rear, left; none: all that are built; not empty
    outer, m: thickness of the outer leaf; none: half the wall; > 0, usually 0.05 to 5, possible 5e-5 to 5000
    joint: law of the collar joint between the leaves (dry: friction alone); none: that of the bricks; not empty
    through: stones through both leaves, a brick's width along the wall and a course high; none where an opening, a corner or a beam is in the way
    """

    _table: ClassVar[str] = "house.leaves"

    walls: Sequence[str] | None = None
    outer: float | None = None
    joint: str | None = None
    through: HouseLeavesThrough | None = None


@dataclass(kw_only=True, slots=True)
class HouseWood(Part):
    """[house.wood]: timber of the house.

    material: of lintels, beams and columns; not empty; default "wood"
    within_member: joint law between elements of one member; not empty; default "wood"
    between_members: joint law between members, and of members with all else; not empty; default "normal"
    timber_on_timber: joint law between members of timber (ring beam on column or ring beam, roof beam on ring beam; not between roof beams); none:
      between_members, the paper's mortar; not empty
    """

    _table: ClassVar[str] = "house.wood"

    material: str | None = None
    within_member: str | None = None
    between_members: str | None = None
    timber_on_timber: str | None = None


@dataclass(kw_only=True, slots=True)
class HouseStorey(Part):
    """[[house.storey]]: a storey upon those before it; a low one on top is a parapet.

    height, m: of its walls; > 0, usually 0.1 to 60, possible 1e-4 to 60000; default 2.4
    bearing_wall, m: thickness; none: as below, and at most that; outer faces are flush; > 0, usually 0.05 to 5, possible 5e-5 to 5000
    nonbearing_wall, m: likewise; > 0, usually 0.05 to 5, possible 5e-5 to 5000
    """

    _table: ClassVar[str] = "house.storey"
    _array: ClassVar[bool] = True

    height: float | None = None
    bearing_wall: float | None = None
    nonbearing_wall: float | None = None


@dataclass(kw_only=True, slots=True)
class HouseInnerWall(Part):
    """[[house.inner_wall]]: a wall from an outer wall to that opposite, toothed into all walls that it meets or crosses.

    name: a name of its own, for openings, messages and results; not empty; default "inner"
    along: where it runs; default "y"
    at, m: its face nearer to the origin, y or x from the outer corner of the house; > 0, usually 0.1 to 100, possible 1e-4 to 1e5; needed
    thickness, m: thickness; > 0, usually 0.01 to 2, possible 1e-5 to 2000; default 0.2
    storeys: that it goes through; none: all; in [1, 100]
    """

    _table: ClassVar[str] = "house.inner_wall"
    _array: ClassVar[bool] = True

    name: str | None = None
    along: Literal["x", "y"] | None = None
    at: float
    thickness: float | None = None
    storeys: Sequence[int] | None = None


@dataclass(kw_only=True, slots=True)
class HousePier(Part):
    """[[house.pier]]: a pier or buttress on the outer face of a wall, toothed into it.

    wall: front, rear, left or right; not empty; needed
    from_, m: start along the wall, x or y from the outer corner of the house; > 0, usually 0.1 to 100, possible 1e-4 to 1e5; needed
    width, m: along the wall; > 0, usually 0.05 to 20, possible 5e-5 to 20000; default 0.3
    depth, m: out of the wall, half a brick or more; > 0, usually 0.05 to 20, possible 5e-5 to 20000; default 0.3
    height, m: of its top above the foot of the walls; none: that of the first storey; > 0, usually 0.05 to 20, possible 5e-5 to 20000
    """

    _table: ClassVar[str] = "house.pier"
    _array: ClassVar[bool] = True

    wall: str
    from_: float
    width: float | None = None
    depth: float | None = None
    height: float | None = None


@dataclass(kw_only=True, slots=True)
class HouseFloor(Part):
    """[[house.floor]]: beams in pockets of the walls, flush with the top of a storey, with or without a deck.

    storey: the storey under it; in [1, 100]; default 1
    along: where its beams run: from wall to wall, through inner walls; default "y"
    beam, m, 2 values: width and height of a beam; > 0, usually 0.01 to 2, possible 1e-5 to 2000; default [0.1, 0.2]
    spacing, m: from axis to axis; in each room as many as fit, the rest at both ends; > 0, usually 0.1 to 3, possible 1e-4 to 3000; default 0.6
    bearing, m: depth of the pockets in the outer walls; half a brick's width or more of a brick stays behind; > 0, usually 0.05 to 5, possible 5e-5
      to 5000; default 0.1
    element, m: length of an element of a beam; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.4
    load, kg/m2: mass of boards and all on them; each beam has load x spacing x its length; >= 0, usually 2 to 700, at most 7e5; default 0.0
    joint: joint law of beams with walls, or "dry": friction alone; not empty; default "dry"
    anchorage: friction: beams lie in their pockets; nailed: straps hold them to the bricks under their ends; anchor: rods to the outer face; default
      "friction"
    anchor: what holds the ends of beams to the walls
    deck: boards or a slab on the beams as a shear panel (diagonal bars between neighbouring beams) and bars across the beams, from the middle of the
      first element of the beams between the walls to that of the last
    """

    _table: ClassVar[str] = "house.floor"
    _array: ClassVar[bool] = True

    storey: int | None = None
    along: Literal["x", "y"] | None = None
    beam: Sequence[float] | None = None
    spacing: float | None = None
    bearing: float | None = None
    element: float | None = None
    load: float | None = None
    joint: str | None = None
    anchorage: Literal["friction", "nailed", "anchor"] | None = None
    anchor: HouseFloorAnchor | None = None
    deck: HouseFloorDeck | None = None


@dataclass(kw_only=True, slots=True)
class HouseRoof(Part):
    """[house.roof]: beams side by side, a barrel vault along x, or pairs of rafters.

    kind: kind of roof; gables: the non-bearing walls go on as under a vault, but there is none; pitched: pairs of rafters on the bearing walls, and
      gables under them; default "none"
    beam, m, 2 values: flat, pitched: width along x and height of a beam or rafter; > 0, usually 0.01 to 2, possible 1e-5 to 2000; default [0.2, 0.2]
    element, m: flat, pitched: length of an element of a beam or rafter; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.2
    between_beams: joint law; flat: between neighbouring beams, pitched: between the rafters of a pair, in the ridge; not empty; default "normal"
    edge_beams: flat: joint law between the first or the last beam, over a side wall, and its neighbour; none: `between_beams`; not empty
    bearing, m: flat: length over which a beam rests on each bearing wall, from the wall's inner face, at most the wall's thickness; none: that
      thickness, at most a brick's length; > 0, usually 0.02 to 30, possible 2e-5 to 30000
    radius, m: vault, gables: inner radius; > 0, usually 0.2 to 60, possible 2e-4 to 60000; default 1.5
    thickness, m: vault: thickness; > 0, usually 0.01 to 2, possible 1e-5 to 2000; default 0.2
    ring, m: vault: length of a ring along x; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.2
    voussoirs: vault, gables: number in a ring; in [3, 1000]; default 25
    surcharge, kg/m2: flat, vault, pitched: mass on the upper surface, added to the roof's elements; >= 0, usually 2 to 700, at most 7e5; default 0.0
    pitch, degrees: pitched: of the rafters; in [5, 60]; default 30.0
    spacing, m: pitched: of the axes of rafters, at most; the first and the last are flush with the ends of the house; > 0, usually 0.1 to 100,
      possible 1e-4 to 1e5; default 0.8
    tie: a rod or beam from foot to foot of each pair of rafters, which takes their thrust; none: the walls do
    deck: boards or a slab on the beams as a shear panel (diagonal bars between neighbouring beams) and bars across the beams, from the middle of the
      first element of the beams between the walls to that of the last
    """

    _table: ClassVar[str] = "house.roof"

    kind: Literal["none", "flat", "vault", "gables", "pitched"] | None = None
    beam: Sequence[float] | None = None
    element: float | None = None
    between_beams: str | None = None
    edge_beams: str | None = None
    bearing: float | None = None
    radius: float | None = None
    thickness: float | None = None
    ring: float | None = None
    voussoirs: int | None = None
    surcharge: float | None = None
    pitch: float | None = None
    spacing: float | None = None
    tie: HouseRoofTie | None = None
    deck: HouseRoofDeck | None = None


@dataclass(kw_only=True, slots=True)
class HouseOpening(Part):
    """[[house.opening]]: a door or a window.

    wall: the wall it is in: front, rear, left, right, or the name of an inner wall; not empty; needed
    storey: the storey it is in; in [1, 100]; default 1
    from_, m: start along the wall, x or y from the outer corner of the house; >= 0, usually 0.1 to 100, at most 1e5; needed
    width, m: clear width; > 0, usually 0.05 to 20, possible 5e-5 to 20000; needed
    sill, m: height of its lower edge above the foot of its storey; in the first storey above base.z; >= 0, usually 0.001 to 60, at most 60000;
      default 0.0
    height, m: clear height; > 0, usually 0.05 to 20, possible 5e-5 to 20000; needed
    lintel: timber over an opening, centred on it
    arch: an arch of voussoirs over an opening, upon its lintel if it has one; its wedges reach up to the course above, and a springer of one piece
      stands at either end
    """

    _table: ClassVar[str] = "house.opening"
    _array: ClassVar[bool] = True

    wall: str
    storey: int | None = None
    from_: float
    width: float
    sill: float | None = None
    height: float
    lintel: HouseOpeningLintel | None = None
    arch: HouseOpeningArch | None = None


@dataclass(kw_only=True, slots=True)
class HouseReinforcement(Part):
    """[house.reinforcement]: timber columns at the inner faces of the walls, and ring beams there or upon the walls.

    column, m, 2 values: section of the columns, along x and y; > 0, usually 0.01 to 2, possible 1e-5 to 2000; default [0.1, 0.1]
    bearing, m: x of the column axes at both bearing walls; >= 0, usually 0.1 to 100, at most 1e5
    nonbearing, m: y of the column axes at both non-bearing walls; >= 0, usually 0.1 to 100, at most 1e5
    ring_beam, m, 2 values: section of the ring beams, width and height; > 0, usually 0.01 to 2, possible 1e-5 to 2000; default [0.1, 0.1]
    ring_beam_place: inside: at the inner faces of the walls, flush with their top; middle: upon the walls, over their middle, under a flat roof or
      none (at most as wide as the thinnest wall); default "inside"
    element, m: length of an element of a member; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.2
    """

    _table: ClassVar[str] = "house.reinforcement"

    column: Sequence[float] | None = None
    bearing: Sequence[float] | None = None
    nonbearing: Sequence[float] | None = None
    ring_beam: Sequence[float] | None = None
    ring_beam_place: Literal["inside", "middle"] | None = None
    element: float | None = None


@dataclass(kw_only=True, slots=True)
class HouseTie(Part):
    """[[house.tie]]: rods of the house by wall and height: through walls from end to end, across the house, or across its corners.

    name: begins the names of its ties; not empty; needed
    kind: along: through a wall, plates on the walls that it meets; across: from a wall to that opposite; corner: from a wall to the next; needed
    walls: walls by name: front, right, rear, left, for along inner walls, too; none: all outer ones that are built; not empty
    heights, m: above the foot of the walls, a rod at each; >= 0, usually 0.001 to 60, at most 60000; needed
    at, m: across: where along the wall, x or y from the outer corner of the house, a rod at each; >= 0, usually 0.1 to 100, at most 1e5
    depth, m: along: from the outer face of the wall; none: half its thickness; >= 0, usually 0.05 to 5, at most 5000
    reach, m: corner: from the outer corner to either end, along the walls; >= 0, usually 0.1 to 100, at most 1e5; default 0.0
    area, m2: of its section; > 0, usually 1e-7 to 0.1, possible 9.999999999999999e-11 to 100; needed
    young, Pa: modulus; the default is that of steel; > 0, usually 1e7 to 1e12, possible 10000 to 1e15; default 210000000000.0
    yield_, Pa: stress at which it yields; none: elastic; > 0, usually 1e5 to 5e9, possible 100 to 5e12
    hardening, Pa: slope of stress over strain beyond yield; >= 0, usually 10000 to 1e12, at most 1e15; default 0.0
    elongation: strain at which it breaks; none: never; > 0, usually 0.001 to 1, possible 1e-6 to 1000
    pretension, N: force that it would have if its ends did not move; put on with gravity, or at once without settling; >= 0, usually 50 to 1e7, at
      most 1e10; default 0.0
    compression: bears compression, too, without buckling; else it goes slack; default False
    plate, m, 2 values: width and height of the anchor plates that spread its force over the faces they cover; none: each end holds one element; > 0,
      usually 0.01 to 2, possible 1e-5 to 2000
    """

    _table: ClassVar[str] = "house.tie"
    _array: ClassVar[bool] = True

    name: str
    kind: Literal["along", "across", "corner"]
    walls: Sequence[str] | None = None
    heights: Sequence[float]
    at: Sequence[float] | None = None
    depth: float | None = None
    reach: float | None = None
    area: float
    young: float | None = None
    yield_: float | None = None
    hardening: float | None = None
    elongation: float | None = None
    pretension: float | None = None
    compression: bool | None = None
    plate: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class HouseMesh(Part):
    """[[house.mesh]]: a net, mesh or bandage on the faces of walls: straps between nodes, in tension alone.

    name: begins the names of its straps; not empty; needed
    walls: walls by name: front, right, rear, left; none: all that are built; not empty
    from_, m: lower edge, above the foot of the walls; >= 0, usually 0.001 to 60, at most 60000; default 0.0
    to, m: upper edge; none: the top of the walls; > 0, usually 0.001 to 60, possible 1e-6 to 60000
    spacing, m, 2 values: of the nodes, along and up; every brick should have one; > 0, usually 0.05 to 20, possible 5e-5 to 20000; default [0.2, 0.2]
    faces: of the walls that it covers; default "both"
    stiffness, N/m: force over strain of a strip one metre wide; > 0, usually 100 to 1e10, possible 0.1 to 1e13; needed
    strength, N/m: force at which a strip one metre wide yields; none: elastic; > 0, usually 10 to 1e8, possible 0.01 to 1e11
    elongation: strain at which it breaks; none: never; > 0, usually 0.001 to 1, possible 1e-6 to 1000
    connectors: bars through the wall that join the two faces of a mesh at its nodes, in tension and compression
    """

    _table: ClassVar[str] = "house.mesh"
    _array: ClassVar[bool] = True

    name: str
    walls: Sequence[str] | None = None
    from_: float | None = None
    to: float | None = None
    spacing: Sequence[float] | None = None
    faces: Literal["both", "outside", "inside"] | None = None
    stiffness: float
    strength: float | None = None
    elongation: float | None = None
    connectors: HouseMeshConnectors | None = None


@dataclass(kw_only=True, slots=True)
class WallOpening(Part):
    """[[wall.opening]]: a door or a window, in one side of the wall.

    from_, m: start along the wall's line from its first point; >= 0, usually 0.1 to 100, at most 1e5; needed
    width, m: clear width; > 0, usually 0.05 to 20, possible 5e-5 to 20000; needed
    sill, m: height of its lower edge above the foot of the wall; >= 0, usually 0.001 to 60, at most 60000; default 0.0
    height, m: clear height; > 0, usually 0.05 to 20, possible 5e-5 to 20000; needed
    lintel: one piece over an opening, as thick as the wall
    arch: an arch of voussoirs over an opening, upon its lintel if it has one; its wedges reach up to the course above, and a springer of one piece
      stands at either end
    """

    _table: ClassVar[str] = "wall.opening"
    _array: ClassVar[bool] = True

    from_: float
    width: float
    sill: float | None = None
    height: float
    lintel: WallOpeningLintel | None = None
    arch: WallOpeningArch | None = None


@dataclass(kw_only=True, slots=True)
class FloorAnchor(Part):
    """[floor.anchor]: what holds the ends of beams to the walls.

    every: beam that has one: 1 for all, 2 for every second; in [1, 100]; default 1
    reach, m: from the face of the wall into the room, where it holds the beam; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.3
    area, m2: of its section; > 0, usually 1e-7 to 0.1, possible 9.999999999999999e-11 to 100; needed
    young, Pa: modulus; the default is that of steel; > 0, usually 1e7 to 1e12, possible 10000 to 1e15; default 210000000000.0
    yield_, Pa: stress at which it yields; none: elastic; > 0, usually 1e5 to 5e9, possible 100 to 5e12
    hardening, Pa: slope of stress over strain beyond yield; >= 0, usually 10000 to 1e12, at most 1e15; default 0.0
    elongation: strain at which it breaks; none: never; > 0, usually 0.001 to 1, possible 1e-6 to 1000
    pretension, N: force that it would have if its ends did not move; put on with gravity, or at once without settling; >= 0, usually 50 to 1e7, at
      most 1e10; default 0.0
    compression: bears compression, too, without buckling; else it goes slack; default False
    plate, m, 2 values: width and height of the anchor plates that spread its force over the faces they cover; none: each end holds one element; > 0,
      usually 0.01 to 2, possible 1e-5 to 2000
    """

    _table: ClassVar[str] = "floor.anchor"

    every: int | None = None
    reach: float | None = None
    area: float | None = None
    young: float | None = None
    yield_: float | None = None
    hardening: float | None = None
    elongation: float | None = None
    pretension: float | None = None
    compression: bool | None = None
    plate: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class FloorDeck(Part):
    """[floor.deck]: boards or a slab on the beams as a shear panel (diagonal bars between neighbouring beams) and bars across the beams, from the
    middle of the first element of the beams between the walls to that of the last.

    shear_stiffness, N/m: shear flow over shear angle, G t; > 0, usually 100 to 1e10, possible 0.1 to 1e13; needed
    shear_strength, N/m: shear flow at which it yields; none: elastic; > 0, usually 10 to 1e8, possible 0.01 to 1e11
    stiffness, N/m: force over strain of a strip one metre wide, across the beams; > 0, usually 100 to 1e10, possible 0.1 to 1e13; needed
    strength, N/m: force at which such a strip yields; none: elastic; > 0, usually 10 to 1e8, possible 0.01 to 1e11
    """

    _table: ClassVar[str] = "floor.deck"

    shear_stiffness: float | None = None
    shear_strength: float | None = None
    stiffness: float | None = None
    strength: float | None = None


@dataclass(kw_only=True, slots=True)
class RoofTie(Part):
    """[roof.tie]: a rod or beam from foot to foot of each pair of rafters, which takes their thrust; none: the walls do.

    area, m2: of its section; > 0, usually 1e-7 to 0.1, possible 9.999999999999999e-11 to 100; needed
    young, Pa: modulus; the default is that of steel; > 0, usually 1e7 to 1e12, possible 10000 to 1e15; default 210000000000.0
    yield_, Pa: stress at which it yields; none: elastic; > 0, usually 1e5 to 5e9, possible 100 to 5e12
    hardening, Pa: slope of stress over strain beyond yield; >= 0, usually 10000 to 1e12, at most 1e15; default 0.0
    elongation: strain at which it breaks; none: never; > 0, usually 0.001 to 1, possible 1e-6 to 1000
    pretension, N: force that it would have if its ends did not move; put on with gravity, or at once without settling; >= 0, usually 50 to 1e7, at
      most 1e10; default 0.0
    compression: bears compression, too, without buckling; else it goes slack; default False
    plate, m, 2 values: width and height of the anchor plates that spread its force over the faces they cover; none: each end holds one element; > 0,
      usually 0.01 to 2, possible 1e-5 to 2000
    """

    _table: ClassVar[str] = "roof.tie"

    area: float | None = None
    young: float | None = None
    yield_: float | None = None
    hardening: float | None = None
    elongation: float | None = None
    pretension: float | None = None
    compression: bool | None = None
    plate: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class RoofDeck(Part):
    """[roof.deck]: boards or a slab on the beams as a shear panel (diagonal bars between neighbouring beams) and bars across the beams, from the
    middle of the first element of the beams between the walls to that of the last.

    shear_stiffness, N/m: shear flow over shear angle, G t; > 0, usually 100 to 1e10, possible 0.1 to 1e13; needed
    shear_strength, N/m: shear flow at which it yields; none: elastic; > 0, usually 10 to 1e8, possible 0.01 to 1e11
    stiffness, N/m: force over strain of a strip one metre wide, across the beams; > 0, usually 100 to 1e10, possible 0.1 to 1e13; needed
    strength, N/m: force at which such a strip yields; none: elastic; > 0, usually 10 to 1e8, possible 0.01 to 1e11
    """

    _table: ClassVar[str] = "roof.deck"

    shear_stiffness: float | None = None
    shear_strength: float | None = None
    stiffness: float | None = None
    strength: float | None = None


@dataclass(kw_only=True, slots=True)
class BlockRotate(Part):
    """[block.rotate]: turns the block before the start.

    axis, 3 values: direction of the axis; need not be a unit vector; default [0.0, 0.0, 1.0]
    angle, degrees: angle, by the right hand; at most 1e6 in magnitude; default 0.0
    about, m, 3 values: a point of the axis; at most 1e9 in magnitude; default [0.0, 0.0, 0.0]
    """

    _table: ClassVar[str] = "block.rotate"

    axis: Sequence[float] | None = None
    angle: float | None = None
    about: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class BlockMotion(Part):
    """[block.motion]: motion of a fixed block, of fixed stones, or of a part of the base: velocity, file, or its end.

    velocity, m/s, 3 values: constant velocity; usually 1e-9 to 100, at most 1e5 in magnitude
    file: CSV of t, x, y, z in s and m, from where the support stands; a first row away from zero is a jump. Three more columns rx, ry, rz turn it: a
      rotation vector, axis times angle, in rad (turn is in degrees), zero in the first row. In settlement and rest t gives only the order and
      proportion in which supports move, not how fast; not empty
    to, m, 3 values: settlement and rest: how far it moves at the end, straight, in place of file; usually 1e-7 to 1, at most 1000 in magnitude
    turn, degrees, 3 values: settlement and rest: how far it turns at the end, a rotation vector (axis times angle), beside or in place of to; at most
      1e6 in magnitude
    about, m, 3 values: point about which the support turns, in axes of the case; to, or x, y, z of the file, move this point. Needs turn, or a file
      with rx, ry, rz; none: the centroid of the block or stone; at most 1e9 in magnitude
    """

    _table: ClassVar[str] = "block.motion"

    velocity: Sequence[float] | None = None
    file: str | None = None
    to: Sequence[float] | None = None
    turn: Sequence[float] | None = None
    about: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class StonesTurn(Part):
    """[stones.turn]: turns the stones about an axis, before they are moved by place; a number: degrees about the file's z axis.

    axis, 3 values: direction of the axis; need not be a unit vector; default [0.0, 0.0, 1.0]
    angle, degrees: angle, by the right hand; at most 1e6 in magnitude; default 0.0
    about, m, 3 values: a point of the axis; at most 1e9 in magnitude; default [0.0, 0.0, 0.0]
    """

    _table: ClassVar[str] = "stones.turn"

    axis: Sequence[float] | None = None
    angle: float | None = None
    about: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class StonesMotion(Part):
    """[stones.motion]: motion of a fixed block, of fixed stones, or of a part of the base: velocity, file, or its end.

    velocity, m/s, 3 values: constant velocity; usually 1e-9 to 100, at most 1e5 in magnitude
    file: CSV of t, x, y, z in s and m, from where the support stands; a first row away from zero is a jump. Three more columns rx, ry, rz turn it: a
      rotation vector, axis times angle, in rad (turn is in degrees), zero in the first row. In settlement and rest t gives only the order and
      proportion in which supports move, not how fast; not empty
    to, m, 3 values: settlement and rest: how far it moves at the end, straight, in place of file; usually 1e-7 to 1, at most 1000 in magnitude
    turn, degrees, 3 values: settlement and rest: how far it turns at the end, a rotation vector (axis times angle), beside or in place of to; at most
      1e6 in magnitude
    about, m, 3 values: point about which the support turns, in axes of the case; to, or x, y, z of the file, move this point. Needs turn, or a file
      with rx, ry, rz; none: the centroid of the block or stone; at most 1e9 in magnitude
    """

    _table: ClassVar[str] = "stones.motion"

    velocity: Sequence[float] | None = None
    file: str | None = None
    to: Sequence[float] | None = None
    turn: Sequence[float] | None = None
    about: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class BasePart(Part):
    """[[base.part]]: a part of the ground above the base, as a slope has in steps, or one that moves: a rectangle in plan, or what lies under a wall
    of the house; walls begin upon it.

    x, m, 2 values: its two ends along x, with y; axes of the case; usually 0.001 to 9000, at most 1e9 in magnitude
    y, m, 2 values: its two ends along y; usually 0.001 to 9000, at most 1e9 in magnitude
    wall: in place of x and y: all that is under this wall: front, rear, left, right, or the name of an inner wall; default ""
    from_, m: with wall: start along it, from the outer corner of the house; none: its start; >= 0, usually 0.1 to 100, at most 1e5
    to, m: with wall: its end; none: the wall's; > 0, usually 0.1 to 100, possible 1e-4 to 1e5
    level, m: height of its top above base.z; at most so much can it sink; > 0, usually 0.001 to 60, possible 1e-6 to 60000; needed
    motion: motion of a fixed block, of fixed stones, or of a part of the base: velocity, file, or its end
    """

    _table: ClassVar[str] = "base.part"
    _array: ClassVar[bool] = True

    x: Sequence[float] | None = None
    y: Sequence[float] | None = None
    wall: str | None = None
    from_: float | None = None
    to: float | None = None
    level: float
    motion: BasePartMotion | None = None


@dataclass(kw_only=True, slots=True)
class Gravity(Part):
    """[gravity]: body force and the settling before time zero.

    acceleration, m/s2, 3 values: acceleration of free fall; at most 1000 in magnitude; default [0.0, 0.0, -9.8]
    settle: ramp gravity and wait for rest before time zero; default True
    ramp, s: length of the ramp; none: five periods of damping.frequency, else 1 s; >= 0, usually 0.001 to 1000, at most 1e6
    settle_limit, s: longest wait for rest after the ramp; then the run goes on with a warning; >= 0, usually 0.001 to 1000, at most 1e6; default 3.0
    """

    _table: ClassVar[str] = "gravity"

    acceleration: Sequence[float] | None = None
    settle: bool | None = None
    ramp: float | None = None
    settle_limit: float | None = None


@dataclass(kw_only=True, slots=True)
class Time(Part):
    """[time]: time step and duration.

    step, s: time step; auto: the largest that divides history_interval and is at most 0.995 of the stability limit (Eq. 19); > 0, usually 1e-9 to
      0.01, at most 10; default "auto"
    duration, s: of the run, after settling; in [0, 1e+06], usually 0.001 to 2000; default 10.0
    after_collapse, s: the run ends so long after the first frame in which the building has collapsed; none: at its duration; >= 0, usually 0.001 to
      1000, at most 1e6
    multirate: steps from one evaluation of the slowest pairs of elements to the next: pairs that allow it are evaluated once in so many steps, in
      half as many, ...; 1: all in every step, as in the paper. An [analysis] takes 1; default 1
    """

    _table: ClassVar[str] = "time"

    step: float | Literal["auto"] | None = None
    duration: float | None = None
    after_collapse: float | None = None
    multirate: Literal[1, 2, 4, 8] | None = None


@dataclass(kw_only=True, slots=True)
class Damping(Part):
    """[damping]: mass damping: ratio at frequency, or alpha.

    ratio: of critical damping, at `frequency` (Eq. 14): 0.02 for 2 %; in [0, 1), usually 1e-4 to 0.2; default 0.0
    frequency, Hz: where the ratio holds: the natural frequency; auto: of the mode with the largest mass in y, computed before the run and kept in its
      case.toml (four digits); > 0, usually 0.02 to 10000, possible 2e-5 to 1e7
    alpha, 1/s: mass damping coefficient, instead of a ratio; >= 0, usually 1e-4 to 10000, at most 1e7
    debris: mass damping of elements without a bond; default "keep"
    frame: velocities that are damped while it shakes: ground: relative to the moving ground, as in Eqs. 13 and 15; inertial: absolute ones; default
      "ground"
    """

    _table: ClassVar[str] = "damping"

    ratio: float | None = None
    frequency: float | Literal["auto"] | None = None
    alpha: float | None = None
    debris: Literal["keep", "off"] | None = None
    frame: Literal["ground", "inertial"] | None = None


@dataclass(kw_only=True, slots=True)
class Material(Part):
    """[materials.<name>]: a material of elements.

    density, kg/m3: mass per volume; > 0, usually 200 to 12000, possible 0.1 to 1e5; needed
    young, Pa: Young's modulus; > 0, usually 1e6 to 5e11, possible 1 to 1e14; needed
    poisson: Poisson's ratio; in [0, 0.5), usually 0.01 to 0.49; needed
    inside: law between the convex pieces of a stone that is not convex, and between the cells of a unit (house.cells, wall.cells, block.cells;
      halves): a name of joint_laws; none: pieces of a stone never part; not empty
    """

    _table: ClassVar[str] = "materials"
    _by_name: ClassVar[bool] = True

    density: float | None = None
    young: float | None = None
    poisson: float | None = None
    inside: str | None = None


@dataclass(kw_only=True, slots=True)
class JointLaw(Part):
    """[joint_laws.<name>]: strength of a joint (Eqs. 5-7) and its mortar (Eq. 3).

    tension, Pa: tensile strength f_t; >= 0, usually 100 to 1e13, at most 1e20; needed
    cohesion, Pa: cohesion c; >= 0, usually 100 to 1e13, at most 1e20; needed
    friction, degrees: angle of friction phi of the bond (Eq. 6); once it is broken: [contact]; in [0, 90), usually 5 to 75; needed
    compression, Pa: compressive strength f_m of the bond; of contacts: contact.compression; > 0, usually 10000 to 1e13, possible 0.001 to 1e20;
      needed
    cap: C_s of the compression cap; >= 0, usually 0.1 to 1000, at most 1e6; default 9.0
    thickness, m: of the mortar; 0: no mortar, Eq. 2; >= 0, usually 1e-4 to 0.1, at most 100; default 0.0
    young, Pa: Young's modulus of the mortar; >= 0, usually 1e5 to 1e11, at most 1e14; default 0.0
    poisson: Poisson's ratio of the mortar; in [0, 0.5), usually 0.01 to 0.49; default 0.0
    fracture_energy_tension, J/m2: mode I, elastic part included: more than f_t^2 / (2 k_n); 0: brittle in tension; >= 0, usually 0.1 to 1e5, at most
      1e8; default 0.0
    fracture_energy_shear, J/m2: mode II, of the cohesion alone, elastic part included: more than c^2 / (2 k_s); 0: by failure.post_shear; >= 0,
      usually 0.1 to 1e5, at most 1e8; default 0.0
    softening: how f_t and c fall over what opens or slides; default "exponential"
    residual_friction, degrees: angle of friction of this joint when its bond is gone, until its faces have slid by half a segment; none: [contact];
      in [0, 90), usually 5 to 75
    dilatancy, degrees: angle by which the first slip under pressure opens the joint, no more than friction; dies with cohesion, needs
      fracture_energy_shear; in [0, 90), usually 0.5 to 45; default 0.0
    normal_stiffness, Pa/m: of the joint alone, in series with its blocks (and with one block on the base); in place of thickness; none: rigid; > 0,
      usually 1e6 to 1e14, possible 1 to 1e17
    shear_stiffness, Pa/m: the same along the joint; both stand, or none; > 0, usually 1e6 to 1e14, possible 1 to 1e17
    maximum_closure, m: largest closure of a dry joint (Bandis' hyperbola): its stiffness grows from normal_stiffness, without pressure; friction is
      residual_friction or that of [contact]; none: one stiffness; > 0, usually 1e-7 to 0.02, possible 1e-10 to 20
    """

    _table: ClassVar[str] = "joint_laws"
    _by_name: ClassVar[bool] = True

    tension: float | None = None
    cohesion: float | None = None
    friction: float | None = None
    compression: float | None = None
    cap: float | None = None
    thickness: float | None = None
    young: float | None = None
    poisson: float | None = None
    fracture_energy_tension: float | None = None
    fracture_energy_shear: float | None = None
    softening: Literal["exponential", "linear"] | None = None
    residual_friction: float | None = None
    dilatancy: float | None = None
    normal_stiffness: float | None = None
    shear_stiffness: float | None = None
    maximum_closure: float | None = None


@dataclass(kw_only=True, slots=True)
class Scatter(Part):
    """[scatter]: random strength of joints: one factor a joint on tension, cohesion and compression of its law.

    seed: the same seed gives the same strengths; default 0
    variation: coefficient of variation, at most 0.33 (normal), 0.57 (uniform), 1 (lognormal); 0: all joints of a law are equally strong; >= 0,
      usually 0.005 to 1, at most 1000; default 0.0
    distribution: of the factor, with mean 1; cut at three standard deviations; default "lognormal"
    laws: names of joint_laws; none: all of them
    """

    _table: ClassVar[str] = "scatter"

    seed: int | None = None
    variation: float | None = None
    distribution: Literal["lognormal", "normal", "uniform"] | None = None
    laws: Sequence[str] | None = None


@dataclass(kw_only=True, slots=True)
class Failure(Part):
    """[failure]: options of the failure law.

    shear: shear limit of bonded segments; default "on"
    post_shear: what a segment does after its shear limit; default "plastic"
    shear_in_tension: shear limit under tension: c, none, or Eq. 6 literally; default "cohesion"
    """

    _table: ClassVar[str] = "failure"

    shear: Literal["on", "off"] | None = None
    post_shear: Literal["plastic", "brittle"] | None = None
    shear_in_tension: Literal["cohesion", "none", "coulomb"] | None = None


@dataclass(kw_only=True, slots=True)
class Joints(Part):
    """[joints]: laws of touching faces: a house's own keys, then the first of `between` that fits, then `default`.

    default: a name of joint_laws, or "dry": no bond, friction contact only; not empty; default "dry"
    between: the law between two materials
    """

    _table: ClassVar[str] = "joints"

    default: str | None = None
    between: Sequence[JointsBetween] | None = None


@dataclass(kw_only=True, slots=True)
class Contact(Part):
    """[contact]: contact of faces without a bond.

    friction, degrees: angle of friction of all pairs of materials, broken joints too, but of those in `between`; in [0, 90), usually 5 to 75; default
      32.0
    damping: h_n = h_s of the dashpots (Eqs. 9, 10); >= 0, usually 0.001 to 10, at most 10000; default 1.0
    dashpots: bounded: spring and dashpot together never pull and never exceed friction; unbounded: the whole dashpot acts while faces touch; default
      "bounded"
    restitution: normal speed at which free bodies part over that at which they meet, at the point of contact; their normal dashpots then act only
      where a point is pressed again that has been deeper, joints keep theirs; none: that of the dashpots; in (0, 1], usually 0.05 to 1, at least 5e-5
    normal: whose face gives the normal; default "slave"
    compression, Pa: pressure at which contacts crush: broken joints and bodies that meet at their points; 0: they bear any pressure; >= 0, usually
      10000 to 1e13, at most 1e20; default 0.0
    crushing_energy, J/m2: that crushing takes above the residual, more than (compression - residual)^2 / (2 k_n); 0: strength does not fall; >= 0,
      usually 1 to 1e8, at most 1e11; default 0.0
    residual_compression, Pa: that crushed contacts still bear, less than compression; needs crushing_energy; >= 0, usually 10000 to 1e13, at most
      1e20; default 0.0
    crushing_depth, m: most that a contact point is crushed: what is crushed so far is compacted and bears any pressure; > 0, usually 1e-5 to 0.2,
      possible 1e-8 to 200; default 0.01
    between: friction of two materials, whether they were joined or not
    """

    _table: ClassVar[str] = "contact"

    friction: float | None = None
    damping: float | None = None
    dashpots: Literal["bounded", "unbounded"] | None = None
    restitution: float | None = None
    normal: Literal["slave", "master"] | None = None
    compression: float | None = None
    crushing_energy: float | None = None
    residual_compression: float | None = None
    crushing_depth: float | None = None
    between: Sequence[ContactBetween] | None = None


@dataclass(kw_only=True, slots=True)
class Analysis(Part):
    """[analysis]: what the run finds out: what an earthquake does, or a capacity by slow loading.

    kind: time-history: [motion] shakes; pushover: lateral forces grow; tilt: gravity turns; settlement: supports move by their [block.motion],
      [stones.motion], or that of a [[base.part]]; cyclic: the loads that grow push to and fro; rest: does it stand? Weights act first, then the loads
      that grow and the movements of supports increase together to their full values. All but the first go slowly and leave [motion] out; default
      "time-history"
    solver: of all kinds but time-history. equilibrium: each row is a state of rest, found by relaxation, and the run's time counts iterations;
      dynamics: the structure moves slowly, so the result depends on the pace; none: equilibrium, but dynamics where pace or damping is given
    pattern: pushover: forces as the masses, as the masses times the mode with most mass in `direction`, the [[load]]s that grow, or as the masses
      times their height above the base; default "mass"
    direction, 2 values: x and y of the push (where gravity turns to); of any length, -x pushes back. Where vertical loads grow, displacements are
      measured along them; default [1.0, 0.0]
    eccentricity: pushover: shift of the resultant across the push, over the width of the plan there; above zero: to the left of the push. EN 1998-1,
      4.3.2: 0.05 and -0.05; in [-0.5, 0.5], usually 0.001 to 0.3; default 0.0
    control, m, 3 values: the control point, whose displacement is that of the capacity curve: the element whose centroid is nearest to a point; or,
      of a block, a stone or a part of the house by its name, as "front wall, storey 2", the element on top nearest to the axis of its centre of mass;
      none: the same of the whole model; where vertical loads grow, the loaded one; at most 1e9 in magnitude
    drop: the run ends when the base shear (tilt: the multiplier) has lost this share of its largest value; in (0, 1); default 0.2
    share: stiffness of the loading spring over the initial one of the structure: displacement control begins where the tangent of the structure falls
      below that of the spring; none: 0.5, cyclic: 5; > 0, possible 1e-6 to 1e6
    pace, s: time in which the displacement grows e-fold; none: 20 first periods, 2 s at least. Twice the pace is half the rate; > 0, usually 0.001 to
      2000, possible 1e-6 to 2e6
    damping, 1/s: mass damping, of rotations too; none: a tenth of critical at the first frequency, less where it would bear 0.2 % of the weight; >=
      0, usually 1e-4 to 10000, at most 1e7
    longest, s: the run ends then at the latest, after settling; in place of time.duration; in [0, 1e+06]; default 300.0
    largest_factor: the run ends when the load factor (tangent of the tilt) gets there; > 0, possible 1e-9 to 1e9; default 5.0
    largest_drift: the run ends when the control point has moved by this share of its height in `direction` (above the base; without one, above the
      lowest corner); > 0, possible 1e-9 to 1e6; default 0.2
    amplitudes, m: cyclic: of the displacement of the loads that grow, one after another; usually 1e-7 to 1, at most 1000 in magnitude
    cycles: cyclic: at each amplitude; in [1, 1000]; default 1
    demand: pushover: the spectrum that the capacity is compared with, of EN 1998-1: "ec8:TYPE:GROUND:AG", as "ec8:1:B:0.25g"; other spectra:
      `voussoir assess --demand`; default ""
    demand_damping: of critical, of the spectrum of demand; in [0, 0.5]; default 0.05
    tolerance: equilibrium: largest unbalanced force over the mean weight of an element (or moment, over that and the element's radius) of a state of
      rest; in (0, 1); default 0.0001
    path_step: equilibrium: change of the load factor from one state to the next, of the largest so far; more where nothing breaks; in (0, 1); default
      0.02
    level: blocks with a load that grows do not turn (the top is held level): cyclic, and pushover with pattern = "given"; default False
    """

    _table: ClassVar[str] = "analysis"

    kind: Literal["time-history", "pushover", "tilt", "settlement", "cyclic", "rest"] | None = None
    solver: Literal["dynamics", "equilibrium"] | None = None
    pattern: Literal["mass", "mode", "given", "triangular"] | None = None
    direction: Sequence[float] | None = None
    eccentricity: float | None = None
    control: Sequence[float] | str | None = None
    drop: float | None = None
    share: float | None = None
    pace: float | None = None
    damping: float | None = None
    longest: float | None = None
    largest_factor: float | None = None
    largest_drift: float | None = None
    amplitudes: Sequence[float] | None = None
    cycles: int | None = None
    demand: str | None = None
    demand_damping: float | None = None
    tolerance: float | None = None
    path_step: float | None = None
    level: bool | None = None


@dataclass(kw_only=True, slots=True)
class Motion(Part):
    """[motion]: acceleration of the base: a record, or files; any axis may be absent.

    record: "bam-like", "bam-like#7" (realisation 7 of its family; 1 to 999), a folder that holds record.toml, or a file that holds L, T and V; not
      empty
    direction: which of L, T, V goes to x, y, z: LTV sends L along the bearing walls of a house that is not turned, TLV across them; default "LTV"
    x: file of the motion along x; not empty
    y: file of the motion along y; not empty
    z: file of the motion along z; not empty
    L: file of the longitudinal motion; not empty
    T: file of the transverse motion; not empty
    V: file of the vertical motion; not empty
    unit: of the files, where a format does not say
    dt, s: between samples of the files, where a format does not say (one column); in [1e-06, 10], usually 1e-4 to 0.1
    from_, s: of the record: the sample nearest to it shakes first, at time zero; none: its start; >= 0, at most 1e6
    to, s: of the record: the last sample that shakes; none: its end; > 0, at most 1e6
    baseline: taken off each component after the cut: its mean, a least-squares line, or the parabola that leaves the least mean square of velocity;
      default "none"
    taper, s, 2 values: half a cosine from zero at the start and to zero at the end of each component, after cut and baseline; or one each; >= 0, at
      most 1e6; default [0.0, 0.0]
    scale, 3 values: factor of the motion, or one each for L, T, V (for x, y, z if files are given so); usually 0.001 to 50, at most 50000 in
      magnitude; default [1.0, 1.0, 1.0]
    intensity: a level that the motion is brought to, after scale
    """

    _table: ClassVar[str] = "motion"

    record: str | None = None
    direction: Literal["LTV", "LVT", "TLV", "TVL", "VLT", "VTL"] | None = None
    x: str | None = None
    y: str | None = None
    z: str | None = None
    L: str | None = None
    T: str | None = None
    V: str | None = None
    unit: Literal["g", "m/s2", "cm/s2"] | None = None
    dt: float | None = None
    from_: float | None = None
    to: float | None = None
    baseline: Literal["none", "mean", "linear", "parabolic"] | None = None
    taper: Sequence[float] | float | None = None
    scale: Sequence[float] | float | None = None
    intensity: MotionIntensity | None = None


@dataclass(kw_only=True, slots=True)
class Segments(Part):
    """[segments]: segments of the faces.

    size, m: for all faces; none: per unit, a quarter of its shortest edge; of a block with faces, and of a piece of a stone, a quarter of the least
      distance between a face and the corner farthest behind it (of a box its shortest edge); > 0, usually 0.001 to 2, possible 1e-6 to 2000
    rule: where contact points lie: at the centres of n equal cells (the paper's; levers are short by 1/n: a wall of 0.20 m with 4 segments across
      overturns at three quarters of its slope), or up to the rim of each joint, with exact area and moments; corners: at the corners of each joint
      alone, for dry stones that turn about their edges (an impact takes the energy that Housner's block loses); default "centres"
    torsion: how stiff bonded joints are against a twist about their normals: G I_p (the paper's: a column of 1.0 x 0.1 m is 27 times too stiff), or
      Saint-Venant's constant of bars and plates in place of I_p; default "paper"
    """

    _table: ClassVar[str] = "segments"

    size: float | None = None
    rule: Literal["centres", "rim", "corners"] | None = None
    torsion: Literal["paper", "solid"] | None = None


@dataclass(kw_only=True, slots=True)
class Output(Part):
    """[output]: what is written, and how often.

    history_interval, s: between rows of histories; time.step = "auto" takes a step that divides it; > 0, usually 1e-6 to 10, possible 1e-9 to 10000;
      default 0.001
    frame_interval, s: between frames of the whole model; auto: 0.02, or for large models the least of 0.05, 0.1, 0.2, 0.5, ... with which elements
      times frames are at most 40 million, up to a tenth of the duration; with [analysis] 0.02; > 0, usually 1e-5 to 1e6, possible 1e-9 to 1e9;
      default "auto"
    ledger_interval, s: between rows of energy, forces and damage; > 0, usually 1e-6 to 10, possible 1e-9 to 10000; default 0.01
    history: an element whose motion is written
    cut: a plane; the force and the moment that pass it are written
    """

    _table: ClassVar[str] = "output"

    history_interval: float | None = None
    frame_interval: float | Literal["auto"] | None = None
    ledger_interval: float | None = None
    history: Sequence[OutputHistory] | None = None
    cut: Sequence[OutputCut] | None = None


@dataclass(kw_only=True, slots=True)
class House(Part):
    """[house]: a house of four walls: bearing walls along x (front at low y, rear at high y), non-bearing walls along y (left at low x, right at high
    x), before turn.

    inner_size, m, 2 values: inside the walls, along x and y; > 0, usually 0.1 to 100, possible 1e-4 to 1e5; default [5.0, 3.0]
    height, m: of the walls; of the first storey if there are more; > 0, usually 0.1 to 60, possible 1e-4 to 60000; default 2.4
    brick, m, 3 values: length, width, height; with mortar, or without it if `mortar` is given; > 0, usually 0.02 to 3, possible 2e-5 to 3000; default
      [0.2, 0.1, 0.1]
    mortar, m: thickness of beds and upright joints, as in the law of `joint`; 0: `brick` has it in it; >= 0, usually 1e-4 to 0.1, at most 100;
      default 0.0
    bond: bond of the bricks; header: walls as thick as a brick is long are all headers; flemish: walls as thick as one or more bricks are long have
      headers and stretchers in turn; others, and gables, as in English bond; rubble: convex stones (gables: bricks in running bond); default
      "english"
    material: of the bricks; not empty; default "adobe"
    joint: joint law between bricks, and of bricks with the base; not empty; default "normal"
    halves: whole bricks can crack: each is two elements, cut at mid-length, with the law materials.<name>.inside between them; as cells = [2, 1, 1]
      does, but cut bricks are not divided; default False
    cells, 3 values: bricks can crack: number of cells along the length, thickness and height of a whole one, with the law materials.<name>.inside
      between them; shorter bricks get cells of about the same size, bricks cut along a slope are not divided; in [1, 16]
    origin, m, 2 values: x and y of the outer corner; at most 1e9 in magnitude; default [0.0, 0.0]
    turn, degrees: about z; default 0
    copies, 2 values: number of houses along x and y; in [1, 1000]; default [1, 1]
    spacing, m, 2 values: from house to house along x and y; > 0, usually 0.1 to 100, possible 1e-4 to 1e5; default [8.0, 6.0]
    bearing_wall, m: thickness; > 0, usually 0.05 to 5, possible 5e-5 to 5000; default 0.2
    nonbearing_wall, m: thickness; > 0, usually 0.05 to 5, possible 5e-5 to 5000; default 0.2
    walls: walls that are built: front, right, rear, left; not empty; default ['front', 'right', 'rear', 'left']
    rubble: convex stones about the size of a brick for bond = "rubble", in courses of random height, their joints askew; level beds and upright ends
      at corners, openings, floors and ends of storeys
    leaves: outer walls of two leaves, each in the house's bond; storeys whose walls are too thin for two leaves have one
    wood: timber of the house
    storey: a storey upon those before it; a low one on top is a parapet
    inner_wall: a wall from an outer wall to that opposite, toothed into all walls that it meets or crosses
    pier: a pier or buttress on the outer face of a wall, toothed into it
    floor: beams in pockets of the walls, flush with the top of a storey, with or without a deck
    roof: beams side by side, a barrel vault along x, or pairs of rafters
    opening: a door or a window
    reinforcement: timber columns at the inner faces of the walls, and ring beams there or upon the walls
    tie: rods of the house by wall and height: through walls from end to end, across the house, or across its corners
    mesh: a net, mesh or bandage on the faces of walls: straps between nodes, in tension alone
    """

    _table: ClassVar[str] = "house"

    inner_size: Sequence[float] | None = None
    height: float | None = None
    brick: Sequence[float] | None = None
    mortar: float | None = None
    bond: Literal["english", "running", "header", "flemish", "rubble"] | None = None
    material: str | None = None
    joint: str | None = None
    halves: bool | None = None
    cells: Sequence[int] | None = None
    origin: Sequence[float] | None = None
    turn: Literal[0, 90, 180, 270] | None = None
    copies: Sequence[int] | None = None
    spacing: Sequence[float] | None = None
    bearing_wall: float | None = None
    nonbearing_wall: float | None = None
    walls: Sequence[str] | None = None
    rubble: HouseRubble | None = None
    leaves: HouseLeaves | None = None
    wood: HouseWood | None = None
    storey: Sequence[HouseStorey] | None = None
    inner_wall: Sequence[HouseInnerWall] | None = None
    pier: Sequence[HousePier] | None = None
    floor: Sequence[HouseFloor] | None = None
    roof: HouseRoof | None = None
    opening: Sequence[HouseOpening] | None = None
    reinforcement: HouseReinforcement | None = None
    tie: Sequence[HouseTie] | None = None
    mesh: Sequence[HouseMesh] | None = None


@dataclass(kw_only=True, slots=True)
class Wall(Part):
    """[[wall]]: a wall along any line of straight sides, with true dimensions; it is toothed at its corners and into the walls that it meets.

    name: a name of its own, for messages and results; not empty; needed
    points, m: [x, y] of its ends, corners and bends in turn. An end in another wall, or on its face, is a T-junction, or a corner if the other ends
      there too; a wall that reaches through another one crosses it. Angles of corners and junctions: 30 to 150 degrees; where it turns by less than
      30, it bends; usually 0.001 to 9000, at most 1e9 in magnitude; needed
    closed: whether the last point is joined to the first; default False
    line: what the points are of: the middle of the wall (always if it bends), or its left or right face, seen along it; default "middle"
    thickness, m: thickness; > 0, usually 0.05 to 5, possible 5e-5 to 5000; needed
    base, m: height of its foot above base.z: that of a part of the base, or the top of the wall that it stands on; >= 0, usually 0.001 to 60, at most
      60000; default 0.0
    height, m: height; > 0, usually 0.1 to 60, possible 1e-4 to 60000; needed
    brick, m, 3 values: length, width, height, with mortar: made longer or shorter, wider or narrower, higher or lower by a third at most, so that
      whole ones fill the wall; cut where that cannot be, to no less than a fifth; > 0, usually 0.02 to 3, possible 2e-5 to 3000; default [0.2, 0.1,
      0.1]
    bond: bond of the bricks, as house.bond; through: one block through the wall in running bond, the bond of walls that bend; default "english"
    cells, 3 values: bricks can crack: number of cells along the length, thickness and height of a whole one, with the law materials.<name>.inside
      between them; shorter bricks get cells of about the same size, bricks cut along a slope are not divided; in [1, 16]
    material: of the bricks; [joints] has the laws of their joints; not empty; needed
    meeting: where it meets walls before it in the case. toothed: either runs through in every second course; butt: the other does in all, as at an
      extension. Corners of one wall are toothed; default "toothed"
    load, kg/m: mass per length on its top (floor, roof), added to the bricks of the course that ends at `height`; >= 0; default 0.0
    tops, m: [place along the wall's line from its first point, height of its top there], in turn; straight from one to the next, `height` before the
      first and behind the last. At `height` or above it; a place given twice is a step. For gables and parapets: bricks are cut to it; >= 0, usually
      0.1 to 100, at most 1e5
    gable, m: of a wall with one side: height of its top in the middle, from where it falls to `height` at both ends; > 0, usually 0.1 to 60, possible
      1e-4 to 60000
    opening: a door or a window, in one side of the wall
    """

    _table: ClassVar[str] = "wall"
    _array: ClassVar[bool] = True

    name: str
    points: Sequence[Sequence[float]]
    closed: bool | None = None
    line: Literal["left", "middle", "right"] | None = None
    thickness: float
    base: float | None = None
    height: float
    brick: Sequence[float] | None = None
    bond: Literal["english", "running", "header", "through"] | None = None
    cells: Sequence[int] | None = None
    material: str
    meeting: Literal["toothed", "butt"] | None = None
    load: float | None = None
    tops: Sequence[Sequence[float]] | None = None
    gable: float | None = None
    opening: Sequence[WallOpening] | None = None


@dataclass(kw_only=True, slots=True)
class Floor(Part):
    """[[floor]]: beams between two walls of [[wall]], in pockets or upon them, with or without a deck: a floor, or a flat roof.

    name: a name of its own, for messages and results; not empty; needed
    walls: the two sides on which beams rest: a wall of one side by its name ("inner"), of several with the number of the side ("outer 2": from its
      second corner on; bends are no corners); not empty; needed
    corners, m: four [x, y] in turn: beams lie within this quadrilateral; none: wherever both sides face each other; usually 0.001 to 9000, at most
      1e9 in magnitude
    material: of the beams; not empty; needed
    within_member: joint law between elements of one of the beams; not empty; default "wood"
    direction, 2 values: [x, y] of the beams in plan; none: square to the first of the two walls. At least 30 degrees off both
    level, m: of the beams' upper faces above base.z; none: the lower top of the two walls. Beams end in pockets in a wall, or lie at its foot or on
      its top. On a top beside a thinner wall above, they lie on the ledge, and in pockets of the thinner wall if bearing is longer than the ledge; >=
      0, usually 0.1 to 60, at most 60000
    beam, m, 2 values: width and height of a beam; > 0, usually 0.01 to 2, possible 1e-5 to 2000; default [0.1, 0.2]
    spacing, m: from axis to axis; in each room as many as fit, the rest at both ends; > 0, usually 0.1 to 3, possible 1e-4 to 3000; default 0.6
    bearing, m: depth of the pockets, or of the seats upon the walls, square to the wall; beams go through walls between the two; > 0, usually 0.05 to
      5, possible 5e-5 to 5000; default 0.1
    element, m: length of an element of a beam; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.4
    load, kg/m2: mass of boards and all on them; each beam has load x spacing x its length; >= 0, usually 2 to 700, at most 7e5; default 0.0
    joint: joint law of beams with walls, or "dry": friction alone; not empty; default "dry"
    anchorage: friction: beams lie in their pockets; nailed: straps hold them to the bricks under their ends; anchor: rods to the outer face; default
      "friction"
    anchor: what holds the ends of beams to the walls
    deck: boards or a slab on the beams as a shear panel (diagonal bars between neighbouring beams) and bars across the beams, from the middle of the
      first element of the beams between the walls to that of the last
    """

    _table: ClassVar[str] = "floor"
    _array: ClassVar[bool] = True

    name: str
    walls: Sequence[str]
    corners: Sequence[Sequence[float]] | None = None
    material: str
    within_member: str | None = None
    direction: Sequence[float] | None = None
    level: float | None = None
    beam: Sequence[float] | None = None
    spacing: float | None = None
    bearing: float | None = None
    element: float | None = None
    load: float | None = None
    joint: str | None = None
    anchorage: Literal["friction", "nailed", "anchor"] | None = None
    anchor: FloorAnchor | None = None
    deck: FloorDeck | None = None


@dataclass(kw_only=True, slots=True)
class Roof(Part):
    """[[roof]]: pairs of rafters between two parallel walls of [[wall]] of the same height, with gables under them.

    name: a name of its own, for messages and results; not empty; needed
    walls: the two sides on which rafters rest: a wall of one side by its name ("inner"), of several with the number of the side ("outer 2": from its
      second corner on; bends are no corners); not empty; needed
    corners, m: four [x, y] in turn: rafters lie within this quadrilateral; none: wherever both sides face each other; usually 0.001 to 9000, at most
      1e9 in magnitude
    material: of the rafters; not empty; needed
    within_member: joint law between elements of one of the rafters; not empty; default "wood"
    gables: sides, named as those in `walls`, that rise to the rafters' underside; not empty
    pitch, degrees: of the rafters; in [5, 60]; default 30.0
    beam, m, 2 values: width along the ridge and depth of a rafter; > 0, usually 0.01 to 2, possible 1e-5 to 2000; default [0.2, 0.2]
    spacing, m: of the axes of rafters, at most; the first and the last are flush with the ends of the walls; > 0, usually 0.1 to 100, possible 1e-4
      to 1e5; default 0.8
    bearing, m: length of a rafter's seat on a wall, from the wall's inner face; none: the thickness of the wall, at most a brick's length; in any
      case at most as cuts half of the rafter's depth; > 0, usually 0.02 to 30, possible 2e-5 to 30000
    element, m: length of an element of a rafter; > 0, usually 0.02 to 30, possible 2e-5 to 30000; default 0.2
    joint: joint law of rafters with walls, or "dry": friction alone; not empty; default "dry"
    between_beams: joint law between the rafters of a pair, in the ridge; "dry": friction alone; not empty; default "normal"
    surcharge, kg/m2: mass on the upper surface, as of tiles, added to the rafters; >= 0, usually 2 to 700, at most 7e5; default 0.0
    tie: a rod or beam from foot to foot of each pair of rafters, which takes their thrust; none: the walls do
    deck: boards or a slab on the beams as a shear panel (diagonal bars between neighbouring beams) and bars across the beams, from the middle of the
      first element of the beams between the walls to that of the last
    """

    _table: ClassVar[str] = "roof"
    _array: ClassVar[bool] = True

    name: str
    walls: Sequence[str]
    corners: Sequence[Sequence[float]] | None = None
    material: str
    within_member: str | None = None
    gables: Sequence[str] | None = None
    pitch: float | None = None
    beam: Sequence[float] | None = None
    spacing: float | None = None
    bearing: float | None = None
    element: float | None = None
    joint: str | None = None
    between_beams: str | None = None
    surcharge: float | None = None
    tie: RoofTie | None = None
    deck: RoofDeck | None = None


@dataclass(kw_only=True, slots=True)
class Vault(Part):
    """[[vault]]: a vault on walls of [[wall]] of the same height, of voussoirs; joints have the laws of [joints].

    name: a name of its own, for messages and results; not empty; needed
    kind: barrel: rings on two parallel sides; cross: two barrels that cut each other over a rectangle, with the walls raised to them; pavilion: level
      courses along four sides, mitred over the diagonals; dome: the same along a round wall; default "barrel"
    walls: the sides on which voussoirs rest, named as those of floors: two of a barrel vault; of a cross or pavilion vault four, in turn round the
      room; of a dome one closed round wall; not empty; needed
    corners, m: barrel: four [x, y] in turn, voussoirs lie within this quadrilateral; none: wherever both sides face each other; usually 0.001 to
      9000, at most 1e9 in magnitude
    material: of the voussoirs; not empty; needed
    gables: barrel: sides, named as those in `walls`, that rise to the vault's soffit; not empty
    rise, m: of the soffit's crown above the tops of the walls, from a twentieth to a half of the span (over a room: the lesser one); none: half the
      span, a half circle; > 0, usually 0.1 to 100, possible 1e-4 to 1e5
    oculus, m: pavilion, dome: width of an opening in the crown at the soffit, from a twentieth to a half of the span; none: a keystone; > 0, usually
      0.1 to 100, possible 1e-4 to 1e5
    thickness, m: of the vault; its feet stand on the walls, which are no thinner than the feet; > 0, usually 0.01 to 2, possible 1e-5 to 2000;
      default 0.2
    ring, m: barrel: how wide a ring is along the axis of the vault; others: length of a voussoir along its course; > 0, usually 0.02 to 30, possible
      2e-5 to 30000; default 0.2
    voussoirs: number in a ring, from wall to wall; odd unless kind = "barrel"; in [3, 1000]; default 25
    surcharge, kg/m2: mass on each m2 of the curved outer face, as of a fill, added to the voussoirs; >= 0, usually 2 to 700, at most 7e5; default 0.0
    """

    _table: ClassVar[str] = "vault"
    _array: ClassVar[bool] = True

    name: str
    kind: Literal["barrel", "cross", "pavilion", "dome"] | None = None
    walls: Sequence[str]
    corners: Sequence[Sequence[float]] | None = None
    material: str
    gables: Sequence[str] | None = None
    rise: float | None = None
    oculus: float | None = None
    thickness: float | None = None
    ring: float | None = None
    voussoirs: int | None = None
    surcharge: float | None = None


@dataclass(kw_only=True, slots=True)
class WallTie(Part):
    """[[wall_tie]]: steel rods in walls of [[wall]], at given heights: along a side, from end to end, or across a room, from one wall to another.

    name: begins the names of its ties; not empty; needed
    kind: along: a rod through the length of each side, anchored on the outer faces of the walls in which that ends; across: from the outer face of
      the first side to that of the second, square to the first; needed
    walls: straight sides, named as those of floors; across: two that face each other; not empty; needed
    heights, m: above base.z, a rod at each; >= 0, usually 0.001 to 60, at most 60000; needed
    at, m: across: where along the line of the first wall from its first point, a rod at each; >= 0, usually 0.1 to 100, at most 1e5
    depth, m: along: from the left face of the side, seen along it; none: half its thickness; >= 0, usually 0.05 to 5, at most 5000
    area, m2: of its section; > 0, usually 1e-7 to 0.1, possible 9.999999999999999e-11 to 100; needed
    young, Pa: modulus; the default is that of steel; > 0, usually 1e7 to 1e12, possible 10000 to 1e15; default 210000000000.0
    yield_, Pa: stress at which it yields; none: elastic; > 0, usually 1e5 to 5e9, possible 100 to 5e12
    hardening, Pa: slope of stress over strain beyond yield; >= 0, usually 10000 to 1e12, at most 1e15; default 0.0
    elongation: strain at which it breaks; none: never; > 0, usually 0.001 to 1, possible 1e-6 to 1000
    pretension, N: force that it would have if its ends did not move; put on with gravity, or at once without settling; >= 0, usually 50 to 1e7, at
      most 1e10; default 0.0
    compression: bears compression, too, without buckling; else it goes slack; default False
    plate, m, 2 values: width and height of the anchor plates that spread its force over the faces they cover; none: each end holds one element; > 0,
      usually 0.01 to 2, possible 1e-5 to 2000
    """

    _table: ClassVar[str] = "wall_tie"
    _array: ClassVar[bool] = True

    name: str
    kind: Literal["along", "across"]
    walls: Sequence[str]
    heights: Sequence[float]
    at: Sequence[float] | None = None
    depth: float | None = None
    area: float
    young: float | None = None
    yield_: float | None = None
    hardening: float | None = None
    elongation: float | None = None
    pretension: float | None = None
    compression: bool | None = None
    plate: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class Block(Part):
    """[[block]]: a block by itself: box, vertices, or polygon and extrude.

    name: a name of its own, for loads and messages; not empty; needed
    material: a name of materials; not empty; needed
    part: the part of a building that it is of: "front wall", "left wall, storey 2", "inner wall", "right gable": blocks of a wall have drift, cracks
      and damage as a house's have; none: no part; default ""
    box, m, 2 values: two opposite corners
    vertices, m: eight corners of a hexahedron, VTK order; with faces, those of any convex polyhedron
    faces: numbers of vertices, from 0, of each face, counter-clockwise seen from outside
    polygon, m: section of a prism along x: its corners [y, z]
    extrude, m, 2 values: the prism's [x0, x1]
    halves: a box that can crack: two elements name/1 and name/2, cut at mid-length (across the longer horizontal edge), with the law
      materials.<name>.inside between them; the same as cells = [2, 1, 1]; default False
    cells, 3 values: a block that can crack: its number of cells along its length, thickness and height, elements name/1, name/2, ... with the law
      materials.<name>.inside between them. A box: along the longer horizontal edge, the other one, z; a polygon of four corners: along its first
      edge, x, its second edge; eight vertices: along the edges from the first to the second, the fourth, the fifth; in [1, 16]
    fixed: does not move, or only by [block.motion]; default False
    free: may float; else touching nothing is an error; default False
    velocity, m/s, 3 values: at the start; usually 1e-9 to 100, at most 1e5 in magnitude; default [0.0, 0.0, 0.0]
    angular_velocity, rad/s, 3 values: at the start, about global axes; usually 1e-6 to 1000, at most 1e6 in magnitude; default [0.0, 0.0, 0.0]
    rotate: turns the block before the start
    motion: motion of a fixed block, of fixed stones, or of a part of the base: velocity, file, or its end
    """

    _table: ClassVar[str] = "block"
    _array: ClassVar[bool] = True

    name: str
    material: str
    part: str | None = None
    box: Sequence[Sequence[float]] | None = None
    vertices: Sequence[Sequence[float]] | None = None
    faces: Sequence[Sequence[int]] | None = None
    polygon: Sequence[Sequence[float]] | None = None
    extrude: Sequence[float] | None = None
    halves: bool | None = None
    cells: Sequence[int] | None = None
    fixed: bool | None = None
    free: bool | None = None
    velocity: Sequence[float] | None = None
    angular_velocity: Sequence[float] | None = None
    rotate: BlockRotate | None = None
    motion: BlockMotion | None = None


@dataclass(kw_only=True, slots=True)
class Stones(Part):
    """[[stones]]: stones out of a file: every closed body in it is one.

    file: OBJ, PLY, STL, VTU or COMPAS JSON; or a folder, each such file in it a stone; not empty; needed
    unit: of lengths in the file; none of these formats says it; needed
    name: goes before the names of its stones: "name/stone"; default ""
    only: names and groups of the file that are taken; none: all
    place, m, 3 values: by which the stones are moved, after they were turned; default [0.0, 0.0, 0.0]
    material: a name of materials; none: the only one; default ""
    part: the part of a building that its stones are of, as block.part; none: no part; default ""
    joint: law between stones of this table: a name of joint_laws, or "dry"; none: [joints]; not empty
    snap, m: faces nearer than this, or as much inside each other, are put into one plane and are in contact; faces that are warped by no more are
      made plane; what else of a stone lies in another one or under the base by no more is cut off; in [0, 0.05]; default 0.001
    gap, m: faces so far apart (within snap) have a bed of mortar between them: both stones are grown to its middle, and its thickness enters Eq. 3 in
      place of the law's; none: they do not touch; in [1e-04, 0.2]
    warped: faces that are warped by more than snap: refused, or parted into triangles along their shortest diagonals, after which the stone is cut
      along its reflex edges; default "refuse"
    fit: how stones are made to touch: within snap; or, for stones drawn with gaps, overlaps and warped faces, by one plane for each pair that
      touches, the best fit of both faces, to which both are cut and filled. The same in all tables of a case; default "snap"
    fit_limit, m: with fit = "planes": how far the surface of a stone may move; overlaps of two stones up to the sum of their limits, and gaps up to
      half of it, are mended; none: a quarter of the least width of each stone; > 0, possible 1e-6 to 10
    supports: stones that are fixed: all that touch the lowest level of the file ("ground"), none of them ("none"), all that reach below a height [m],
      or those of the names and groups in an array; none: those that the file marks as supports, and if it marks none and the case has neither [base]
      nor a fixed block: "ground"; at most 1e9 in magnitude
    turn: turns the stones about an axis, before they are moved by place; a number: degrees about the file's z axis
    motion: motion of a fixed block, of fixed stones, or of a part of the base: velocity, file, or its end
    """

    _table: ClassVar[str] = "stones"
    _array: ClassVar[bool] = True

    file: str
    unit: Literal["m", "cm", "mm", "in", "ft"]
    name: str | None = None
    only: Sequence[str] | None = None
    place: Sequence[float] | None = None
    material: str | None = None
    part: str | None = None
    joint: str | None = None
    snap: float | None = None
    gap: float | None = None
    warped: Literal["refuse", "triangles"] | None = None
    fit: Literal["snap", "planes"] | None = None
    fit_limit: float | None = None
    supports: float | Sequence[str] | Literal["ground", "none"] | None = None
    turn: StonesTurn | float | None = None
    motion: StonesMotion | None = None


@dataclass(kw_only=True, slots=True)
class Load(Part):
    """[[load]]: a force and a moment on a block, constant after the ramp unless they grow.

    block: name of the block; empty: the first one that the force meets from `at` on, or from the points of `path`; default ""
    force, N, 3 values: force; usually 0.001 to 1e9, at most 1e12 in magnitude; default [0.0, 0.0, 0.0]
    moment, N m, 3 values: moment; usually 0.001 to 1e9, at most 1e12 in magnitude; default [0.0, 0.0, 0.0]
    at, m, 3 values: point of the block where the force acts, moving with it; none: the centroid; at most 1e9 in magnitude
    path: CSV of t, x, y, z in s and m: a force that moves along these points, in place of `block` and `at`; before the first time there is none,
      after the last it stays at the last point; not empty
    ramp, s, 2 values: grows linearly from the first time to the second; usually 0.001 to 2000, at most 2e6 in magnitude; default [0.0, 0.0]
    history: CSV of t, x, y, z in s and N: the force over time, in place of `force` and `ramp`; not empty
    follows: force and moment turn with the block; false: a dead load, which keeps its direction; default False
    grows: multiplied by the load factor of [analysis]: a pushover with pattern = "given", or cyclic; default False
    """

    _table: ClassVar[str] = "load"
    _array: ClassVar[bool] = True

    block: str | None = None
    force: Sequence[float] | None = None
    moment: Sequence[float] | None = None
    at: Sequence[float] | None = None
    path: str | None = None
    ramp: Sequence[float] | None = None
    history: str | None = None
    follows: bool | None = None
    grows: bool | None = None


@dataclass(kw_only=True, slots=True)
class Tie(Part):
    """[[tie]]: a rod, cable, strap or bar between two points of the model.

    name: a name of its own, for results and messages; not empty; needed
    from_, m, 3 values: a point in or on an element, or on the base; with a plate, on an outer face; needed
    to, m, 3 values: its other end, likewise; needed
    area, m2: of its section; > 0, usually 1e-7 to 0.1, possible 9.999999999999999e-11 to 100; needed
    young, Pa: modulus; the default is that of steel; > 0, usually 1e7 to 1e12, possible 10000 to 1e15; default 210000000000.0
    yield_, Pa: stress at which it yields; none: elastic; > 0, usually 1e5 to 5e9, possible 100 to 5e12
    hardening, Pa: slope of stress over strain beyond yield; >= 0, usually 10000 to 1e12, at most 1e15; default 0.0
    elongation: strain at which it breaks; none: never; > 0, usually 0.001 to 1, possible 1e-6 to 1000
    pretension, N: force that it would have if its ends did not move; put on with gravity, or at once without settling; >= 0, usually 50 to 1e7, at
      most 1e10; default 0.0
    compression: bears compression, too, without buckling; else it goes slack; default False
    plate, m, 2 values: width and height of the anchor plates that spread its force over the faces they cover; none: each end holds one element; > 0,
      usually 0.01 to 2, possible 1e-5 to 2000
    """

    _table: ClassVar[str] = "tie"
    _array: ClassVar[bool] = True

    name: str
    from_: Sequence[float]
    to: Sequence[float]
    area: float
    young: float | None = None
    yield_: float | None = None
    hardening: float | None = None
    elongation: float | None = None
    pretension: float | None = None
    compression: bool | None = None
    plate: Sequence[float] | None = None


@dataclass(kw_only=True, slots=True)
class Base(Part):
    """[base]: fixed half-space under everything.

    z, m: height of its top, the lowest ground; usually 0.001 to 9000, at most 1e9 in magnitude; default 0.0
    tilt, degrees, 2 values: about x and y; turns gravity; in (-90, 90), usually 0.001 to 60; default [0.0, 0.0]
    part: a part of the ground above the base, as a slope has in steps, or one that moves: a rectangle in plan, or what lies under a wall of the
      house; walls begin upon it
    """

    _table: ClassVar[str] = "base"

    z: float | None = None
    tilt: Sequence[float] | None = None
    part: Sequence[BasePart] | None = None


@dataclass(kw_only=True, slots=True)
class Case(Part):
    """The whole case.

    title: one line, for lists and reports; default ""
    source: where the numbers come from; default ""
    include: ready cases or .toml files that are read first; this case lies over them, key by key
    gravity: body force and the settling before time zero
    time: time step and duration
    damping: mass damping: ratio at frequency, or alpha
    materials: a material of elements
    joint_laws: strength of a joint (Eqs. 5-7) and its mortar (Eq. 3)
    scatter: random strength of joints: one factor a joint on tension, cohesion and compression of its law
    failure: options of the failure law
    joints: laws of touching faces: a house's own keys, then the first of `between` that fits, then `default`
    contact: contact of faces without a bond
    analysis: what the run finds out: what an earthquake does, or a capacity by slow loading
    motion: acceleration of the base: a record, or files; any axis may be absent
    segments: segments of the faces
    output: what is written, and how often
    house: a house of four walls: bearing walls along x (front at low y, rear at high y), non-bearing walls along y (left at low x, right at high x),
      before turn
    wall: a wall along any line of straight sides, with true dimensions; it is toothed at its corners and into the walls that it meets
    floor: beams between two walls of [[wall]], in pockets or upon them, with or without a deck: a floor, or a flat roof
    roof: pairs of rafters between two parallel walls of [[wall]] of the same height, with gables under them
    vault: a vault on walls of [[wall]] of the same height, of voussoirs; joints have the laws of [joints]
    wall_tie: steel rods in walls of [[wall]], at given heights: along a side, from end to end, or across a room, from one wall to another
    block: a block by itself: box, vertices, or polygon and extrude
    stones: stones out of a file: every closed body in it is one
    load: a force and a moment on a block, constant after the ramp unless they grow
    tie: a rod, cable, strap or bar between two points of the model
    base: fixed half-space under everything
    """

    _table: ClassVar[str] = ""

    title: str | None = None
    source: str | None = None
    include: str | Sequence[str] | None = None
    gravity: Gravity | None = None
    time: Time | None = None
    damping: Damping | None = None
    materials: Mapping[str, Material] | None = None
    joint_laws: Mapping[str, JointLaw] | None = None
    scatter: Scatter | None = None
    failure: Failure | None = None
    joints: Joints | None = None
    contact: Contact | None = None
    analysis: Analysis | None = None
    motion: Motion | None = None
    segments: Segments | None = None
    output: Output | None = None
    house: House | None = None
    wall: Sequence[Wall] | None = None
    floor: Sequence[Floor] | None = None
    roof: Sequence[Roof] | None = None
    vault: Sequence[Vault] | None = None
    wall_tie: Sequence[WallTie] | None = None
    block: Sequence[Block] | None = None
    stones: Sequence[Stones] | None = None
    load: Sequence[Load] | None = None
    tie: Sequence[Tie] | None = None
    base: Base | None = None


__all__ = ["Analysis", "Base", "BasePart", "BasePartMotion", "Block", "BlockMotion", "BlockRotate", "Case", "Contact", "ContactBetween", "Damping",
           "Failure", "Floor", "FloorAnchor", "FloorDeck", "Gravity", "House", "HouseFloor", "HouseFloorAnchor", "HouseFloorDeck", "HouseInnerWall",
           "HouseLeaves", "HouseLeavesThrough", "HouseMesh", "HouseMeshConnectors", "HouseOpening", "HouseOpeningArch", "HouseOpeningLintel",
           "HousePier", "HouseReinforcement", "HouseRoof", "HouseRoofDeck", "HouseRoofTie", "HouseRubble", "HouseStorey", "HouseTie", "HouseWood",
           "JointLaw", "Joints", "JointsBetween", "Load", "Material", "Motion", "MotionIntensity", "Output", "OutputCut", "OutputHistory", "Roof",
           "RoofDeck", "RoofTie", "Scatter", "Segments", "Stones", "StonesMotion", "StonesTurn", "Tie", "Time", "Vault", "Wall", "WallOpening",
           "WallOpeningArch", "WallOpeningLintel", "WallTie"]
