# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""From the elements of a drawing (read_ifc.mjs) to walls and floors as [[wall]] and [[floor]] have them: straight, from point to point, resting on
each other, meeting in their middle lines. What is not read, and what is changed, is written down."""
from __future__ import annotations

import collections
import dataclasses
import math
import re

import solids

Point = tuple[float, float]

LIGHT = re.compile(r"stud|plaster|gypsum|gips|glas|insul|dämm|timber|wood|holz|metal|steel|air|void|furring|panel|vapou?r", re.I)
WOOD = re.compile(r"wood|timber|lumber|holz|joist|plywood", re.I)
DENSITIES = [(re.compile(p, re.I), d) for p, d in (
    (r"insul|dämm|air|void|vapou?r|membrane", 30.0), (WOOD.pattern, 600.0), (r"leichtbeton|light|aerated|poren", 900.0), (r"reinforced|stahlbeton", 2500.0),
    (r"concrete|beton|screed|estrich", 2300.0), (r"brick|clay|ziegel", 1700.0), (r"block|masonry|mauer|kalksand", 1600.0), (r"stone|stein|tile", 2200.0),
    (r"plaster|gyps|gips", 1000.0))]
OTHER_DENSITY = 2000.0  # kg/m3, of what none of these words tells
ERRORS = (ArithmeticError, IndexError, KeyError, RecursionError, TypeError, ValueError)  # of elements that make no plan
TOUCH = 0.03            # m: what is nearer touches
SLAB = 0.8              # m: a wall stands on another if no more is between them, as the end of a floor
LOW = 0.35              # m: a lowest wall that begins so much above the ground is taken down to it
STOREY = 1.8            # m: a slab with less above the ground is no floor between walls
RECTANGULAR = 0.9       # share of the rectangle round it that a slab fills
BORNE = 0.85            # share of a wall that lies on others, for it to stand on them
COURSE = 0.05           # m: sills, heads and lintels nearer to each other become one level
LINTEL = 0.2            # m, height, and bearing at either side
SHAPE = 0.03            # share of a wall's volume by which what was read may differ before it is told


@dataclasses.dataclass
class Opening:
    start: float  # along the wall, from its first point
    width: float
    sill: float   # above the wall's foot
    height: float
    name: str = ""
    lintel: float = 0.0  # its height; 0: none
    narrowed: float = 0.0  # by so much, in all

    @property
    def head(self) -> float:
        return self.sill + self.height


@dataclasses.dataclass
class Wall:
    name: str
    points: list[Point]  # both ends of its middle line
    thickness: float
    base: float
    height: float
    tops: list[Point] = dataclasses.field(default_factory=list)  # (place, height above its foot)
    openings: list[Opening] = dataclasses.field(default_factory=list)
    layers: list[dict] = dataclasses.field(default_factory=list)
    storey: str = ""

    @property
    def length(self) -> float:
        return math.dist(*self.points)

    @property
    def along(self) -> Point:
        (x, y), (X, Y) = self.points
        return ((X - x) / self.length, (Y - y) / self.length)

    @property
    def top(self) -> float:
        return self.base + self.height

    def rectangle(self) -> solids.Rectangle:
        (x, y), (X, Y) = self.points
        return solids.Rectangle((0.5 * (x + X), 0.5 * (y + Y)), self.along, self.length, self.thickness)


@dataclasses.dataclass
class Floor:
    name: str
    walls: tuple[str, str]
    corners: list[Point]
    level: float
    thickness: float
    mass: float  # kg/m2, of all layers
    wood: bool
    spacing: float = 0.6


@dataclasses.dataclass
class Plan:
    walls: list[Wall] = dataclasses.field(default_factory=list)
    floors: list[Floor] = dataclasses.field(default_factory=list)
    ground: float = 0.0
    changed: list[str] = dataclasses.field(default_factory=list)  # how what is in the case differs from the drawing
    left_out: dict[str, list[str]] = dataclasses.field(default_factory=dict)  # what is not in the case, by why

    def leave_out(self, what: str, why: str) -> None:
        self.left_out.setdefault(why, []).append(what)

    def left_out_lines(self) -> list[str]:
        """A line for each reason, with the first few that have it."""
        return [f"{', '.join(names[:3])}{f' and {len(names) - 3} more' if len(names) > 3 else ''}: {why}" for why, names in self.left_out.items()]


@dataclasses.dataclass
class Choice:
    thinnest: float = 0.1       # m: thinner walls are left out
    without: list[str] = dataclasses.field(default_factory=list)  # words; elements that have one in their name or storey are left out
    light: bool = False         # take walls of studs and boards, too


def density(layer: str) -> float:
    return next((d for pattern, d in DENSITIES if pattern.search(layer)), OTHER_DENSITY)


def is_light(element: dict) -> bool:
    """Whether all layers are of boards, studs and the like. A wall without layers is masonry."""
    names = [layer["name"] for layer in element["layers"] if layer["name"]]
    return bool(names) and all(LIGHT.search(name) for name in names)


class Namer:
    """Names that are told apart, as short as the drawing's allow."""

    def __init__(self) -> None:
        self.given: set[str] = set()

    def name(self, wanted: str, otherwise: str = "wall") -> str:
        base = re.sub(r"[^\w.,()/ +-]", " ", wanted).strip() or otherwise
        name, k = base, 1
        while name in self.given:
            k += 1
            name = f"{base} {k}"
        self.given.add(name)
        return name


