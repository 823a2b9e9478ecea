#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""One measure of the runs of a study: a row for each set of options, a column for each case.

usage: measure.py TABLE.csv [TABLE.csv ...] MEASURE

MEASURE is a column of the tables, as settling_cracks (io/MEASURES.md). Writes a table in Markdown. A cell has the value of the runs that are
done, or the least and the greatest, if they differ; a dash where no run has one. The tables are of one version.
"""
import collections
import sys

from collapses import place
from outcomes import all_rows, done, tables_of
from versions import one_version


def number(text):
    return float(text) if "." in text or "e" in text else int(text)


def said(values):
    ends = sorted({min(values), max(values)}) if values else []
    return " to ".join(f"{value:,}" if isinstance(value, int) else f"{value:.4g}" for value in ends) or "–"


def main():
    *paths, measure = sys.argv[1:] or [""]
    if not paths or any(word.startswith("-") for word in sys.argv[1:]):
        sys.exit(__doc__)
    one_version(tables_of(paths))
    rows = done(all_rows(paths))
    if not any(measure in row for row in rows):
        sys.exit(f"{measure}: no such column in {', '.join(paths)}; allowed: those of io/MEASURES.md, as settling_cracks")
    cells = collections.defaultdict(lambda: collections.defaultdict(list))
    for row in rows:
        values = cells[row["options"]][row["case"]]
        if row.get(measure, ""):
            values.append(number(row[measure]))
    cases = sorted({row["case"] for row in rows}, key=lambda case: (place(case), case))
    print("| options | " + " | ".join(cases) + " |\n|---|" + "---|" * len(cases))
    for options, of_case in cells.items():
        print(f"| {options or '–'} | " + " | ".join(said(of_case[case]) for case in cases) + " |")


if __name__ == "__main__":
    main()
