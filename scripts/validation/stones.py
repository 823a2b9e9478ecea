# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""From a row of stone_walls.csv to a wall: the rules of scripts/validation/README.md, the same for every row. Nothing is fitted."""
import dataclasses
import math
import pathlib

import case_file
import walls as wall_data
from walls import number

TABLE = "stone_walls.csv"
UNIT_WEIGHT = 20e3            # N/m3: the table's own; its total loads contain it
FRICTION = {"dry": 0.62, "mortar": 0.577}
COURSES, ASPECT = 8, 1.25     # of walls without courses of their own; length over height of a stone (WR: 167 mm, 133 mm)
POINTS = 2                    # segments along a unit
SLICE = 0.1                   # m: thickness of what is computed of a thicker wall, in its plane
PUSHED, DROP = 0.02, 0.5      # drift to which a wall is pushed; share of its force that it may lose before that
CRUSHING_LENGTH = 1.6e-3      # m: fracture energy in compression over strength, up to 12 MPa
SOFTENING, RESIDUAL = 1.2, 0.1  # of the energy below which a contact would snap through, the least taken; of the strength, what is left
GOOD, POOR = 2.0, 0.7         # MPa: strength of mortar above or below which strengths of masonry are multiplied


@dataclasses.dataclass(frozen=True)
class Typology:
    """Mean values of Table C8.5.I of the Italian Circolare 7/2019 for a typology of the table, SI units, and the factors of C8.5.II."""
    words: str
    strength: float      # Pa, in compression
    shear: float         # Pa, τ0 of Turnšek and Čačović
    bed: float           # Pa, f_v0 of a bed; 0: rubble has none
    modulus: float       # Pa
    good_mortar: float   # factor of mortar above GOOD
    injected: float      # factor of retrofitting by injection


TYPOLOGIES = {
    "A": Typology("irregular rubble", 1.5e6, 0.025e6, 0.0, 870e6, 1.5, 2.0),
    "B": Typology("roughly hewn stones, leaves of uneven thickness", 2.0e6, 0.043e6, 0.0, 1230e6, 1.4, 1.7),
    "C": Typology("split stones with good bond", 3.2e6, 0.065e6, 0.0, 1740e6, 1.3, 1.5),
    "D": Typology("regular blocks of soft stone", 2.6e6, 0.060e6, 0.145e6, 1410e6, 1.6, 1.2),
    "E": Typology("squared hard stones", 7.0e6, 0.105e6, 0.23e6, 2850e6, 1.2, 1.2),
}


@dataclasses.dataclass
class Test:
    """What was measured on one wall."""
    name: str
    peak: float        # N, mean of both directions
    type: float        # 1 flexure, 0 shear, ½ both
    report: str        # letters of the authors


@dataclasses.dataclass
class Stone:
    """A wall, its tests, and strengths that formulas by hand need."""
    wall: wall_data.Wall
    reference: str
    typology: str
    dry: bool
    strength: float    # Pa, f_c
    shear: float       # Pa, τ0; 0: dry
    injected: bool
    tests: list


def first(*values):
    """The first that is a number."""
    return next((v for v in values if not math.isnan(v)), math.nan)


def is_injected(row):
    return number(row["Unretrofitted / Retrof"]) == 1.0


def factor_of(row, typology):
    """Factor of the strengths of a typology for mortar and injection."""
    mortar = number(row["fc,m  [MPa]"])
    factor = typology.good_mortar if mortar > GOOD else 0.7 if mortar < POOR else 1.0
    return factor * (typology.injected if is_injected(row) else 1.0)


def unit_of(row, height):
    """Length and height of the units, m: those of the table where stones are in courses, else assumed."""
    own = [1e-3 * number(row[key]) for key in ("lb [mm]", "hb [mm]")]
    coursed = row["Stone masonry typology"][0] in "CDE" and not any(math.isnan(v) for v in own)
    return tuple(own) if coursed else (ASPECT * height / COURSES, height / COURSES)


def mean(values):
    found = [v for v in values if not math.isnan(v)]
    return sum(found) / len(found) if found else math.nan


