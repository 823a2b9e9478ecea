#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""One measure of the runs of a study: a row for each set of options, a column for each case.

usage: measure.py TABLE.csv [TABLE.csv ...] MEASURE

MEASURE is a column of the tables, as settling_cracks (io/MEASURES.md). Writes a table in Markdown. A cell covers the runs of the case with
these options, whatever their direction, motion, strength and seed: their value, or the least and the greatest, if they differ; a dash where no
run has one. The tables are of one version.
"""
import collections
import math
import sys

from collapses import place
from outcomes import all_rows, done, tables_of
from versions import one_version


def number(text, measure):
    """A number as in the table: counts stay integers."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    sys.exit(f"{measure}: {text} is no number; allowed: columns of numbers, as settling_cracks")


def said(values):
    ends = sorted({min(values), max(values)}) if values else []
    return " to ".join(f"{value:,}" if isinstance(value, int) else f"{value:.4g}" for value in ends) or "–"


def main():
    *paths, measure = sys.argv[1:] or [""]
    if not paths or any(word.startswith("-") for word in sys.argv[1:]):
        sys.exit(__doc__)
    one_version(tables_of(paths))
    rows = all_rows(paths)
    if not any(measure in row for row in rows):
        sys.exit(f"{measure}: no such column in {', '.join(paths)}; allowed: those of io/MEASURES.md, as settling_cracks")
    cells = collections.defaultdict(lambda: collections.defaultdict(list))
    rows = done(rows)
    for row in rows:
        values = cells[row.get("options", "")][row["case"]]
        value = number(row[measure], measure) if row.get(measure) else math.nan
        if not math.isnan(value):
            values.append(value)
    cases = sorted({row["case"] for row in rows}, key=lambda case: (place(case), case))
    print("| options | " + " | ".join(cases) + " |\n|---|" + "---|" * len(cases))
    for options, of_case in cells.items():
        print(f"| {options or '–'} | " + " | ".join(said(of_case[case]) for case in cases) + " |")


if __name__ == "__main__":
    main()
