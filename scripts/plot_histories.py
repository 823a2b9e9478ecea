#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws histories of followed elements, several runs in one figure, a panel for each element (the paper's Figs. 20 and 21).

usage: scripts/plot_histories.py [LABEL=]DIR ... [--show element1:x element2:y] [--limit 0.3] [-o histories.png] [--peaks peaks.csv]
"""

import csv

import numpy as np

import run_file
from voussoir import plots


def peak(run, name, axis, quantity, until):
    """A row of the table of peaks: the largest magnitude of a curve, and its time."""
    time, values = plots.curve(run, name, quantity)
    curve = values[time <= (np.inf if until is None else until), plots.AXES.index(axis)]
    at = int(np.nanargmax(abs(curve)))
    return {"run": run.label, "history": name, "axis": axis, f"peak [{plots.UNITS[quantity]}]": f"{curve[at]:.5g}", "time [s]": f"{time[at]:.3f}"}


def write_peaks(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    p = run_file.parser(__doc__, "histories.png", over_time=True)
    p.add_argument("run", nargs="+", help="folder of a run, or LABEL=folder")
    p.add_argument("--show", nargs="+", metavar="NAME:AXIS", help="a panel each (default: all, along the axis that moves more)")
    p.add_argument("--quantity", choices=plots.UNITS, default="displacement")
    p.add_argument("--limit", type=float, help="of the vertical axes, both ways; what is beyond is off the scale")
    p.add_argument("--peaks", metavar="FILE.csv", help="also write the peak of each curve as far as it is drawn, and when it is reached")
    a = p.parse_args()
    runs = [run_file.Run(argument) for argument in a.run]
    with run_file.or_exit():
        figure = plots.histories(runs, a.show, quantity=a.quantity, limit=a.limit, until=a.until, width=a.width)
        run_file.save(figure, a.output)
        panels = plots.history_panels(runs, a.show, a.quantity)
    if a.peaks:
        write_peaks(a.peaks, [peak(run, name, axis, a.quantity, a.until) for name, axis in panels for run in runs])


if __name__ == "__main__":
    main()