def openings_of(element: dict, r: solids.Rectangle, low: float, high: float) -> list[Opening]:
    """Each as the rectangle round it, as far as it is in the wall."""
    found = []
    for o in element["openings"]:
        if not o["corners"]:
            continue
        surface = solids.Surface.of(o)
        places = [r.place((x, y))[0] + 0.5 * r.length for x, y, _ in surface.corners]
        start, end = max(min(places), 0.0), min(max(places), r.length)
        sill, head = max(surface.low, low), min(surface.high, high)
        if end - start > TOUCH and head - sill > TOUCH:
            found.append(Opening(start, end - start, sill - low, head - sill, o["name"]))
    return sorted(found, key=lambda o: (o.start, o.sill))


def wall_of(element: dict, name: str, plan: Plan) -> Wall | None:
    surface = solids.Surface.of(element)
    r = solids.rectangle([(x, y) for x, y, _ in surface.corners])
    if r is None:
        plan.leave_out(f"wall {name}", "has no thickness")
        return None
    outline = solids.area(solids.hull([(x, y) for x, y, _ in surface.corners]))
    if outline < r.length * r.width - 2.0 * r.width**2 - 1e-6:  # mitres take a square of the thickness at most
        plan.leave_out(f"wall {name}", "is not straight in plan; [[wall]] has points for bends and rings")
        return None
    low, high = surface.low, surface.high
    openings = openings_of(element, r, low, high)
    line = solids.top_line(surface, r, [(o.start - 0.5 * r.length, o.start + o.width - 0.5 * r.length) for o in openings if o.sill + o.height > high - low - TOUCH])
    height = min((z for _, z in line), default=high) - low
    tops = [(s, z - low) for s, z in line] if line and high - low - height > 0.02 else []
    wall = Wall(name, [r.point(-0.5 * r.length, 0.0), r.point(0.5 * r.length, 0.0)], r.width, low, height, tops, openings, element["layers"], element["storey"])
    compare_volume(wall, surface, plan)
    return wall


def compare_volume(wall: Wall, surface: solids.Surface, plan: Plan) -> None:
    """Writes down where the volume of what was read is not that of the drawing."""
    side = wall.height * wall.length
    for (s, z), (t, w) in zip(wall.tops, wall.tops[1:]):
        side += (t - s) * (0.5 * (z + w) - wall.height)
    whole = wall.thickness * (side - sum(o.width * o.height for o in wall.openings))
    drawn = surface.volume()
    if abs(whole - drawn) > SHAPE * drawn + wall.thickness**2 * wall.height:  # its ends may be mitred
        plan.changed.append(f"wall {wall.name}: {whole:.2f} m3 as read, {drawn:.2f} m3 as drawn (openings are taken as the rectangles round them)")


def borne(a: Wall, below: list[Wall]) -> float:
    """Share of the middle line of a that lies over any of the walls below, in plan."""
    r, count = a.rectangle(), 40
    inside = 0
    for k in range(count):
        p = r.point(((k + 0.5) / count - 0.5) * r.length, 0.0)
        places = [(b, b.rectangle().place(p)) for b in below]
        inside += any(abs(s) < 0.5 * b.length + TOUCH and abs(n) < 0.5 * b.thickness + TOUCH for b, (s, n) in places)
    return inside / count


