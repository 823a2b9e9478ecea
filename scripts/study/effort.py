#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Gain against effort: what each measure of a strengthening study takes, and what the house does with it.

usage: effort.py STUDY.toml TABLE.csv [TABLE.csv ...] [--record NAME] [--bills FOLDER]

The first case of the study is the bare house; effort is what the bills of `voussoir check` have more in the others (VOUSSOIR names the
program, default build/release/io/voussoir, else the one on the PATH). Bills are kept in FOLDER, if one is given, and not made again.
Writes a table in Markdown on standard output: damage grade and fallen mass [%] by direction, motion and its scale or level; runs that are not done have
a dash, columns without any are left out. A last column has the means over the runs that are done for both the measure and the bare house:
grade and fallen mass, with the measure and (without), and of how many runs. --record: only the runs of this motion. The tables are of one
version, with one set of options and one seed; a run that is in two of them counts once.
"""
import argparse
import csv
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "python/voussoir"))
import program
import toml_reading
from outcomes import difference, same_run
from strength import words_of
from versions import one_version

COLUMNS = {"bill of blocks": ("count", "m3"), "bill of ties": ("count", "rod", "mesh", "anchors")}
LEAST = 5e-3  # below it a difference is round-off of what is printed


def number(text):
    return float(text.replace(",", ""))


def rows_of(text, title):
    """Rows of a bill: name, with its numbers by column."""
    lines = iter(text.splitlines())
    if not any(line.startswith(title) for line in lines):
        return
    for line in lines:
        if not line.strip():
            return
        columns = COLUMNS[title]
        name, *values = line.rsplit(maxsplit=len(columns))
        yield name, dict(zip(columns, map(number, values)))


def kind_of(name):
    """"adobe brick, cut, 0.15 x 0.1 x 0.1 m" is "adobe brick"; loads of beams are not part of the name."""
    return re.sub(r" (with roof surcharge|of floor \d+ with) [^ ]+ kg/m2", "", name.split(",")[0])


def bill(text):
    """Material of a model: m3 by kind of block, m of rod, m2 of mesh, m2 of decks, anchors, bars."""
    sums = {}

    def add(what, amount):
        if amount > 0:
            sums[what] = sums.get(what, 0.0) + amount

    for name, row in rows_of(text, "bill of blocks"):
        add(f"m3 of {kind_of(name)}", row["m3"])
    for name, row in rows_of(text, "bill of ties"):
        add("m of rod", row["rod"])
        add("m2 of deck" if name.endswith(" deck") else "m2 of mesh", row["mesh"])
        add("anchors", row["anchors"])
    if not sums:
        sys.exit("effort.py: no bill in what `voussoir check` printed:\n" + text)
    return sums


def checked(case, folder, bills):
    """The output of `voussoir check` for a case of the study."""
    kept = bills / f"{pathlib.Path(case).stem}.txt" if bills else None
    if kept and kept.exists():
        return kept.read_text()
    done = subprocess.run([program.program(), "check", case, "--bill", "-j", "1"], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"effort.py: voussoir check {case}: {done.stderr.strip()}")
    if kept:
        bills.mkdir(parents=True, exist_ok=True)
        kept.write_text(done.stdout)
    return done.stdout


def effort(bare, bill_of_case):
    """Material of a case in addition to that of the bare house, and saved material."""
    words = []
    for what in sorted(bare.keys() | bill_of_case.keys()):
        more = bill_of_case.get(what, 0.0) - bare.get(what, 0.0)
        if abs(more) < LEAST:
            continue
        sign = "−" if more < 0 else "+" if what in bare else ""
        words.append(f"{sign}{abs(more):.0f} {what}" if what == "anchors" else f"{sign}{abs(more):.2f} {what}")
    return ", ".join(words) or "other joints alone"


def key(run):
    return run["direction"], run["record"], words_of(run)


def outcome(run):
    grade = run["damage_grade"]
    fallen = f"{100 * float(run['fallen_mass_fraction']):.1f}"
    return fallen if grade.startswith("-") else f"G{grade} {fallen}"


def mean(runs, column):
    return sum(float(run[column]) for run in runs) / len(runs)


def gain(runs, bare):
    """Means over the runs that are done with and without the measure."""
    both = sorted(runs.keys() & bare.keys())
    if not both:
        return "–"
    pairs = [[side[k] for k in both] for side in (runs, bare)]
    grades = [f"{mean(side, 'damage_grade'):.1f}" for side in pairs]
    fallen = [f"{100 * mean(side, 'fallen_mass_fraction'):.1f}" for side in pairs]
    return f"G{grades[0]} (G{grades[1]}), {fallen[0]} ({fallen[1]}), {len(both)} of {len(bare)}"


def add(runs, run):
    """Adds one of a case's runs."""
    first = runs.setdefault(key(run), run)
    if first is not run and not same_run(first, run):
        sys.exit(f"{run['run']}: the same house, direction, motion and strength as {first['run']}; they differ in {difference(first, run)}; "
                 "allowed: one run of each")


def read(paths, record):
    """Finished runs, of one record if given, by case, then by direction, motion and strength; and a sorted list of all directions, motions and
    strengths that occur."""
    done, keys, tables = {}, {}, {}
    for path in paths:
        with open(path, newline="", encoding="utf-8") as file:
            tables[path] = list(csv.DictReader(file))
    one_version(tables)
    for run in (run for rows in tables.values() for run in rows):
        if run["status"] == "done" and record in (None, run["record"]):
            keys.setdefault(key(run), len(keys))
            add(done.setdefault(run["case"], {}), run)
    return done, list(keys)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", type=pathlib.Path)
    parser.add_argument("tables", nargs="+")
    parser.add_argument("--record")
    parser.add_argument("--bills", type=pathlib.Path)
    args = parser.parse_args()
    cases = toml_reading.loads(args.study.read_text())["cases"]
    done, keys = read(args.tables, args.record)
    names = [pathlib.Path(case).stem for case in cases]
    heads = ["measure", "effort", *(f"{d}, {strength}" if args.record else f"{d}, {record}, {strength}" for d, record, strength in keys), "mean (without)"]
    print("| " + " | ".join(heads) + " |\n|" + "---|" * len(heads))
    bare = None
    for case, name in zip(cases, names):
        own = bill(checked(case, args.study.parent, args.bills))
        bare = bare or own
        runs = done.get(name, {})
        cells = [outcome(runs[k]) if k in runs else "–" for k in keys]
        words = ["none", "–"] if case == cases[0] else [effort(bare, own), gain(runs, done.get(names[0], {}))]
        print("| " + " | ".join([name, words[0], *cells, words[1]]) + " |")


if __name__ == "__main__":
    main()
