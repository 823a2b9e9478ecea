#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""In how many runs of an ensemble does each statement of the paper hold?

usage: outcomes.py TABLE.csv [TABLE.csv ...] [--by options | --by record]

Writes a table in Markdown: the statement (statements.py), the runs in which it holds, of how many that tell, and the 95 % interval of that
share (Wilson's score interval; it is about motions like those of the ensemble). Runs that do not tell are counted as undecided: the statement
asks for something that did not happen there, or the run ended too early. A statement that compares two houses pairs them by record. The last
line says how many runs are done, and how many of them failed numerically; both kinds that have no result are left out.

--by: how many runs agree with each statement, of how many that tell, by the set of options, or by the record without its number (bam-like#7
and bam-like#8 count together, as do pulse50-1 and pulse50-2): a column each.
"""
import collections
import csv
import math
import re
import sys

from statements import STATEMENTS, Run, Unknown

NORMAL_95 = 1.959963984540054


def wilson(holds, runs):
    """The score interval of a share, 95 %."""
    z2 = NORMAL_95**2
    middle = (holds + z2 / 2) / (runs + z2)
    half = NORMAL_95 / (runs + z2) * math.sqrt(holds * (runs - holds) / runs + z2 / 4)
    return max(0.0, middle - half), min(1.0, middle + half)


def answers(statement, runs):
    """By record: whether the statement holds; None: undecided."""
    mine = runs[statement.case, statement.direction]
    others = runs[statement.other] if statement.other else None
    found = {}
    for record, row in mine.items():
        if others is not None and record not in others:
            continue
        rows = (row,) if others is None else (row, others[record])
        try:
            found[record] = statement.holds(*map(Run, rows))
        except Unknown:
            found[record] = None
    return found


def count(found):
    """In how many runs a statement holds, of how many that tell."""
    return sum(a is True for a in found.values()), sum(a is not None for a in found.values())


def all_rows(paths):
    for path in paths:
        try:
            with open(path, newline="") as file:
                yield from csv.DictReader(file)
        except OSError as error:
            sys.exit(f"{path}: {error.strerror}")


def done(rows):
    return [row for row in rows if row["status"] == "done"]


def by_record(rows):
    """By case and direction, then by record."""
    runs = collections.defaultdict(dict)
    for row in rows:
        of_house = runs[row["case"], row["direction"]]
        if row["record"] in of_house:
            sys.exit(f"{row['run']}: the same house, direction and record as {of_house[row['record']]['run']}; allowed: each once, with one set "
                     "of options, scale and seed (sets of options: --by options)")
        of_house[row["record"]] = row
    return runs


def family(record):
    """What bam-like#7 and FOLDER/pulse50-7 are realisations of; other records are by themselves."""
    return re.sub(r"-[0-9]+$", "", record.rsplit("/", 1)[1]) if "/" in record else re.sub(r"#[0-9]+$", "", record)


def progress(rows):
    failed = sum(row["status"] == "numerical failure" for row in rows)
    return f"{len(done(rows)) + failed} of {len(rows)} runs are done" + (f", of them {failed} with a numerical failure." if failed else ".")


def print_shares(rows):
    runs = by_record(done(rows))
    print("| house | direction | the paper | holds in | share, % | 95 % interval, % | undecided |\n|---|---|---|---|---|---|---|")
    for statement in STATEMENTS:
        found = answers(statement, runs)
        if not found:
            continue
        holds, of = count(found)
        low, high = wilson(holds, of) if of else (0.0, 1.0)
        share = f"{100 * holds / of:.0f}" if of else "–"
        print(f"| {statement.case} | {statement.direction} | {statement.text} | {holds} of {of} | {share} | {100 * low:.0f} to {100 * high:.0f} "
              f"| {len(found) - of} |")
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


LABELS = {"options": lambda row: row["options"] or "as_it_is", "record": lambda row: family(row["record"])}


def main():
    words = sys.argv[1:]
    by = words.pop(-1) if words[-2:-1] == ["--by"] else None
    paths = words[:-1] if by else words
    if not paths or any(path.startswith("-") for path in paths) or (by and by not in LABELS):
        sys.exit(__doc__)
    rows = list(all_rows(paths))
    if by:
        print_groups(rows, LABELS[by])
    else:
        print_shares(rows)


if __name__ == "__main__":
    main()
