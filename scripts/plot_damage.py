#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws the damage of runs over time, by mode, a panel for each run: percent of all segments broken in tension, shear and compression, one
above the other, and as a line those that hold but have slipped.

usage: scripts/plot_damage.py [LABEL=]DIR ... [-o damage.png]
"""

import numpy as np

import run_file

MODES = {"tension": "#d55e00", "shear": "#0072b2", "compression": "#555555"}


def main():
    p = run_file.parser(__doc__, "damage.png", over_time=True)
    p.add_argument("run", nargs="+", help="folder of a run, or LABEL=folder")
    a = p.parse_args()
    runs = [run_file.Run(argument) for argument in a.run]
    ends = [0.0]
    figure, all_axes = run_file.panels(len(runs), a.width, sharex=True, sharey=True)
    for axes, run in zip(all_axes, runs):
        damage = run.table("damage")
        percent = 100.0 / np.maximum(1, sum(damage[key] for key in ("bonded", *MODES)))  # 1: a case without bonds
        axes.stackplot(damage["time"], *(damage[mode] * percent for mode in MODES), labels=MODES, colors=MODES.values(), linewidth=0)
        axes.plot(damage["time"], damage["slipped"] * percent, color="black", linestyle="--", label="slipped, holds")
        axes.set_ylabel("% of segments")
        ends.append(damage["time"][-1])
        axes.set_title(run.label, loc="left")
    all_axes[0].legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=4, borderaxespad=0.2)
    all_axes[0].set_ylim(bottom=0.0)  # all share it; earlier, it would stop the scale from growing
    run_file.time_axis(all_axes[-1], a.until, ends)
    run_file.save(figure, a.output)


if __name__ == "__main__":
    main()
