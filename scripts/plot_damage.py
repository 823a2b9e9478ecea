#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws the damage of runs over time, by mode, a panel for each run: percent of all segments that are open, by what opened them (tension,
shear, compression), one above the other; as a line those that hold but have slipped. With --first: percent that have failed, by the limit
that they reached first.

usage: scripts/plot_damage.py [--first] [LABEL=]DIR ... [-o damage.png]
"""

import numpy as np

import run_file

MODES = {"tension": "#d55e00", "shear": "#0072b2", "compression": "#555555"}


def main():
    p = run_file.parser(__doc__, "damage.png", over_time=True)
    p.add_argument("run", nargs="+", help="folder of a run, or LABEL=folder")
    p.add_argument("--first", action="store_true", help="by the limit reached first, not by what opened them")
    a = p.parse_args()
    prefix, verb = ("first_", "reached first") if a.first else ("", "opened by")
    runs = [run_file.Run(argument) for argument in a.run]
    ends = [0.0]
    figure, all_axes = run_file.panels(len(runs), a.width, sharex=True, sharey=True)
    for axes, run in zip(all_axes, runs):
        damage = run.table("damage")
        percent = 100.0 / np.maximum(1, sum(damage[key] for key in ("bonded", *MODES)))  # 1: a case without bonds
        counts = [damage[prefix + mode] * percent for mode in MODES]
        axes.stackplot(damage["time"], *counts, labels=[f"{verb} {mode}" for mode in MODES], colors=MODES.values(), linewidth=0)
        if not a.first:
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
