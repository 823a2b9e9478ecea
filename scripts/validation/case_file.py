# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The case file of a wall in shear-compression: courses in running bond, a loading beam, a jack and an actuator.

The jack's load is dead: it stays vertical and goes with the beam. The actuator pushes at the height of zero moment, where the beam's centroid
is (a height below the top: with a moment that has the same effect); where the top is held level the beam does not turn. Segments go up to
the rim of joints, so that levers are exact.
"""
import math

import walls as wall_data

BEAM_DENSITY = 500.0  # kg/m3; its weight counts in the jack's load
BEAM_HEIGHT = 0.2     # m; of one with its centroid at the height of zero moment, twice the distance from the top to there


def courses(wall):
    """Boxes (name, x0, x1, z0, z1) of the units in running bond; halves at both ends of every second course."""
    length, height = wall.unit
    rows = round(wall.height / height)
    across = wall.length / round(wall.length / length)
    out = []
    for row in range(rows):
        z0, z1 = wall.height * row / rows, wall.height * (row + 1) / rows
        edges = [0.0] + ([0.5 * across] if row % 2 else [])
        while edges[-1] < wall.length - 1e-9:
            edges.append(min(wall.length, edges[-1] + across))
        out += [(f"c{row}_{i}", a, b, z0, z1) for i, (a, b) in enumerate(zip(edges, edges[1:]))]
    return out


def rounded(value):
    return float(f"{value:.6g}")


def joint_stiffness(wall, modulus):
    """k_n, k_s [Pa/m] of a bed joint, THEORY (5a): 1/k = h (1/E_pc − 1/E′) with the E′ of the blocks; k_s by its share."""
    plane = modulus / (1.0 - wall_data.POISSON ** 2)
    if plane <= wall.wall_modulus:
        raise ValueError(f"{wall.name}: the blocks' modulus {plane:.4g} Pa is not above the wall's, {wall.wall_modulus:.4g} Pa")
    normal = 1.0 / (wall.unit[1] * (1.0 / wall.wall_modulus - 1.0 / plane))
    return normal, normal * wall_data.SHEAR_SHARE


def softest_contact(wall, modulus):
    """Stiffness [Pa/m] of the softest contact that the case can have: a head joint, the bed under the beam, or two of its largest faces."""
    plane, beam = modulus / (1.0 - wall_data.POISSON ** 2), beam_of(wall)[0] - wall.height
    joint = 1.0 / (max(wall.unit[0], 0.5 * (wall.unit[1] + beam)) / plane + 1.0 / joint_stiffness(wall, modulus)[0])
    return min(joint, plane / max(wall.length, beam, wall.unit[0]))


def law_lines(name, law, more=()):
    return [f"[joint_laws.{name}]"] + [f"{key} = {rounded(value)}" for key, value in [*law.items(), *more]] + [""]


def block(name, material, box, thickness, halves=False):
    x0, x1, z0, z1 = (rounded(v) for v in box)
    text = f"[[block]]\nname     = \"{name}\"\nmaterial = \"{material}\"\nbox      = [[{x0}, 0.0, {z0}], [{x1}, {thickness}, {z1}]]\n"
    return text + ("halves   = true\n" if halves else "")


def beam_of(wall):
    """Height [m] of the beam's top, and the lever [m] by which its centroid lies above the height of zero moment."""
    if wall.level:
        return wall.height + BEAM_HEIGHT, 0.0
    if wall.shear_span > 1.02 * wall.height:
        return 2.0 * wall.shear_span - wall.height, 0.0
    return wall.height + BEAM_HEIGHT, wall.height + 0.5 * BEAM_HEIGHT - wall.shear_span


