#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws the energy of a run since the shaking began. Above: what came in (the work of ground and loads, and what gravity gave) and where
it went, losses and stores one above the other, so that a whole ledger shows no gap. Below: the residual of the ledger.

usage: scripts/plot_energy.py [LABEL=]DIR [-o energy.png]
"""

import run_file
from voussoir import plots


def main():
    p = run_file.parser(__doc__, "energy.png", over_time=True)
    p.add_argument("run", help="folder of a run, or LABEL=folder")
    a = p.parse_args()
    with run_file.or_exit():
        run_file.save(plots.energy(run_file.Run(a.run), until=a.until, width=a.width), a.output)


if __name__ == "__main__":
    main()
