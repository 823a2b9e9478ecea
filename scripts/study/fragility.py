#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Fragility curves of a study: the probability of a damage grade or worse, and of collapse, over the intensity or the scale of its motion.

usage: scripts/study/fragility.py TABLE.csv [-o fragility.svg] [--csv curves.csv] [--states 2 3 4 collapse] [--all-records] [--peak P]

A curve for each case, direction, record and set of options, P = Phi(ln(x / median) / dispersion), by maximum likelihood over the runs that are
done, with 95 % bands. x is the level of the study's [intensity], else the scale. A seed is the same house at every level, so from three seeds on
bands are those of houses drawn anew (`by seed`), else of runs (`by run`). --all-records: one curve for all records, whose dispersion is from
record to record, too; from three records on bands are those of records drawn anew (`by record`). Where the runs determine no curve, the table
says why and gives the bracket of the median. --peak: of a study over scales, the peak acceleration of its motion at scale 1, m/s2; then x is the
peak ground acceleration. Needs what `scripts/setup study` installs.
"""
import csv
import itertools
import math
import os
import pathlib
import sys

import numpy as np
from scipy import linalg, optimize, special

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import run_file  # noqa: E402
from strength import axis_of, strength_of, text_of  # noqa: E402
from versions import one_version  # noqa: E402

GROUP = ("case", "direction", "record", "options")
STATES = ("1", "2", "3", "4", "5", "collapse")
RARER = "rarer under stronger motion"
UPPER = 0.975  # of a band of 95 %
LEAST = 0.1  # of the variance by house (or record) over that by run, in any direction: below, outcomes of the few cancel there by chance
MARKERS = (("o", 3), ("s", 5), ("^", 8), ("D", 10), ("v", 12))  # hollow, one about the other: shares are often the same
COLUMNS = ("curve", "state", "runs", "reached", "median", "median_low", "median_high", "dispersion", "dispersion_low", "dispersion_high", "bands",
           "remark")


class Fit:
    """Phi(a + b ln x): its two coefficients, their covariance, the quantile of the band in standard errors, and the unit of the covariance."""

    def __init__(self, coefficients, covariance, quantile, bands):
        self.coefficients, self.covariance, self.quantile, self.bands = coefficients, covariance, quantile, bands

    @property
    def median(self):
        a, b = self.coefficients
        return math.exp(-a / b)

    @property
    def dispersion(self):
        return 1.0 / self.coefficients[1]

    def log_errors(self):
        """Standard errors of ln median and ln dispersion, by the delta method."""
        a, b = self.coefficients
        slopes = np.array([[-1.0 / b, a / b**2], [0.0, -1.0 / b]])
        return np.sqrt(np.diag(slopes @ self.covariance @ slopes.T))

    def bands_of_95(self):
        """Lower and upper end of the median, and of the dispersion."""
        factors = np.exp(self.quantile * self.log_errors())
        return [(value / factor, value * factor) for value, factor in zip((self.median, self.dispersion), factors)]

    def band(self, x):
        """Lower end, curve, upper end at x."""
        design = np.column_stack([np.ones_like(x), np.log(x)])
        middle = design @ self.coefficients
        error = self.quantile * np.sqrt(np.einsum("ij,jk,ik->i", design, self.covariance, design))
        return special.ndtr(middle - error), special.ndtr(middle), special.ndtr(middle + error)


def remark_of(x, reached):
    """The reason why there is no curve; empty if there is one. Likelihood has a maximum only where outcomes overlap (Albert and Anderson 1984)."""
    if not x.size:
        return "no walls: no grades"
    if not reached.any():
        return f"never reached: median above {x.max():g}"
    if reached.all():
        return f"always reached: median below {x.min():g}"
    below, above = x[~reached].max(), x[reached].min()
    if below <= above:
        return f"mixed at {above:g} alone" if below == above else f"no overlap: median {below:g} to {above:g}"
    return RARER if x[reached].max() <= x[~reached].min() else ""


def scores(design, reached, coefficients):
    """Gradient of each run's log-likelihood."""
    sign = np.where(reached, 1.0, -1.0)
    eta = sign * (design @ coefficients)
    hazard = np.exp(-0.5 * eta**2 - 0.5 * math.log(2 * math.pi) - special.log_ndtr(eta))
    return design * (sign * hazard)[:, None]


