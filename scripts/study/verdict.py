#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Motion or model? For each statement of the paper: in how many runs of an ensemble it holds, which changes make it hold, and the verdict.

usage: verdict.py ENSEMBLE.csv [ENSEMBLE.csv ...] [--model TABLE.csv ...] [--motion TABLE.csv ...] [--brief]

ENSEMBLE: realisations of the synthetic motion (bam-like#1, #2, ...), which all meet the same published figures (peaks of acceleration and
  velocity, period of the pulse, Arias intensity, durations: cases/catalogue/bam-like.md), with the default model.
--model: some of these realisations again, with one choice of the model changed at a time. The column `options` names the change; rows of
  `as_it_is` have none. Rows without record and direction are runs in which nothing shakes. They answer one question only, whether
  something cracks before the motion begins; one run with a change and one without it are enough. Options whose name begins with "chance"
  vary strengths by a millionth: what differs then is chance.
--motion: the default model under motions of which one thing is changed. The column `record` names change and realisation: FOLDER/pulse50-2
  is a changed bam-like#2. The table also holds the unchanged bam-like#2.
All tables are of one version.
--brief: a line for each statement and verdict, with the houses and in how many runs it holds there. Statements that agree, and those without
  an answer (too few runs tell, or no change was tried), are counted only.

The statements are those of statements.py. Runs that do not tell are left out. A statement that compares two houses pairs them by realisation:
a house with a changed model with the other house of the ensemble, a house under a changed motion with the other house under that motion. A
statement that compares LTV with TLV takes both from runs with the change.

A change makes a statement hold if, of three or more realisations that tell both with and without it, the statement is true in all with it and
in none without.

The verdict is the first of these that applies:
open: no run tells, open: few runs   fewer than four runs of the ensemble tell
agrees                               it holds in most motions: the 95 % interval of its share lies above one half
motion or chance                     it holds in some, and runs that differ by chance alone give different answers, too
motion                               it holds in some: motions that meet the same figures give different outcomes. Where no repeats were run
                                     (–) chance is not ruled out
open: a motion with other figures    it holds in none; under a changed motion it does
model                                it holds in none; with a choice of the model it does, and with none of the changed motions (which cannot change
                                     what cracks before they begin)
