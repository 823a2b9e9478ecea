#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Two sets of options of a study: do their runs come from one distribution?

usage: compare_options.py TABLE.csv FIRST OTHER [OTHER ...]

Writes a table in Markdown: of each measure the median (and quartiles) with each set of options, and for each of the
others the Kolmogorov-Smirnov distance from FIRST with its p-value: the share of 20,000 random ways to make two such sets
of all runs that are as far apart or farther. "by seed": both have the same seeds (of the same cases, directions, records,
scales and levels), so the two runs of each seed change places or not; "divided": they have not, and all runs are divided anew.
The ways have a fixed seed. Runs that are not done are left out; an event that does not come in a run (a first fall)
counts as later than any.
"""
import bisect
import csv
import math
import random
import sys

WAYS = 20_000
PLACE = ("case", "direction", "record", "scale", "intensity", "level", "seed")
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


def known(values):
    return [v for v in values if v is not None]


def distance(a, b):
    """Largest difference of the cumulative shares of two samples (Kolmogorov-Smirnov distance); 0 if one is empty."""
    a, b = sorted(known(a)), sorted(known(b))
    if not a or not b:
        return 0.0
    return max(abs(bisect.bisect_right(a, x) / len(a) - bisect.bisect_right(b, x) / len(b)) for x in a + b)


def place(run):
    return tuple(run.get(column, "") for column in PLACE)


def same_seeds(runs, others):
    """Whether two sets have the same places in the study, each once."""
    places, of_others = sorted(map(place, runs)), sorted(map(place, others))
    return places == of_others and len(set(places)) == len(places)


def exchanged(a, b):
    """a and b side by side: the two values of each seed exchanged at random."""
    source = random.Random(36)
    for _ in range(WAYS):
        pairs = [(x, y) if source.random() < 0.5 else (y, x) for x, y in zip(a, b)]
        yield zip(*pairs)


def divided(a, b):
    """All values divided at random into two sets of the sizes of a and b."""
    size, values, source = len(known(a)), known(a) + known(b), random.Random(36)
    for _ in range(WAYS):
        source.shuffle(values)
        yield values[:size], values[size:]


def p_value(a, b, ways):
    found = distance(a, b)
    as_far = sum(distance(*way) >= found - 1e-12 for way in ways(a, b))
    return found, (as_far + 1) / (WAYS + 1)


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
    sets = [sorted((run for run in done if run["options"] == name), key=place) for name in names]
    for name, runs in zip(names, sets):
        if not runs:
            sys.exit(f"{sys.argv[1]}: no run that is done has the options \"{name}\"")
    by_seed = [same_seeds(sets[0], other) for other in sets[1:]]
    head = [f"{name}, {len(runs)} runs" for name, runs in zip(names, sets)]
    head += [f"{name}: D, p ({'by seed' if same else 'divided'})" for name, same in zip(names[1:], by_seed)]
    print("| | " + " | ".join(head) + " |")
    print("|---" * (1 + len(head)) + "|")
    for title, columns, factor, event in MEASURES:
        samples = [[value(run, columns, factor, event) for run in runs] for runs in sets]
        if not all(map(known, samples)):
            continue
        tests = [p_value(samples[0], other, exchanged if same else divided) for other, same in zip(samples[1:], by_seed)]
        print(f"| {title} | " + " | ".join(quantiles(known(s)) for s in samples) + " | " + " | ".join(f"{d:.2f}, {p:.2f}" for d, p in tests) + " |")


if __name__ == "__main__":
    main()
