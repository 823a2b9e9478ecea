# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the paper's sections 4.1 to 4.4 say of its houses, as questions that a row of a study's table answers.

A question is answered by true or false, or by raising Unknown: the table has no such column, the run ended before the paper's 10 s
(`time.after_collapse`) and what is asked might still have come, or the question does not arise ("after 6 s, if it falls" of a house that
stands). Columns: io/MEASURES.md, and /summary in io/RESULTS.md. Times that the paper gives are those of its record; bam-like is made to be
strong at the same times, another record need not be.

Not asked, since no column tells: where on a wall cracks lie, whether they are diagonal or horizontal, that end beams
separate from a roof.
"""
import collections
import math

BEARING, SIDE = ("front wall", "rear wall"), ("left wall", "right wall")
STAYS = 0.15     # of its mass: a wall that has lost less stays, one that has lost as much or more loses bricks. The bricks in its corners are 4 to
                 # 12 % of a wall, and fall with the walls that they are toothed to
FALLS = 0.25     # of its mass: a wall that has lost as much or more falls
HEIGHT = 2.4     # m, of the walls of all ten houses
DURATION = 10.0  # s, of the paper's runs
L_RULES = 3.5    # s: until then the component L is the stronger one (3.7)
AT_ONCE = 1.5    # s, assumed, for "as soon as the simulation started"
STRONG = 2.4     # s, assumed, for the end of the "small initial ground motion": peaks of bam-like begin here
ALIKE = 0.5      # s, assumed, for collapses with "no clear difference"
ROUNDING = 1e-3  # s
LEGEND = ("A roof falls if more than half of its mass has fallen. A wall falls if it has lost 25 % of its mass or more, or leans by more than "
          "its thickness at the end of the run, where a loose wall would overturn. It loses bricks if it has lost 15 % or more. It stays if it "
          "has lost less (the bricks in its corners, 4 to 12 % of it, fall with the wall that they are toothed to), does not lean so far, and "
          "still has half of its uppermost course. A house stands if its roof does not fall and both bearing walls stay, whatever its side "
          "walls do.")


class Unknown(Exception):
    """The table does not determine the answer."""


def thickness(case, wall):
    """Thickness of a wall of one of the ten houses [m]: flat40n has bearing walls of 40 cm."""
    return 0.4 if "40" in case and wall in BEARING else 0.2


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
        """Time of an event; infinity: never."""
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

    def lean(self, wall):
        """Lean of the wall's top at the end [m], outward or inward; infinity: the wall does not stand. Unknown: the table has no such column."""
        if f"{wall}: residual_drift" not in self.row:
            raise Unknown
        drift = self.row[f"{wall}: residual_drift"]
        return abs(float(drift)) * HEIGHT if drift else math.inf

    def overturns(self, wall):
        """Whether it leans by more than its thickness at the end of the run, where a loose wall would overturn. A wall that has lost its top has no
        lean."""
        return thickness(self.row["case"], wall) < self.lean(wall) < math.inf

    def stays(self, wall):
        return self.number(f"{wall}: fallen_mass_fraction") < STAYS and self.lean(wall) <= thickness(self.row["case"], wall)

    def falls(self, wall):
        return self.number(f"{wall}: fallen_mass_fraction") >= FALLS or self.overturns(wall)

    def earliest(self, walls, what):
        return min(self.time(f"{wall}: {what}") for wall in walls)

    def needs_its_whole_time(self):
        if self.number("end_time") < DURATION - ROUNDING:
            raise Unknown


def happened(seen, run):
    """Whether an irreversible event has happened: a fall, a crack. Unknown: not seen, and the run ended early."""
    if not seen:
        run.needs_its_whole_time()
    return seen


# These take walls and return a question; all others below are questions.


def walls_stay(walls):
    return lambda run: not happened(not all(map(run.stays, walls)), run)


def walls_lose_bricks(walls):
    """At least one of the walls loses bricks."""
    return lambda run: happened(max(run.fallen(walls)) >= STAYS, run)


def walls_fall(walls):
    """All of the walls fall."""
    return lambda run: happened(all(map(run.falls, walls)), run)


def stands(run):
    """The roof does not fall, and both bearing walls stay."""
    return not run.collapsed and walls_stay(BEARING)(run)


def nothing_falls(run):
    return not happened(run.collapsed or run.number("fallen_mass_fraction") > 0, run)


def roof_falls(run):
    return happened(run.collapsed, run)


def collapses_after(t):
    """Whether the house collapses after a time. Unknown: it does not collapse."""
    return lambda run: run.collapse_time >= t


def collapses_before(t):
    return lambda run: roof_falls(run) and run.collapse_time < t


def falls_where_other_stands(run, other):
    return roof_falls(run) and stands(other)


def before(a, b):
    """Whether one event precedes another. Unknown: neither happened, or both in the same frame."""
    if a == b:
        raise Unknown
    return a < b


def bearing_walls_fall_first(run):
    """A quarter of a bearing wall has fallen before a quarter of any side wall has. Unknown: no wall falls."""
    return before(*(run.earliest(walls, "quarter_fallen_time") for walls in (BEARING, SIDE)))


