# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A case as plain data, and as a case file. SI units, z up. Numbers are written with all their digits."""
import copy
import dataclasses

import numpy


@dataclasses.dataclass
class Block:
    """A convex polyhedron: corners, and faces as loops of corner numbers, counter-clockwise seen from outside."""
    name: str
    vertices: numpy.ndarray
    faces: tuple
    material: str = "stone"
    fixed: bool = False
    part: str = ""
    velocity: numpy.ndarray = None
    spin: numpy.ndarray = None  # angular velocity
    motion: numpy.ndarray = None  # of a fixed one: rows of t, x, y, z, rx, ry, rz
    about: numpy.ndarray = None  # point about which it turns; none: its centroid

    def middle(self):
        return self.vertices.mean(axis=0)


@dataclasses.dataclass
class Load:
    block: str
    force: numpy.ndarray
    moment: numpy.ndarray = None
    at: numpy.ndarray = None
    follows: bool = False


@dataclasses.dataclass
class Tie:
    name: str
    start: numpy.ndarray
    end: numpy.ndarray
    area: float
    young: float
    pretension: float = 0.0
    compression: bool = False
    plate: tuple = None
    yields: float = None  # Pa


@dataclasses.dataclass
class Case:
    kind: str
    blocks: list = dataclasses.field(default_factory=list)
    house: dict = None  # tables of a house, in place of blocks
    plan: dict = None  # "wall", "floor", "roof": tables of walls of any plan, in place of blocks
    materials: dict = dataclasses.field(default_factory=dict)
    laws: dict = dataclasses.field(default_factory=dict)
    default: str = "dry"
    between: list = dataclasses.field(default_factory=list)  # (material, material, law)
    rubs: list = dataclasses.field(default_factory=list)  # (material, material, angle of friction)
    friction: float = 32.0
    base: float = 0.0  # height; none: no base
    ground: list = dataclasses.field(default_factory=list)  # (x0, x1, y0, y1, level): parts of the base
    gravity: numpy.ndarray = None
    loads: list = dataclasses.field(default_factory=list)
    ties: list = dataclasses.field(default_factory=list)
    points: dict = dataclasses.field(default_factory=dict)  # followed
    cuts: list = dataclasses.field(default_factory=list)  # (name, point, normal)
    samples: numpy.ndarray = None  # acceleration of the base, rows of x, y, z
    dt: float = 0.002
    start: float = None  # motion.from
    alpha: float = 20.0
    rule: str = "centres"
    size: float = None  # of segments
    times: dict = dataclasses.field(default_factory=dict)  # ramp, settle, duration, history, frame, ledger
    settle: bool = True
    capacity: dict = None  # keys of [analysis] for a pushover, a tilt, a cyclic test or states of rest of the same case
    growing: list = dataclasses.field(default_factory=list)  # loads of a cyclic test, of the capacity alone
    live: numpy.ndarray = None  # direction of the live load of `voussoir limit`
    unit: str = None  # the blocks are stones of a file in this unit; none: they stand in the case
    pivot: numpy.ndarray = None  # where the model stands: a point that is moved with it
    facets: int = 8

    def copy(self):
        return copy.deepcopy(self)


UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}


def number(x):
    return repr(float(x))


def numbers(values):
    return "[" + ", ".join(number(x) for x in values) + "]"


def table(name, entries):
    """Lines of a table; strings, booleans, numbers, arrays."""
    def word(v):
        if isinstance(v, bool):
            return "true" if v else "false"
        if isinstance(v, str):
            return f'"{v}"'
        if isinstance(v, (int, float)):
            return repr(v)
        if isinstance(v, dict):
            return "{ " + ", ".join(f"{k} = {word(x)}" for k, x in v.items()) + " }"
        return "[" + ", ".join(word(x) for x in (v.tolist() if isinstance(v, numpy.ndarray) else v)) + "]"
    return [name] + [f"{k} = {word(v)}" for k, v in entries.items() if v is not None] + [""]


def upright(block):
    """The two corners of an upright box, or none."""
    low, high = block.vertices.min(axis=0), block.vertices.max(axis=0)
    if len(block.vertices) == 8 and all(all((v == low) | (v == high)) for v in block.vertices):
        return low, high
    return None


