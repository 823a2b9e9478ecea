# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A plan (plan.py) as a case file that can be edited."""
from __future__ import annotations

import dataclasses
import json

from plan import LINTEL, Floor, Opening, Plan, Wall

WOODEN, CONCRETE = 0.1, 0.2  # m, widths of beams that stand for a floor
HEAD = """# Read by scripts/import from {source}. Walls are as drawn, but for what stands at the end of this file. All that a drawing does not say is
# assumed: values of materials and joints, sizes of bricks, lintels, beams of floors. YOUR_HOUSE.md has values for the mortars of old houses.

title = {title}

[damping]
ratio     = 0.02                  # of critical, at the frequency below
frequency = "auto"

[materials.brick]
density = {density}                # kg/m3
young   = 1.0e9                   # Pa, of masonry with its mortar
poisson = 0.2

[materials.concrete]              # lintels and floors
density = 2400.0
young   = 1.0e10
poisson = 0.2

[materials.wood]
density = 600.0
young   = 1.0e9                   # Pa, softer than it is: a longer time step
poisson = 0.3

[joint_laws.mortar]               # lime and some cement
tension     = 1.0e5               # Pa
cohesion    = 1.5e5
friction    = 32.0                # degrees
compression = 5.0e6
thickness   = 0.01                # m
young       = 5.0e8
poisson     = 0.2

[joint_laws.member]               # within a beam
tension     = 1.0e7
cohesion    = 1.0e7
friction    = 32.0
compression = 3.0e7

[joints]
default = "mortar"

[contact]
friction = 32.0                   # degrees

[base]
z = {ground}
"""


def text(value: str) -> str:
    return json.dumps(value, ensure_ascii=False)


def number(x: float) -> str:
    """Metres, to the tenth of a millimetre."""
    return f"{round(x, 4) + 0.0:.4f}".rstrip("0").rstrip(".")


def comment(words: str) -> str:
    """A name of a drawing as a part of one line."""
    return " ".join("".join(c if c.isprintable() else " " for c in words).split())[:300]


def point(p: tuple[float, float]) -> str:
    return f"[{number(p[0])}, {number(p[1])}]"


@dataclasses.dataclass
class Bricks:
    length: float = 0.4
    height: float = 0.2


def opening_text(o: Opening) -> str:
    rows = [f"\n[[wall.opening]]{'                  # ' + comment(o.name) if o.name else ''}", f"from   = {number(o.start)}", f"width  = {number(o.width)}"]
    if o.sill > 1e-4:
        rows.append(f"sill   = {number(o.sill)}")
    rows.append(f"height = {number(o.height)}")
    if o.lintel > 0.0:
        rows.append(f'lintel = {{ bearing = {LINTEL}, height = {number(o.lintel)}, material = "concrete" }}')
    return "\n".join(rows) + "\n"


def wall_text(w: Wall, bricks: Bricks, ground: float) -> str:
    layers = ", ".join(f"{x['name']} {x['thickness']:.3f} m" if x["thickness"] else x["name"] for x in w.layers if x["name"])
    rows = ["\n[[wall]]" + (f"                          # {comment(w.storey + ('; ' if w.storey and layers else '') + layers)}" if w.storey or layers else ""),
            f"name      = {text(w.name)}", f"points    = [{point(w.points[0])}, {point(w.points[1])}]   # m", f"thickness = {number(w.thickness)}"]
    if w.base > ground + 1e-6:
        rows.append(f"base      = {number(w.base - ground)}")
    rows.append(f"height    = {number(w.height)}")
    if w.tops:
        rows.append(f"tops      = [{', '.join(point((s, z)) for s, z in w.tops)}]")
    rows += [f"brick     = [{number(max(bricks.length, w.thickness))}, {number(w.thickness)}, {number(bricks.height)}]", 'bond      = "through"', 'material  = "brick"']
    return "\n".join(rows) + "\n" + "".join(map(opening_text, w.openings))


def floor_text(f: Floor, ground: float) -> str:
    width, material, density = (WOODEN, "wood", 600.0) if f.wood else (CONCRETE, "concrete", 2400.0)
    load = max(0.0, f.mass - density * width * f.thickness / f.spacing)
    young = 1.0e7 if f.wood else 1.0e10 * f.thickness
    return "\n".join(["\n[[floor]]                         # beams that stand for the drawn slab, with its mass and a deck as stiff in its plane", f"name          = {text(f.name)}",
                      f"walls         = [{text(f.walls[0])}, {text(f.walls[1])}]", f"corners       = [{', '.join(map(point, f.corners))}]   # m", f'material      = "{material}"',
                      'within_member = "member"', f"level         = {number(f.level - ground)}", f"beam          = [{number(width)}, {number(f.thickness)}]", f"spacing       = {number(f.spacing)}",
                      f"load          = {load:.1f}               # kg/m2", f"deck          = {{ shear_stiffness = {0.4 * young:.3g}, stiffness = {young:.3g} }}"]) + "\n"


def case_text(plan: Plan, source: str, title: str, bricks: Bricks, density: float = 1800.0) -> str:
    out = HEAD.format(source=comment(source), title=text(title), density=density, ground=number(plan.ground))
    out += "".join(wall_text(w, bricks, plan.ground) for w in plan.walls) + "".join(floor_text(f, plan.ground) for f in plan.floors)
    for head, lines in (("Changed", plan.changed), ("Not in this case", plan.left_out_lines())):
        if lines:
            out += f"\n# {head}:\n" + "".join(f"# - {comment(line)}\n" for line in lines)
    return out
