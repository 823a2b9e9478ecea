# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the paper's sections 4.1 to 4.3 say of its houses, as questions that a row of a study's table answers.

A question is answered by true or false, or by raising Unknown: the table has no such column, or the run ended early (`time.after_collapse`)
and what is asked might still have come. Columns: io/MEASURES.md.

What the paper says and no column tells, so is not here: where on a wall cracks lie, whether they are diagonal or horizontal, that end beams
separate from a roof.
"""
import collections
import math

BEARING, SIDE = ("front wall", "rear wall"), ("left wall", "right wall")
STAYS, FALLS = 0.05, 0.25  # shares of a wall's mass: less has fallen from a wall that stays, as much or more from one that falls
DURATION = 10.0            # s, of the paper's runs
FRAME = 0.051              # s: times that are closer come from neighbouring frames, and their order means nothing
# Assumed, where the paper has words: "as soon as the simulation started"; small and large motion, whose peaks begin at 2.4 s in bam-like.
AT_ONCE, STRONG, ALIKE = 1.5, 2.4, 0.5  # s
L_RULES = 3.5              # s: until then the component L is the stronger one (3.7)


class Unknown(Exception):
    """The table does not tell."""


class Run:
    """A row of a study's table."""

    def __init__(self, row):
        self.row = row
        self.collapsed = row["collapsed"] == "1"

    def number(self, column):
        if self.row.get(column, "") == "":
            raise Unknown
        return float(self.row[column])

    def time(self, column):
        """Infinity: never."""
        t = self.number(column)
        return math.inf if t < 0 else t

    @property
    def collapse_time(self):
        if not self.collapsed:
            raise Unknown
        t = self.time("collapse_time")
        return self.number("end_time") if t == math.inf else t  # between the last frame and the end

    def fallen(self, walls):
        return [self.number(f"{wall}: fallen_mass_fraction") for wall in walls]

    def earliest(self, walls, what):
        return min(self.time(f"{wall}: {what}") for wall in walls)

    def needs_its_whole_time(self):
        if self.collapsed and self.number("end_time") < DURATION - FRAME:
            raise Unknown


def came(seen, run):
    """Something that, once it has come, stays: a fall, a crack."""
    if not seen:
        run.needs_its_whole_time()
    return seen


def stay(walls):
    return lambda run: not came(max(run.fallen(walls)) >= STAYS, run)


def lose_bricks(walls):
    return lambda run: came(max(run.fallen(walls)) >= STAYS, run)


def fall(walls):
    """All of them."""
    return lambda run: came(min(run.fallen(walls)) >= FALLS, run)


def stands(run):
    """Neither the roof nor a bearing wall falls."""
    return not run.collapsed and stay(BEARING)(run)


def nothing_falls(run):
    return not run.collapsed and run.number("fallen_mass_fraction") == 0


def roof_falls(run):
    return run.collapsed


def collapses_after(t):
    """Asked only of runs that collapse."""
    return lambda run: run.collapse_time >= t


def collapses_before(t):
    return lambda run: run.collapsed and run.collapse_time < t


def falls_where_other_stands(run, other):
    return run.collapsed and stands(other)


def before(a, b):
    """Which of two times comes first, if either does and they are told apart."""
    if a == b or abs(a - b) < FRAME:
        raise Unknown
    return a < b


def bearing_walls_fall_first(run):
    """A quarter of a bearing wall has fallen before a quarter of any side wall. Asked only where some wall falls."""
    return before(*(run.earliest(walls, "quarter_fallen_time") for walls in (BEARING, SIDE)))


def bearing_walls_crack_first(run):
    a, b = (run.earliest(walls, "first_crack_time") for walls in (BEARING, SIDE))
    if a == b:
        raise Unknown
    return a < b


def cracks(run):
    return came(sum(run.number(mode) for mode in ("tension", "shear", "compression")) > 0, run)


def cracks_while_l_rules(run):
    """Asked only of houses that crack."""
    if not cracks(run):
        raise Unknown
    return run.time("first_crack_time") <= L_RULES


def tension_alone(run):
    """By the limit that a spring reaches first, as the paper counts (2.4). Asked only where some spring reaches one."""
    tension, others = run.number("first_tension"), run.number("first_shear") + run.number("first_compression")
    if tension + others == 0:
        raise Unknown
    return not came(others > 0, run)


def less(mine, other, measure):
    """Of two measures that only grow: one of a run that ended early is a lower bound."""
    a, b = measure(mine), measure(other)
    if a == b == 0:
        raise Unknown
    (mine if a < b else other).needs_its_whole_time()
    return a < b


def cracked(walls):
    return lambda run: max(run.number(f"{wall}: opened_extent") for wall in walls)


def lean(run):
    """A wall that never stood leans without bounds."""
    return max(abs(run.number(f"{wall}: peak_drift")) if run.row.get(f"{wall}: peak_drift") else math.inf for wall in BEARING)


def less_cracked(mine, other):
    return less(mine, other, cracked(BEARING))


def leans_less(mine, other):
    return less(mine, other, lean)


def front_more_cracked(mine, other):
    return less(other, mine, cracked(["front wall"]))


def roof_falls_later(mine, other):
    """Asked only where both fall."""
    return not before(mine.collapse_time, other.collapse_time)


def collapse_alike(mine, other):
    return mine.collapsed and other.collapsed and abs(mine.collapse_time - other.collapse_time) <= ALIKE


