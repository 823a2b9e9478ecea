# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Quantities of a study's table: over the intensity or scale of the motion, or a bar a run. usage: plot.py TABLE QUANTITY.svg ...

Over either: a point a run, a line through the means over seeds, one for each case, direction, record and set of options. Where something,
as a crack, never came in some of the seeds, they have no mean, and the line has a gap.
"""
import csv
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import own_files
import run_file
from strength import axis_of, strength_of, text_of

UNITS = {"first_crack_time": "s", "peak_base_shear": "kN", "peak_speed": "m/s"}
SHOWN = {"peak_base_shear": 1e-3}  # of the table's value, where that is in another unit
GROUP = ("case", "direction", "record", "options")


def is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def value_of(row, quantity):
    """The value of a quantity; None: never, stored as a time below zero."""
    value = float(row[quantity])
    return None if UNITS.get(quantity) == "s" and value < 0 else SHOWN.get(quantity, 1) * value


def mean(values):
    return math.nan if None in values else sum(values) / len(values)


def over_strength(axes, rows, quantity):
    groups = {}
    for row in rows:
        points = groups.setdefault(" ".join(row[key] for key in GROUP if row[key]), {})
        points.setdefault(strength_of(row), []).append(value_of(row, quantity))
    for number, (label, points) in enumerate(groups.items()):
        look = run_file.style(number)
        strengths = sorted(points)
        axes.plot(strengths, [mean(points[s]) for s in strengths], label=label, **look)
        shown = [(s, v) for s in strengths for v in points[s] if v is not None]
        axes.plot([s for s, _ in shown], [v for _, v in shown], ".", color=look["color"])
    axes.set(xlabel=axis_of(rows), ylabel=label_of(quantity))
    axes.legend()


def bars(axes, rows, quantity):
    axes.barh([row["run"] for row in rows], [value_of(row, quantity) for row in rows], color=run_file.COLOURS[0], height=0.6)
    axes.invert_yaxis()
    axes.set(xlabel=label_of(quantity))


def label_of(quantity):
    return quantity.replace("_", " ") + (f", {UNITS[quantity]}" if quantity in UNITS else "")


def has(row, quantity):
    """Whether a finished run has a value of the quantity."""
    return row["status"] == "done" and is_number(row.get(quantity) or "")


def draw(rows, path):
    own_files.refuse_other(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    quantity = path.stem
    there = [row for row in rows if has(row, quantity)]
    shown = [row for row in there if value_of(row, quantity) is not None]
    scaled = len({text_of(row) for row in shown}) > 1 and all(is_number(text_of(row)) for row in there)
    figure, axes = run_file.plt.subplots(figsize=(16 / 2.54, (8.0 if scaled else 1.6 + 0.5 * len(shown)) / 2.54))
    if scaled:
        over_strength(axes, there, quantity)
    else:
        bars(axes, shown, quantity)
    run_file.save(figure, path)


def main():
    with open(sys.argv[1], newline="") as file:
        rows = list(csv.DictReader(file))
    try:
        axis_of(rows)
    except ValueError as error:
        sys.exit(f"{sys.argv[1]}: {error}")
    try:
        for path in sys.argv[2:]:
            draw(rows, pathlib.Path(path))
    except own_files.StudyError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