def block_lines(block, folder):
    entries = {"name": block.name, "material": block.material}
    box = upright(block)
    if box:
        entries["box"] = [box[0], box[1]]
    else:
        entries |= {"vertices": block.vertices, "faces": [list(f) for f in block.faces]}
    entries |= {"fixed": True if block.fixed else None, "part": block.part or None, "velocity": block.velocity, "angular_velocity": block.spin}
    if block.motion is not None:
        file = f"motion-{block.name.replace(' ', '-')}.csv"
        (folder / file).write_text("t,x,y,z,rx,ry,rz\n" + "\n".join(",".join(number(x) for x in row) for row in block.motion) + "\n")
        entries["motion"] = {"file": file} | ({} if block.about is None else {"about": block.about})
    return table("[[block]]", entries)


def obj_text(blocks, metres):
    lines, first = [], 1
    for block in blocks:
        lines.append(f"o {block.name}")
        lines += ["v " + " ".join(number(x / metres) for x in corner) for corner in block.vertices]
        lines += ["f " + " ".join(str(first + i) for i in face) for face in block.faces]
        first += len(block.vertices)
    return "\n".join(lines) + "\n"


def motion_lines(case, folder):
    if case.samples is None:
        return []
    for k, axis in enumerate("xyz"):
        rows = [f"{number(i * case.dt)},{number(a)}" for i, a in enumerate(case.samples[:, k])]
        (folder / f"{axis}.csv").write_text("t,a\n" + "\n".join(rows) + "\n")
    return table("[motion]", {"x": "x.csv", "y": "y.csv", "z": "z.csv", "unit": "m/s2", "from": case.start})


def structure_lines(case, folder):
    lines = []
    if case.house:
        for name, entries in case.house.items():
            for one in entries if isinstance(entries, list) else [entries]:
                lines += table(name, one)
    elif case.plan:
        for name, tables in case.plan.items():
            for one in tables:
                lines += table(f"[[{name}]]", one)
    elif case.unit:
        (folder / "stones.obj").write_text(obj_text(case.blocks, UNITS[case.unit]))
        supports = [b.name for b in case.blocks if b.fixed]
        lines += table("[[stones]]", {"file": "stones.obj", "unit": case.unit, "supports": supports or "none", "material": case.blocks[0].material,
                                      "snap": 1e-5})
    else:
        for block in case.blocks:
            lines += block_lines(block, folder)
    return lines


def load_lines(load, grows=None):
    return table("[[load]]", {"block": load.block, "force": load.force, "moment": load.moment, "at": load.at, "follows": load.follows or None, "grows": grows})


def write(case, folder):
    """Writes folder/case.toml and the files that it names."""
    folder.mkdir(parents=True, exist_ok=True)
    t = case.times
    lines = [f'title = "{case.kind}"', ""]
    settling = {"ramp": t["ramp"], "settle_limit": t["settle"]} if case.settle else {}
    lines += table("[gravity]", {"acceleration": case.gravity, "settle": case.settle} | settling)
    lines += table("[time]", {"duration": t["duration"]}) + table("[damping]", {"alpha": case.alpha})
    for name, m in case.materials.items():
        lines += table(f"[materials.{name}]", m)
    for name, law in case.laws.items():
        lines += table(f"[joint_laws.{name}]", law)
    between = [{"materials": [a, b], "law": law} for a, b, law in case.between]
    lines += table("[joints]", {"default": case.default} | ({"between": between} if between else {}))
    rubs = [{"materials": [a, b], "friction": angle} for a, b, angle in case.rubs]
    lines += table("[contact]", {"friction": case.friction} | ({"between": rubs} if rubs else {}))
    lines += table("[segments]", {"rule": case.rule, "size": case.size})
    lines += motion_lines(case, folder)
    lines += table("[output]", {"history_interval": t["history"], "frame_interval": t["frame"], "ledger_interval": t["ledger"]})
    for name, point in case.points.items():
        lines += table("[[output.history]]", {"name": name, "point": point})
    for name, point, normal in case.cuts:
        lines += table("[[output.cut]]", {"name": name, "point": point, "normal": normal})
    if case.base is not None:
        lines += table("[base]", {"z": case.base})
    for x0, x1, y0, y1, level in case.ground:
        lines += table("[[base.part]]", {"x": [x0, x1], "y": [y0, y1], "level": level})
    lines += structure_lines(case, folder)
    for load in case.loads:
        lines += load_lines(load)
    for tie in case.ties:
        lines += table("[[tie]]", {"name": tie.name, "from": tie.start, "to": tie.end, "area": tie.area, "young": tie.young,
                                   "pretension": tie.pretension, "compression": tie.compression or None, "yield": tie.yields, "plate": tie.plate})
    path = folder / "case.toml"
    path.write_text("\n".join(lines))
    return path
