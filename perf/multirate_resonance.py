#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""When impulses of soft springs excite a stiff beam on a wall, and how a ring of bricks prevents it.

A chain of stiff springs (the elements of a wooden beam, which limit the step to 0.995 of 2/omega) lies on rows of
bricks with soft springs. The springs of the beam and of so many rows under it act in every step, the others in every
k-th with k times their impulse: the method of `time.multirate`, which has ring 2. Ring -1 is
the plain impulse method: each soft spring is slow, also that between beam and brick. Printed: the largest factor by
which a free motion grows in one of the small steps, less 1, and the share of random stiffnesses with which some
motion grows by more than mass damping takes (2 % at 6 Hz). usage: multirate_resonance.py
"""
import numpy as np

STEP = 5.0e-5  # s
DAMPED = 0.02 * 2 * np.pi * 6.05 * STEP / 2  # share of an amplitude that mass damping takes in a step


def stiffness(springs, count):
    k = np.zeros((count, count))
    for a, b, value in springs:
        for i, j, sign in ((a, a, 1), (b, b, 1), (a, b, -1), (b, a, -1)):
            if i >= 0 and j >= 0:
                k[i, j] += sign * value
    return k


def beam_on_wall(elements, rows, ring, scatter, random):
    """Springs by unit mass: of the beam, of the rows in its ring, of the others. Masses 1 (wood) and 0.6 to 1.7 (bricks)."""
    count = elements * (1 + rows)
    at = lambda row, i: (1 + row) * elements + i
    vary = lambda: 1.0 + scatter * random.uniform(-1, 1)
    stiff = [(i, i + 1, vary()) for i in range(elements - 1)]
    near, far = [], []
    for i in range(elements):
        below = i
        for row in range(rows):
            (near if row <= ring else far).append((below, at(row, i), vary()))
            if i + 1 < elements:
                (near if row < ring else far).append((at(row, i), at(row, i + 1), vary()))
            below = at(row, i)
        (near if rows <= ring else far).append((below, -1, vary()))
    mass = np.concatenate([np.ones(elements), random.uniform(0.6, 1.7, count - elements)])
    root = 1.0 / np.sqrt(np.outer(mass, mass))
    return [stiffness(springs, count) * root for springs in (stiff, near, far)]


def largest(k):
    """Highest frequency times the step."""
    return np.linalg.eigvalsh(k)[-1] ** 0.5 * STEP


def growth(fast, slow, every):
    """Largest |eigenvalue| of `every` small steps, as a factor of one of them."""
    n = len(fast)
    one, none = np.eye(n), np.zeros((n, n))
    kick = lambda k, h: np.block([[one, none], [-h * k, one]])
    drift = np.block([[one, STEP * one], [none, one]])
    cycle = np.eye(2 * n)
    for step in range(every):
        cycle = kick(fast, STEP) @ cycle
        if step == 0:
            cycle = kick(slow, every * STEP) @ cycle
        cycle = drift @ cycle
    return np.abs(np.linalg.eigvals(cycle)).max() ** (1.0 / every)


def main():
    print(f"taken by mass damping: {DAMPED:.1e} a step")
    print("| soft springs alone | ring | every 2 | 3 | 4 | grows at 2 | 3 | 4 |")
    print("|---|---|---|---|---|---|---|---|")
    tries = 100
    for share in (0.5, 0.25, 0.125):
        for ring in (-1, 0, 1, 2):
            random = np.random.default_rng(36)
            most, grows = np.zeros(5), np.zeros(5)
            for _ in range(tries):
                stiff, near, far = beam_on_wall(7, 6, ring, 0.3, random)
                stiff *= (1.99 / largest(stiff)) ** 2
                soft = (1.99 * share / largest(near + far)) ** 2
                near, far = soft * near, soft * far
                whole = (1.99 / largest(stiff + near + far)) ** 2
                for every in (2, 3, 4):
                    g = growth(whole * (stiff + near), whole * far, every) - 1.0
                    most[every] = max(most[every], g)
                    grows[every] += g > DAMPED
            cells = [f"omega dt {1.99 * share:.2f}", str(ring)] + [f"{most[k]:.1e}" for k in (2, 3, 4)]
            print("| " + " | ".join(cells + [f"{100 * grows[k] / tries:.0f} %" for k in (2, 3, 4)]) + " |", flush=True)


if __name__ == "__main__":
    main()