def fisher_information(design, coefficients):
    eta = design @ coefficients
    weight = np.exp(-eta**2 - math.log(2 * math.pi) - special.log_ndtr(eta) - special.log_ndtr(-eta))
    return design.T @ (weight[:, None] * design)


def by_cluster(score, information, clusters):
    """Covariance by the sandwich estimator, and its quantile; None if there are too few clusters."""
    names = sorted(set(clusters))
    free = len(names) - 1
    if "" in names or free < 2:
        return None
    sums = np.array([score[clusters == name].sum(axis=0) for name in names])
    meat = len(names) / free * sums.T @ sums
    if linalg.eigvalsh(meat, information)[0] < LEAST:
        return None
    bread = np.linalg.inv(information)
    return bread @ meat @ bread, special.stdtrit(free, UPPER)


def likeliest(x, reached, clusters, bands):
    """Maximum of the likelihood, which is unique, since the log-likelihood is concave in the coefficients."""
    design = np.column_stack([np.ones_like(x), np.log(x)])

    def loss(coefficients):
        eta = np.where(reached, 1.0, -1.0) * (design @ coefficients)
        return -special.log_ndtr(eta).sum(), -scores(design, reached, coefficients).sum(axis=0)

    coefficients = optimize.minimize(loss, np.array([0.0, 1.0]), jac=True, method="BFGS", options={"gtol": 1e-8}).x
    information = fisher_information(design, coefficients)
    drawn_anew = by_cluster(scores(design, reached, coefficients), information, clusters)
    if drawn_anew:
        return Fit(coefficients, *drawn_anew, bands)
    return Fit(coefficients, np.linalg.inv(information), special.ndtri(UPPER), "by run")


def fit(x, reached, clusters, bands="by seed"):
    """The curve, and the reason why there is none: one of the two is None or empty. `clusters`: by run, equal for runs that depend on each
    other; `bands`: name of the clusters."""
    remark = remark_of(x, reached)
    result = None if remark else likeliest(x, reached, clusters, bands)
    if result and result.coefficients[1] <= 0:
        return None, RARER
    return result, remark


def tells(row, state):
    """Whether the run gives information on the state: a building without walls has no damage grade (-1), but may collapse."""
    return state == "collapse" or int(row["damage_grade"]) >= 0


def has_reached(row, state):
    return int(row["collapsed"]) == 1 if state == "collapse" else int(row["damage_grade"]) >= int(state)


def done_rows(path):
    """Rows of finished runs whose motion has a single level of intensity, or a single scale, above zero."""
    try:
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
    except (OSError, ValueError, csv.Error) as error:  # of the file; of UTF-8; of CSV
        sys.exit(f"{path}: {getattr(error, 'strerror', None) or error}; wanted table.csv of scripts/study/run")
    if not rows or not {"scale", "seed", "status", "damage_grade", "collapsed"} <= rows[0].keys():
        sys.exit(f"{path}: no table of a study over several scales or intensities, with measures; wanted table.csv of scripts/study/run")
    done = []
    for row in rows:
        try:
            if row["status"] == "done" and strength_of(row) > 0:
                done.append(row)
        except ValueError:
            sys.exit(f"{path}: run {row['run']} has the level or scale {text_of(row) or 'of its case'}; wanted a number for each run")
    return done


def name_of_strength(path, rows, peak=None, all_records=False):
    """Name of the horizontal axis."""
    try:
        axis = axis_of(rows)
    except ValueError as error:
        sys.exit(f"{path}: {error}")
    over_scales = not any(row.get("intensity") for row in rows)
    if peak and not over_scales:
        sys.exit(f"--peak is for studies over scales; the curves of {path} are over {axis} as it is")
    if all_records and over_scales and len({row["record"] for row in rows}) > 1:
        sys.exit(f"{path}: the same scale of different records is no one level; --all-records is for studies with [intensity]")
    return "peak ground acceleration, m/s²" if peak else axis.replace("m/s2", "m/s²")


