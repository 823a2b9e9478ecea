# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Random models across the plane of x and z, equally thick along y. Stones are about 1 high, and stand on z = 0."""
import math

from shapes import Load, Model, across, upright_box


def course(rng, length, kind, number, stone):
    """Positions of the head joints of a course, ends included."""
    count = max(1, round(length / stone))
    stone = length / count
    if kind == "whole":
        return [i * stone for i in range(count + 1)]
    if kind == "half":
        shift = 0.5 * stone if number % 2 else 0.0
        return [0.0] + [x for x in (i * stone - shift for i in range(count + 2)) if 1e-3 < x < length - 1e-3] + [length]
    cuts = [0.0]
    while cuts[-1] < length - 1.3 * stone:
        cuts.append(cuts[-1] + stone * rng.uniform(0.5, 1.3))
    return cuts + [length]


def boxes(name, cuts, low, high, z0, z1):
    """A course along x."""
    return [upright_box(f"{name}_{i}", (a, low, z0), (b, high, z1)) for i, (a, b) in enumerate(zip(cuts, cuts[1:]))]


def heavy_top(rng, model, top, length, low, high, z):
    """A beam, loads on the upper stones, or nothing."""
    choice = rng.choice(["beam", "loads", "nothing"])
    if choice == "beam":
        model.density["beam"] = round(rng.uniform(500.0, 15000.0))
        model.blocks.append(upright_box("beam", (0.0, low, z), (length, high, z + rng.uniform(0.5, 2.0)), "beam"))
        if rng.random() < 0.5:
            model.between.append(("beam", "stone", round(rng.uniform(15.0, 45.0), 2)))
    elif choice == "loads":
        for block in rng.sample(top, min(len(top), rng.randint(1, 3))):
            model.loads.append(Load(block.name, (rng.uniform(-0.05, 0.05), 0.0, -rng.uniform(0.5, 5.0))))


def wall(rng):
    length, thickness, stone = rng.uniform(2.0, 8.0), rng.uniform(0.5, 2.0), rng.uniform(1.0, 3.0)
    rows, kind = rng.randint(1, 8), rng.choice(["whole", "half", "half", "unequal"])
    model, z = Model("wall", [], plane=True), 0.0
    for number in range(rows):
        height = rng.uniform(0.7, 1.3) if kind == "unequal" else 1.0
        top = boxes(f"c{number}", course(rng, length, kind, number, stone), 0.0, thickness, z, z + height)
        model.blocks += top
        z += height
    heavy_top(rng, model, top, length, 0.0, thickness, z)
    return model


def tower(rng):
    """A stack of blocks, each a little beside the one below."""
    model, x, z, thickness = Model("tower", [], plane=True), 0.0, 0.0, rng.uniform(0.5, 2.0)
    for i in range(rng.randint(1, 10)):
        width, height = rng.uniform(0.8, 2.5), rng.uniform(0.3, 1.5)
        x += rng.uniform(-0.35, 0.35)
        model.blocks.append(upright_box(f"t{i}", (x - width / 2, 0.0, z), (x + width / 2, thickness, z + height)))
        z += height
    return model


def steps(rng):
    """A stair in the air, with a heavy block at its tail or without."""
    model, n, shift, length = Model("steps", [], plane=True), rng.randint(2, 7), rng.uniform(0.05, 0.6), rng.uniform(1.5, 3.0)
    for i in range(n):
        model.blocks.append(upright_box(f"s{i}", (i * shift, 0.0, 0.5 * i), (i * shift + length, 1.0, 0.5 * i + 0.5)))
    if rng.random() < 0.7:
        tail = n * shift - shift
        model.density["heavy"] = round(rng.uniform(2000.0, 20000.0))
        model.blocks.append(upright_box("tail", (tail, 0.0, 0.5 * n), (tail + 0.3 * length, 1.0, 0.5 * n + 1.0), "heavy"))
    return model


def angles(rng, a, b, n):
    """n parts from a to b, equal or not."""
    weights = [1.0 if rng.random() < 0.5 else rng.uniform(0.6, 1.4)] * n
    if rng.random() < 0.4:
        weights = [rng.uniform(0.6, 1.4) for _ in range(n)]
    at = [a]
    for w in weights:
        at.append(at[-1] + (b - a) * w / sum(weights))
    return at[:-1] + [b]


