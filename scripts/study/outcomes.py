#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""In how many runs of an ensemble does each statement of the paper hold?

usage: outcomes.py TABLE.csv [TABLE.csv ...] [--by options | --by record]

Writes a table in Markdown: the statement (statements.py), the runs in which it holds, of how many that tell, and the 95 % interval of that
share (Wilson's score interval; it holds for motions drawn like those of the ensemble). Undecided runs do not tell: the question does not
arise, the run ended too early, or the table lacks a column. If there is one run of each house and direction: yes, no or undecided. A statement
that compares two runs pairs them by record, and is left out where one of the two is not in the table. Runs that are not finished, and
numerical failures, do not count. The tables have one scale, one seed and one version. A run that is in two tables counts once.

The last column asks the same of the runs of the other direction, LTV for TLV and TLV for LTV: section 4.4 (1) of the paper, against 4.1, has
its houses collapse in TLV.

--by: how many runs agree with each statement, of how many that tell, by the set of options, or by the record without its number (bam-like#7
and bam-like#8 count together, as do pulse50-1 and pulse50-2): a column each.
"""
import collections
import csv
import math
import re
import sys

from statements import LEGEND, STATEMENTS, Run, Unknown
from versions import one_version

NORMAL_95 = 1.959963984540054


def wilson(holds, runs):
    """Wilson's score interval of a share, 95 %."""
    z2 = NORMAL_95**2
    middle = (holds + z2 / 2) / (runs + z2)
    half = NORMAL_95 / (runs + z2) * math.sqrt(holds * (runs - holds) / runs + z2 / 4)
    return max(0.0, middle - half), min(1.0, middle + half)


def answer(statement, rows):
    """Whether the statement is true for the run, or the two runs, of these rows; None: undecided."""
    try:
        return statement.holds(*map(Run, rows))
    except Unknown:
        return None


def answers(statement, runs):
    """By record: whether the statement is true; None: undecided."""
    mine = runs[statement.case, statement.direction]
    others = runs[statement.other] if statement.other else None
    found = {}
    for record, row in mine.items():
        if others is not None and record not in others:
            continue
        found[record] = answer(statement, (row,) if others is None else (row, others[record]))
    return found


def count(found):
    """Number of runs in which a statement is true, and number of decided runs."""
    return sum(a is True for a in found.values()), sum(a is not None for a in found.values())


NEEDED = ("run", "case", "direction", "record", "status", "collapsed", "end_time")


def rows_of(path):
    try:
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
    except (OSError, ValueError, csv.Error) as error:  # of the file; of UTF-8; of CSV
        sys.exit(f"{path}: {getattr(error, 'strerror', None) or error}")
    missing = [name for name in NEEDED if rows and name not in rows[0]]
    if missing:
        sys.exit(f'{path}: no column "{missing[0]}"; allowed: the table.csv of a study')
    return rows


def tables_of(paths):
    return {path: rows_of(path) for path in paths}


def all_rows(paths):
    return [row for rows in tables_of(paths).values() for row in rows]


def done(rows):
    return [row for row in rows if row["status"] == "done"]


def difference(a, b):
    """The column of the study in which two rows differ, for a message."""
    return next((f"{name} ({a.get(name, '')}, {b.get(name, '')})" for name in ("options", "scale", "intensity", "level", "seed") if a.get(name) != b.get(name)), "nothing")


def same_run(a, b):
    """Whether two rows are of one run, since studies may share runs (--known of scripts/study/run)."""
    return bool(a.get("identity")) and a["identity"] == b.get("identity")


def by_record(rows):
    """Rows by case and direction, then by record."""
    runs = collections.defaultdict(dict)
    for row in rows:
        of_house = runs[row["case"], row["direction"]]
        first = of_house.get(row["record"])
        if first and not same_run(first, row):
            sys.exit(f"{row['run']}: the same house, direction and record as {first['run']}; they differ in {difference(first, row)}; "
                     "allowed: one run of each")
        of_house[row["record"]] = row
    return runs


def family(record):
    """The name of a record without its number: bam-like of bam-like#7, pulse50 of FOLDER/pulse50-7."""
    return re.sub(r"-[0-9]+$", "", record.rsplit("/", 1)[1]) if "/" in record else re.sub(r"#[0-9]+$", "", record)


def progress(rows):
    failed = sum(row["status"] == "numerical failure" for row in rows)
    return LEGEND + f"\n{len(done(rows)) + failed} of {len(rows)} runs are finished" + (f", {failed} by a numerical failure." if failed else ".")


OTHER_DIRECTION = {"LTV": "TLV", "TLV": "LTV"}


def exchanged(runs):
    """Runs with the names of the directions LTV and TLV exchanged."""
    return collections.defaultdict(dict, {(case, OTHER_DIRECTION.get(direction, direction)): of_house
                                          for (case, direction), of_house in runs.items()})


def share(found):
    holds, of = count(found)
    low, high = wilson(holds, of) if of else (0.0, 1.0)
    return [f"{holds} of {of}", f"{100 * holds / of:.0f}" if of else "–", f"{100 * low:.0f} to {100 * high:.0f}", f"{len(found) - of}"]


def said(found):
    """The answer in words for a single run."""
    return [{True: "yes", False: "no", None: "undecided"}[a] for a in found.values()]


def print_shares(rows):
    runs = by_record(done(rows))
    other_way = exchanged(runs)
    single = all(len(of_house) == 1 for of_house in runs.values())
    show = said if single else share
    print("| house | direction | the paper | " + ("here | directions exchanged |\n|---|---|---|---|---|" if single
          else "holds in | share, % | 95 % interval, % | undecided | directions exchanged |\n|---|---|---|---|---|---|---|---|"))
    for statement in STATEMENTS:
        found, found_other_way = answers(statement, runs), answers(statement, other_way)
        if found:
            cells = show(found) + (show(found_other_way)[:1] if found_other_way else ["–"])
            print(f"| {statement.case} | {statement.direction} | {statement.text} | " + " | ".join(cells) + " |")
    print("\n" + progress(rows))


def print_groups(rows, label_of):
    groups = collections.defaultdict(list)
    for row in done(rows):
        groups[label_of(row)].append(row)
    runs = {label: by_record(group) for label, group in groups.items()}
    print("| house | direction | the paper | " + " | ".join(runs) + " |\n|---|---|---|" + "---|" * len(runs))
    for statement in STATEMENTS:
        found = [answers(statement, of_label) for of_label in runs.values()]
        if any(found):
            cells = ("{} of {}".format(*count(of_label)) if of_label else "–" for of_label in found)
            print(f"| {statement.case} | {statement.direction} | {statement.text} | " + " | ".join(cells) + " |")
    print("\n" + progress(rows))


LABELS = {"options": lambda row: row.get("options") or "as_it_is", "record": lambda row: family(row["record"])}


def main():
    words = sys.argv[1:]
    by = words.pop(-1) if words[-2:-1] == ["--by"] else None
    paths = words[:-1] if by else words
    if not paths or any(path.startswith("-") for path in paths) or (by and by not in LABELS):
        sys.exit(__doc__)
    one_version(tables_of(paths))
    rows = all_rows(paths)
    if by:
        print_groups(rows, LABELS[by])
    else:
        print_shares(rows)


if __name__ == "__main__":
    main()
