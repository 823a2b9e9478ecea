#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws histories of followed elements, several runs in one figure, a panel for each element (the paper's Figs. 20 and 21).

usage: scripts/plot_histories.py [LABEL=]DIR ... [--show element1:x element2:y] [--limit 0.3] [-o histories.png] [--peaks peaks.csv]
"""

import csv

import numpy as np

import run_file

UNITS = {"displacement": "m", "velocity": "m/s", "rotation": "rad"}
AXES = "xyz"


def wanted_panels(show, runs, quantity):
    """(name, axis) of each panel. Without a wish: every history of the first run, along the horizontal axis on which it moves more."""
    if show:
        panels = [tuple(text.rpartition(":")[::2]) for text in show]
        for name, axis in panels:
            if not name or axis not in tuple(AXES):
                raise SystemExit(f"--show {name}:{axis}: wanted NAME:AXIS with the axis x, y or z")
        return panels
    chosen = []
    for name in runs[0].names():
        peaks = np.nanmax(abs(runs[0].history(name, quantity)[1]), axis=0)
        chosen.append((name, AXES[int(np.argmax(peaks[:2]))]))
    if not chosen:
        raise SystemExit(f"{runs[0].label}: the case follows no element; see [[output.history]]")
    return chosen


def peak(run, name, axis, quantity, until):
    """A row of the table of peaks: the largest magnitude of a curve, and when."""
    time, values = run.history(name, quantity)
    curve = values[time <= (np.inf if until is None else until), AXES.index(axis)]
    at = int(np.nanargmax(abs(curve)))
    return {"run": run.label, "history": name, "axis": axis, f"peak [{UNITS[quantity]}]": f"{curve[at]:.5g}", "time [s]": f"{time[at]:.3f}"}


def write_peaks(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    p = run_file.parser(__doc__, "histories.png", over_time=True)
    p.add_argument("run", nargs="+", help="folder of a run, or LABEL=folder")
    p.add_argument("--show", nargs="+", metavar="NAME:AXIS", help="a panel each (default: all, along the axis that moves more)")
    p.add_argument("--quantity", choices=UNITS, default="displacement")
    p.add_argument("--limit", type=float, help="of the vertical axes, both ways; what is beyond is off the scale")
    p.add_argument("--peaks", metavar="FILE.csv", help="also write the peak of each curve as far as it is drawn, and when it is reached")
    a = p.parse_args()
    runs = [run_file.Run(argument) for argument in a.run]
    panels = wanted_panels(a.show, runs, a.quantity)
    ends = [0.0]
    figure, all_axes = run_file.panels(len(panels), a.width, sharex=True)
    for axes, (name, axis) in zip(all_axes, panels):
        for number, run in enumerate(runs):
            time, values = run.history(name, a.quantity)
            ends.append(time[-1])
            axes.plot(time, values[:, AXES.index(axis)], label=run.label, **run_file.style(number))
        axes.set_ylabel(f"{a.quantity} {axis}, {UNITS[a.quantity]}")
        axes.set_title(name, loc="left")
        if a.limit:
            axes.set_ylim(-a.limit, a.limit)
    all_axes[0].legend(ncols=min(4, len(runs)), loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2)
    run_file.time_axis(all_axes[-1], a.until, ends)
    run_file.save(figure, a.output)
    if a.peaks:
        write_peaks(a.peaks, [peak(run, name, axis, a.quantity, a.until) for name, axis in panels for run in runs])


if __name__ == "__main__":
    main()
