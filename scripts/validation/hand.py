# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Peak forces of a wall by hand: formulas of codes, with the same data that its case has."""
import math


def rocking(load, length, thickness, span, strength):
    """N: the wall turns about a toe with a rectangular block of 0.85 f_c."""
    return 0.5 * load * length / span * (1.0 - load / (0.85 * strength * length * thickness))


def sliding(load, friction):
    """N: a bed without bond slides."""
    return friction * load


def cracked_sliding(load, length, thickness, span, cohesion, friction):
    """N: the compressed part of the base slides, stress being linear over it; all of the base where it is compressed."""
    force = (1.5 * cohesion * length * thickness + friction * load) / (1.0 + 3.0 * cohesion * thickness * span / load)
    whole = cohesion * length * thickness + friction * load
    return whole if force * span / load <= length / 6.0 else force


def diagonal(load, length, thickness, height, shear):
    """N: the middle cracks along its diagonal, after Turnšek and Čačović, with f_t = 1.5 τ0."""
    tension, form = 1.5 * shear, min(1.5, max(1.0, height / length))
    return length * thickness * tension / form * math.sqrt(1.0 + load / (length * thickness * tension))


def formulas(stone):
    """(words, N) of each formula that fits the wall."""
    w = stone.wall
    load = w.load + w.weight
    out = [("rocking with toe", rocking(load, w.length, w.thickness, w.shear_span, stone.strength))]
    if stone.dry:
        return out + [("sliding", sliding(load, w.friction))]
    return out + [("sliding of the cracked base", cracked_sliding(load, w.length, w.thickness, w.shear_span, w.bond["cohesion"], w.friction)),
                  ("diagonal cracks", diagonal(load, w.length, w.thickness, w.height, stone.shear))]


def least(stone):
    return min(formulas(stone), key=lambda f: f[1])
