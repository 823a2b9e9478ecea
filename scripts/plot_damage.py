#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws the damage of runs over time, by mode, a panel for each run: percent of all segments that are open, by what opened them (tension,
shear, compression), one above the other; as a line those that hold but have slipped. With --first: percent that have failed, by the limit
that they reached first.

usage: scripts/plot_damage.py [--first] [LABEL=]DIR ... [-o damage.png]
"""

import run_file
from voussoir import plots


def main():
    p = run_file.parser(__doc__, "damage.png", over_time=True)
    p.add_argument("run", nargs="+", help="folder of a run, or LABEL=folder")
    p.add_argument("--first", action="store_true", help="by the limit reached first, not by what opened them")
    a = p.parse_args()
    runs = [run_file.Run(argument) for argument in a.run]
    with run_file.or_exit():
        run_file.save(plots.damage(runs, first=a.first, until=a.until, width=a.width), a.output)


if __name__ == "__main__":
    main()