def case_text(wall, modulus=None, pace=None, largest_drift=0.032, segment=None, drop=0.9):
    """The case as TOML. modulus: of the blocks in the run; none: the units' own. pace: of slow motion [s]; none: states of rest."""
    modulus = modulus or wall.unit_modulus
    normal, shear = joint_stiffness(wall, modulus)
    beam_top, lever = beam_of(wall)
    beam_weight = BEAM_DENSITY * 9.81 * wall.length * wall.thickness * (beam_top - wall.height)
    lines = [f'title  = "{wall.name}: a wall in shear and compression"', 'source = "scripts/validation"', "",
             "[gravity]", "acceleration = [0.0, 0.0, -9.81]", "settle       = true", "ramp         = 0.5", "settle_limit = 2.0", "",
             "[analysis]"]
    if wall.cyclic:
        amplitudes = [rounded(d * wall.lever_height) for d in wall.drifts]
        lines += ['kind       = "cyclic"', f"amplitudes = {amplitudes}", "cycles     = 1", f"level      = {str(wall.level).lower()}"]
    else:
        lines += ['kind          = "pushover"', 'pattern       = "given"', f"largest_drift = {largest_drift}",
                  "largest_factor = 1000.0", f"drop          = {drop}"]
        lines += ["level         = true"] if wall.level else []
    lines += ["direction  = [1.0, 0.0]", "longest    = 3000.0"] + ([f"pace       = {pace}"] if pace else []) + [""]
    poisson, angle = wall_data.POISSON, math.degrees(math.atan(wall.friction))
    lines += ["[materials.unit]", f"density = {wall.density}", f"young   = {rounded(modulus)}", f"poisson = {poisson}"]
    lines += (['inside  = "unit"'] if wall.unit_bond else []) + [""]
    lines += ["[materials.beam]", f"density = {BEAM_DENSITY}", f"young   = {rounded(modulus)}", f"poisson = {poisson}", ""]
    own = [("normal_stiffness", normal), ("shear_stiffness", shear)]
    if wall.closure:
        own[0] = ("normal_stiffness", wall.closure[0])
        own.append(("maximum_closure", wall.closure[1]))
    lines += law_lines("bed", wall.bond or {"tension": 0.0, "cohesion": 0.0, "friction": angle, "compression": wall.crushing}, own)
    if wall.unit_bond:
        lines += law_lines("unit", wall.unit_bond)
    if wall.bond:
        lines += law_lines("glue", {"tension": 1e12, "cohesion": 1e12, "friction": 30.0, "compression": 1e12})
    lines += ["[joints]", 'default = "bed"'] + (['between = [ { materials = ["unit", "beam"], law = "glue" } ]'] if wall.bond else [])
    lines += ["",
              "[contact]", f"friction = {rounded(angle)}", *(f"{key} = {rounded(value)}" for key, value in wall.toe.items()), "",
              "[segments]", f"size = {segment or wall.segment}", 'rule = "rim"', "", "[base]", "",
              "[output]", "history_interval = 0.02", "ledger_interval = 0.02", "frame_interval = 1.0", "",
              "[[load]]                         # the jack", 'block = "beam"',
              f"force = [0.0, 0.0, {rounded(-(wall.load - beam_weight))}]", "",
              "[[load]]                         # the actuator; the load factor counts kN", 'block = "beam"',
              "force = [1000.0, 0.0, 0.0]", *([f"moment = [0.0, {rounded(-1000.0 * lever)}, 0.0]"] if lever else []), "grows = true", ""]
    text = "\n".join(lines) + "\n"
    text += "\n".join(block(name, "unit", box, wall.thickness, is_whole(wall, box)) for name, *box in courses(wall))
    return text + "\n" + block("beam", "beam", (0.0, wall.length, wall.height, beam_top), wall.thickness)


def is_whole(wall, box):
    """Whether a unit can crack at mid-length: a whole unit of a wall with units that crack."""
    return bool(wall.unit_bond) and box[1] - box[0] > 0.75 * wall.unit[0]


def drive_of(wall):
    """Settings of the run of a wall: modulus of its blocks, and pace.

    Blocks may be softer than the units, and their joints stiffer, with the same sum (5a): the wall is as stiff and the step longer.
    """
    return {"modulus": wall_data.BLOCK_OVER_WALL * wall.wall_modulus, "pace": 0.5}
