#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The pushovers of a table.csv that are done, as a table in Markdown on standard output: what each bears, and what its demand takes of it. Below
it the least of each column's capacity, or the largest of each demand, with the run that has it.

usage: pushes.py TABLE.csv
"""
import csv
import math
import sys

NOTHING = "–"


def number(row, name):
    text = row.get(f"capacity: {name}", "")
    return float(text) if text else math.nan


def shown(value, digits, factor=1.0):
    return NOTHING if math.isnan(value) else f"{factor * value:.{digits}f}"


# Head: figure, digits, factor, and which of all runs is the worst one.
COLUMNS = {
    "load factor": ("multiplier", 4, 1.0, min),
    "base shear, kN": ("peak_shear", 1, 1e-3, min),
    "at, mm": ("peak_displacement", 2, 1e3, None),
    "near collapse, mm": ("near_collapse", 2, 1e3, min),
    "ductility, EC 8": ("ec8_ductility", 2, 1.0, min),
    "effective mass, %": ("effective_mass_share", 0, 100.0, min),
    "demand over capacity: N2, EC 8": ("n2_ec8_demand_over_capacity", 2, 1.0, max),
    "N2, NTC": ("n2_ntc_demand_over_capacity", 2, 1.0, max),
    "capacity spectrum": ("capacity_spectrum_demand_over_capacity", 2, 1.0, max),
}


def name_of(row):
    return row["options"] or row["run"]


def proven(row):
    """Whether a demand was compared with a capacity without reserve, by both forms of N2."""
    return "yes" if not any(row.get(f"capacity: {method}_not_proven", "") for method in ("n2_ec8", "n2_ntc")) else "no"


def lines(rows):
    yield "| push | " + " | ".join(COLUMNS) + " | proven |"
    yield "|---" * (len(COLUMNS) + 2) + "|"
    for row in rows:
        yield f"| {name_of(row)} | " + " | ".join(shown(number(row, c[0]), c[1], c[2]) for c in COLUMNS.values()) + f" | {proven(row)} |"
    worst = []
    for figure, digits, factor, choose in COLUMNS.values():
        known = [(number(row, figure), name_of(row)) for row in rows if not math.isnan(number(row, figure))]
        unknown = len(rows) - len(known)
        said = f"{shown(choose(known)[0], digits, factor)} ({choose(known)[1]})" if choose and known else NOTHING
        worst.append(said + (f"; {unknown} not known" if choose and unknown else ""))
    yield "| worst | " + " | ".join(worst) + " |  |"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["status"] == "done"]
    if not rows or "capacity: multiplier" not in rows[0]:
        sys.exit(f"{sys.argv[1]}: holds no pushover that is done")
    print("\n".join(lines(rows)))


main()
