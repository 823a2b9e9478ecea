# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The measured walls: what the tables say of each, and the parameters of its model with their sources.

A wall is a row of the tables of measured walls (dry_walls.csv, brick_walls.csv) and what a model needs beside it. Nothing here is fitted to
a single wall: a joint's stiffness follows from the moduli of wall and units, strengths are of units, mortar and couplets.
"""
import csv
import dataclasses
import math
import pathlib

GRAVITY = 9.81
SHEAR_SHARE = 0.4  # k_s/k_n of a joint
POISSON = 0.2
BLOCK_OVER_WALL = 2.0  # modulus of blocks as they run over that of the wall; joints take the rest of the compliance


@dataclasses.dataclass
class Wall:
    """One kind of wall under one load, in SI units."""
    name: str
    tests: list        # names of the tests of this kind
    kind: str          # "SW" | "WS" | "MI" | "ISP"
    height: float      # m, of the masonry
    length: float
    thickness: float
    unit: tuple        # m: length, height
    shear_span: float  # m, H0: height of zero moment above the base
    stress: float      # Pa, σ0
    density: float     # kg/m3
    unit_modulus: float
    wall_modulus: float
    friction: float    # tan φ of a contact
    level: bool = False
    drifts: tuple = ()  # cyclic: of the amplitudes, over H0 (level: over the height)
    bond: dict = dataclasses.field(default_factory=dict)  # of mortar: the strengths of its law
    unit_bond: dict = dataclasses.field(default_factory=dict)  # of the unit's own mid-length joint
    segment: float = 0.05
    crushing: float = 1e12  # Pa, of dry beds: the masonry's strength
    closure: tuple = ()     # Pa/m, m: k_n without pressure and V of dry beds that stiffen as they close; (): one stiffness
    toe: dict = dataclasses.field(default_factory=dict)  # keys of [contact] by which toes crush

    @property
    def cyclic(self):
        return bool(self.drifts)

    @property
    def load(self):
        """Load of the jack, N."""
        return self.stress * self.length * self.thickness

    @property
    def weight(self):
        return self.density * GRAVITY * self.length * self.height * self.thickness

    @property
    def lever_height(self):
        """Height of the measured displacement above the base, m."""
        return self.height if self.level else self.shear_span

    @property
    def rocking_bound(self):
        """N: upper bound of the force of a rigid wall that rotates about its toe, for any joints (half the height where the top is held level)."""
        arm = 0.5 * self.height if self.level else self.shear_span
        return (self.load + self.weight) * 0.5 * self.length / arm

    @property
    def sliding_bound(self):
        """N: upper bound of the force by sliding of a bed, with cohesion."""
        return (self.load + self.weight) * self.friction + self.bond.get("cohesion", 0.0) * self.length * self.thickness


def number(text):
    try:
        return float(text)
    except ValueError:
        return math.nan


def read_table(path):
    """Rows of a CSV file with a header as dictionaries."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def read_curve(path):
    """Displacement [m] and force [N] of one test: two lines of words, names, units, then numbers in mm and kN."""
    with open(path, newline="", encoding="utf-8") as file:
        lines = list(csv.reader(line.replace(";", ",") for line in file))
    at = next((i for i, line in enumerate(lines) if any(cell.startswith("[") for cell in line)), None)
    if not at:
        raise ValueError(f"{path}: no line of units below the names; wanted [mm] and [kN]")
    names, units = lines[at - 1], lines[at]
    u, f = (names.index(one if one in names else other) for one, other in (("top_displacement", "Displacement"), ("horizontal_force", "Force")))
    if (units[u], units[f]) != ("[mm]", "[kN]"):
        raise ValueError(f"{path}: displacement and force in {units[u]} and {units[f]}; wanted [mm] and [kN]")
    rows = [(number(row[u]), number(row[f])) for row in lines[at + 1:] if len(row) > max(u, f)]
    rows = [(x, y) for x, y in rows if not math.isnan(x + y)]
    return [1e-3 * x for x, _ in rows], [1e3 * y for _, y in rows]


