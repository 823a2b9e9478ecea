# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Random models in space. Stones are about 1 high, and stand on z = 0 unless a block is fixed."""
import math

from plane_kinds import angles, arch_on_piers, boxes, course, heavy_top, ring, round_arch, tower, wall
from shapes import Load, Model, between_loops, standing, turned, unit, upright_box


def along_y(name, cuts, x0, x1, z0, z1):
    return [upright_box(f"{name}_{i}", (x0, a, z0), (x1, b, z1)) for i, (a, b) in enumerate(zip(cuts, cuts[1:]))]


def corner_wall(rng):
    """Two legs of one leaf that are toothed at the corner."""
    t, long, wide, stone = rng.uniform(0.6, 1.2), rng.uniform(2.5, 5.0), rng.uniform(1.5, 4.0), rng.uniform(1.2, 2.2)
    model, top = Model("corner wall", []), []
    kind = rng.choice(["half", "unequal"])
    for k in range(rng.randint(1, 5)):
        start = 0.0 if k % 2 == 0 else t
        top = boxes(f"x{k}", [start + x for x in course(rng, long - start, kind, k, stone)], 0.0, t, k, k + 1.0)
        begin = t - start
        top += along_y(f"y{k}", [begin + y for y in course(rng, wide - begin, kind, k, stone)], 0.0, t, k, k + 1.0)
        model.blocks += top
    if rng.random() < 0.4:
        model.loads.append(Load(rng.choice(top).name, (rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), -rng.uniform(0.2, 3.0))))
    return model


def two_leaves(rng):
    """Two leaves with bonders through both, a return at one end or none."""
    t, long, stone = rng.uniform(0.5, 1.0), rng.uniform(2.5, 4.5), rng.uniform(1.2, 2.2)
    model = Model("two leaves", [])
    rows, back = rng.randint(1, 5), rng.choice([0.0, rng.uniform(1.0, 2.5)])
    for k in range(rows):
        start = t if back and k % 2 else 0.0
        if k % rng.choice([2, 3]) == 1:
            model.blocks += boxes(f"bond{k}", [start + x for x in course(rng, long - start, "unequal", k, stone)], 0.0, 2 * t, k, k + 1.0)
        else:
            for leaf in (0, 1):
                cuts = [start + x for x in course(rng, long - start, rng.choice(["half", "unequal"]), k + leaf, stone)]
                model.blocks += boxes(f"leaf{leaf}c{k}", cuts, leaf * t, (leaf + 1) * t, k, k + 1.0)
        if back:
            begin = 0.0 if start else 2 * t
            model.blocks += along_y(f"back{k}", [begin + y for y in course(rng, 2 * t + back - begin, "half", k, stone)], 0.0, t, k, k + 1.0)
    if rng.random() < 0.4:
        heavy_top(rng, model, model.blocks[-2:], long, 0.0, 2 * t, float(rows))
    return model


def buttress(rng):
    """A wall with a buttress that steps back, toothed or only beside it."""
    t, half, stone, rows = rng.uniform(0.6, 1.2), rng.uniform(1.2, 2.5), rng.uniform(1.2, 2.0), rng.randint(2, 5)
    model, out, toothed = Model("buttress", []), rng.uniform(1.0, 3.0), rng.random() < 0.6
    for k in range(rows):
        reach = t + out * (1.0 - 0.8 * k / rows)
        if toothed and k % 2:
            model.blocks += boxes(f"l{k}", [-half, -t / 2], 0.0, t, k, k + 1.0) + boxes(f"r{k}", [t / 2, half], 0.0, t, k, k + 1.0)
            model.blocks += along_y(f"b{k}", [0.0, reach], -t / 2, t / 2, k, k + 1.0)
        else:
            model.blocks += boxes(f"w{k}", [x - half for x in course(rng, 2 * half, "half", k, stone)], 0.0, t, k, k + 1.0)
            model.blocks += along_y(f"b{k}", [t + y for y in course(rng, reach - t, "half", k, stone)], -t / 2, t / 2, k, k + 1.0)
    return model


