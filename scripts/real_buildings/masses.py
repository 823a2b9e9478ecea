# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Volume and mass of a building of [[wall]], [[floor]], [[roof]] and [[vault]] by areas of polygons, from its TOML alone.

For straight floors, roofs and vaults at right angles to their walls, as the buildings of the study have them. A wall is the union of its
sides as in `scripts/plan_check`; a curved wall is its polyline. An arch leaves the segment of its circle open.
"""
import importlib.machinery
import importlib.util
import math
import pathlib
import sys
import tomllib
from typing import Any

import numpy as np

PLAN_CHECK = pathlib.Path(__file__).resolve().parent.parent / "plan_check"
sys.path.insert(0, str(PLAN_CHECK))
import roofs  # noqa: E402

LOADER = importlib.machinery.SourceFileLoader("plan_check", str(PLAN_CHECK / "plan_check"))
SPEC = importlib.util.spec_from_loader("plan_check", LOADER)
assert SPEC
plan = importlib.util.module_from_spec(SPEC)
LOADER.exec_module(plan)
Table = dict[str, Any]


def read(path: pathlib.Path) -> Table:
    case = tomllib.loads(path.read_text())
    shared = tomllib.loads((path.parent / case["include"]).read_text())
    case["materials"] = shared["materials"]
    for wall in case["wall"]:
        wall.update(points=[np.array(p, dtype=float) for p in wall["points"]], closed=wall.get("closed", False), line=wall.get("line", "middle"))
        wall["base"] = wall.get("base", 0.0)
    return case


def middle_sides(wall: Table) -> list[tuple[np.ndarray, np.ndarray]]:
    offset = {"left": -0.5, "middle": 0.0, "right": 0.5}[wall["line"]] * wall["thickness"]
    return plan.sides(plan.middle_line(wall["points"], wall["closed"], offset), wall["closed"])


def side_of(case: Table, name: str) -> tuple[Table, np.ndarray, np.ndarray]:
    """The wall of a side, and the ends of the side's middle line."""
    for wall in case["wall"]:
        if name == wall["name"]:
            return wall, *middle_sides(wall)[0]
        if name.startswith(wall["name"] + " "):
            return wall, *middle_sides(wall)[int(name.split()[-1]) - 1]
    raise KeyError(name)


def walls_volume(walls: list[Table]) -> float:
    levels = sorted({w["base"] for w in walls} | {w["base"] + w["height"] for w in walls})
    return sum((high - low) * plan.union_area([p for w in walls if w["base"] <= low and w["base"] + w["height"] >= high for p in plan.footprint(w)])
               for low, high in zip(levels, levels[1:]))


def above(wall: Table) -> float:
    """Area of what `tops` adds above the wall's height."""
    tops = wall.get("tops", [])
    return sum(0.5 * (b[0] - a[0]) * (a[1] + b[1] - 2.0 * wall["height"]) for a, b in zip(tops, tops[1:]))


def open_area(opening: Table) -> float:
    area, width = opening["width"] * opening["height"], opening["width"]
    rise = opening.get("arch", {}).get("rise", 0.0)
    if rise:
        radius = (0.25 * width * width + rise * rise) / (2.0 * rise)
        half = math.acos((radius - rise) / radius)
        area += radius * radius * (half - math.sin(half) * math.cos(half))
    return area


def free_room(walls: list[Table], centre: np.ndarray, across: np.ndarray, level: float) -> float:
    """Clear width of the room round a point, along a direction, at a level."""
    turned = np.array([across, plan.left(across)])
    cuts = [[(turned @ p)[[1, 0]] for p in polygon] for w in walls if w["base"] < level <= w["base"] + w["height"] + 1e-9 for polygon in plan.footprint(w)]
    v, u = (turned @ centre)[1] + 1e-5, (turned @ centre)[0]
    ranges = [r for r in (plan.section(c, v) for c in cuts) if r]
    return min(r[0] for r in ranges if r[0] > u) - max(r[1] for r in ranges if r[1] < u)