# Case, direction, what the paper says and where, the question; of a comparison: case and direction of the other house.
Statement = collections.namedtuple("Statement", "case direction text holds other", defaults=(None,))


def in_both(case, text, holds, other_case=None):
    return [Statement(case, d, text, holds, (other_case, d) if other_case else None) for d in ("TLV", "LTV")]


FLAT = [
    *in_both("flat20w", "cracks first in a bearing wall (4.1)", bearing_walls_crack_first),
    Statement("flat20w", "TLV", "bearing walls and roof stay (4.1)", stands),
    Statement("flat20w", "TLV", "side walls lose bricks (4.1)", lose_bricks(SIDE)),
    Statement("flat20w", "LTV", "the roof falls (4.1)", roof_falls),
    Statement("flat20w", "LTV", "with both bearing walls (4.1)", fall(BEARING)),
    Statement("flat20w", "LTV", "after 4.8 s, if it falls (4.1)", collapses_after(4.8)),
    Statement("flat20w", "LTV", "falls where TLV stands (4.1)", falls_where_other_stands, ("flat20w", "TLV")),
    Statement("flat20n", "TLV", "stands (4.1)", stands),
    Statement("flat20n", "LTV", "the roof falls (4.1)", roof_falls),
    Statement("flat20n", "LTV", "with both bearing walls (4.1)", fall(BEARING)),
    Statement("flat20n", "LTV", "these before a side wall, if any falls (implied, 4.1)", bearing_walls_fall_first),
    Statement("flat20n", "LTV", "after 6 s, if it falls (4.1)", collapses_after(6.0)),
    Statement("flat20n", "LTV", "falls where TLV stands (4.1)", falls_where_other_stands, ("flat20n", "TLV")),
    *in_both("flat20s", "nothing falls (4.1)", nothing_falls),
    *in_both("flat20s", "cracks (4.1)", cracks),
    *in_both("flat20s", "first by 3.5 s, while L rules, if it cracks (4.1)", cracks_while_l_rules),
    Statement("flat40n", "TLV", "stands (4.3)", stands),
    Statement("flat40n", "LTV", "stands (4.1)", stands),
    *in_both("flat40n", "bearing walls less cracked than Flat20N's (4.1)", less_cracked, "flat20n"),
    Statement("flat40n", "LTV", "and lean less (4.1)", leans_less, ("flat20n", "LTV")),
    Statement("flat20r", "TLV", "stands (implied, 4.1)", stands),
    Statement("flat20r", "LTV", "the bearing walls stand (4.1)", stands),
    *in_both("flat20r", "bearing walls less cracked than Flat20N's (4.1)", less_cracked, "flat20n"),
    Statement("flat20r", "LTV", "and lean less (4.1)", leans_less, ("flat20n", "LTV")),
]
VAULTS = [
    *in_both("vault20w", "collapses as soon as the motion begins (4.2)", collapses_before(AT_ONCE)),
    *in_both("vault20w", "a bearing wall falls before a side wall (4.2)", bearing_walls_fall_first),
    *in_both("vault20w", "the side walls fall, too (4.2)", fall(SIDE)),
    *in_both("vault20n", "the roof falls (4.2)", roof_falls),
    *in_both("vault20n", "with both bearing walls (4.2)", fall(BEARING)),
    *in_both("vault20n", "before the strong motion (4.2)", collapses_before(STRONG)),
    *in_both("vault20n", "a bearing wall falls before a side wall (4.2)", bearing_walls_fall_first),
    *in_both("vault20n", "the side walls fall, too (4.2)", fall(SIDE)),
    *(Statement(case, "TLV", "collapses within 0.5 s of LTV (4.2)", collapse_alike, (case, "LTV")) for case in ("vault20w", "vault20n")),
    *in_both("vault20s", "stands (4.2)", stands),
    *in_both("vault20s", "the front wall more cracked than Flat20S's (4.2)", front_more_cracked, "flat20s"),
    *in_both("vault40n", "the roof falls (4.2)", roof_falls),
    *in_both("vault40n", "later than Vault20N's, if both fall (4.2)", roof_falls_later, "vault20n"),
    Statement("vault40n", "TLV", "both bearing walls stay (4.2)", stay(BEARING)),
    Statement("vault40n", "LTV", "the front wall loses bricks (4.2)", lose_bricks(["front wall"])),
    Statement("vault40n", "LTV", "the rear wall stays (4.2)", stay(["rear wall"])),
    *in_both("vault20r", "the roof falls (4.2)", roof_falls),
    *in_both("vault20r", "later than Vault40N's, if both fall (4.2)", roof_falls_later, "vault40n"),
    *in_both("vault20r", "the side walls stay (4.2)", stay(SIDE)),
    *in_both("vault20r", "the rear wall stays (4.2)", stay(["rear wall"])),
]
# Of Vault40N the paper rules out compression alone.
MODES = [statement for case in ("flat20w", "flat20n", "flat20s", "flat40n", "flat20r", "vault20w", "vault20n", "vault20s", "vault20r")
         for statement in in_both(case, "springs fail in tension alone (4.1, 4.2)", tension_alone)]
HOUSES = list(dict.fromkeys(statement.case for statement in FLAT + VAULTS))
STATEMENTS = sorted(FLAT + VAULTS + MODES, key=lambda statement: (HOUSES.index(statement.case), statement.direction != "TLV"))
