# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Pitched roofs and barrel vaults on rectangles, by polygons: what rafters or rings, surcharge and gables add to a plan."""
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
            "voussoirs": rng.randint(9, 24), "surcharge": rng.choice([0.0, 80.0])}


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


def roof_text(roof: Table) -> str:
    if "vault" in roof:
        gables = ", ".join(f'"ring {g}"' for g in roof["gables"])
        return (f'[[vault]]\nname = "vault"\nwalls = ["ring 1", "ring 3"]\ngables = [{gables}]\nmaterial = "stone"\n' +
                "".join(f"{key} = {roof[key]}\n" for key in ("rise", "thickness", "ring", "voussoirs", "surcharge")))
    gables = ", ".join(f'"ring {g}"' for g in roof["gables"])
    return (f'[[roof]]\nname = "roof"\nwalls = ["ring 1", "ring 3"]\ngables = [{gables}]\nmaterial = "oak"\nwithin_member = "dry"\nbetween_beams = "dry"\n' +
            "".join(f"{key} = {roof[key]}\n" for key in ("pitch", "beam", "spacing", "element", "surcharge")))
