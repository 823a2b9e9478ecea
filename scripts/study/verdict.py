#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Motion or model? For each statement of the paper: in how many runs of an ensemble it holds, what brings it, and what follows.

usage: verdict.py ENSEMBLE.csv [ENSEMBLE.csv ...] [--model TABLE.csv ...] [--motion TABLE.csv ...]

ENSEMBLE has realisations of one motion; --model tables change one choice of the model at a time (column `options`), --motion tables one
thing of the motion (column `record`), both with the same few realisations. A change brings a statement if it holds in at least two more
of their runs with the change than without.

agrees  it holds in most runs of the ensemble: the 95 % interval of its share lies above a half
motion  it holds in some and not in others: motions that meet the same figures differ in it, and the paper's is one of them
model   it holds in none; a choice of the model brings it, no change of the motion does
open    it holds in none, and nothing brings it, or a change of the motion does: such a motion no longer meets the figures
"""
import collections
import sys

from outcomes import LABELS, STATEMENTS, by_record, count, rows_of, wilson

MORE_RUNS = 2  # than without the change, for it to bring a statement


def groups_of(paths, label_of):
    """Runs by case and direction, then by record: of each label, that of the runs without a change first."""
    rows = collections.defaultdict(list)
    for row in rows_of(paths):
        rows[label_of(row)].append(row)
    return {label: by_record(group) for label, group in rows.items()}


def brought_by(statement, groups, unchanged):
    """The labels that bring the statement, with their counts; None where nothing was tried."""
    if unchanged not in groups:
        return None
    without, of = count(statement, groups[unchanged])
    counts = {label: count(statement, runs) for label, runs in groups.items() if label != unchanged}
    tried = {label: (holds, runs) for label, (holds, runs) in counts.items() if runs == of and of > 0}
    if not tried:
        return None
    return [f"{label} ({holds} of {runs}, without {without})" for label, (holds, runs) in tried.items() if holds - without >= MORE_RUNS]


def verdict(holds, runs, by_model, by_motion):
    if wilson(holds, runs)[0] > 0.5:
        return "agrees"
    if holds > 0:
        return "motion"
    if by_model and not by_motion:
        return "model"
    return "open"


def said(brought):
    return "not tried" if brought is None else "; ".join(brought) or "none"


def split(words):
    """Paths behind each --word; those before any are the ensemble's."""
    paths, key = {"ensemble": [], "--model": [], "--motion": []}, "ensemble"
    for word in words:
        if word.startswith("-"):
            if word not in paths:
                sys.exit(__doc__)
            key = word
        else:
            paths[key].append(word)
    if not paths["ensemble"]:
        sys.exit(__doc__)
    return paths


def main():
    paths = split(sys.argv[1:])
    ensemble = by_record(rows_of(paths["ensemble"]))
    model, motion = groups_of(paths["--model"], LABELS["options"]), groups_of(paths["--motion"], LABELS["record"])
    print("| house | direction | the paper | holds in | 95 % interval, % | choices of the model that bring it | changes of the motion that do "
          "| verdict |\n|---|---|---|---|---|---|---|---|")
    for statement in STATEMENTS:
        holds, runs = count(statement, ensemble)
        if not runs:
            continue
        by_model, by_motion = brought_by(statement, model, "as_it_is"), brought_by(statement, motion, "bam-like")
        low, high = wilson(holds, runs)
        print(f"| {statement.case} | {statement.direction} | {statement.text} | {holds} of {runs} | {100 * low:.0f} to {100 * high:.0f} "
              f"| {said(by_model)} | {said(by_motion)} | {verdict(holds, runs, by_model, by_motion)} |")


if __name__ == "__main__":
    main()
