#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws the energy of a run since the shaking began. Above: what came in (the work of ground and loads, and what gravity gave) and where
it went, losses and stores one above the other, so that a whole ledger shows no gap. Below: the residual of the ledger.

usage: scripts/plot_energy.py [LABEL=]DIR [-o energy.png]
"""

import numpy as np

import run_file

# Losses first, as they only grow; stores above them.
PARTS = {"damping": ("mass damping", "#56b4e9"), "dashpot": ("dashpots", "#0072b2"), "friction": ("friction", "#e69f00"),
         "fracture": ("fracture", "#d55e00"), "strain": ("strain", "#009e73"), "contact": ("contacts", "#cc79a7"),
         "kinetic": ("kinetic", "#999999")}


def main():
    p = run_file.parser(__doc__, "energy.png", over_time=True)
    p.add_argument("run", help="folder of a run, or LABEL=folder")
    a = p.parse_args()
    run = run_file.Run(a.run)
    energy = run.table("energy")
    start = int(np.searchsorted(energy["time"], 0.0))
    if start == len(energy["time"]):
        raise SystemExit(f"{run.label}: the shaking has not begun")
    kilo = {key: (values[start:] - values[start]) / 1000.0 for key, values in energy.items()}
    time = energy["time"][start:]

    figure, (axes, below) = run_file.panels(2, a.width, 5.5, sharex=True, gridspec_kw={"height_ratios": [4, 1]})
    axes.stackplot(time, *(kilo[key] for key in PARTS), labels=[word for word, _ in PARTS.values()],
                   colors=[colour for _, colour in PARTS.values()], linewidth=0)
    axes.plot(time, kilo["input"] - kilo["gravity"], color="black", label="ground and gravity")
    axes.plot(time, kilo["input"], color="black", linestyle="--", label="ground alone")
    axes.set_ylabel("energy, kJ")
    axes.set_title(run.label, loc="left")
    handles, words = axes.get_legend_handles_labels()
    axes.legend(handles[::-1], words[::-1], loc="upper left", bbox_to_anchor=(1.0, 1.0))  # in the order of the picture
    below.plot(time, energy["residual"][start:], color="black")
    below.set_ylabel("residual")
    below.set_ylim(bottom=0.0)
    run_file.time_axis(below, a.until, [0.0, time[-1]])
    run_file.save(figure, a.output)


if __name__ == "__main__":
    main()