SOURCES = {
    "SW": {"geometry, σ0, H0, moduli": "measured: EPFL Stone Masonry Database after Lourenço et al. (2005)",
           "friction 0.62": "measured: couplets of the same stone; Solfec's published input uses it too",
           "density 2040 kg/m³": "measured: from the weight of the wall, 3.6 kN"},
    "WS": {"geometry, σ0, H0, moduli": "measured: EPFL Stone Masonry Database after Vasconcelos and Lourenço (2009)",
           "friction 0.62": "literature: sawn granite, 0.6 to 0.65; the same value as for SW",
           "density 2600 kg/m³": "literature: granite"},
    "MI": {"geometry, σ0, units, mortar": "measured: EPFL database of modern masonry walls after Magenes and Calvi (1992)",
           "E of the wall 2991 MPa, f_m 7.92 MPa, c 0.21 MPa, tan φ 0.81": "measured, the same table"},
    "ISP": {"geometry, σ0, units, mortar": "measured: the same database after Anthoine et al. (1995)",
            "f_m 6.2 MPa, c 0.23 MPa, tan φ 0.58": "measured, the same table",
            "E of the wall 2341 MPa": "assumed: 378 f_m, as for MI"},
    "MI, ISP": {
        "f_t of mortar = c/1.4; G_I 18 J/m², G_II 125 J/m²": "literature: Lourenço and Rots (1997), their micro-model of brick walls",
        "compressive strength of a bed: f_m of the masonry": "measured; that a bed has it: assumed",
        "f_t of bricks = 0.05 f_b; c = 2 f_t, φ 45°": "assumed; the national annex of DIN EN 1996-1-1 has 0.032 f_b for solid units",
        "G_I of bricks 80 J/m²": "literature: Lourenço and Rots (1997)",
        "G_II of bricks 800 J/m²": "assumed",
        "density 1800 kg/m³": "assumed",
        "one block through the thickness; head joints are filled and have the law of the beds": "assumed",
        "a block: one brick (ISP), 2 × 2 bricks (MI)": "chosen to save time: a wall of MI has up to 276 bricks; blocks keep their proportions"},
}


def dry_walls(folder):
    """SW and WS, a kind under one load each."""
    rows = read_table(pathlib.Path(folder) / "dry_walls.csv")
    found = {}
    for row in rows:
        test = row["Test unit name"]
        name = test.rsplit(".", 1)[0] if test.startswith("SW") else "WS*." + test.split(".")[1]
        if name in found:
            found[name].tests.append(test)
            continue
        sw = name.startswith("SW")
        m = {key: 1e-3 * number(row[key + " [mm]"]) for key in ("H", "L", "t", "H0", "hb", "lb")}
        found[name] = Wall(
            name=name, tests=[test], kind="SW" if sw else "WS", height=m["H"], length=m["L"], thickness=m["t"], unit=(m["lb"], m["hb"]),
            shear_span=m["H0"], stress=1e6 * number(row["σ0,pc [MPa]"]), density=2040.0 if sw else 2600.0,
            unit_modulus=1e6 * number(row["Eb [MPa]"]), wall_modulus=1e6 * number(row["Epc [MPa]"]), friction=0.62,
            crushing=1e6 * number(row.get("fc [MPa]", "1e6")), drifts=() if sw else (0.005, 0.0125, 0.03))
    return list(found.values())


def closure_of(walls, kind):
    """k_n without pressure [Pa/m] and V [m] of the dry beds of a kind: the hyperbola whose secants are those of the moduli that the walls
    of this kind had under two stresses, the joint's secant under the pressure p being k_n + p/V (THEORY (17a))."""
    (p, k), (q, m) = sorted((w.stress, 1.0 / (w.unit[1] * (1.0 / w.wall_modulus - (1.0 - POISSON ** 2) / w.unit_modulus)))
                            for w in walls if w.kind == kind)
    most = (q - p) / (m - k)
    return k - p / most, most


def measured_rows(folder, wall):
    """Data of the wall's tests in the tables: peak forces [N] with their drift, stiffness [N/m], failure."""
    out = []
    if wall.kind in ("SW", "WS"):
        for row in read_table(pathlib.Path(folder) / "dry_walls.csv"):
            if row["Test unit name"] not in wall.tests:
                continue
            failure = next(value for key, value in row.items() if key and key.startswith("From test report"))
            for sign in "+-":
                force = number(row[f"Vmax,{sign} [kN]"])
                if math.isnan(force):
                    continue
                out.append({"test": row["Test unit name"] + ("" if wall.kind == "SW" else " " + sign), "force": 1e3 * force,
                            "drift": 0.01 * number(row[f"dmax,{sign} [%]"]), "stiffness": 1e6 * number(row[f"Kel,{sign} [kN/mm]"]),
                            "failure": failure})
    else:
        for row in read_table(pathlib.Path(folder) / "brick_walls.csv"):
            if row["wall"] not in wall.tests:
                continue
            for sign in ("plus", "minus"):
                out.append({"test": row["wall"] + " " + ("+" if sign == "plus" else "-"), "force": 1e3 * number(row[f"Vmax_{sign}_kN"]),
                            "drift": 0.01 * number(row[f"drift_Vmax_{sign}_pct"]), "stiffness": math.nan, "failure": row["mode"]})
    return out


def curve_files(folder, wall):
    """Files of measured curves of the wall, by test."""
    files = {}
    for test in wall.tests:
        short = test.replace(".", "")
        for path in sorted(pathlib.Path(folder).glob(f"*_{short}_*.csv")):
            files[test] = path
    return files


# Of joints of mortar and of units: ratios from the micro-model of P. B. Lourenço and J. G. Rots, Multisurface interface model for analysis of
# masonry structures, J. Eng. Mech. 123(7), 1997. The same for every brick wall.
COHESION_OVER_TENSION = 1.4
MORTAR_ENERGIES = (18.0, 125.0)   # J/m2, tension and shear
UNIT_TENSION = 0.05               # of the unit's compressive strength
UNIT_ENERGIES = (80.0, 800.0)     # J/m2
JOINT = 0.01                      # m of mortar
BRICKS_IN_BLOCK = {"MI": 2, "ISP": 1}  # along either edge: the larger walls in larger blocks of the same proportions, a seventh of the time


