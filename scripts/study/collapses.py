#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""In how many runs of a study the roof falls, and when: a row for each motion, a column for each house and direction.

usage: collapses.py TABLE.csv [TABLE.csv ...]

Writes a table in Markdown. A row holds the records of one name without their numbers (bam-like#7 and bam-like#8, pulse50-1 and pulse50-2), of
one scale or level of intensity and one set of options. A cell: the runs in which the roof falls, of how many that are done, and the first and the last time, s, at
which half of it has fallen. The tables are of one version. A run that is in two tables counts once.
"""
import collections
import sys

from outcomes import all_rows, done, family, tables_of
from statements import HOUSES, Run
from strength import words_of
from versions import one_version


def place(case):
    """Order of a house: the paper's houses in the paper's order, then others."""
    return HOUSES.index(case) if case in HOUSES else len(HOUSES)


def motion(row):
    strength, options = words_of(row).replace("x", "scale ", 1), row.get("options")
    return f"`{family(row['record'])}`" + (f", {strength}" if strength else "") + (f", {options}" if options else "")


def said(runs):
    times = sorted(run.collapse_time for run in runs if run.collapsed)
    when = "" if not times else f", {times[0]:.1f}" + (f" to {times[-1]:.1f}" if f"{times[0]:.1f}" != f"{times[-1]:.1f}" else "")
    return f"{len(times)} of {len(runs)}{when}"


def main():
    paths = sys.argv[1:]
    if not paths or any(path.startswith("-") for path in paths):
        sys.exit(__doc__)
    one_version(tables_of(paths))
    rows = list({row.get("identity") or id(row): row for row in done(all_rows(paths))}.values())
    cells = collections.defaultdict(lambda: collections.defaultdict(list))
    for row in rows:
        cells[motion(row)][row["case"], row["direction"]].append(Run(row))
    houses = sorted({(row["case"], row["direction"]) for row in rows}, key=lambda house: (place(house[0]), house))
    print("| motion | " + " | ".join(map(" ".join, houses)) + " |\n|---|" + "---|" * len(houses))
    for label, of_house in cells.items():
        print(f"| {label} | " + " | ".join(said(of_house[house]) if house in of_house else "–" for house in houses) + " |")


if __name__ == "__main__":
    main()
