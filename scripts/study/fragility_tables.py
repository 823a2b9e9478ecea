#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of a study over several scales or intensities and seeds, in Markdown on standard output.

usage: fragility_tables.py grades TABLE.csv     damage grade of each run by level and curve, its seeds in order; c: collapsed
       fragility_tables.py medians TABLE.csv [--all-records]    the level at which half of the houses reach a state

A curve is a case, direction, record and set of options; what all curves share is not named. Medians are those of fragility.py: by maximum
likelihood, with their band of 95 % and the dispersion of the curve; "near", "between", "above" or "below" where the runs determine no curve. --all-records: one
curve for all records. A run that is not done has a dash. Needs what `scripts/setup study` installs.
"""
import sys

from fragility import GROUP, RARER, curves, done_rows, fit, name_of_strength
from strength import strength_of
from versions import one_version

STATES = {"2": "grade 2", "3": "grade 3", "4": "grade 4", "collapse": "collapse"}


def told_apart(rows):
    """Columns of GROUP in which the runs differ; at least the case."""
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
    of = {(" ".join(row[key] for key in keys if row[key]), strength_of(row), row["seed"]): grade(row) for row in rows}
    levels = sorted({strength_of(row) for row in rows})
    cells = lambda name, level: ", ".join(of.get((name, level, seed), "–") for seed in seeds)
    first = name_of_strength("the table", rows, None)
    return head(first, names) + [line([f"{level:g}", *(cells(name, level) for name in names)]) for level in levels]


def bracket(x, reached):
    """Range of the median for runs that determine no curve."""
    if reached.all():
        return f"below {x.min():g}"
    if not reached.any():
        return f"above {x.max():g}"
    below, above = x[~reached].max(), x[reached].min()
    return f"near {above:g}" if below == above else f"between {below:g} and {above:g}"


def short(value):
    return f"{value:.2f}" if value >= 0.1 else f"{value:#.2g}"


def median(x, reached, clusters):
    result, remark = fit(x, reached, clusters)
    if result:
        low, high = result.bands_of_95()[0]
        return f"{short(result.median)} ({short(low)} to {short(high)}); {short(result.dispersion)}"
    return remark if remark == RARER or not x.size else bracket(x, reached)


def medians(rows, all_records):
    axis = name_of_strength("the table", rows, all_records=all_records)
    group, keys = ([key for key in names if not (all_records and key == "record")] for names in (GROUP, told_apart(rows)))
    found, names = {}, {}
    for name, state, x, reached, clusters in curves(rows, STATES, all_records=all_records):
        names[name] = None
        found[state, name] = median(x, reached, clusters)
    full = {" ".join(row[key] for key in group if row[key]): " ".join(row[key] for key in keys if row[key]) for row in rows}
    return head("state" if axis == "scale of the motion" else f"state; {axis}", [full[name] for name in names]) + [line([title, *(found[state, name] for name in names)]) for state, title in STATES.items()]


def main():
    words = [word for word in sys.argv[1:] if word != "--all-records"]
    all_records = len(words) < len(sys.argv) - 1
    if len(words) != 2 or words[0] not in ("grades", "medians") or (all_records and words[0] == "grades"):
        sys.exit(__doc__)
    which, path = words
    rows = done_rows(path)
    if not rows:
        sys.exit(f"{path}: no run is done yet")
    one_version({path: rows})
    print("\n".join(grades(rows) if which == "grades" else medians(rows, all_records)))


if __name__ == "__main__":
    main()
