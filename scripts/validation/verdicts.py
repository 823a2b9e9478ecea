# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What has to hold for each wall beside its peak: the mode of failure, no loss of force that the tests have not, loops that centre themselves."""
import math

import measures

SLIDES, ROCKS = 0.6, 0.15  # shares of the top's displacement by slip
WATCHED = 0.02             # drift up to which a loss of force counts
CENTRED = 0.2              # share of the largest displacement that may remain when the force is gone
WORDS = {"R": "rocking", "SL": "sliding", "TC": "toe crushing"}


def modes_of_slip(slip):
    """Letters of a dry wall whose top moved by this share by slip."""
    return {"SL"} if slip > SLIDES else {"R"} if slip < ROCKS else {"R", "SL"}


def modes_of(failure):
    """Letters of one test; flexure of a dry wall is rocking."""
    return {"R" if letter.strip() == "F" else letter.strip() for letter in failure.split(",")}


def measured_modes(failures):
    """Number of tests with each letter."""
    counts = {}
    for failure in failures:
        for letter in modes_of(failure):
            counts[letter] = counts.get(letter, 0) + 1
    return counts


def in_words(letters):
    return " and ".join(WORDS[letter] for letter in ("R", "SL", "TC") if letter in letters)


def counts_in_words(counts, tests):
    return ", ".join(WORDS[k] + ("" if counts[k] == tests else f" ({counts[k]} of {tests})") for k in ("R", "SL", "TC") if k in counts)


def compare_modes(counts, tests, computed):
    """Compares modes of dry walls: modes of most tests that the run lacks, and modes of the run that no test has."""
    missing, beside = {k for k, n in counts.items() if 2 * n > tests} - computed, computed - set(counts)
    parts = ([f"no {in_words(missing)}"] if missing else []) + ([f"{in_words(beside)} as well"] if beside else [])
    return "yes" if not parts else ("**no**: " if missing else "partly: ") + ", ".join(parts)


def inner_mode(share):
    return "shear" if share > 0.5 else "flexure"


def mode(c):
    """Measured and computed modes, and whether they agree."""
    if not c.wall.bond:
        failures = list({row["test"].split(" ")[0]: row["failure"] for row in c.rows}.values())
        counts, tests, computed = measured_modes(failures), len(failures), modes_of_slip(c.slip)
        return counts_in_words(counts, tests), in_words(computed), compare_modes(counts, tests, computed)
    measured = c.rows[0]["failure"]
    to_peak, to_end = c.run.inner_share(c.run.time_of_peak()), c.run.inner_share()
    at_peak, at_end = (inner_mode(to_end if math.isnan(share) else share) for share in (to_peak, to_end))
    computed = at_peak if at_peak == at_end else f"{at_peak}, then {at_end}"
    verdict = "yes" if at_peak == at_end == measured else "up to the peak" if at_peak == measured else "beyond the peak alone" if at_end == measured else "**no**"
    return measured, computed, verdict


def before(drift):
    return not math.isnan(drift) and drift < WATCHED


def losses(c):
    """Drifts of the first loss of a fifth before WATCHED: of the tests with a curve, and of the run."""
    height = c.wall.lever_height
    tests = [way.first_drop / height for u, f in c.curves.values() for way in measures.both_ways(u, f) if len(way.displacement) > 2]
    run = [c.first_drop(way) / height for way in c.ways]
    return [d for d in tests if before(d)], [d for d in run if before(d)]


def loss(c):
    """The loss in words; brick walls, which are pushed to 0.5 %, have no requirement."""
    if c.wall.bond:
        return "–"
    tests, run = losses(c)
    if not run:
        return "none" + (f"; {len(tests)} of the tests' curves have one" if tests else "")
    return f"at {100 * min(run):.1f} %" + (", as in tests" if tests else ": **miss**")


def centred(c):
    """Self-centring in words, for walls under cyclic loading."""
    if not c.wall.cyclic:
        return "–"
    share = c.residual_share
    said = f"{100 * share:.0f} % remains"
    return said if c.wall.bond else said + (": yes" if share <= CENTRED else ": **miss**")


def table(found):
    lines = ["## What else has to hold", "",
             "| wall | failure, measured | computed | the same | loss of a fifth of the force before 2 % drift | self-centring |",
             "|---|---|---|---|---|---|"]
    for c in found:
        lines.append(f"| {c.wall.name} | " + " | ".join([*mode(c), loss(c), centred(c)]) + " |")
    return lines