def test_of(row):
    peak = 1e3 * mean(number(row[f"Vmax,{s} [kN]"]) for s in "+-")
    return Test(row["Test unit name"], peak, number(row["Failure type"]), row["From test report: Failure ty"])


def curve_of(folder, test):
    """Displacements [m] and forces [N] of the test's envelope; none: it has none."""
    short = "".join(c for c in test.name if c.isalnum())
    found = sorted(p for place in (folder, folder / "envelopes") for p in pathlib.Path(place).glob(f"*_{short}_*.csv"))
    return wall_data.read_curve(found[0]) if found else None


def stone_of(row):
    """The wall of a row."""
    kind = row["Stone masonry typology"]
    dry, typology = row["Joints"] == "Dry", TYPOLOGIES[kind[0]]
    height, length, thickness, span = (1e-3 * number(row[key]) for key in ("H [mm]", "L [mm]", "t [mm]", "H0 [mm]"))
    factor = factor_of(row, typology)
    strength = first(1e6 * number(row["fc [MPa]"]), factor * typology.strength)
    modulus = first(1e6 * number(row["Epc [MPa]"]), 1e6 * number(row["Ecompr [MPa]"]), factor * typology.modulus)
    friction = FRICTION["dry" if dry else "mortar"]
    cohesion = factor * (typology.bed or 1.5 * typology.shear)
    unit, stone = unit_of(row, height), 1e6 * number(row["fc,b [MPa]"])
    cracks = kind[0] == "D" and not math.isnan(stone)  # hard stones do not
    wall = wall_data.Wall(
        name=row["Test unit name"], tests=[], kind=kind, height=height, length=length, thickness=thickness, unit=unit, shear_span=span,
        stress=1e6 * number(row["σ0,pc [MPa]"]), density=UNIT_WEIGHT / wall_data.GRAVITY,
        unit_modulus=wall_data.BLOCK_OVER_WALL * modulus, wall_modulus=modulus, friction=friction, level=abs(span / height - 0.5) < 0.01,
        bond={} if dry else wall_data.mortar_law(cohesion, friction, strength), unit_bond=wall_data.unit_law(stone) if cracks else {},
        segment=unit[0] / POINTS, crushing=strength)
    return Stone(wall, row["Reference"], kind, dry, strength, 0.0 if dry else factor * typology.shear, is_injected(row), [])


def crushing_energy(strength):
    """J/m2 that a bed takes in compression: Model Code 90 above 12 MPa, and its ratio to the strength at 12 MPa below."""
    mega = 1e-6 * strength
    return CRUSHING_LENGTH * strength if mega < 12.0 else 1e3 * (15.0 + 0.43 * mega - 0.0036 * mega * mega)


def crushing(wall):
    """Keys of [contact] by which the beds of a wall crush and soften, with and without their bond."""
    residual = RESIDUAL * wall.crushing
    fall = wall.crushing - residual
    least = SOFTENING * 0.5 * fall * fall / case_file.softest_contact(wall, wall.unit_modulus)
    return {"compression": wall.crushing, "residual_compression": residual, "crushing_energy": max(crushing_energy(wall.crushing), least)}


def changed(wall, softens=False):
    """What is computed of the wall in a variant of the table: a slice, whose forces are the wall's by the share of its thickness."""
    return dataclasses.replace(wall, thickness=min(SLICE, wall.thickness), toe=crushing(wall) if softens else {})


def read(folder):
    """The walls of the table: kinds with all their tests, and (test, reason) of those that are left out."""
    found, out = {}, []
    for row in wall_data.read_table(pathlib.Path(folder) / TABLE):
        test, stone = test_of(row), stone_of(row)
        if math.isnan(stone.wall.stress) or math.isnan(test.peak):
            out.append((test, stone, "neither load nor peak in the table"))
            continue
        if test.peak > stone.wall.rocking_bound:
            out.append((test, stone, ""))
            continue
        same = (stone.reference, *(str(v) for k, v in dataclasses.asdict(stone.wall).items() if k not in ("name", "tests")))
        kept = found.setdefault(same, stone)
        kept.tests.append(test)
        kept.wall.tests.append(test.name)
    return list(found.values()), out
