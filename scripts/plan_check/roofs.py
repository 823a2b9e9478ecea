# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Pitched roofs and barrel, cross and pavilion vaults on rectangles, by polygons: what rafters or rings, surcharge and gables add to a plan."""
import math
import random
from typing import Any

import numpy as np

Table = dict[str, Any]


def random_rectangle(rng: random.Random) -> list[np.ndarray]:
    """Corners of a rectangle that stands askew, counter-clockwise."""
    long, across, turn = rng.uniform(3.2, 6.0), rng.uniform(3.2, 5.0), rng.uniform(0.0, 2.0 * math.pi)
    u = np.array([math.cos(turn), math.sin(turn)])
    v = np.array([-u[1], u[0]])
    from_ = np.array([rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0)])
    return [from_, from_ + long * u, from_ + long * u + across * v, from_ + across * v]


def random_roof(rng: random.Random) -> Table:
    """On the first and the third side of a ring; its gables are the other two, or one of them, or none."""
    gables = rng.choice([[2, 4], [2], [4], []])
    return {"gables": gables, "pitch": round(rng.uniform(20.0, 45.0), 1), "beam": [0.1, rng.choice([0.14, 0.18])], "spacing": rng.choice([0.6, 0.85]),
            "element": 0.7, "surcharge": rng.choice([0.0, 60.0])}


def add_roof(roof: Table, length: float, width: float, thickness: float, brick: float) -> None:
    """Sets the volume of rafters [m3], the mass of the surcharge [kg] and the area of a gable [m2].

    length: along the ridge, outer faces; width: across it, outer faces [m]. A rafter is a parallelogram in the section across the ridge,
    whose lower edge passes through the inner edge of the wall's top; the wall fills the triangle beyond, down to the seat.
    """
    slope = math.tan(math.radians(roof["pitch"]))
    plumb = roof["beam"][1] / math.cos(math.radians(roof["pitch"]))  # depth of a rafter, upright
    seat = min(thickness, brick, 0.5 * plumb / slope)
    reach = 0.5 * width - thickness + seat  # from the ridge to the foot, level
    section = plumb * reach - 0.5 * seat * seat * slope
    pairs = math.ceil((length - roof["beam"][0]) / roof["spacing"] - 1e-9) + 1
    roof["volume"] = 2.0 * pairs * roof["beam"][0] * section
    roof["load"] = 2.0 * roof["surcharge"] * length * reach / math.cos(math.radians(roof["pitch"]))
    roof["gable"] = slope * (0.5 * width - thickness) ** 2


def random_vault(rng: random.Random) -> Table:
    """Between the first and the third side of a ring; its gables are the other two, or one of them, or none."""
    return {"vault": True, "gables": rng.choice([[2, 4], [2], [4], []]), "share": rng.choice([1.0, rng.uniform(0.25, 0.95)]), "ring": rng.choice([0.5, 0.8]),
            "voussoirs": rng.randint(9, 24), "surcharge": rng.choice([0.0, 80.0]), "kind": rng.choice(["barrel", "cross", "pavilion"])}


def shoelace(polygon: list[tuple[float, float]]) -> float:
    return 0.5 * abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(polygon, polygon[1:] + polygon[:1])))


def add_vault(vault: Table, length: float, width: float, thickness: float) -> None:
    """Sets the same of a vault. length: along the axis, outer faces; width: across it, outer faces [m]. thickness: of the walls."""
    half = 0.5 * width - thickness
    vault["rise"], vault["thickness"] = round(vault["share"] * half, 3), round(0.8 * thickness, 3)
    if vault["share"] == 1.0:
        vault["rise"] = math.floor(1e6 * half) / 1e6
    centre = (vault["rise"] ** 2 - half**2) / (2.0 * vault["rise"])  # height above the walls
    radius, n = vault["rise"] - centre, vault["voussoirs"]
    first = math.atan2(-centre, half)
    angles = [first + k * (math.pi - 2.0 * first) / n for k in range(n + 1)]
    inner = [(radius * math.cos(a), centre + radius * math.sin(a)) for a in angles]
    outer = [((radius + vault["thickness"]) * math.cos(a), centre + (radius + vault["thickness"]) * math.sin(a)) for a in angles]
    whole = [(outer[0][0], 0.0), *outer, (outer[-1][0], 0.0)]
    vault["volume"] = length * (shoelace(whole) - shoelace(inner))
    vault["gable"] = shoelace(inner)
    vault["load"] = vault["surcharge"] * length * sum(math.dist(a, b) for a, b in zip(outer, outer[1:]))


