# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Random walls of any plan ([[wall]]) with floors, roofs and vaults between them, and what a relation does to their tables."""
import math

import numpy

from data import Case

TIMBER = {"material": "wood", "within_member": "timber"}


def wall(rng, name, points, thickness, height, closed=False):
    """A wall of one block through, of 0.4 x 0.2 m."""
    return {"name": name, "points": [[float(x) for x in p] for p in points], "closed": closed, "line": rng.choice(["left", "middle", "right"]) if closed else "middle",
            "thickness": thickness, "height": height, "brick": [0.4, 0.2, 0.2], "bond": "through", "material": "stone",
            "load": float(rng.choice([0, 0, 150]))}


def floor(rng, walls, thickness):
    f = {"name": "floor", "walls": walls, "beam": [0.1, 0.12], "spacing": rng.choice([0.45, 0.55]), "bearing": rng.choice([0.12, thickness]),
         "element": 0.45, "load": float(rng.choice([0, 120]))} | TIMBER
    if rng.random() < 0.4:
        f["deck"] = {"shear_stiffness": 3.5e5, "stiffness": 1e7}
    if f["bearing"] < thickness and rng.random() < 0.4:
        f |= {"anchorage": "nailed", "anchor": {"area": 1e-4, "young": 2e11, "reach": 0.25}}
    return f


def roof(rng, walls, gables):
    r = {"name": "roof", "walls": walls, "gables": gables, "pitch": round(rng.uniform(25.0, 42.0), 1), "beam": [0.1, 0.12], "spacing": 0.7,
         "element": 0.5, "between_beams": "dry", "surcharge": float(rng.choice([0, 50])), "tie": {"area": 1e-3, "young": 1e10, "compression": True}} | TIMBER
    if rng.random() < 0.7:
        r["deck"] = {"shear_stiffness": 3.5e5, "stiffness": 1e7}
    return r


def vault(rng, walls, gables, across):
    return {"name": "vault", "walls": walls, "gables": gables, "material": "stone", "thickness": 0.15, "ring": 0.45, "voussoirs": rng.choice([7, 10]),
            "rise": round(rng.uniform(0.25, 0.4) * across, 3), "surcharge": float(rng.choice([0, 60]))}


def plan(rng):
    """Two walls that carry a floor, a roof or a vault, or a room with two of them; no two lengths are alike."""
    mm = lambda low, high: round(rng.uniform(low, high), 3)
    case = Case("plan")
    case.materials = {"stone": {"density": 1900, "young": 2e9, "poisson": 0.2}, "wood": {"density": 600, "young": 2e9, "poisson": 0.3}}
    case.laws["timber"] = {"tension": 1e7, "cohesion": 1e7, "friction": 35.0, "compression": 1e8}
    thickness, height, long, across = mm(0.2, 0.26), mm(0.55, 0.65), mm(1.2, 1.5), mm(1.3, 1.7)
    kind = rng.choice(["floor", "roof", "vault", "room", "room"])
    walls, floors, roofs, vaults = [], [], [], []
    if kind == "room":
        points = [(0.0, 0.0), (long, 0.0), (long, across), (0.0, across)]
        walls = [wall(rng, "ring", points, thickness, height, closed=True)]
        floors = [floor(rng, ["ring 1", "ring 3"], thickness)] if rng.random() < 0.7 else []
        roofs = [roof(rng, ["ring 1", "ring 3"], rng.choice([[], ["ring 2"], ["ring 4", "ring 2"]]))] if not floors or rng.random() < 0.5 else []
        if roofs and rng.random() < 0.4:
            vaults = [vault(rng, roofs[0]["walls"], roofs[0]["gables"], across - 2.0 * thickness)]
            roofs = []
    else:
        lean = mm(0.05, 0.2) if kind == "floor" else 0.0
        walls = [wall(rng, "one", [(0.0, 0.0), (long, 0.0)], thickness, height), wall(rng, "other", [(0.0, across), (long, across + lean)], thickness, height)]
        floors = [floor(rng, ["one", "other"], thickness)] if kind == "floor" else []
        roofs = [roof(rng, ["one", "other"], [])] if kind == "roof" else []
        vaults = [vault(rng, ["one", "other"], [], across - thickness)] if kind == "vault" else []
    case.plan = {"wall": walls, "floor": floors, "roof": roofs, "vault": vaults}
    case.friction = 32.0
    case.points = {"top": numpy.array([0.3, 0.05, height - 0.08]), "foot": numpy.array([0.45 * long, across - 0.04, 0.12])}
    case.cuts = [("across", numpy.array([0.3, 0.4, 0.47 * height]), numpy.array([0.0, 0.0, 1.0]))]
    case.pivot = numpy.zeros(3)
    case.kind += f", {kind}" + (" with floor" if kind == "room" and floors else "") + (" with roof" if kind == "room" and roofs else "") + (" with vault" if kind == "room" and vaults else "")
    return case


def each_point(case):
    """All lists [x, y] of places in plan."""
    for tables in case.plan.values():
        for one in tables:
            yield from one.get("points", []) + one.get("corners", [])


def points_moved(case, move):
    for p in each_point(case):
        x, y, _ = move(numpy.array([p[0], p[1], 0.0]))
        p[:] = [float(x), float(y)]


def turned(case, R):
    """What is no place: the side on which a wall lies of its line, and the direction of beams."""
    for w in case.plan["wall"]:
        if numpy.linalg.det(R) < 0.0 and w["line"] != "middle":
            w["line"] = "left" if w["line"] == "right" else "right"
    for f in case.plan["floor"]:
        if "direction" in f:
            f["direction"] = [float(x) for x in (R @ numpy.array([*f["direction"], 0.0]))[:2]]


# Powers of the scale, of a model by Froude's law. Places are points, and are moved with them.
POWERS = {"thickness": 1, "height": 1, "brick": 1, "beam": 1, "spacing": 1, "bearing": 1, "element": 1, "reach": 1, "rise": 1, "ring": 1, "area": 2, "young": 1,
          "shear_stiffness": 2, "stiffness": 2}
LOADS = {"wall": 2, "floor": 1, "roof": 1, "vault": 1}  # kg/m; kg/m2, also of `surcharge`


def scaled(case, factor):
    def scale(table, load):
        for key, value in table.items():
            if isinstance(value, dict):
                scale(value, load)
            power = load if key in ("load", "surcharge") else POWERS.get(key)
            if power is not None:
                table[key] = [v * factor**power for v in value] if isinstance(value, list) else value * factor**power
    for name, tables in case.plan.items():
        for one in tables:
            scale(one, LOADS[name])


def in_other_order(rng, case):
    for tables in case.plan.values():
        rng.shuffle(tables)



def side(name):
    """The name of a side, whose last word tells whether it runs along an axis."""
    return name.removesuffix("ing") if name.endswith(" walling") else name


def sides(case):
    """Names of the sides of all walls, with which their numbers begin."""
    return tuple(f"{w['name']} " for w in case.plan["wall"])