def on_circle(x, r, angle):
    return (x + r * math.cos(angle), 0.0 if angle in (0.0, math.pi) else r * math.sin(angle))


def ring(name, centre, inner, outer, at, y0, y1, lift=0.0):
    """Voussoirs with plane faces between radial joints at angles `at`."""
    out = []
    for i, (a, b) in enumerate(zip(at, at[1:])):
        section = [on_circle(centre, inner, a), on_circle(centre, outer, a), on_circle(centre, outer, b), on_circle(centre, inner, b)]
        out.append(across(f"{name}{i}", [(x, z + lift) for x, z in section], y0, y1))
    return out


def round_arch(rng):
    r, depth = rng.uniform(3.0, 8.0), rng.uniform(0.5, 2.0)
    t = r * rng.uniform(0.09, 0.35)
    stones = ring("v", 0.0, r - t / 2, r + t / 2, angles(rng, 0.0, math.pi, rng.randint(4, 27)), 0.0, depth)
    if rng.random() < 0.5:
        return Model("round arch", stones, plane=True)
    stones[0].fixed = stones[-1].fixed = True
    return Model("round arch", stones, plane=True, base=None)


def segmental_arch(rng):
    r, depth, half = rng.uniform(3.0, 10.0), rng.uniform(0.5, 2.0), math.radians(rng.uniform(25.0, 75.0))
    t = r * rng.uniform(0.02, 0.2)
    at = angles(rng, math.pi / 2 - half, math.pi / 2 + half, rng.randint(5, 21))
    stones = ring("v", 0.0, r - t / 2, r + t / 2, at, 0.0, depth)
    stones[0].fixed = stones[-1].fixed = True
    return Model("segmental arch", stones, plane=True, base=None)


def pointed_arch(rng):
    """Two arcs whose centres lie beyond the axis; they meet in an upright joint."""
    r, depth, n = rng.uniform(3.0, 6.0), rng.uniform(0.5, 2.0), rng.randint(3, 12)
    t, c = r * rng.uniform(0.08, 0.3), r * rng.uniform(0.1, 0.6)
    inner, outer = r - t / 2, r + t / 2
    lowest = min(math.acos(c / inner), math.acos(c / outer))
    at = angles(rng, 0.0, lowest * (1.0 - 0.7 / n), n)
    last = at[-1]
    right = ring("r", -c, inner, outer, at, 0.0, depth)
    apex = [on_circle(-c, inner, last), on_circle(-c, outer, last), (0.0, math.sqrt(outer**2 - c**2)), (0.0, math.sqrt(inner**2 - c**2))]
    right.append(across(f"r{n}", apex, 0.0, depth))
    left = [across("l" + b.name[1:], [(-x, z) for x, y, z in b.vertices if y == 0.0], 0.0, depth) for b in right]
    return Model("pointed arch", right + left, plane=True)


def arch_on_piers(rng):
    """A round arch on piers of boxes, which may be wider than the arch."""
    r, depth = rng.uniform(3.0, 6.0), rng.uniform(0.5, 2.0)
    t = r * rng.uniform(0.12, 0.35)
    inner, outer, z, blocks = r - t / 2, r + t / 2, 0.0, []
    wide = outer + rng.choice([0.0, rng.uniform(0.0, 3.0)])
    for k in range(rng.randint(1, 5)):
        height = rng.uniform(0.5, 1.5)
        for side, (a, b) in (("l", (-wide, -inner)), ("r", (inner, wide))):
            blocks.append(upright_box(f"p{side}{k}", (a, 0.0, z), (b, depth, z + height)))
        z += height
    stones = ring("v", 0.0, inner, outer, angles(rng, 0.0, math.pi, rng.randint(5, 21)), 0.0, depth, z)
    model = Model("arch on piers", blocks + stones, plane=True)
    if rng.random() < 0.4:
        model.loads.append(Load(rng.choice(stones[1:-1]).name, (0.0, 0.0, -rng.uniform(0.1, 1.0))))
    return model


