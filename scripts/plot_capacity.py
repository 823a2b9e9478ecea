#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws capacity curves: base shear against the displacement of the control point, of quasi-static analyses; with --bilinear their
elastic-perfectly plastic forms (EC 8 dashed, NTC 2018 dotted). A cyclic test shows its loops: load factor against displacement of its forces.

usage: scripts/plot_capacity.py [LABEL=]DIR... [--bilinear] [-o capacity.png]
"""

import run_file
from voussoir import plots


def main():
    p = run_file.parser(__doc__, "capacity.png")
    p.add_argument("run", nargs="+", help="folder of a run, or LABEL=folder")
    p.add_argument("--bilinear", action="store_true", help="draw the bilinear forms, too")
    a = p.parse_args()
    with run_file.or_exit():
        run_file.save(plots.capacity([run_file.Run(name) for name in a.run], bilinear=a.bilinear, width=a.width), a.output)


if __name__ == "__main__":
    main()