def bearing_walls_crack_first(run):
    return before(*(run.earliest(walls, "first_open_joint_time") for walls in (BEARING, SIDE)))


def cracks(run):
    """Whether the house cracks during the shaking."""
    return happened(run.time("first_crack_time") < math.inf, run)


def whole_at_first(run):
    """Whether nothing has opened under the house's own weight when the shaking begins. Also answered by runs without motion."""
    return run.number("settling_cracks") == 0


def cracks_while_l_rules(run):
    """Whether the first crack comes while L is the stronger component. Unknown: the house does not crack."""
    if not cracks(run):
        raise Unknown
    return run.time("first_crack_time") <= L_RULES


def tension_alone(run):
    """By the limit that a spring reaches first, as the paper counts (2.4). Unknown: no spring reaches one."""
    tension, others = run.number("first_tension"), run.number("first_shear") + run.number("first_compression")
    if tension + others == 0:
        raise Unknown
    return not happened(others > 0, run)


def smaller(mine, other, measure):
    """Whether a measure that only grows is smaller for the first run. Unknown: the run with the smaller one ended early; both are 0 or infinite."""
    a, b = measure(mine), measure(other)
    if a == b and a in (0, math.inf):
        raise Unknown
    (mine if a < b else other).needs_its_whole_time()
    return a < b


def cracked(walls):
    return lambda run: max(run.number(f"{wall}: opened_extent") for wall in walls)


def lean(run):
    """Largest peak drift of the bearing walls; infinity: one never stood (its drift is empty)."""
    drifts = [run.row.get(f"{wall}: peak_drift") for wall in BEARING]
    if None in drifts:
        raise Unknown
    return max(abs(float(drift)) if drift else math.inf for drift in drifts)


def less_cracked(mine, other):
    return smaller(mine, other, cracked(BEARING))


def leans_less(mine, other):
    return smaller(mine, other, lean)


def front_more_cracked(mine, other):
    return smaller(other, mine, cracked(["front wall"]))


def roof_falls_later(mine, other):
    """Whether the roof falls later than another. Unknown: one of them stands, or both fall in the same frame."""
    return before(other.collapse_time, mine.collapse_time)


def collapse_alike(mine, other):
    return roof_falls(mine) and roof_falls(other) and abs(mine.collapse_time - other.collapse_time) <= ALIKE + ROUNDING


def debris_covers_more(mine, other):
    """Whether debris covers more than in another run. Unknown: one of the houses stands, or one run ended early, so that debris may still move."""
    if not (mine.collapsed and other.collapsed):
        raise Unknown
    for run in (mine, other):
        run.needs_its_whole_time()
    return mine.number("debris_area") > other.number("debris_area")


Statement = collections.namedtuple("Statement", (
    "case", "direction",
    "text",   # what the paper says, and its section
    "holds",  # the question: takes a Run, or two
    "other",  # case and direction of the second run; None: the question takes one
), defaults=(None,))


def in_both(case, text, holds, other_case=None):
    """Whether a statement is true for both directions; a second house, if there is one, has the same direction."""
    return [Statement(case, d, text, holds, (other_case, d) if other_case else None) for d in ("TLV", "LTV")]


