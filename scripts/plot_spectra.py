#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws response spectra of ground motion, from tables that `voussoir motion FILE... --spectra spectra.csv` writes.

usage: scripts/plot_spectra.py spectra.csv ... [--quantity Sd|Sv|Sa] [--over frequency|period] [-o spectra.png]
Needs python3-numpy, python3-matplotlib. Vertical lines mark natural frequencies given by --mark (Hz), as of `voussoir modes CASE`.
"""

import csv
import sys

import run_file

UNITS = {"Sd": "m", "Sv": "m/s", "Sa": "m/s2"}
NAMES = {"Sd": "displacement", "Sv": "pseudo-velocity", "Sa": "pseudo-acceleration"}
OVER = {"frequency": "frequency [Hz]", "period": "period [s]"}


def curves(paths, over, quantity):
    """{label: [(frequency or period, value)]}, in the order of the files; with the file's name if there are several."""
    found = {}
    for path in paths:
        try:
            with open(path, newline="") as file:
                for row in csv.DictReader(file):
                    label = f"{row['record']} {row['component']}, {100 * float(row['damping']):g} %"
                    if len(paths) > 1:
                        label = f"{path}: {label}"
                    found.setdefault(label, []).append((float(row[OVER[over]]), float(row[f"{quantity} [{UNITS[quantity]}]"])))
        except (OSError, KeyError, TypeError, ValueError) as error:
            sys.exit(f"{path}: no table of `voussoir motion --spectra`: {error}")
    if not found:
        sys.exit(f"{', '.join(paths)}: no rows")
    return found


def main():
    p = run_file.parser(__doc__, "spectra.png")
    p.add_argument("table", nargs="+")
    p.add_argument("--quantity", choices=UNITS, default="Sa")
    p.add_argument("--over", choices=OVER, default="frequency")
    p.add_argument("--mark", type=float, nargs="+", default=[], metavar="HZ", help="frequencies to mark")
    a = p.parse_args()
    figure, (axes,) = run_file.panels(1, a.width, 8.0)
    for number, (label, points) in enumerate(curves(a.table, a.over, a.quantity).items()):
        x, y = zip(*sorted(points))
        axes.loglog(x, y, label=label, **run_file.style(number))
    for frequency in a.mark:
        axes.axvline(frequency if a.over == "frequency" else 1.0 / frequency, color="grey", linewidth=0.8)
    axes.set(xlabel=OVER[a.over].replace(" [", ", ").rstrip("]"), ylabel=f"{NAMES[a.quantity]}, {UNITS[a.quantity]}")
    run_file.plots.plain_numbers(axes)
    axes.grid(which="minor", linewidth=0.25)
    axes.legend()
    run_file.save(figure, a.output)


if __name__ == "__main__":
    main()
