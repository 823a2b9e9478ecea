#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws capacity curves: base shear against the displacement of the control point, of quasi-static analyses; with --bilinear their
elastic-perfectly plastic forms (EC 8 dashed, NTC 2018 dotted). A cyclic test shows its loops: load factor against displacement of its forces.

usage: scripts/plot_capacity.py [LABEL=]DIR... [--bilinear] [-o capacity.png]
"""

import math

import numpy as np

import run_file


def base_shear(run):
    """Base shear along the push, N, as a running mean over a first period (io/MEASURES.md, Capacity)."""
    time, push = run.assessment.time, run.case["analysis"]["direction"]
    k = np.searchsorted(run.forces.time, np.asarray(time) - 1e-9)
    shear = -(np.asarray(run.forces.base_shear)[k, :2] @ push) / np.hypot(*push)
    step = time[1] - time[0] if len(time) > 1 else 1.0
    half = int(0.5 / run.file["assessment"].attrs["frequency"] / step + 1e-9)
    sums = np.concatenate([[0.0], np.cumsum(shear)])
    widths = np.minimum(half, np.minimum(np.arange(len(shear)), np.arange(len(shear))[::-1]))
    rows = np.arange(len(shear))
    return (sums[rows + widths + 1] - sums[rows - widths]) / (2 * widths + 1)


def bilinear(axes, capacity, code, dashes, colour):
    force, yield_, end = capacity[f"{code}_force"], capacity[f"{code}_yield"], capacity["ultimate_displacement"]
    end = capacity["peak_displacement"] if math.isnan(end) else end
    if not math.isnan(yield_):
        axes.plot([0.0, 1e3 * yield_, 1e3 * max(end, yield_)], [0.0, 1e-3 * force, 1e-3 * force], linestyle=dashes, color=colour)


def main():
    p = run_file.parser(__doc__, "capacity.png")
    p.add_argument("run", nargs="+", help="folder of a run, or LABEL=folder")
    p.add_argument("--bilinear", action="store_true", help="draw the bilinear forms, too")
    a = p.parse_args()
    figure, (axes,) = run_file.panels(1, a.width, 8.0)
    for number, name in enumerate(a.run):
        run = run_file.Run(name)
        if "assessment" not in run.file or not len(run.file["assessment/time"]):
            raise SystemExit(f"{run.label}: is no quasi-static analysis; it has no rows of assessment")
        rows, capacity = run.assessment, run.capacity
        style = run_file.style(number)
        if capacity.get("kind") == "cyclic":
            axes.plot(1e3 * rows.moved, rows.factor, label=run.label, **style)
            axes.set(xlabel="displacement of the forces, mm", ylabel="load factor")
            continue
        axes.plot(1e3 * rows.displacement, 1e-3 * base_shear(run), label=run.label, **style)
        axes.set(xlabel="displacement of the control point, mm", ylabel="base shear, kN")
        if a.bilinear and capacity:
            bilinear(axes, capacity, "ec8", "--", style["color"])
            bilinear(axes, capacity, "ntc", ":", style["color"])
    axes.legend(loc="best")
    run_file.save(figure, a.output)


if __name__ == "__main__":
    main()