def add_room_vault(vault: Table, length: float, width: float, thickness: float) -> None:
    """Sets the same of a cross or pavilion vault, and the area by which all walls rise. All lengths across are in shares q of half a span."""
    halves = (0.5 * length - thickness, 0.5 * width - thickness)
    half, n = min(halves), vault["voussoirs"]
    vault["rise"], vault["thickness"] = round(min(vault["share"], 0.95) * half, 3), round(0.3 * thickness, 3)
    radius = (half**2 + vault["rise"] ** 2) / (2.0 * vault["rise"])
    angles = [2.0 * math.atan(vault["rise"] / half) * (1.0 - 2.0 * k / n) for k in range(n // 2 + 1)]
    inner, outer = ([(r * math.sin(a) / half, r * math.cos(a) - radius + vault["rise"]) for a in angles] for r in (radius, radius + vault["thickness"]))
    crown = [(0.0, outer[-1][1]), (0.0, inner[-1][1])]
    section = [(outer[0][0], 0.0), *outer, *crown, *reversed(inner)]
    area = shoelace(section)
    moment = abs(sum((a[0] * b[1] - b[0] * a[1]) * (a[0] + b[0]) for a, b in zip(section, section[1:] + section[:1]))) / 6.0
    under = shoelace([(0.0, 0.0), *inner, crown[1]])
    face = 4.0 * halves[0] * halves[1] * outer[-1][0] ** 2  # the keystone
    volume = 0.0
    for here, other in (halves, halves[::-1]):  # two sides at this distance from the centre
        if vault["kind"] == "pavilion":
            volume += 4.0 * here * other * moment
            face += sum(2.0 * other * (a[0] + b[0]) * math.hypot(here * (a[0] - b[0]), a[1] - b[1]) for a, b in zip(outer, outer[1:]))
        else:
            end = here + thickness
            volume += 4.0 * other * (end * area - here * moment)
            face += sum(2.0 * (2.0 * end - here * (a[0] + b[0])) * math.hypot(other * (a[0] - b[0]), a[1] - b[1]) for a, b in zip(outer, outer[1:]))
            face += 4.0 * (end - here * outer[-1][0]) * other * outer[-1][0]
    vault["volume"], vault["load"] = volume, vault["surcharge"] * face
    vault["gables"], vault["gable"] = [1], 4.0 * sum(halves) * under if vault["kind"] == "cross" else 0.0


def roof_text(roof: Table) -> str:
    if roof.get("kind", "barrel") != "barrel":
        return (f'[[vault]]\nname = "vault"\nkind = "{roof["kind"]}"\nwalls = ["ring 1", "ring 2", "ring 3", "ring 4"]\nmaterial = "stone"\n' +
                "".join(f"{key} = {roof[key]}\n" for key in ("rise", "thickness", "ring", "voussoirs", "surcharge")))
    if "vault" in roof:
        gables = ", ".join(f'"ring {g}"' for g in roof["gables"])
        return (f'[[vault]]\nname = "vault"\nwalls = ["ring 1", "ring 3"]\ngables = [{gables}]\nmaterial = "stone"\n' +
                "".join(f"{key} = {roof[key]}\n" for key in ("rise", "thickness", "ring", "voussoirs", "surcharge")))
    gables = ", ".join(f'"ring {g}"' for g in roof["gables"])
    return (f'[[roof]]\nname = "roof"\nwalls = ["ring 1", "ring 3"]\ngables = [{gables}]\nmaterial = "oak"\nwithin_member = "dry"\nbetween_beams = "dry"\n' +
            "".join(f"{key} = {roof[key]}\n" for key in ("pitch", "beam", "spacing", "element", "surcharge")))
