# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the runs of the stone walls gave, beside formulas by hand and tests: the page tests/validation/STONE_WALLS.md."""
import datetime
import math
import os
import textwrap

import numpy as np

import case_file
import hand
import measures
import run_walls
import stones
import tables
import verdicts

# Words of a variant, and what it changes in a case.
VARIANTS = {"strength in compression of the bond alone": {}, "beds crush and soften": {"softens": True}}
NO_REST = 2  # mark of a row that is no state of rest: the path has none beyond
SAME = 1.5  # ratio of drifts up to which a loss of a fifth counts as the same
MODES = {1.0: "flexure", 0.5: "both", 0.0: "shear"}


def mean(values):
    found = [v for v in values if not math.isnan(v)]
    return sum(found) / len(found) if found else math.nan


def lost_at(curve):
    """m: the displacement beyond the peak at which a fifth of the force is gone; NaN: nowhere."""
    beyond = curve.displacement >= curve.at_peak
    return measures.Curve(curve.displacement[beyond], curve.force[beyond]).first_drop if beyond.any() else math.nan


def measured_loss(stone, folder):
    """Drift at which the tests of a wall lost a fifth, mean over those that did, and their number of curves without it."""
    drifts = []
    for test in stone.tests:
        curve = stones.curve_of(folder, test)
        for way in measures.both_ways(*curve) if curve else ():
            if len(way.displacement) > 2 and way.force.max() > 0.0:
                drifts.append(lost_at(way) / max(stone.wall.height, stone.wall.shear_span))
    return mean(drifts)


def case_of(stone, variant, runs):
    """Folder of the run of a variant, what is computed of the wall, and the text of its case."""
    wall, number = stone.wall, list(VARIANTS).index(variant)
    folder = runs / ("".join(c if c.isalnum() else "_" for c in wall.name) + (f"-{number}" if number else ""))
    changed = stones.changed(wall, **VARIANTS[variant])
    return folder, changed, case_file.case_text(changed, modulus=wall.unit_modulus, largest_drift=stones.PUSHED, drop=stones.DROP)


def is_done(stone, variant, runs):
    folder, _, text = case_of(stone, variant, runs)
    return run_walls.is_done(folder, text)