def add_floor(case: Table, floor: Table, out: Table) -> None:
    (one, a, b), (two, c, d) = (side_of(case, name) for name in floor["walls"])
    across = plan.unit(b - a)
    along = plan.left(across) * math.copysign(1.0, plan.left(across) @ (c - a))
    span = abs((c - a) @ along)
    corners = floor.get("corners")
    low = max(min(p @ across for p in (a, b)), min(p @ across for p in (c, d)))
    high = min(max(p @ across for p in (a, b)), max(p @ across for p in (c, d)))
    if corners:
        low, high = max(low, min(np.array(p) @ across for p in corners)), min(high, max(np.array(p) @ across for p in corners))
    centre = 0.5 * (low + high) * across + ((a @ along) + 0.5 * one["thickness"] + 0.31 * (span - one["thickness"])) * along
    level = floor.get("level", min(w["base"] + w["height"] for w in (one, two)))
    least = 0.2 * max(one["brick"][0], two["brick"][0])
    width, height = floor["beam"]
    room = free_room(case["wall"], centre, across, level)
    number = math.floor((room - 2.0 * least - width) / floor["spacing"] + 1e-9) + 1
    clear = span - 0.5 * (one["thickness"] + two["thickness"])
    length = clear + 2.0 * floor["bearing"]
    masses = {name: m["density"] for name, m in case["materials"].items()}
    section = number * width * height
    out["volume"] += section * clear
    out["mass"] += section * length * masses[floor["material"]] - section * 2.0 * floor["bearing"] * masses[one["material"]]
    out["mass"] += number * length * floor["spacing"] * floor.get("load", 0.0)


def size(case: Table, span: Table) -> tuple[float, float, float, float]:
    """Of a roof or vault: its length along the axis, its width between outer faces, thickness of its walls, length of their bricks."""
    (one, a, b), (two, c, _) = (side_of(case, name) for name in span["walls"])
    axis = plan.unit(b - a)
    half = 0.5 * one["thickness"]
    ends = [np.array(p) @ axis for p in span["corners"]] if "corners" in span else [a @ axis - half, b @ axis + half]
    return max(ends) - min(ends), abs((c - a) @ plan.left(axis)) + 2.0 * half, one["thickness"], one["brick"][0]


def add_span(case: Table, span: Table, out: Table, vault: bool) -> None:
    length, width, thickness, brick = size(case, span)
    density = {name: m["density"] for name, m in case["materials"].items()}
    table = dict(span)
    if vault:
        n, radius = span["voussoirs"], 0.5 * width - thickness  # half a circle
        inner, outer = ([(r * math.cos(k * math.pi / n), r * math.sin(k * math.pi / n)) for k in range(n + 1)] for r in (radius, radius + span["thickness"]))
        table["gable"] = roofs.shoelace(inner)
        table["volume"] = length * (roofs.shoelace(outer) - table["gable"])
        table["load"] = span.get("surcharge", 0.0) * length * sum(math.dist(p, q) for p, q in zip(outer, outer[1:]))
    else:
        roofs.add_roof(table, length, width, thickness, brick)
    out["volume"] += table["volume"]
    out["mass"] += table["volume"] * density[span["material"]] + table["load"]
    for name in span.get("gables", []):
        wall, _, _ = side_of(case, name)
        out["volume"] += table["gable"] * wall["thickness"]
        out["mass"] += table["gable"] * wall["thickness"] * density[wall["material"]]


def of_building(path: pathlib.Path) -> Table:
    """Volume [m3] and mass [kg] of the case."""
    case = read(path)
    density = {name: m["density"] for name, m in case["materials"].items()}
    walls = case["wall"]
    material = density[walls[0]["material"]]  # all walls of these buildings are of one
    volume = walls_volume(walls) + sum(above(w) * w["thickness"] for w in walls)
    out = {"volume": volume, "mass": volume * material}
    for wall in walls:
        out["mass"] += wall.get("load", 0.0) * sum(np.hypot(*(b - a)) for a, b in middle_sides(wall))
        for opening in wall.get("opening", []):
            hole = open_area(opening) * wall["thickness"]
            out["volume"] -= hole
            out["mass"] -= hole * material
            lintel = opening.get("lintel", {})
            piece = (opening["width"] + 2.0 * lintel.get("bearing", 0.2)) * lintel.get("height", 0.1) * wall["thickness"]
            if "material" in lintel:
                out["mass"] += piece * (density[lintel["material"]] - material)
    for floor in case.get("floor", []):
        add_floor(case, floor, out)
    for kind in ("roof", "vault"):
        for span in case.get(kind, []):
            add_span(case, span, out, kind == "vault")
    return out
