#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of a study over several scales and seeds, in Markdown on standard output.

usage: fragility_tables.py grades TABLE.csv     damage grade of each run by scale and curve, its seeds in order; c: collapsed
       fragility_tables.py medians TABLE.csv    the scale at which half of the houses reach a state

A curve is a case, direction, record and set of options; what all curves share is not named. Medians are those of fragility.py: by maximum
likelihood, with their band of 95 % and the dispersion of the curve; "near", "between", "above" or "below" where the runs determine no curve. A run
that is not done has a dash. Needs what `scripts/setup study` installs.
"""
import sys

from fragility import GROUP, RARER, curves, done_rows, fit
from outcomes import one_version

STATES = {"2": "grade 2", "3": "grade 3", "4": "grade 4", "collapse": "collapse"}


def told_apart(rows):
    """The columns of GROUP in which the runs differ; the case at least."""
    return [key for key in GROUP if key == "case" or len({row[key] for row in rows}) > 1]


def line(cells):
    return "| " + " | ".join(cells) + " |"


def head(first, names):
    return [line([first, *names]), "|---" * (len(names) + 1) + "|"]


def grade(row):
    return row["damage_grade"] + ("c" if row["collapsed"] == "1" else "")


def grades(rows):
    keys = told_apart(rows)
    names = list(dict.fromkeys(" ".join(row[key] for key in keys if row[key]) for row in rows))
    seeds = sorted({row["seed"] for row in rows}, key=lambda s: (len(s), s))
    of = {(" ".join(row[key] for key in keys if row[key]), float(row["scale"]), row["seed"]): grade(row) for row in rows}
    scales = sorted({float(row["scale"]) for row in rows})
    cells = lambda name, scale: ", ".join(of.get((name, scale, seed), "–") for seed in seeds)
    return head("scale of the motion", names) + [line([f"{scale:g}", *(cells(name, scale) for name in names)]) for scale in scales]


def bracket(x, reached):
    """Where the median lies, of runs that determine no curve."""
    if reached.all():
        return f"below {x.min():g}"
    if not reached.any():
        return f"above {x.max():g}"
    below, above = x[~reached].max(), x[reached].min()
    return f"near {above:g}" if below == above else f"between {below:g} and {above:g}"


def median(x, reached, seeds):
    result, remark = fit(x, reached, seeds)
    if result:
        low, high = result.bands_of_95()[0]
        return f"{result.median:.2f} ({low:.2f} to {high:.2f}); {result.dispersion:.2f}"
    return remark if remark == RARER or not x.size else bracket(x, reached)


def medians(rows):
    keys = told_apart(rows)
    found, names = {}, {}
    for name, state, x, reached, seeds in curves(rows, STATES, 1.0):
        names[name] = None
        found[state, name] = median(x, reached, seeds)
    full = {" ".join(row[key] for key in GROUP if row[key]): " ".join(row[key] for key in keys if row[key]) for row in rows}
    return head("state", [full[name] for name in names]) + [line([title, *(found[state, name] for name in names)]) for state, title in STATES.items()]


def main():
    tables = {"grades": grades, "medians": medians}
    if len(sys.argv) != 3 or sys.argv[1] not in tables:
        sys.exit(__doc__)
    rows = done_rows(sys.argv[2])
    if not rows:
        sys.exit(f"{sys.argv[2]}: no run is done yet")
    one_version({sys.argv[2]: rows})
    print("\n".join(tables[sys.argv[1]](rows)))


if __name__ == "__main__":
    main()