class Computed:
    """A wall with its tests, and one run of it."""

    def __init__(self, stone, variant, runs, measured):
        self.stone, self.variant = stone, variant
        wall = stone.wall
        folder, changed, text = case_of(stone, variant, runs)
        run_walls.run(changed, folder, text)
        self.run = measures.RunOfWall(folder / "run", changed)
        self.seconds = int((folder / "took.txt").read_text())
        rests = self.run.file["assessment/over"][:self.run.rows_of("assessment")] != NO_REST
        self.curve = measures.both_ways(self.run.displacement[rests], self.run.force[rests] * wall.thickness / changed.thickness)[0]
        self.stops = not rests[-1]
        energies = self.run.file["energy/residual"][:self.run.rows_of("energy")]
        self.residual = float(np.abs(energies[:-2] if self.stops else energies).max())
        self.formula, self.by_hand = hand.least(stone)
        self.measured = mean(t.peak for t in stone.tests)
        self.loss, self.computed_loss = measured_loss(stone, measured), self.loss_of_run() / self.height

    def loss_of_run(self):
        """m: where a fifth is gone; where the path has no further state of rest, all of it is."""
        at = lost_at(self.curve)
        return float(self.curve.displacement[-1]) if math.isnan(at) and self.stops else at

    @property
    def height(self):
        """m, of the point whose displacement is the drift, above the base."""
        return max(self.stone.wall.height, self.stone.wall.shear_span)

    @property
    def errors(self):
        return [self.curve.peak / t.peak - 1.0 for t in self.stone.tests]

    @property
    def errors_by_hand(self):
        return [self.by_hand / t.peak - 1.0 for t in self.stone.tests]

    @property
    def measured_mode(self):
        return MODES[round(2.0 * mean(t.type for t in self.stone.tests)) / 2.0]

    @property
    def mode(self):
        """Of a dry wall by its slip at the end, else by where it was broken up to the peak and at the end."""
        if self.stone.dry:
            letters = verdicts.modes_of_slip(self.run.slip_share(self.run.rows_of("frames") - 1))
            return "both" if len(letters) > 1 else "shear" if letters == {"SL"} else "flexure"
        shares = [self.run.inner_share(until) for until in (self.run.time_of_peak(), math.inf)]
        found = {verdicts.inner_mode(s) for s in shares if not math.isnan(s)}
        return "both" if len(found) > 1 else found.pop() if found else "flexure"

    @property
    def agrees(self):
        """1: the mode is the tests'; ½: one of the two is both."""
        return 1.0 if self.mode == self.measured_mode else 0.5 if "both" in (self.mode, self.measured_mode) else 0.0

    def line(self):
        return f"{self.stone.wall.name}, {self.variant}: {1e-3 * self.curve.peak:.1f} kN, measured {1e-3 * self.measured:.1f}, {self.seconds} s"

    def cells(self):
        w = self.stone.wall
        names = w.tests[0] + (f" and {len(w.tests) - 1} more" if len(w.tests) > 1 else "")
        return [names, self.stone.typology + (", injected" if self.injected else ""), f"{1e-3 * self.measured:.1f}", f"{1e-3 * self.by_hand:.1f} {self.formula}",
                percent(self.by_hand / self.measured - 1.0), f"{1e-3 * self.curve.peak:.1f}", percent(self.curve.peak / self.measured - 1.0),
                self.measured_mode, self.mode, drift(self.loss), drift(self.computed_loss)]

    @property
    def injected(self):
        return self.stone.injected


def percent(value):
    return f"{100.0 * value:+.0f} %"


def drift(value):
    return "–" if math.isnan(value) else f"{100.0 * value:.2f} %"


def summary(done):
    """Figures over all walls of a variant."""
    by_test = [abs(e) for c in done for e in c.errors]
    hand_by_test = [abs(e) for c in done for e in c.errors_by_hand]
    kinds = [abs(c.curve.peak / c.measured - 1.0) for c in done]
    hand_kinds = [abs(c.by_hand / c.measured - 1.0) for c in done]
    both = [c.computed_loss / c.loss for c in done if not math.isnan(c.loss + c.computed_loss)]
    lost = [c for c in done if not math.isnan(c.loss)]
    rows = [("mean error of the peak, over tests", f"{100 * np.mean(by_test):.1f} %", f"{100 * np.mean(hand_by_test):.1f} %"),
            ("over kinds", f"{100 * np.mean(kinds):.1f} %", f"{100 * np.mean(hand_kinds):.1f} %"),
            ("mean of computed over measured, over tests", f"{np.mean([1 + e for c in done for e in c.errors]):.2f}",
             f"{np.mean([1 + e for c in done for e in c.errors_by_hand]):.2f}"),
            ("within 15 %, share of the tests", f"{100 * np.mean([e <= 0.15 for e in by_test]):.0f} %", f"{100 * np.mean([e <= 0.15 for e in hand_by_test]):.0f} %"),
            ("mode as in the tests (partly: one has both)", f"{sum(c.agrees == 1.0 for c in done)} of {len(done)} ({sum(c.agrees == 0.5 for c in done)})", "–"),
            (f"loss of a fifth: of {len(lost)} kinds that have it, computed too; within a factor of {SAME}",
             f"{len(both)}; {sum(1 / SAME <= r <= SAME for r in both)}", "–"),
            ("residual of the ledger at most, of states of rest", f"{max(c.residual for c in done):.1e}", "–"),
            ("wall-clock time of all runs", f"{sum(c.seconds for c in done)} s", "–")]
    return rows