def ground_of(walls: list[Wall]) -> float:
    """The lowest height at which a sixth of all walls, by length, begins: a garden wall below is not the ground of the building."""
    whole = sum(w.length for w in walls)
    levels = sorted(w.base for w in walls)
    return next((z for z in levels if sum(w.length for w in walls if z - 1e-9 <= w.base <= z + LOW) >= whole / 6.0), levels[0])


def take_down(wall: Wall, rise: float, plan: Plan) -> None:
    """To the ground; its tops and openings stay where they are."""
    wall.height, wall.base = wall.height + rise, plan.ground
    wall.tops = [(s, z + rise) for s, z in wall.tops]
    for o in wall.openings:
        o.sill += rise


def rest_on_each_other(plan: Plan) -> None:
    """Takes walls down to the ground, or those below up to them; what stands on no wall is left out."""
    plan.ground = ground_of(plan.walls)
    kept: list[Wall] = []
    for wall in sorted(plan.walls, key=lambda w: w.base):
        rise = wall.base - plan.ground
        under = [w for w in kept if -TOUCH < wall.base - w.top < SLAB and borne(wall, [w]) > 0.0]
        if rise < -TOUCH:
            plan.leave_out(f"wall {wall.name}", f"begins {-rise:.2f} m below the ground on which most walls stand")
            continue
        if rise <= TOUCH:
            take_down(wall, rise, plan)
        elif borne(wall, under) > BORNE:
            for w in under:
                gap = wall.base - w.top
                if abs(gap) > 1e-6 and not w.tops:
                    if gap > TOUCH:
                        plan.changed.append(f"wall {w.name}: raised by {gap:.3f} m to wall {wall.name}, which stands on it, where the drawing has a floor")
                    w.height += gap
        elif rise <= LOW:
            plan.changed.append(f"wall {wall.name}: taken down by {rise:.3f} m to the ground")
            take_down(wall, rise, plan)
        else:
            plan.leave_out(f"wall {wall.name}", f"{100 * borne(wall, under):.0f} % of it stand on walls, {rise:.2f} m above the lowest")
            continue
        kept.append(wall)
    plan.walls = kept


def meeting(wall: Wall, end: int, other: Wall) -> float | None:
    """How far an end has to go on (below 0: back) to the middle line of another wall; none if that does not go by."""
    p, sign = wall.points[end], 1.0 if end == 1 else -1.0
    d = (sign * wall.along[0], sign * wall.along[1])
    u, q = other.along, other.points[0]
    turn = d[0] * u[1] - d[1] * u[0]
    if abs(turn) < math.sin(math.radians(30.0)):
        return None
    gap = (q[0] - p[0], q[1] - p[1])
    far, place = (gap[0] * u[1] - gap[1] * u[0]) / turn, (gap[0] * d[1] - gap[1] * d[0]) / turn
    reach = 0.5 * (wall.thickness + other.thickness) / abs(turn) + TOUCH
    if not -reach <= far <= reach or not -reach <= place <= other.length + reach:
        return None
    return far


def meet_in_middle_lines(plan: Plan) -> None:
    """Moves the ends of walls to the middle lines of those that they meet: corners and T-junctions."""
    moves = []
    for wall in plan.walls:
        for end in (0, 1):
            beside = [w for w in plan.walls if w is not wall and min(w.top, wall.top) - max(w.base, wall.base) > TOUCH]
            ways = [m for m in (meeting(wall, end, w) for w in beside) if m is not None]
            if ways:
                moves.append((wall, end, min(ways, key=abs)))
    for wall, end, far in moves:
        (x, y), u, sign = wall.points[end], wall.along, 1.0 if end == 1 else -1.0
        wall.points[end] = (x + sign * far * u[0], y + sign * far * u[1])
        if end == 0:
            wall.tops = [(s + far, z) for s, z in wall.tops]
            for o in wall.openings:
                o.start += far
    for wall in plan.walls:
        wall.tops = clipped(wall.tops, wall.length)