def opening(rng):
    """A wall with a door and a lintel, and courses above it; its return at one end or none."""
    t, pier, door, stone, rows = rng.uniform(0.5, 1.2), rng.uniform(1.0, 2.5), rng.uniform(1.0, 2.0), rng.uniform(1.0, 2.0), rng.randint(1, 4)
    long, model = 2 * pier + door, Model("opening", [])
    for k in range(rows):
        model.blocks += boxes(f"l{k}", course(rng, pier, "half", k, stone), 0.0, t, k, k + 1.0)
        model.blocks += boxes(f"r{k}", [pier + door + x for x in course(rng, pier, "unequal", k, stone)], 0.0, t, k, k + 1.0)
    bear = pier * rng.uniform(0.2, 0.9)
    model.blocks += boxes("lintel", [0.0, pier - bear, pier + door + bear, long], 0.0, t, rows, rows + 1.0)
    for k in range(rows + 1, rows + 1 + rng.randint(0, 2)):
        model.blocks += boxes(f"a{k}", course(rng, long, "half", k, stone), 0.0, t, k, k + 1.0)
    if rng.random() < 0.5:
        for k in range(rows):
            model.blocks += along_y(f"y{k}", [t + y for y in course(rng, 2.0, "half", k, stone)], 0.0, t, k, k + 1.0)
    return model


def twin_arches(rng):
    """Two rings side by side with different joints, on the base."""
    r, y = rng.uniform(3.0, 6.0), 0.0
    t, blocks = r * rng.uniform(0.13, 0.35), []
    for k in range(2):
        depth = rng.uniform(0.5, 1.5)
        blocks += ring(f"ring{k}v", 0.0, r - t / 2, r + t / 2, angles(rng, 0.0, math.pi, rng.randint(5, 15)), y, y + depth)
        y += depth
    return Model("twin arches", blocks)


def turned_stack(rng):
    """Prisms of 3 to 8 corners, each rotated and moved relative to the one below."""
    blocks, z = [], 0.0
    for i in range(rng.randint(2, 9)):
        n, radius, turn, height = rng.randint(3, 8), rng.uniform(0.8, 1.6), rng.uniform(0.0, 360.0), rng.uniform(0.3, 1.2)
        x, y = rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)
        plan = [(x + radius * c, y + radius * s) for c, s, _ in (unit(turn + 360.0 * k / n) for k in range(n))]
        blocks.append(standing(f"d{i}", plan, z, z + height))
        z += height
    return Model("turned stack", blocks)


def rings(rng):
    """Courses of wedges round an axis, each rotated relative to the one below and of smaller radius."""
    blocks, outer, width = [], rng.uniform(2.5, 4.0), rng.uniform(0.6, 1.2)
    for k in range(rng.randint(1, 4)):
        n, start = rng.randint(5, 10), rng.uniform(0.0, 72.0)
        for i in range(n):
            corners = [unit(start + 360.0 * j / n) for j in (i, i + 1)]
            plan = [tuple(radius * c[:2]) for radius, order in ((outer - width, corners), (outer, corners[::-1])) for c in order]
            blocks.append(standing(f"k{k}_{i}", plan, 0.8 * k, 0.8 * k + 0.8))
        outer -= rng.uniform(0.0, 0.3) * width
    return Model("rings", blocks)


def leaning_beds(rng):
    """A stack whose beds lean in both directions."""
    size, blocks, z = (rng.uniform(0.8, 2.0), rng.uniform(0.8, 2.0)), [], 0.0
    bed = lambda a, b, z: [(x, y, z + a * x + b * y) for x, y in ((0.0, 0.0), (size[0], 0.0), size, (0.0, size[1]))]
    below = bed(0.0, 0.0, 0.0)
    for i in range(rng.randint(2, 7)):
        z += rng.uniform(1.3, 2.0)  # more than two beds may come nearer at a corner
        above = bed(rng.uniform(-0.15, 0.15), rng.uniform(-0.15, 0.15), z)
        blocks.append(between_loops(f"b{i}", below, above))
        below = above
    return Model("leaning beds", blocks, exact=True)