INTRO = """\
# Stone walls of the database

`scripts/validation/stone_walls` writes this page; it is not edited by hand. A row of the table of
91 tests (EPFL Stone Masonry Database, Vanin et al. 2017) becomes a case by [written
rules](../../scripts/validation/README.md), the same for all. Nothing is fitted to a result.

- **A kind**: tests with the same data; one run, pushed one way by states of rest. Measured: mean of
  the peaks of its tests, both directions.
- **By hand**: the least of rocking with a toe, sliding (dry walls), sliding of the cracked base and
  diagonal cracks (walls with mortar), with the data of the case.
- **Mode**: measured, the database's type of failure (1 flexure, 0 shear, between: both). Computed:
  of dry walls by the share of slip in the top's displacement at the end (above 60 % shear, below
  15 % flexure), of the others by where bonds broke, up to the peak and at the end (shear: in the
  middle three fifths of the height).
- **Loss**: drift at which a fifth of the largest force is gone, measured on the envelopes; "–": it
  is not, or there is no envelope. Where a computed path has no further state of rest, its last
  drift counts as that of the loss. Walls are pushed to 2 %.
"""


def machine():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        model = next((line.split(":")[1].strip() for line in file if line.startswith("model name")), "unknown")
    return f"{os.cpu_count()} cores, {model}"


def left_out_rows(left_out):
    lines = ["| test | measured [kN] | rigid wall without tension [kN] | |", "|---|---|---|---|"]
    for test, stone, reason in left_out:
        bound = "–" if reason else f"{1e-3 * stone.wall.rocking_bound:.1f}"
        lines.append(f"| {test.name} | {'–' if math.isnan(test.peak) else f'{1e-3 * test.peak:.1f}'} | {bound} | {reason} |")
    return lines


def lost_rows(lost):
    return ["| test | | why |", "|---|---|---|", *(f"| {stone.wall.tests[0]} | {variant} | {words} |" for stone, variant, words in lost)]


def page(done, lost, left_out):
    origin = f"(`scripts/validation/stone_walls`, {datetime.date.today()}, {tables.version()}, one thread; {machine()})"
    lines = [INTRO, *textwrap.wrap(origin, 100), "", "## Together", ""]
    variants = {v: [c for c in done if c.variant == v] for v in VARIANTS}
    common = set.intersection(*({c.stone.wall.name for c in of} for of in variants.values()))
    figures = [summary([c for c in of if c.stone.wall.name in common]) for of in variants.values()]
    tests = sum(len(c.stone.tests) for c in next(iter(variants.values())) if c.stone.wall.name in common)
    lines += [f"{tests} tests of {len(common)} kinds; what has no run of one of the variants is left out of these figures.", ""]
    lines += ["| | " + " | ".join(variants) + " | by hand |", "|---|" + "---|" * len(variants) + "---|"]
    lines += ["| " + " | ".join([rows[0][0], *(r[1] for r in rows), rows[0][2]]) + " |" for rows in zip(*figures)]
    lines += ["", "## Left out", "", "Walls that bore more than a rigid wall without tension can under the load and the height of zero",
              "moment of the table, N L/(2 H0): no model with these data reaches them.", "", *left_out_rows(left_out), ""] if left_out else [""]
    if lost:
        lines += ["## Lost", "", "Runs that the program ended before their end, since it could not vouch for them.", "", *lost_rows(lost), ""]
    for words, of in variants.items():
        rows = summary(of)
        lines += [f"## {words[0].upper()}{words[1:]}", "", f"{sum(len(c.stone.tests) for c in of)} tests of {len(of)} kinds: mean error of the peak over tests "
                  f"{rows[0][1]}, by hand {rows[0][2]}.", "",
                  "| tests | typology | measured [kN] | least by hand [kN] | error | computed [kN] | error | mode, measured | computed | loss, measured | computed |",
                  "|---|---|---|---|---|---|---|---|---|---|---|"]
        lines += ["| " + " | ".join(c.cells()) + " |" for c in of] + [""]
    return "\n".join(lines).rstrip() + "\n"
