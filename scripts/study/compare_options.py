#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Two sets of options of a study: do their runs come from one distribution?

usage: compare_options.py TABLE.csv FIRST OTHER [OTHER ...]

Writes a table in Markdown: of each measure the median (and quartiles) with each set of options, and for each of the
others the Kolmogorov-Smirnov distance from FIRST with its p-value, the share of 20,000 random divisions of all runs
into two such sets that are as far apart or farther. The divisions have a fixed seed. Runs that are not done are left
out; an event that does not come in a run (a first fall) counts as later than any.
"""
import bisect
import csv
import math
import random
import sys

DIVISIONS = 20_000
MEASURES = [  # title, column or sum of columns, factor, whether a missing value is an event that never came
    ("fallen mass, %", ["fallen_mass_fraction"], 100.0, False),
    ("first fall, s", ["first_fallen_time"], 1.0, True),
    ("first crack, s", ["first_crack_time"], 1.0, True),
    ("collapse, s", ["collapse_time"], 1.0, True),
    ("broken segments", ["tension", "shear", "compression"], 1.0, False),
    ("peak drift", ["peak_drift"], 1.0, False),
    ("residual drift", ["residual_drift"], 1.0, False),
    ("peak base shear, N", ["peak_base_shear"], 1.0, False),
]


def value(run, columns, factor, event):
    cells = [run.get(c, "") for c in columns]
    if all(cells) and not any(math.isnan(float(c)) for c in cells):
        number = factor * sum(map(float, cells))
        return math.inf if event and number < 0 else number
    return math.inf if event else None


def distance(a, b):
    """Largest difference of the two shares of values up to any number."""
    a, b = sorted(a), sorted(b)
    return max(abs(bisect.bisect_right(a, x) / len(a) - bisect.bisect_right(b, x) / len(b)) for x in a + b)


def p_value(a, b):
    found, values, source = distance(a, b), a + b, random.Random(36)
    as_far = 0
    for _ in range(DIVISIONS):
        source.shuffle(values)
        as_far += distance(values[: len(a)], values[len(a) :]) >= found - 1e-12
    return found, (as_far + 1) / (DIVISIONS + 1)


def quantiles(values):
    ordered = sorted(values)
    at = lambda share: ordered[min(len(ordered) - 1, int(share * len(ordered)))]
    show = lambda x: "never" if math.isinf(x) else f"{x:.4g}"
    return f"{show(at(0.5))} ({show(at(0.25))} to {show(at(0.75))})"


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    names = sys.argv[2:]
    with open(sys.argv[1], newline="") as file:
        done = [run for run in csv.DictReader(file) if run["status"] == "done"]
    sets = [[run for run in done if run["options"] == name] for name in names]
    for name, runs in zip(names, sets):
        if not runs:
            sys.exit(f"{sys.argv[1]}: no run that is done has the options \"{name}\"")
    head = [f"{name}, {len(runs)} runs" for name, runs in zip(names, sets)] + [f"{name}: D, p" for name in names[1:]]
    print("| | " + " | ".join(head) + " |")
    print("|---" * (1 + len(head)) + "|")
    for title, columns, factor, event in MEASURES:
        samples = [[v for run in runs if (v := value(run, columns, factor, event)) is not None] for runs in sets]
        if not all(samples):
            continue
        tests = [p_value(list(samples[0]), list(other)) for other in samples[1:]]
        print(f"| {title} | " + " | ".join(quantiles(s) for s in samples) + " | " + " | ".join(f"{d:.2f}, {p:.2f}" for d, p in tests) + " |")


if __name__ == "__main__":
    main()
