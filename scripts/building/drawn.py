# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Random rectangular buildings as a drawing has them, for tests: walls to the outer corners, an inner one, openings, slabs; and the same as IFC."""
from __future__ import annotations

import dataclasses
import math
import random


@dataclasses.dataclass
class DrawnWall:
    name: str
    start: tuple[float, float]  # of its middle line
    end: tuple[float, float]
    thickness: float
    base: float
    height: float
    openings: list[tuple[float, float, float, float]]  # start, width, sill above the foot, height
    layers: list[dict]
    top: list[tuple[float, float]] | None = None  # (place, height above the foot)

    @property
    def length(self) -> float:
        return math.dist(self.start, self.end)


def grid(x: float) -> float:
    return round(20.0 * x) / 20.0


class Building:
    def __init__(self, seed: int, slabs: bool = True) -> None:
        r = random.Random(seed)
        self.slabs, self.storeys, self.place = slabs, r.choice((1, 2)), (0.0, 0.0, 0.0, 0.0)
        self.size = (grid(r.uniform(5.0, 9.0)), grid(r.uniform(4.0, 7.0)))
        self.walls: list[DrawnWall] = []
        self.slab_thickness = 0.2
        (X, Y), t, ti = self.size, grid(r.uniform(0.25, 0.45)), grid(r.uniform(0.15, 0.3))
        at = grid(r.uniform(0.35, 0.65) * X)
        for s in range(self.storeys):
            height = 3.0
            base = s * height
            brick = [{"name": "Brick", "thickness": t}]
            for name, a, b in (("south", (0.0, t / 2), (X, t / 2)), ("north", (0.0, Y - t / 2), (X, Y - t / 2)), ("west", (t / 2, t), (t / 2, Y - t)), ("east", (X - t / 2, t), (X - t / 2, Y - t))):
                self.walls.append(DrawnWall(f"{name} {s + 1}", a, b, t, base, height, self.holes(r, math.dist(a, b)), brick))
            self.walls.append(DrawnWall(f"inner {s + 1}", (at, t), (at, Y - t), ti, base, height, self.holes(r, Y - 2 * t, 1), [{"name": "Brick", "thickness": ti}]))
        self.order = list(range(len(self.walls)))
        self.thickness = t

    @staticmethod
    def holes(r: random.Random, length: float, most: int = 2) -> list[tuple[float, float, float, float]]:
        found = []
        for k in range(r.randrange(most + 1)):
            width, room = grid(r.uniform(0.8, 1.2)), length / most
            start = grid(k * room + r.uniform(0.65, max(0.66, room - width - 0.65)))
            if room > width + 1.3 and start + width < length - 0.6:
                sill = r.choice((0.0, 0.9))
                found.append((start, width, sill, 2.1 - sill))
        return found

    def turned(self, angle: float, x: float, y: float, z: float) -> "Building":
        self.place = (angle, x, y, z)
        return self

    def point(self, x: float, y: float, z: float) -> list[float]:
        angle, dx, dy, dz = self.place
        return [math.cos(angle) * x - math.sin(angle) * y + dx, math.sin(angle) * x + math.cos(angle) * y + dy, z + dz]

    def volume(self) -> float:
        """Of the walls; outer ones of a storey do not overlap, as drawn."""
        return sum(w.thickness * (w.length * w.height - sum(b * h for _, b, _, h in w.openings)) for w in self.walls)

    def prism(self, w: DrawnWall, section: list[tuple[float, float]]) -> dict:
        """A section (place along the wall, height) over its thickness, as triangles from its first corner; convex, or seen whole from there."""
        (x, y), (X, Y) = w.start, w.end
        u = ((X - x) / w.length, (Y - y) / w.length)
        corners = []
        for side in (-0.5, 0.5):
            for s, z in section:
                corners += self.point(x + s * u[0] - side * w.thickness * u[1], y + s * u[1] + side * w.thickness * u[0], w.base + z)
        n = len(section)
        triangles = [i for k in range(1, n - 1) for i in (0, k, k + 1, n, n + k + 1, n + k)]
        for k in range(n):
            j = (k + 1) % n
            triangles += [k, n + k, n + j, k, n + j, j]
        return {"corners": corners, "triangles": triangles}

    def wall_surface(self, w: DrawnWall) -> dict:
        """The wall without its openings, as a row of pieces: from opening to opening, below and above each."""
        top = w.top or [(0.0, w.height), (w.length, w.height)]
        if not w.openings:
            return self.prism(w, [(0.0, 0.0), (w.length, 0.0), *top[::-1]])
        pieces, at = [], 0.0
        for start, width, sill, height in w.openings:
            pieces += [(at, start, 0.0, w.height), (start, start + width, 0.0, sill), (start, start + width, sill + height, w.height)]
            at = start + width
        pieces.append((at, w.length, 0.0, w.height))
        out: dict = {"corners": [], "triangles": []}
        for a, b, low, high in pieces:
            if b - a > 1e-9 and high - low > 1e-9:
                p = self.prism(w, [(a, low), (b, low), (b, high), (a, high)])
                first = len(out["corners"]) // 3
                out["corners"] += p["corners"]
                out["triangles"] += [i + first for i in p["triangles"]]
        return out

    def box(self, low: tuple[float, float, float], high: tuple[float, float, float]) -> dict:
        w = DrawnWall("", (low[0], 0.5 * (low[1] + high[1])), (high[0], 0.5 * (low[1] + high[1])), high[1] - low[1], low[2], high[2] - low[2], [], [])
        return self.prism(w, [(0.0, 0.0), (w.length, 0.0), (w.length, w.height), (0.0, w.height)])

    def elements(self) -> list[dict]:
        rows = []
        for i in self.order:
            w = self.walls[i]
            holes = [{"name": f"hole {k + 1}", **self.prism(dataclasses.replace(w, thickness=w.thickness + 0.1), [(a, z), (a + b, z), (a + b, z + h), (a, z + h)])} for k, (a, b, z, h) in enumerate(w.openings)]
            rows.append({"id": str(i), "kind": "wall", "type": "", "name": w.name, "storey": "", "layers": w.layers, "openings": holes, **self.wall_surface(w)})
        for s in range(self.storeys if self.slabs else 0):
            top, t = 3.0 * (s + 1), self.thickness
            rows.append({"id": f"slab {s}", "kind": "slab", "type": "FLOOR", "name": f"slab {s + 1}", "storey": "", "layers": [{"name": "Wood joists", "thickness": 0.2}], "openings": [],
                         **self.box((t, t, top - self.slab_thickness), (self.size[0] - t, self.size[1] - t, top))})
        return rows