open: a choice of the model, ...     the same, but no changed motion was tried
open: nothing that was tried         nothing makes it hold
open: runs differ before the motion  it holds in some, and no motion can change it
open: no change was tried            it holds in none, and too few runs with a change tell
"""
import collections
import re
import sys

from outcomes import LABELS, all_rows, answer, answers, by_record, count, done, same_run, tables_of, wilson
from versions import one_version
from statements import STATEMENTS, whole_at_first

UNCHANGED = {"--model": "as_it_is", "--motion": "bam-like"}
LEAST_RUNS = 3  # with and without a change, to say that it makes a statement hold
FEW = 4         # fewer runs than these cannot agree: the interval of 3 of 3 reaches below one half


def realisation(record):
    number = re.search(r"^bam-like#([0-9]+)$|/.*-([0-9]+)$", record)
    if number is None:
        sys.exit(f'record = "{record}"; allowed: realisations, as bam-like#7 or FOLDER/pulse50-7')
    return int(number[1] or number[2])


def by_realisation(rows):
    """Rows as in by_record, but by the number of the realisation."""
    runs = collections.defaultdict(dict)
    for house, of_house in by_record(rows).items():
        for record, row in of_house.items():
            number = realisation(record)
            if number in runs[house]:
                sys.exit(f"{row['run']}: a second run of realisation {number} beside {runs[house][number]['run']}; allowed: one of each")
            runs[house][number] = row
    return runs


class Changes:
    """Runs with one change at a time, and runs without changes."""

    def __init__(self, paths, column, unchanged, others):
        """others: runs of the other houses that statements compare with; None: these are among the runs with the change."""
        rows, self.at_rest = collections.defaultdict(list), collections.defaultdict(dict)
        for row in done(all_rows(paths)):
            label = LABELS[column](row)
            if row["record"] or row["direction"] or column == "record":
                rows[label].append(row)
            else:
                self.add_at_rest(label, row)
        self.groups = {label: by_realisation(of_label) for label, of_label in rows.items()}
        self.others = others
        self.unchanged = self.groups.pop(unchanged, collections.defaultdict(dict))

    def add_at_rest(self, label, row):
        first = self.at_rest[row["case"]].setdefault(label, row)
        if first is not row and not same_run(first, row):
            sys.exit(f"{row['run']}: a second run of {row['case']} at rest with the options {label} beside {first['run']}; allowed: one of each")

    def decided(self, statement, runs):
        """By realisation: whether the statement is true, for decided runs."""
        if self.others is not None and statement.other and statement.other[0] != statement.case:
            runs = collections.defaultdict(dict, {**runs, statement.other: self.others[statement.other]})
        return {number: a for number, a in answers(statement, runs).items() if a is not None}

    def pairs(self, statement, wanted=lambda label: True):
        """By change: answers with and without it, for realisations that have both."""
        without = self.decided(statement, self.unchanged)
        found = {label: self.decided(statement, group) for label, group in self.groups.items() if wanted(label)}
        return {label: [(a[n], without[n]) for n in sorted(a.keys() & without.keys())] for label, a in found.items()}

    def counts(self, statement):
        """By change: number of runs in which the statement is true with it, without it, and total number."""
        return {label: (sum(a for a, _ in pairs), sum(b for _, b in pairs), len(pairs))
                for label, pairs in self.pairs(statement, lambda label: not is_repeat(label)).items() if len(pairs) >= LEAST_RUNS}

    def counts_at_rest(self, statement):
        """Counts for houses without motion: one run with the change, and one without."""
        found = {label: answer(statement, [row]) for label, row in self.at_rest[statement.case].items() if not is_repeat(label)}
        without = found.pop("as_it_is", None)
        return {label: (int(a), int(without), 1) for label, a in found.items() if None not in (a, without)}

    def repeats(self, statement):
        """Number of runs that differ in last digits only and give another answer, and total number."""
        pairs = [pair for of_label in self.pairs(statement, is_repeat).values() for pair in of_label]
        return sum(a != b for a, b in pairs), len(pairs)


def is_repeat(label):
    return label.startswith("chance")


def makes_hold(holds, without, runs):
    return holds == runs and without == 0


def verdict(holds, runs, model, motion, differ):
    """model, motion: counts by change; None for motion: no motion can change the statement. differ: number of repeats with another answer."""
    by_model, by_motion = (any(makes_hold(*c) for c in counts.values()) for counts in (model, motion or {}))
    if runs < FEW:
        return "open: few runs" if runs else "open: no run tells"
    if wilson(holds, runs)[0] > 0.5:
        return "agrees"
    if holds > 0 and motion is None:
        return "open: runs differ before the motion begins"
    if holds > 0:
        return "motion or chance" if differ > 0 else "motion"
    if by_motion:
        return "open: a motion with other figures makes it hold"
    if by_model:
        return "model" if motion or motion is None else "open: a choice of the model makes it hold, no changed motion was tried"
    return "open: nothing that was tried makes it hold" if model or motion else "open: no change was tried"


def said(counts):
    if counts is None:
        return "cannot change it"
    if not counts:
        return "not tried"
    making = [f"{label} ({holds} of {runs}, without {without})" for label, (holds, without, runs) in counts.items() if makes_hold(holds, without, runs)]
    if making:
        return "; ".join(making)
    most = max(counts, key=lambda label: (counts[label][0] - counts[label][1]) / counts[label][2])
    holds, without, runs = counts[most]
    return f"none of {len(counts)}" + (f" (nearest: {most}, {holds} of {runs}, without {without})" if holds > without else "")


def split(words):
    """Paths after each --word; those before any belong to the ensemble."""
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


def judged(paths):
    """Each statement with runs in the ensemble, with its counts and its verdict."""
    ensemble = by_realisation(done(all_rows(paths[""])))
    model = Changes(paths["--model"], "options", UNCHANGED["--model"], ensemble)
    motion = Changes(paths["--motion"], "record", UNCHANGED["--motion"], None)
    for statement in STATEMENTS:
        found = answers(statement, ensemble)
        if not found:
            continue
        holds, runs = count(found)
        by_model, by_motion, (differ, repeats) = model.counts(statement), motion.counts(statement), model.repeats(statement)
        if statement.holds is whole_at_first:
            by_model, by_motion = model.counts_at_rest(statement) | by_model, None
        yield Judged(statement, holds, runs, by_model, by_motion, differ, repeats, verdict(holds, runs, by_model, by_motion, differ))


Judged = collections.namedtuple("Judged", "statement holds runs by_model by_motion differ repeats verdict")


def in_full(rows):
    yield ("| house | direction | the paper | holds in | 95 % interval, % | choices of the model that make it hold | changes of the motion that make it hold "
           "| repeats with another answer | verdict |")
    yield "|---|---|---|---|---|---|---|---|---|"
    for r in rows:
        low, high = wilson(r.holds, r.runs) if r.runs else (0.0, 1.0)
        yield (f"| {r.statement.case} | {r.statement.direction} | {r.statement.text} | {r.holds} of {r.runs} | {100 * low:.0f} to {100 * high:.0f} "
               f"| {said(r.by_model)} | {said(r.by_motion)} | {f'{r.differ} of {r.repeats}' if r.repeats else '–'} | {r.verdict} |")


NO_ANSWER = ("open: no run tells", "open: few runs", "open: no change was tried")


def in_brief(rows):
    rows = list(rows)
    agree, silent = sum(r.verdict == "agrees" for r in rows), sum(r.verdict in NO_ANSWER for r in rows)
    yield f"| the paper: of {len(rows)} statements {agree} agree, {silent} have no answer, and these are left | holds in | verdict |"
    yield "|---|---|---|"
    groups = collections.defaultdict(lambda: collections.defaultdict(list))
    for r in rows:
        if r.verdict != "agrees" and r.verdict not in NO_ANSWER:
            groups[r.statement.text, r.verdict][r.statement.case].append(f"{r.statement.direction} {r.holds}/{r.runs}")
    for (text, said_of_it), houses in groups.items():
        yield f"| {text} | {'; '.join(house + ' ' + ', '.join(runs) for house, runs in houses.items())} | {said_of_it} |"


def main():
    brief = "--brief" in sys.argv[1:]
    paths = split([word for word in sys.argv[1:] if word != "--brief"])
    one_version(tables_of([path for of_word in paths.values() for path in of_word]))
    print("\n".join((in_brief if brief else in_full)(judged(paths))))


if __name__ == "__main__":
    main()
