#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Motion or model? For each statement of the paper: in how many runs of an ensemble it holds, which changes make it hold, and the verdict.

usage: verdict.py ENSEMBLE.csv [ENSEMBLE.csv ...] [--model TABLE.csv ...] [--motion TABLE.csv ...]

The ensemble: realisations of the synthetic motion (bam-like#1, #2, ...), which all meet the same published peak values; the model as it is.
--model: some of these realisations again, with one choice of the model changed at a time (column `options`; `as_it_is`: none).
--motion: the model as it is, and some of these realisations with one thing changed at a time (column `record`: FOLDER/pulse50-2 is a changed
bam-like#2), beside the unchanged ones.
Runs that are not done, and numerical failures, are left out.

A change makes a statement hold if, of the realisations that were run with and without it, three or more, the statement is true in all with
the change and in none without. A statement that compares two houses takes the other house from the ensemble.

agrees  the statement holds in all runs of the ensemble, or in so many that the 95 % interval of their share lies above one half
motion  it holds in some of them: motions with the same peak values give different outcomes
model   it holds in none of them; a choice of the model makes it hold, and of the changes of the motion that were tried none does
open    it holds in none, and nothing that was tried makes it hold; or a changed motion does, which no longer meets the peak values; or no
        change of the motion was tried
"""
import collections
import re
import sys

from outcomes import LABELS, STATEMENTS, by_record, count, rows_of, wilson

UNCHANGED = {"--model": "as_it_is", "--motion": "bam-like"}
LEAST_RUNS = 3  # with and without a change, to say that it makes a statement hold


def realisation(record):
    number = re.search(r"[#-]([0-9]+)$", record)
    if number is None:
        sys.exit(f'record = "{record}"; allowed: realisations, as bam-like#7 or FOLDER/pulse50-7')
    return int(number[1])


def by_realisation(runs):
    """As by_record gives them, but by the number of the realisation."""
    return collections.defaultdict(dict, {house: {realisation(record): run for record, run in of_house.items()} for house, of_house in runs.items()})


def groups_of(paths, label_of):
    rows = collections.defaultdict(list)
    for row in rows_of(paths):
        rows[label_of(row)].append(row)
    return {label: by_realisation(by_record(group)) for label, group in rows.items()}


def with_other(statement, runs, ensemble):
    """The runs that a statement needs: the other house of a comparison is that of the ensemble."""
    if statement.other is None or statement.other[0] == statement.case:
        return runs
    return collections.defaultdict(dict, {**runs, statement.other: ensemble[statement.other]})


def among(statement, runs, numbers):
    house = statement.case, statement.direction
    return collections.defaultdict(dict, {**runs, house: {n: run for n, run in runs[house].items() if n in numbers}})


def numbers_of(statement, runs):
    """The realisations for which the statement can be asked."""
    mine = set(runs[statement.case, statement.direction])
    return mine if statement.other is None else mine & set(runs[statement.other])


class Changes:
    """Runs with one change at a time, and those without any."""

    def __init__(self, paths, column, unchanged, ensemble):
        self.groups, self.ensemble = groups_of(paths, LABELS[column]), ensemble
        self.unchanged = self.groups.pop(unchanged, None)

    def counts(self, statement):
        """By change: in how many runs the statement holds with it, in how many without it, of how many."""
        if self.unchanged is None:
            return {}
        without = with_other(statement, self.unchanged, self.ensemble)
        found = {}
        for label, group in self.groups.items():
            changed = with_other(statement, group, self.ensemble)
            both = numbers_of(statement, changed) & numbers_of(statement, without)
            if len(both) >= LEAST_RUNS:
                found[label] = (count(statement, among(statement, changed, both))[0], count(statement, among(statement, without, both))[0], len(both))
        return found


def making(counts):
    """The changes that make a statement hold."""
    return [f"{label} ({holds} of {runs}, without {without})" for label, (holds, without, runs) in counts.items() if holds == runs and without == 0]


def verdict(holds, runs, by_model, by_motion, motions_tried):
    if holds == runs or wilson(holds, runs)[0] > 0.5:
        return "agrees"
    if holds > 0:
        return "motion"
    return "model" if by_model and motions_tried and not by_motion else "open"


def said(counts):
    return "; ".join(making(counts)) or f"none of {len(counts)}" if counts else "not tried"


def split(words):
    """Paths behind each --word; those before any are the ensemble's."""
    paths, key = {"": [], "--model": [], "--motion": []}, ""
    for word in words:
        if word.startswith("-"):
            if word not in paths:
                sys.exit(__doc__)
            key = word
        else:
            paths[key].append(word)
    if not paths[""]:
        sys.exit(__doc__)
    return paths


def main():
    paths = split(sys.argv[1:])
    ensemble = by_realisation(by_record(rows_of(paths[""])))
    model = Changes(paths["--model"], "options", UNCHANGED["--model"], ensemble)
    motion = Changes(paths["--motion"], "record", UNCHANGED["--motion"], ensemble)
    print("| house | direction | the paper | holds in | 95 % interval, % | choices of the model that make it hold | changes of the motion that do "
          "| verdict |\n|---|---|---|---|---|---|---|---|")
    for statement in STATEMENTS:
        holds, runs = count(statement, ensemble)
        if not runs:
            continue
        by_model, by_motion = model.counts(statement), motion.counts(statement)
        low, high = wilson(holds, runs)
        print(f"| {statement.case} | {statement.direction} | {statement.text} | {holds} of {runs} | {100 * low:.0f} to {100 * high:.0f} "
              f"| {said(by_model)} | {said(by_motion)} | {verdict(holds, runs, making(by_model), making(by_motion), bool(by_motion))} |")


if __name__ == "__main__":
    main()