def ifc_text(b: Building, schema: str, unit: float) -> str:
    """The building in IFC: walls as extruded rectangles with voids and layers. unit: metres in the file's unit of length."""
    rows: list[str] = []

    def add(text: str) -> str:
        rows.append(f"#{len(rows) + 1}={text};")
        return f"#{len(rows)}"

    def number(x: float) -> str:
        text = f"{x / unit:.6f}"
        return text

    def point(*x: float) -> str:
        return add(f"IFCCARTESIANPOINT(({','.join(number(c) for c in x)}))")

    def direction(*x: float) -> str:
        return add(f"IFCDIRECTION(({','.join(f'{c:.12f}' for c in x)}))")

    def placement(x: float, y: float, z: float, angle: float, within: str) -> str:
        return add(f"IFCLOCALPLACEMENT({within},{add(f'IFCAXIS2PLACEMENT3D({point(x, y, z)},{direction(0, 0, 1)},{direction(math.cos(angle), math.sin(angle), 0)})')})")

    guid = iter(range(10**6))

    def root(kind: str, name: str, rest: str) -> str:
        return add(f"{kind}('{next(guid):022d}',{owner},'{name}',$,{rest})")

    def box(length: float, width: float, height: float, x: float, y: float, z: float) -> str:
        profile = add(f"IFCRECTANGLEPROFILEDEF(.AREA.,$,{add(f'IFCAXIS2PLACEMENT2D({point(x + length / 2, y)},$)')},{number(length)},{number(width)})")
        solid = add(f"IFCEXTRUDEDAREASOLID({profile},{add(f'IFCAXIS2PLACEMENT3D({point(0, 0, z)},$,$)')},{direction(0, 0, 1)},{number(height)})")
        return add(f"IFCPRODUCTDEFINITIONSHAPE($,$,({add(f'IFCSHAPEREPRESENTATION({context},$BODY$,$SWEPT$,({solid}))')}))")

    person = add("IFCPERSON($,'x','x',$,$,$,$,$)")
    organisation = add("IFCORGANIZATION($,'x',$,$,$)")
    both = add(f"IFCPERSONANDORGANIZATION({person},{organisation},$)")
    application = add(f"IFCAPPLICATION({organisation},'1','x','x')")
    owner = add(f"IFCOWNERHISTORY({both},{application},$,.ADDED.,$,$,$,0)")
    units = add(f"IFCUNITASSIGNMENT(({add('IFCSIUNIT(*,.LENGTHUNIT.,' + ('.MILLI.' if unit < 0.1 else '$') + ',.METRE.)')},{add('IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.)')}))")
    context = add(f"IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-05,{add(f'IFCAXIS2PLACEMENT3D({point(0, 0, 0)},$,$)')},$)")
    project = root("IFCPROJECT", "p", f"$,$,$,({context}),{units}")
    angle, x, y, z = b.place
    site_at = placement(x, y, z, angle, "$")
    site = root("IFCSITE", "s", f"$,{site_at},$,$,.ELEMENT.,$,$,$,$,$")
    building = root("IFCBUILDING", "b", f"$,{placement(0, 0, 0, 0, site_at)},$,$,.ELEMENT.,$,$,$")
    storey = root("IFCBUILDINGSTOREY", "ground", f"$,{placement(0, 0, 0, 0, site_at)},$,$,.ELEMENT.,0.")
    for above, below in ((project, site), (site, building), (building, storey)):
        root("IFCRELAGGREGATES", "", f"{above},({below})")
    walls = []
    for w in b.walls:
        (sx, sy), (ex, ey) = w.start, w.end
        at = placement(sx, sy, w.base, math.atan2(ey - sy, ex - sx), site_at)
        tail = "" if schema == "IFC2X3" else ",$"
        wall = root("IFCWALLSTANDARDCASE", w.name, f"$,{at},{box(w.length, w.thickness, w.height, 0, 0, 0)},$" + tail)
        walls.append(wall)
        for start, width, sill, height in w.openings:
            hole = root("IFCOPENINGELEMENT", "hole", f"$,{placement(0, 0, 0, 0, at)},{box(width, w.thickness + 0.1, height, start, 0, sill)},$" + tail)
            root("IFCRELVOIDSELEMENT", "", f"{wall},{hole}")
        more = "" if schema == "IFC2X3" else ",$,$,$,$"
        layer = add(f"IFCMATERIALLAYER({add(chr(73) + 'FCMATERIAL(' + chr(39) + 'Brick' + chr(39) + ('' if schema == 'IFC2X3' else ',$,$') + ')')},{number(w.thickness)},$" + more + ")")
        layers = add(f"IFCMATERIALLAYERSET(({layer}),$" + ("" if schema == "IFC2X3" else ",$") + ")")
        use = add(f"IFCMATERIALLAYERSETUSAGE({layers},.AXIS2.,.POSITIVE.,{number(-w.thickness / 2)}" + ("" if schema == "IFC2X3" else ",$") + ")")
        root("IFCRELASSOCIATESMATERIAL", "", f"({wall}),{use}")
    root("IFCRELCONTAINEDINSPATIALSTRUCTURE", "", f"({','.join(walls)}),{storey}")
    head = f"ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('b.ifc','2026-01-01T00:00:00',(''),(''),'','','');\nFILE_SCHEMA(('{schema}'));\nENDSEC;\nDATA;\n"
    return head + "\n".join(rows).replace("$BODY$", "'Body'").replace("$SWEPT$", "'SweptSolid'") + "\nENDSEC;\nEND-ISO-10303-21;\n"