def flat_arch(rng):
    """A lintel of wedges between fixed abutments."""
    n, width, height, lean = rng.randint(3, 11), rng.uniform(3.0, 8.0), rng.uniform(0.8, 2.0), rng.uniform(0.1, 0.6)
    low = [width * (i / n - 0.5) for i in range(n + 1)]
    high = [x * (1.0 + lean) for x in low]
    stones = [across(f"w{i}", [(low[i], 0.0), (low[i + 1], 0.0), (high[i + 1], height), (high[i], height)], 0.0, 1.0) for i in range(n)]
    end = high[-1] + 1.0
    stones.append(across("right", [(low[-1], 0.0), (end, 0.0), (end, height), (high[-1], height)], 0.0, 1.0, fixed=True))
    stones.append(across("left", [(-end, 0.0), (low[0], 0.0), (high[0], height), (-end, height)], 0.0, 1.0, fixed=True))
    return Model("flat arch", stones, plane=True, base=None)


def slope(rng):
    """Blocks with inclined beds, on a fixed wedge."""
    lean, width, z = rng.uniform(-0.5, 0.5), rng.uniform(1.0, 2.5), 1.0
    sloped = lambda name, z0, z1, lean0, lean1, **more: across(
        name, [(0.0, z0), (width, z0 + lean0 * width), (width, z1 + lean1 * width), (0.0, z1)], 0.0, 1.0, **more)
    foot = min(0.0, lean * width) - 1.0
    blocks = [across("wedge", [(0.0, foot), (width, foot), (width, z + lean * width), (0.0, z)], 0.0, 1.0, fixed=True)]
    for i in range(rng.randint(1, 6)):
        height, next_lean = rng.uniform(0.6, 1.5), lean + rng.uniform(-0.1, 0.1)
        blocks.append(sloped(f"b{i}", z, z + height, lean, next_lean))
        z, lean = z + height, next_lean
    return Model("slope", blocks, plane=True, base=None)


def notched(rng):
    """Stones that are not convex: a portal on two blocks, and one with an arm."""
    model, z, x, depth = Model("notched stones", [], plane=True), 0.0, 0.0, rng.uniform(0.5, 1.5)

    def stone(name, outline, pieces):
        model.outlines.append(across(name, outline, 0.0, depth))
        for i, (x0, x1, z0, z1) in enumerate(pieces):
            model.blocks.append(upright_box(f"{name}_{i}", (x0, 0.0, z0), (x1, depth, z1)))
            model.blocks[-1].stone = name

    first = rng.random() < 0.6
    if first:
        leg, span, foot, low, top = rng.uniform(0.5, 1.0), rng.uniform(1.0, 2.5), rng.uniform(0.5, 1.5), rng.uniform(0.3, 1.5), rng.uniform(0.3, 0.8)
        ends = (0.0, leg, leg + span, 2 * leg + span)
        for name, (a, b) in (("l", ends[:2]), ("r", ends[2:])):
            model.blocks.append(upright_box(name, (a, 0.0, 0.0), (b + rng.uniform(-0.2, 0.2), depth, foot)))
        z0, z1, z = foot, foot + low, foot + low + top
        stone("portal", [(0.0, z0), (leg, z0), (leg, z1), (ends[2], z1), (ends[2], z0), (ends[3], z0), (ends[3], z), (0.0, z)],
              [(0.0, leg, z0, z1), (ends[2], ends[3], z0, z1), (0.0, ends[3], z1, z)])
        x = rng.uniform(0.0, span)
    if not first or rng.random() < 0.6:
        width, height, arm, thick = rng.uniform(0.6, 1.2), rng.uniform(1.0, 2.0), rng.uniform(0.3, 1.2), rng.uniform(0.2, 0.6)
        end, under, top = x + width, z + height - thick, z + height
        stone("arm", [(x, z), (end, z), (end, under), (end + arm, under), (end + arm, top), (x, top)],
              [(x, end, z, top), (end, end + arm, under, top)])
        if rng.random() < 0.5:
            model.blocks.append(upright_box("on_top", (x + 0.1, 0.0, top), (end + arm * rng.uniform(0.0, 1.2), depth, top + 0.5)))
    return model


KINDS = (wall, wall, tower, steps, round_arch, segmental_arch, pointed_arch, arch_on_piers, flat_arch, slope, notched)