def pyramid(rng):
    """Frustums, one on the other, each rotated."""
    blocks, z, r = [], 0.0, rng.uniform(1.5, 2.5)
    for i in range(rng.randint(2, 6)):
        height, shrink, turn = rng.uniform(0.4, 1.0), rng.uniform(0.7, 1.0), rng.uniform(0.0, 90.0)
        loop = turned([(r, r, 0.0), (-r, r, 0.0), (-r, -r, 0.0), (r, -r, 0.0)], turn)
        lift = lambda points, at: [(x, y, at) for x, y, _ in points]
        blocks.append(between_loops(f"f{i}", lift(loop, z), lift(loop * shrink, z + height)))
        z, r = z + height, r * shrink * rng.uniform(0.75, 1.05)
    return Model("pyramid", blocks, exact=True)


def saddle(rng):
    """Saddle-shaped blocks on fixed wedges: their beds are inclined to both sides, so that corners of the friction polygon matter."""
    a, n, blocks = rng.uniform(0.3, 1.2), rng.randint(1, 4), []
    wide, long = rng.uniform(0.8, 1.6), rng.uniform(1.0, 2.0)
    blocks.append(between_loops("fixed", [(-wide, 0, -1), (wide, 0, -1), (wide, 0, 0), (0, 0, a), (-wide, 0, 0)],
                                [(-wide, long, -1), (wide, long, -1), (wide, long, 0), (0, long, a), (-wide, long, 0)], fixed=True))
    for i in range(n):
        y0, y1 = long * i / n, long * (i + 1) / n
        for side in (-1, 1):
            section = [(0.0, a), (side * wide, 0.0), (side * wide, 0.8 + rng.uniform(0.0, 1.0)), (0.0, a + 0.8 + rng.uniform(0.0, 1.0))]
            blocks.append(between_loops(f"b{i}{'l' if side < 0 else 'r'}", [(x, y0, z) for x, z in section], [(x, y1, z) for x, z in section]))
    return Model("saddle", blocks, base=None)


def pushed_across(rng):
    """A plane model with a live force out of its plane (set by models.aim)."""
    model = rng.choice([wall, round_arch, arch_on_piers, tower])(rng)
    model.kind, model.plane = "plane one, pushed across", False
    return model


def boulder(rng):
    """A large block on small ones, and a little one on top."""
    width, depth, height, blocks = rng.uniform(2.0, 6.0), rng.uniform(2.0, 4.0), rng.uniform(1.0, 4.0), []
    small = 10.0 ** rng.uniform(-1.5, -0.8)
    for i, (sx, sy) in enumerate(rng.sample([(-1, -1), (1, -1), (1, 1), (-1, 1), (0, 0)], rng.randint(3, 5))):
        x, y = sx * width * rng.uniform(0.25, 0.45), sy * depth * rng.uniform(0.25, 0.45)
        w, d = small * rng.uniform(0.7, 1.5), small * rng.uniform(0.7, 1.5)
        blocks.append(upright_box(f"p{i}", (x - w, y - d, 0.0), (x + w, y + d, small)))
    blocks.append(upright_box("boulder", (-width / 2, -depth / 2, small), (width / 2, depth / 2, small + height)))
    blocks.append(upright_box("top", (0.0, 0.0, small + height), (small, small, 3.0 * small + height)))
    return Model("boulder", blocks)


def overhang(rng):
    """A plane model with one block that is thicker than the others."""
    model = rng.choice([wall, tower, arch_on_piers])(rng)
    candidates = [b for b in model.blocks if b.box and b.vertices[:, 2].max() >= max(c.vertices[:, 2].max() for c in model.blocks) - 1e-9]
    model.kind, model.plane = "plane one, a block thicker", False
    if not candidates:
        return pushed_across(rng)
    block = rng.choice(candidates)
    low, high = block.box
    more = rng.uniform(0.05, 0.4)
    thick = upright_box(block.name, (low[0], low[1] - more, low[2]), (high[0], high[1] + rng.choice([0.0, more]), high[2]), block.material)
    model.blocks[model.blocks.index(block)] = thick
    return model


KINDS = (corner_wall, corner_wall, two_leaves, buttress, opening, twin_arches, turned_stack, turned_stack, rings, leaning_beds, pyramid, saddle,
         boulder, pushed_across, overhang)
