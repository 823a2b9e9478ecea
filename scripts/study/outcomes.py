#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""In how many runs of an ensemble does each statement of the paper's section 4 hold?

usage: outcomes.py TABLE.csv [TABLE.csv ...] [--by options | --by record]

Writes a table in Markdown: the statement, the runs in which it holds, of how many, and the 95 % interval of that share (Wilson's score
interval). Runs that are not done, and numerical failures, are left out; a statement that compares two runs counts the records for which
both are done. The paper has one record, so each of its statements is one draw: it is within what the ensemble allows if the interval
reaches 5 % or more.

--by: how many runs agree with each statement, of how many, by the set of options, or by the record without its number (bam-like#7 and
bam-like#8 count together, as do pulse50-1 and pulse50-2): a column each.
"""
import collections
import csv
import math
import re
import sys

BEARING, SIDE = ("front wall", "rear wall"), ("left wall", "right wall")
STANDS, FALLS = 0.05, 0.25  # shares of a wall's mass: less has fallen from a wall that stands, more from one that falls
NORMAL_95 = 1.959963984540054


def number(run, column):
    return float(run[column]) if run.get(column, "") != "" else math.nan


def collapses(run):
    return run["collapsed"] == "1"


def fallen(run, walls):
    return [number(run, f"{wall}: fallen_mass_fraction") for wall in walls]


def stands(run):
    """Neither the roof nor a bearing wall falls."""
    return not collapses(run) and max(fallen(run, BEARING)) < STANDS


def bearing_walls_fall(run):
    return max(fallen(run, BEARING)) > FALLS


def bearing_walls_first(run):
    """A bearing wall, or the roof over it, loses its first element before a side wall does."""
    return run["first_fallen_wall"] in BEARING


def sides_lose_bricks(run):
    return max(fallen(run, SIDE)) > 0.0


def cracks(run):
    return sum(number(run, mode) for mode in ("tension", "shear", "compression"))


def cracks_alone(run):
    return cracks(run) > 0 and number(run, "fallen_mass_fraction") == 0


# Case, direction, what the paper says (its section), and whether a run agrees. A statement about two runs takes the other one, too: case
# and direction stand last.
Statement = collections.namedtuple("Statement", "case direction text holds other", defaults=(None,))
STATEMENTS = [
    Statement("flat20w", "TLV", "bearing walls and roof stay (4.1)", stands),
    Statement("flat20w", "TLV", "side walls lose bricks (4.1)", sides_lose_bricks),
    Statement("flat20w", "LTV", "the roof falls (4.1)", collapses),
    Statement("flat20w", "LTV", "with the bearing walls (4.1)", bearing_walls_fall),
    Statement("flat20w", "LTV", "and these before the side walls (4.1)", bearing_walls_first),
    Statement("flat20n", "TLV", "stands (4.1)", stands),
    Statement("flat20n", "LTV", "the roof falls (4.1)", collapses),
    Statement("flat20n", "LTV", "with the bearing walls (4.1)", bearing_walls_fall),
    Statement("flat20n", "LTV", "and these before the side walls (4.1)", bearing_walls_first),
    Statement("flat20n", "LTV", "not before 5 s; the paper has 6 s (4.1)", lambda run: collapses(run) and number(run, "collapse_time") > 5.0),
    Statement("flat20n", "LTV", "falls where TLV stands (4.1)", lambda run, tlv: collapses(run) and stands(tlv), ("flat20n", "TLV")),
    Statement("flat20s", "TLV", "cracks, nothing falls (4.1)", cracks_alone),
    Statement("flat20s", "LTV", "cracks, nothing falls (4.1)", cracks_alone),
    Statement("flat40n", "TLV", "stands (4.1)", stands),
    Statement("flat40n", "TLV", "fewer cracks than Flat20N (4.1)", lambda run, thin: cracks(run) < cracks(thin), ("flat20n", "TLV")),
    Statement("flat40n", "LTV", "stands (4.1)", stands),
    Statement("flat20r", "TLV", "stands (4.1)", stands),
    Statement("flat20r", "TLV", "fewer cracks than Flat20N (4.1)", lambda run, bare: cracks(run) < cracks(bare), ("flat20n", "TLV")),
    Statement("flat20r", "LTV", "the bearing walls stand (4.1)", stands),
    *(Statement("vault20w", d, "collapses as soon as the motion begins (4.2)", lambda run: collapses(run) and number(run, "collapse_time") < 1.5)
      for d in ("TLV", "LTV")),
    *(Statement("vault20n", d, "collapses with the bearing walls (4.2)", lambda run: collapses(run) and bearing_walls_fall(run))
      for d in ("TLV", "LTV")),
    *(Statement("vault20s", d, "does not collapse (4.2)", stands) for d in ("TLV", "LTV")),
    *(Statement("vault40n", d, "the roof falls later than Vault20N's (4.2)",
                lambda run, thin: collapses(run) and number(run, "collapse_time") > number(thin, "collapse_time"), ("vault20n", d))
      for d in ("TLV", "LTV")),
    Statement("vault40n", "TLV", "both bearing walls stay (4.2)", lambda run: not bearing_walls_fall(run)),
    Statement("vault40n", "LTV", "the front wall fractures (4.2)", lambda run: number(run, "front wall: fallen_mass_fraction") > STANDS),
    *(Statement("vault20r", d, "the roof falls later than Vault40N's (4.2)",
                lambda run, thick: collapses(run) and number(run, "collapse_time") > number(thick, "collapse_time"), ("vault40n", d))
      for d in ("TLV", "LTV")),
]


def wilson(holds, runs):
    """The score interval of a share, 95 %."""
    z2 = NORMAL_95**2
    middle = (holds + z2 / 2) / (runs + z2)
    half = NORMAL_95 / (runs + z2) * math.sqrt(holds * (runs - holds) / runs + z2 / 4)
    return max(0.0, middle - half), min(1.0, middle + half)


def count(statement, runs):
    """How many runs agree, of how many."""
    mine = runs[statement.case, statement.direction]
    other = runs[statement.other] if statement.other else None
    results = [statement.holds(run, other[record]) if other is not None else statement.holds(run)
               for record, run in mine.items() if other is None or record in other]
    return sum(results), len(results)


def rows_of(paths):
    """Those that are done."""
    for path in paths:
        with open(path, newline="") as file:
            yield from (row for row in csv.DictReader(file) if row["status"] == "done")


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


def print_shares(runs):
    print("| house | direction | the paper | holds in | share, % | 95 % interval, % |\n|---|---|---|---|---|---|")
    for statement in STATEMENTS:
        holds, of = count(statement, runs)
        if of:
            low, high = wilson(holds, of)
            print(f"| {statement.case} | {statement.direction} | {statement.text} | {holds} of {of} | {100 * holds / of:.0f} | {100 * low:.0f} to {100 * high:.0f} |")


def print_groups(rows, label_of):
    groups = collections.defaultdict(list)
    for row in rows:
        groups[label_of(row)].append(row)
    runs = {label: by_record(group) for label, group in groups.items()}
    print("| house | direction | the paper | " + " | ".join(runs) + " |\n|---|---|---|" + "---|" * len(runs))
    for statement in STATEMENTS:
        counts = [count(statement, of_label) for of_label in runs.values()]
        if any(of for _, of in counts):
            cells = (f"{holds} of {of}" if of else "–" for holds, of in counts)
            print(f"| {statement.case} | {statement.direction} | {statement.text} | " + " | ".join(cells) + " |")


LABELS = {"options": lambda row: row["options"] or "as_it_is", "record": lambda row: family(row["record"])}


def main():
    words = sys.argv[1:]
    by = words.pop(-1) if words[-2:-1] == ["--by"] else None
    paths = words[:-1] if by else words
    if not paths or any(path.startswith("-") for path in paths) or (by and by not in LABELS):
        sys.exit(__doc__)
    rows = list(rows_of(paths))
    if by:
        print_groups(rows, LABELS[by])
    else:
        print_shares(by_record(rows))


if __name__ == "__main__":
    main()