# Figs. 20 and 21 show how far element 1 moves, which lies in the middle of a side wall; 4.1 (6) names no curve of it that leaves the figure.
# Directions are those of 4.1: 4.4 (1) calls LTV what 4.1 calls TLV, and TLV what it calls LTV.
FLAT = [
    *in_both("flat20w", "cracks first in a bearing wall (4.1)", bearing_walls_crack_first),
    Statement("flat20w", "TLV", "stands (4.1)", stands),
    Statement("flat20w", "TLV", "side walls lose bricks (4.1)", walls_lose_bricks(SIDE)),
    Statement("flat20w", "LTV", "the roof falls (4.1)", roof_falls),
    Statement("flat20w", "LTV", "both bearing walls fall (4.1)", walls_fall(BEARING)),
    Statement("flat20w", "LTV", "if the roof falls, after 4.8 s (4.1)", collapses_after(4.8)),
    Statement("flat20w", "LTV", "falls, and under TLV it stands (4.1)", falls_where_other_stands, ("flat20w", "TLV")),
    Statement("flat20w", "LTV", "if both roofs fall, debris covers more than Flat20N's (4.4)", debris_covers_more, ("flat20n", "LTV")),
    Statement("flat20n", "TLV", "stands (4.1)", stands),
    Statement("flat20n", "LTV", "the roof falls (4.1)", roof_falls),
    Statement("flat20n", "LTV", "both bearing walls fall (4.1)", walls_fall(BEARING)),
    Statement("flat20n", "LTV", "a bearing wall falls before a side wall, if any falls (implied, 4.1)", bearing_walls_fall_first),
    Statement("flat20n", "LTV", "if the roof falls, after 6 s (4.1)", collapses_after(6.0)),
    Statement("flat20n", "LTV", "falls, and under TLV it stands (4.1)", falls_where_other_stands, ("flat20n", "TLV")),
    *in_both("flat20n", "side walls stay (implied, Figs. 20 and 21)", walls_stay(SIDE)),
    *in_both("flat20s", "nothing falls (4.1)", nothing_falls),
    *in_both("flat20s", "cracks (4.1)", cracks),
    *in_both("flat20s", "if it cracks, first by 3.5 s, while L rules (4.1)", cracks_while_l_rules),
    Statement("flat40n", "TLV", "stands (4.3)", stands),
    Statement("flat40n", "LTV", "stands (4.1)", stands),
    *in_both("flat40n", "bearing walls less cracked than Flat20N's (4.1)", less_cracked, "flat20n"),
    Statement("flat40n", "LTV", "bearing walls lean less than Flat20N's (4.1)", leans_less, ("flat20n", "LTV")),
    *in_both("flat40n", "side walls stay (implied, Figs. 20 and 21)", walls_stay(SIDE)),
    Statement("flat20r", "TLV", "stands (implied, 4.1)", stands),
    Statement("flat20r", "LTV", "stands (4.1)", stands),
    *in_both("flat20r", "bearing walls less cracked than Flat20N's (4.1)", less_cracked, "flat20n"),
    Statement("flat20r", "LTV", "bearing walls lean less than Flat20N's (4.1)", leans_less, ("flat20n", "LTV")),
    *in_both("flat20r", "side walls stay (implied, Figs. 20 and 21)", walls_stay(SIDE)),
]
VAULTS = [
    *in_both("vault20w", "collapses as soon as the motion begins (4.2)", collapses_before(AT_ONCE)),
    *in_both("vault20w", "a bearing wall falls before a side wall (4.2)", bearing_walls_fall_first),
    *in_both("vault20w", "both bearing walls fall (4.2)", walls_fall(BEARING)),
    *in_both("vault20w", "both side walls fall (4.2)", walls_fall(SIDE)),
    *in_both("vault20n", "nothing cracks before the motion begins (4.2)", whole_at_first),
    *in_both("vault20n", "the roof falls (4.2)", roof_falls),
    *in_both("vault20n", "both bearing walls fall (4.2)", walls_fall(BEARING)),
    *in_both("vault20n", "the roof falls before the strong motion (4.2)", collapses_before(STRONG)),
    *in_both("vault20n", "a bearing wall falls before a side wall (4.2)", bearing_walls_fall_first),
    *in_both("vault20n", "both side walls fall (4.2)", walls_fall(SIDE)),
    *(Statement(case, "TLV", "collapses within 0.5 s of LTV (4.2)", collapse_alike, (case, "LTV")) for case in ("vault20w", "vault20n")),
    *in_both("vault20s", "stands (4.2)", stands),
    *in_both("vault20s", "the front wall more cracked than Flat20S's (4.2)", front_more_cracked, "flat20s"),
    *in_both("vault40n", "the roof falls (4.2)", roof_falls),
    *in_both("vault40n", "if both roofs fall, later than Vault20N's (4.2)", roof_falls_later, "vault20n"),
    Statement("vault40n", "TLV", "both bearing walls stay (4.2)", walls_stay(BEARING)),
    Statement("vault40n", "LTV", "the front wall loses bricks (4.2)", walls_lose_bricks(["front wall"])),
    Statement("vault40n", "LTV", "the rear wall stays (4.2)", walls_stay(["rear wall"])),
    *in_both("vault40n", "a side wall loses bricks (implied, 4.2)", walls_lose_bricks(SIDE)),  # element 1 falls, a brick of it
    *in_both("vault20r", "the roof falls (4.2)", roof_falls),
    *in_both("vault20r", "if both roofs fall, later than Vault40N's (4.2)", roof_falls_later, "vault40n"),
    *in_both("vault20r", "the side walls stay (4.2)", walls_stay(SIDE)),
    *in_both("vault20r", "the rear wall stays (4.2)", walls_stay(["rear wall"])),
    *in_both("vault20r", "the front wall loses bricks (4.2)", walls_lose_bricks(["front wall"])),
]
# Of all models: "stand stably under gravitational force without failure" (3.7). Vault20N is above; of Vault20W the paper says otherwise, too (4.2).
AT_REST = [statement for case in ("flat20w", "flat20n", "flat20s", "flat40n", "flat20r", "vault20s", "vault40n", "vault20r")
           for statement in in_both(case, "nothing cracks before the motion begins (3.7)", whole_at_first)]
# Vault40N is not here: of it the paper excludes failure in compression, and not in shear.
MODES = [statement for case in ("flat20w", "flat20n", "flat20s", "flat40n", "flat20r", "vault20w", "vault20n", "vault20s", "vault20r")
         for statement in in_both(case, "springs fail in tension alone (4.1, 4.2)", tension_alone)]
HOUSES = list(dict.fromkeys(statement.case for statement in FLAT + VAULTS))
STATEMENTS = sorted(AT_REST + FLAT + VAULTS + MODES, key=lambda statement: (HOUSES.index(statement.case), statement.direction != "TLV"))