def clipped(line: list[Point], length: float) -> list[Point]:
    """The part of a line (place, height) from 0 to a length."""
    out: list[Point] = []
    for (a, z), (b, w) in zip(line, line[1:]):
        low, high = max(a, 0.0), min(b, length)
        if low <= high and a < b:
            out += [(s, z + (w - z) * (s - a) / (b - a)) for s in (low, high)]
        elif a == b and 0.0 <= a <= length:  # a step
            out += [(a, z), (b, w)]
    return [p for k, p in enumerate(out) if k == 0 or p != out[k - 1]]


def lay_courses(plan: Plan) -> None:
    """Leaves out openings that [[wall]] has no place for, and moves sills, heads and lintels to few levels, so that no course is too low."""
    for wall in plan.walls:
        for o in list(wall.openings):
            why = "at the end of its wall" if o.start < TOUCH or o.start + o.width > wall.length - TOUCH else "" if o.head <= wall.height + TOUCH or in_gable(wall, o, 0.0) else "too near to the slope of a gable"
            if why:
                wall.openings.remove(o)
                plan.leave_out(f"opening {o.name} of wall {wall.name}".replace("  ", " "), f"is {why}")
    levels = {z for w in plan.walls for z in (w.base, w.top)} | {z for f in plan.floors for z in (f.level, f.level - f.thickness)}
    moved = []

    def level(z: float, within: float) -> float:
        near = min(levels, key=lambda x: abs(x - z))
        if abs(near - z) < within:
            return near
        levels.add(z)
        return z

    every = sorted(((w, o) for w in plan.walls for o in w.openings), key=lambda x: -x[1].width * x[1].height)
    for wall, o in every:
        sill, head = (level(wall.base + z, COURSE) - wall.base for z in (o.sill, o.head))
        moved += [abs(sill - o.sill), abs(head - o.head)]
        o.sill, o.height = sill, head - sill
    for wall, o in every:
        if has_room(wall, o):
            head = wall.base + o.head
            top = min((z for z in levels if head + 0.5 * LINTEL <= z <= head + 1.5 * LINTEL), key=lambda z: abs(z - head - LINTEL), default=None)
            if top is None:
                top = level(head + LINTEL, COURSE)
            o.lintel = top - head
    bare = [f"{o.name or 'opening'} of wall {w.name}" for w, o in every if o.lintel == 0.0]
    if bare:
        plan.changed.append(f"{len(bare)} opening{'s have' if len(bare) > 1 else ' has'} no lintel, for which there is no room: {', '.join(bare[:3])}{' and others' if len(bare) > 3 else ''}")
    if moved and max(moved) > 1e-4:
        plan.changed.append(f"{sum(m > 1e-4 for m in moved)} of {len(moved)} sills and heads: moved by {max(moved):.3f} m at most, so that courses of bricks fit")


def in_gable(wall: Wall, o: Opening, beyond: float) -> bool:
    """Whether a wall reaches above an opening, and its lintel, by half a block."""
    def top(s: float) -> float:
        return next((z + (w - z) * (s - a) / (b - a) for (a, z), (b, w) in zip(wall.tops, wall.tops[1:]) if a <= s <= b and a < b), wall.height)
    return o.head + beyond + 0.1 <= min(top(o.start - beyond), top(o.start + o.width + beyond))


def has_room(wall: Wall, o: Opening) -> bool:
    """Whether a lintel fits above and beside an opening."""
    beside = [o.start, wall.length - o.start - o.width]
    for p in wall.openings:
        if p is not o and p.sill < o.head + LINTEL and p.head + LINTEL > o.head:
            beside.append((o.start - p.start - p.width if p.start < o.start else p.start - o.start - o.width) - LINTEL)
    return (wall.height - o.head >= LINTEL - COURSE or in_gable(wall, o, LINTEL)) and min(beside) >= LINTEL


