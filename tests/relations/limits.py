# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""How far apart two numbers may be that mean the same, beside the largest of their kind; the README has the reasons."""

SINGLE = 2e-6  # frames of single precision, of the size of the model
STATIC = 1e-9  # geometry and equilibrium: sums in another order
PROGRAMME = 2e-6  # the program proves a multiplier to 1e-6
MODES = 2e-5  # six digits are printed
DYNAMIC = 1e-6  # a thousand steps, each with the round-off of its sums, and contacts that open and close
PAGE = 1e-4  # a page has fewer digits
REST = 1e-3  # what the tolerance of states of rest leaves open
ONE = 0.5  # counts: the same
# Of numbers by the beginning of their names; the first that fits.
TABLE = {"check": (("step_bound", 1e-8), ("", STATIC)),  # bricks of plans, scaled, end on whole nanometres
         "limit": (("points", ONE), ("multiplier", PROGRAMME), ("kinematic: weight", STATIC), ("kinematic", 1e-6), ("", STATIC)),
         "modes": (("frequency", MODES), ("mass", 2e-4)),
         "run": (("frames", SINGLE), ("element", STATIC), ("joint", STATIC), ("motion", STATIC), ("summary: peak_drift", 1e-4), ("", DYNAMIC)),
         "view": (("place", SINGLE), ("", ONE)),
         "summary": (("", DYNAMIC),),
         "assess": (("", DYNAMIC),),
         "report": (("place", SINGLE), ("", PAGE)),
         "capacity": (("capacity: first_stiffness", 5 * REST), ("demand", 10 * REST), ("cyclic: energy", 10 * REST), ("", REST))}
COUNTS = ("elements", "joints", "base_joints", "faults", "storeys", "damage", "cracks", "summary: collapsed", "summary: settled", "summary: damage_grade",
          "summary: deep_pairs", "summary: touching_pairs", "collapsed", "settled", "tension", "shear", "compression", "slipped", "damage_grade")


def of(command, name, change):
    if change.equal == "bits" or name in COUNTS or name.startswith("damage"):
        return ONE
    return next(limit for beginning, limit in TABLE[command] if name.startswith(beginning))