def mortar_law(cohesion, friction, crushing):
    return {"tension": cohesion / COHESION_OVER_TENSION, "cohesion": cohesion, "friction": math.degrees(math.atan(friction)),
            "compression": crushing, "fracture_energy_tension": MORTAR_ENERGIES[0], "fracture_energy_shear": MORTAR_ENERGIES[1]}


def unit_law(strength):
    """Law of the joint at mid-length of a unit, from the unit's compressive strength."""
    tension = UNIT_TENSION * strength
    return {"tension": tension, "cohesion": 2.0 * tension, "friction": 45.0, "compression": strength,
            "fracture_energy_tension": UNIT_ENERGIES[0], "fracture_energy_shear": UNIT_ENERGIES[1]}


def brick_walls(folder):
    """MI and ISP: top held level, mortared bricks that can crack. Moduli of walls are measured for MI; ISP has the same share of f_m."""
    rows = read_table(pathlib.Path(folder) / "brick_walls.csv")
    shares = [number(row["Em_MPa"]) / number(row["fm_MPa"]) for row in rows if row["Em_MPa"]]
    found = []
    for row in rows:
        mi = row["wall"].startswith("MI")
        modulus = 1e6 * (number(row["Em_MPa"]) if row["Em_MPa"] else number(row["fm_MPa"]) * shares[0])
        friction, height, bricks = number(row["mu"]), number(row["H_m"]), BRICKS_IN_BLOCK["MI" if mi else "ISP"]
        found.append(Wall(
            name=row["wall"], tests=[row["wall"]], kind="MI" if mi else "ISP", height=height, length=number(row["L_m"]),
            thickness=number(row["t_m"]), unit=tuple(bricks * (1e-3 * number(row[key]) + JOINT) for key in ("unit_l_mm", "unit_h_mm")),
            shear_span=number(row["H0_over_H"]) * height, stress=1e6 * number(row["sigma0_MPa"]), density=1800.0,
            unit_modulus=modulus * BLOCK_OVER_WALL, wall_modulus=modulus, friction=friction, level=True, drifts=(0.001, 0.0025, 0.005),
            bond=mortar_law(1e6 * number(row["fv0_MPa"]), friction, 1e6 * number(row["fm_MPa"])),
            unit_bond=unit_law(1e6 * number(row["fb_MPa"])), segment=0.13))
    return found


COMMON_SOURCES = {
    "Young's modulus of the blocks: 2 E_pc": "chosen: softer blocks allow a longer step; with k from E_pc the wall is as stiff as with stiff ones",
    "normal stiffness of a joint": "from the modulus of the wall: 1/k = h (1/E_pc − 1/E′), h the height of a course (THEORY (5a))",
    "shear stiffness of a joint: 0.4 of the normal one": "assumed: 1/(2 (1 + ν)) of an isotropic layer with ν = 0.25",
    "Poisson's ratio 0.2": "assumed",
}
# Why a wall misses its limit, as far as it is known.
REASONS = {
    "SW.30": "both tests bore more than a rigid wall that turns about its toe can, and limit analysis of the same blocks with friction "
             "gives this wall's value, too. With the whole lever 22.4 kN need 45 kN at the base, not 33.6 kN; and the force of SW.30.1 rises "
             "from 14 to 21 kN between 13 and 28 mm, where a constant load lets it fall. So the load was not constant, or the top not free to "
             "turn, at their peaks: a top held level would allow 33.6 L/H = 37 kN. Load (30 kN and 3.6 kN of weight), height of zero "
             "moment and drift (displacement over H0: 1 % is 10 mm) are those of the tables. Up to a displacement of 20 mm the force measured on "
             "SW.30.1 is 13 to 17 kN, near the computed one.",
    "ISP3": "bending governs up to the peak, as in the test; then the bricks crack and the wall splits. The flexural formula with f_m, N "
            "L (1 − σ0/(0.85 f_m))/H, gives 86 kN, near the computed peak: the measured one lies below both. With a tensile strength of "
            "the bricks of 0.03 f_b, in place of the assumed 0.05 f_b, the error is 15 % (see below).",
    "MI1": "the values of σ0 in the table are in doubt (see MI2); with them the computed wall is too strong. The tensile strength of its "
           "bricks is assumed as 0.05 f_b; with 0.03 f_b the error is −5 % (see below).",
    "MI3": "σ0 is in doubt, and the tensile strength of bricks is assumed, as for MI1. Its mode is missed, too, and so is that of MI4, which under "
           "the load of the table rocks at its rigid bound.",
    "MI2": "the test bore more than a rigid wall can under the load of the table, and so did MI4. A σ0 of 0.4 MPa and these forces cannot "
           "both be right: with the top held level these forces need at least 0.51 MPa on MI2, and 0.51 MPa on MI4 too.",
}


def all_walls(folder):
    return dry_walls(folder) + brick_walls(folder)