def floor_of(element: dict, name: str, plan: Plan) -> None:
    surface = solids.Surface.of(element)
    r = solids.rectangle([(x, y) for x, y, _ in surface.corners])
    thickness = surface.high - surface.low
    if r is None or element["type"] in ("ROOF", "LANDING"):
        plan.leave_out(f"slab {name}", f"is a {element['type'].lower() or 'surface'}, which is not read")
        return
    if surface.low < plan.ground + STOREY:
        plan.leave_out(f"slab {name}", "lies on the ground, or has no storey below")
        return
    holes = [solids.rectangle([(x, y) for x, y, _ in solids.Surface.of(o).corners]) for o in element["openings"]]
    hole = sum(h.length * h.width for h in holes if h) * thickness
    if surface.volume() + hole < RECTANGULAR * r.length * r.width * thickness:
        plan.leave_out(f"slab {name}", "is no rectangle in plan")
        return
    if hole > 0.0:
        plan.changed.append(f"slab {name}: has no opening, as for stairs, of {hole / thickness:.1f} m2")
    if thickness < 0.05:
        plan.leave_out(f"slab {name}", "less than 5 cm thick, a finish; its mass is not in the case")
        return
    layers = [layer for layer in element["layers"] if layer["thickness"] > 0] or [{"name": next((x["name"] for x in element["layers"]), ""), "thickness": thickness}]
    walls = bearing_walls(r, surface.high, plan)
    if walls is None:
        plan.leave_out(f"slab {name}", f"no two walls bear it at {surface.high:.2f} m on opposite sides")
        return
    plan.floors.append(Floor(name, walls, r.corners(), surface.high, thickness, sum(density(x["name"]) * x["thickness"] for x in layers), any(WOOD.search(x["name"]) for x in layers)))


def bearing_walls(r: solids.Rectangle, level: float, plan: Plan) -> tuple[str, str] | None:
    """The walls along two opposite sides of a rectangle, those that are nearer to each other first, that reach up to a level."""
    for along, length, width in ((r.along, r.length, r.width), (r.across, r.width, r.length)):
        across = (-along[1], along[0])
        sides = []
        for sign in (-1.0, 1.0):
            best, share = None, 0.3
            for w in plan.walls:
                if w.top < level - TOUCH or w.base > level - TOUCH or abs(w.along[0] * along[1] - w.along[1] * along[0]) > 0.1:
                    continue
                places = [((p[0] - r.middle[0]) * along[0] + (p[1] - r.middle[1]) * along[1], (p[0] - r.middle[0]) * across[0] + (p[1] - r.middle[1]) * across[1]) for p in w.points]
                if abs(0.5 * (places[0][1] + places[1][1]) - 0.5 * sign * width) > 0.5 * w.thickness + 0.1:
                    continue
                low, high = sorted(p[0] for p in places)
                covered = (min(high, 0.5 * length) - max(low, -0.5 * length)) / length
                if covered > share:
                    best, share = w, covered
            sides.append(best)
        if sides[0] and sides[1]:
            return sides[0].name, sides[1].name
    return None


def plan_of(elements: list[dict], choice: Choice) -> Plan:
    plan, namer = Plan(), Namer()
    others: collections.Counter[str] = collections.Counter()
    slabs = []
    for e in elements:
        words = f"{e['name']} {e['storey']}"
        if any(w.lower() in words.lower() for w in choice.without):
            plan.leave_out(f"{e['kind']} {e['name']}", "--without")
        elif e["kind"] not in ("wall", "slab"):
            others[e["kind"]] += 1
        elif not e["corners"]:
            plan.leave_out(f"{e['kind']} {e['name']}", "has no surface")
        elif e["kind"] == "slab":
            slabs.append(e)
        else:
            name = namer.name(e["name"])
            wall = wall_of(e, name, plan)
            if wall is None:
                continue
            if not choice.light and is_light(e):
                plan.leave_out(f"wall {name}", f"of {', '.join(layer['name'] for layer in e['layers'])}, no masonry (--light takes it)")
            elif wall.thickness < choice.thinnest:
                plan.leave_out(f"wall {name}", f"{1000 * wall.thickness:.0f} mm thick (--thinnest)")
            else:
                plan.walls.append(wall)
    if not plan.walls:
        return plan
    named = {w.name for w in plan.walls}
    plan.changed = [line for line in plan.changed if line[5:].rsplit(": ", 1)[0] in named]
    rest_on_each_other(plan)
    meet_in_middle_lines(plan)
    for e in slabs:
        floor_of(e, namer.name(e["name"], "slab"), plan)
    lay_courses(plan)
    for kind, count in sorted(others.items()):
        plan.leave_out(f"{count} {kind}{'' if count == 1 else 's'}", "not read")
    return plan