def refuse_table(table, outputs):
    """Refuses to overwrite the table, which may have taken days, by any name for it."""
    for path in outputs:
        if os.path.exists(path) and os.path.samefile(table, path):
            sys.exit(f"{path}: is the table itself; wanted another file to write to")


def curves(rows, states, peak=1.0, all_records=False):
    """(name, state, x, reached, clusters) of each curve; clusters are seeds, or records if all records are taken together."""
    group = [key for key in GROUP if not (all_records and key == "record")]

    def name_of(row):
        return " ".join(row[key] for key in group if row[key])

    for name, state in itertools.product(dict.fromkeys(map(name_of, rows)), states):
        of_group = [row for row in rows if name_of(row) == name and tells(row, state)]
        yield (name, state, np.array([peak * strength_of(row) for row in of_group]),
               np.array([has_reached(row, state) for row in of_group], dtype=bool),
               np.array([row["record" if all_records else "seed"] for row in of_group]))


def table_row(name, state, x, reached, result, remark):
    row = {"curve": name, "state": state, "runs": len(x), "reached": int(reached.sum()), "remark": remark}
    if result:
        median, dispersion = result.bands_of_95()
        row |= {"bands": result.bands, "median": result.median, "median_low": median[0], "median_high": median[1],
                "dispersion": result.dispersion, "dispersion_low": dispersion[0], "dispersion_high": dispersion[1]}
    return {key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()}


def draw(axes, number, name, x, reached, result):
    """Draws the shares of runs at each level, and the curve with its band, if there is one."""
    look = run_file.style(number)
    levels = np.unique(x)
    marker, size = MARKERS[number % len(MARKERS)]
    axes.plot(levels, [reached[x == level].mean() for level in levels], marker, color=look["color"], markersize=size, markerfacecolor="none", clip_on=False, label=name)
    if result:
        grid = np.geomspace(0.5 * x.min(), 1.5 * x.max(), 200)
        low, middle, high = result.band(grid)
        axes.plot(grid, middle, **look)
        axes.fill_between(grid, low, high, color=look["color"], alpha=0.12, linewidth=0)


def title_of(state):
    return "collapse" if state == "collapse" else f"damage grade G{state} or worse"


def main():
    p = run_file.parser(__doc__, "fragility.svg")
    p.add_argument("table")
    p.add_argument("--csv", default="curves.csv", help="medians and dispersions (default curves.csv)")
    p.add_argument("--states", nargs="+", choices=STATES, default=["2", "3", "4", "collapse"])
    p.add_argument("--all-records", action="store_true", help="one curve for all records")
    p.add_argument("--peak", type=float, help="of the motion at scale 1, m/s2")
    a = p.parse_args()
    rows = done_rows(a.table)
    refuse_table(a.table, (a.output, a.csv))
    if not rows:
        sys.exit(f"{a.table}: no run is done yet")
    one_version({a.table: rows})
    strength = name_of_strength(a.table, rows, a.peak, a.all_records)
    figure, panels = run_file.panels(len(a.states), a.width, height=5.0, sharex=True)
    numbers, out = {}, []
    for name, state, x, reached, clusters in curves(rows, a.states, a.peak or 1.0, a.all_records):
        result, remark = fit(x, reached, clusters, "by record" if a.all_records else "by seed")
        draw(panels[a.states.index(state)], numbers.setdefault(name, len(numbers)), name, x, reached, result)
        out.append(table_row(name, state, x, reached, result, remark))
    for axes, state in zip(panels, a.states):
        axes.set(ylabel="probability", ylim=(-0.05, 1.05))
        axes.set_title(title_of(state), loc="left")
    panels[0].legend(loc="lower right")
    panels[-1].set_xlabel(strength)
    run_file.save(figure, a.output)
    with open(a.csv, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(out)


if __name__ == "__main__":
    main()
