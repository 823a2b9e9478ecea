#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""When impulses of soft springs excite stiff beams in a wall, and how rings of bricks prevent it.

One-dimensional models of a wall of bricks with a lintel (springs that limit the step to 0.995 of 2/omega) in one course
and, in the second part, a roof beam on top (springs that allow twice that step). Random stiffnesses and masses. A spring
acts in every step, in every second, or in every k-th, with the impulse of as many: the method of `time.multirate`
(kernels/THEORY.md (24a)). Each element has the longest step that its own springs allow; with ring n an element up to n
springs away from one with a shorter step has that one's. A spring has the shorter step of its two elements; in ring -1
(the plain impulse method) the longer one. Printed: the largest factor by which a free motion grows in one of the small
steps, less 1, and the share of models with a motion that grows by more than mass damping takes (2 % at 6 Hz).
usage: multirate_resonance.py
"""
import numpy as np

STEP = 5.0e-5  # s
DAMPED = 0.02 * 2 * np.pi * 6.05 * STEP / 2  # share of an amplitude that mass damping takes in a step
WIDTH, TRIES = 7, 100
LIMIT = 1.99  # omega times the step of the fastest


class Wall:
    """`courses`: of each, "brick", "lintel" or "beam", from the base upwards."""

    def __init__(self, courses, random):
        count = WIDTH * len(courses)
        vary = lambda: 1.0 + 0.3 * random.uniform(-1, 1)
        at = lambda row, i: row * WIDTH + i
        self.kind = [kind for kind in courses for _ in range(WIDTH)]
        self.springs = []  # (a, b, stiffness, kind); b = -1: the base
        for row, kind in enumerate(courses):
            for i in range(WIDTH):
                self.springs.append((at(row, i), at(row - 1, i) if row else -1, vary(), "brick"))
                if i + 1 < WIDTH:
                    self.springs.append((at(row, i), at(row, i + 1), vary(), kind))
        mass = np.array([1.0 if kind != "brick" else random.uniform(0.6, 1.7) for kind in self.kind])
        self.root = 1.0 / np.sqrt(np.outer(mass, mass))

    def matrix(self, springs):
        k = np.zeros_like(self.root)
        for a, b, value, _ in springs:
            for i, j, sign in ((a, a, 1), (b, b, 1), (a, b, -1), (b, a, -1)):
                if i >= 0 and j >= 0:
                    k[i, j] += sign * value
        return k * self.root

    def largest(self, *kinds):
        """Highest frequency of these springs alone, times the step."""
        return np.linalg.eigvalsh(self.matrix([s for s in self.springs if s[3] in kinds]))[-1] ** 0.5 * STEP

    def scale(self, kind, beside, wanted):
        """Makes springs of that kind so stiff that the highest frequency of these and those `beside` them is as wanted."""
        low, high, springs = 0.0, 1e12, self.springs
        while high - low > 1e-6 * high:
            factor = 0.5 * (low + high) if low > 0.0 or high < 1e3 else 1e-3 * high
            self.springs = [(a, b, v * factor if k == kind else v, k) for a, b, v, k in springs]
            low, high = (factor, high) if self.largest(kind, *beside) < wanted else (low, factor)

    def levels(self, own, rings):
        level = np.array([own[kind] for kind in self.kind])
        for _ in range(max(rings, 0)):
            inside = level.copy()
            for a, b, *_ in self.springs:
                if b >= 0:
                    level[a], level[b] = min(level[a], inside[b]), min(level[b], inside[a])
        lower = min if rings >= 0 else max
        stiff = lambda kind: rings < 0 and kind != "brick"
        return [own[k] if stiff(k) else lower(level[a], level[b]) if b >= 0 else level[a] for a, b, _, k in self.springs]

    def growth(self, every, own, rings):
        """Largest |eigenvalue| of a cycle, as a factor of one of its steps. `every`: by level, its steps."""
        levels = self.levels(own, rings)
        by_level = [self.matrix([s for s, l in zip(self.springs, levels) if l == level]) for level in range(len(every))]
        n = len(self.root)
        one, none = np.eye(n), np.zeros((n, n))
        kick = lambda k, h: np.block([[one, none], [-h * k, one]])
        drift = np.block([[one, STEP * one], [none, one]])
        cycle = np.eye(2 * n)
        for step in range(every[-1]):
            for level, steps in enumerate(every):
                if step % steps == 0:
                    cycle = kick(by_level[level], steps * STEP) @ cycle
            cycle = drift @ cycle
        return np.abs(np.linalg.eigvals(cycle)).max() ** (1.0 / every[-1])


def table(heading, columns, rows, wall_of):
    """`columns`: (title, steps by level, own levels). `rows`: (share of the bricks, rings)."""
    print(f"\n{heading}\n")
    titles = [title for title, *_ in columns]
    print("| bricks alone, omega dt | ring | " + " | ".join(f"worst at {t}" for t in titles) + " | " +
          " | ".join(f"grow at {t}" for t in titles) + " |")
    print("|---" * (2 + 2 * len(columns)) + "|")
    for share, rings in rows:
        random = np.random.default_rng(36)
        most, grows = [0.0] * len(columns), [0] * len(columns)
        for _ in range(TRIES):
            wall = wall_of(share, random)
            for c, (_, every, own) in enumerate(columns):
                g = wall.growth(every, own, rings) - 1.0
                most[c], grows[c] = max(most[c], g), grows[c] + (g > DAMPED)
        print(f"| {LIMIT * share:.2f} | {rings} | " + " | ".join(f"{m:.1e}" for m in most) + " | " +
              " | ".join(f"{100 * g / TRIES:.0f} %" for g in grows) + " |", flush=True)


def lintel_on_top(share, random):
    wall = Wall(6 * ["brick"] + ["lintel"], random)
    wall.scale("brick", [], LIMIT * share)
    wall.scale("lintel", ["brick"], LIMIT)
    return wall


def lintel_and_beam(between):
    """So many courses between the lintel and the beam on top."""

    def wall_of(share, random):
        wall = Wall(3 * ["brick"] + ["lintel"] + between * ["brick"] + ["beam"], random)
        wall.scale("brick", [], LIMIT * share)
        wall.scale("beam", ["brick"], LIMIT * 0.5)
        wall.scale("lintel", ["beam", "brick"], LIMIT)
        return wall

    return wall_of


def main():
    print(f"taken by mass damping: {DAMPED:.1e} a step")
    two = {"lintel": 0, "brick": 1}
    rows = [(share, ring) for share in (0.5, 0.25, 0.125) for ring in (-1, 0, 1, 2)]
    table("Two rates: a lintel on six courses", [(str(k), (1, k), two) for k in (2, 3, 4)], rows, lintel_on_top)
    three = {"lintel": 0, "beam": 1, "brick": 2}
    for between in (1, 2, 3, 5):
        table(f"Steps of 1, 2 and 4: a lintel, {between} courses, a beam", [("1, 2, 4", (1, 2, 4), three), ("1, 4", (1, 4), {**three, "beam": 0, "brick": 1})],
              [(0.25, ring) for ring in (-1, 0, 1, 2)], lintel_and_beam(between))


if __name__ == "__main__":
    main()
