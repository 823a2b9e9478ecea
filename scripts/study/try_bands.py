#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""How good are the bands and the dispersion of `fragility.py --all-records`? Tried on tables of drawn outcomes, whose truth is known.

usage: scripts/study/try_bands.py [TABLES]

Each record has a median of its own, lognormal about 1 with a dispersion of 0.35, and the house collapses at every level above it: eight levels
in equal ratios, over three ranges. Prints, for 5, 8 and 12 records: how many tables determine a curve (of TABLES, default 1,000), how many of
these have bands by run after all, in how many the 95 % band of the median contains 1, the same if all bands were by run, and the median
dispersion. Its random numbers have a fixed seed.
"""
import sys

import numpy as np

from fragility import fit

MEDIAN, DISPERSION, LEVELS = 1.0, 0.35, 8
RANGES = ((0.3, 3.0), (0.4, 2.5), (0.5, 2.0))


def contains(result):
    low, high = result.bands_of_95()[0]
    return low <= MEDIAN <= high


def tried(rng, records, levels, tables):
    fits = []
    for _ in range(tables):
        capacity = MEDIAN * np.exp(rng.normal(0.0, DISPERSION, records))
        x, of_record = np.tile(levels, records), np.repeat(np.arange(records), LEVELS)
        names = np.array([str(r) for r in of_record])
        reached = x > capacity[of_record]
        result, _ = fit(x, reached, names, "by record")
        if result:
            fits.append((result, fit(x, reached, np.full(len(x), ""))[0]))
    share = lambda values: 100.0 * np.mean(values)
    return (len(fits), sum(result.bands == "by run" for result, _ in fits), share([contains(result) for result, _ in fits]),
            share([contains(by_run) for _, by_run in fits]), np.median([result.dispersion for result, _ in fits]))


def main():
    tables = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    rng = np.random.default_rng(1)
    print("records,levels from,to,curves,bands by run,median in its band [%],by run [%],median dispersion")
    for records in (5, 8, 12):
        for low, high in RANGES:
            curves, by_run, inside, inside_by_run, dispersion = tried(rng, records, np.geomspace(low, high, LEVELS), tables)
            print(f"{records},{low},{high},{curves},{by_run},{inside:.1f},{inside_by_run:.1f},{dispersion:.3f}", flush=True)


if __name__ == "__main__":
    main()
