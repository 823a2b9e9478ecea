#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Writes examples of stones of one's own: files of geometry, and a case for each.

usage: cases/stones/make.py FOLDER [NAME...]     names: round-arch pointed-arch dome cross-vault column retaining-wall bridge (default: all)

A stone is a name, corners [m] and faces (loops of corner numbers, counter-clockwise seen from outside). Plain Python, nothing to install.
"""
import math
import pathlib
import random
import sys

MATERIAL = """[materials.stone]
density = 2300.0      # kg/m3
young   = 5.0e9       # Pa
poisson = 0.2

[contact]
friction = {friction}      # degrees
"""


def volume(corners, faces):
    six = 0.0
    for loop in faces:
        a = corners[loop[0]]
        for i, k in zip(loop[1:], loop[2:]):
            b, c = corners[i], corners[k]
            six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    return six / 6


def prism(name, ends, group=None):
    """A stone between two loops of as many corners, corner by corner."""
    low, high = ends
    n = len(low)
    faces = [[i, (i + 1) % n, (i + 1) % n + n, i + n] for i in range(n)] + [list(range(n))[::-1], list(range(n, 2 * n))]
    corners = list(low) + list(high)
    if volume(corners, faces) < 0:
        faces = [f[::-1] for f in faces]
    return name, corners, faces, group


def write_obj(path, stones):
    lines, first = ["# stones for voussoir, in metres"], 1
    for name, corners, faces, group in stones:
        lines.append(f"o {name}")
        if group:
            lines.append(f"g {group}")
        lines += ["v " + " ".join(repr(round(x, 15) + 0.0) for x in p) for p in corners]
        lines += ["f " + " ".join(str(first + i) for i in loop) for loop in faces]
        first += len(corners)
    path.write_text("\n".join(lines) + "\n")


def write_case(path, title, stones, keys="", friction=40.0, rest=""):
    path.write_text(f'title = "{title}"\n\n[time]\nduration = 2.0\n\n[damping]\nalpha = 2.0        # 1/s\n\n' + MATERIAL.format(friction=friction) +
                    f'\n[[stones]]\nfile = "{stones}"\nunit = "m"\n{keys}' + (f"\n{rest}" if rest else ""))


def ring_of(name, inner, outer, depth, group=None):
    """A voussoir of an arch in the x-z plane: two inner corners, two outer ones, from y = 0 to depth."""
    section = [inner[0], outer[0], outer[1], inner[1]]
    return prism(name, [[(x, y, z) for x, z in section] for y in (0.0, depth)], group)


def round_arch(folder, count=25, radius=1.5, thickness=0.25, depth=0.5):
    at = lambda r, i: (r * math.cos(math.pi * i / count), r * math.sin(math.pi * i / count) if 0 < i < count else 0.0)
    stones = [ring_of(f"v{i}", [at(radius - thickness / 2, k) for k in (i, i + 1)], [at(radius + thickness / 2, k) for k in (i, i + 1)], depth) for i in range(count)]
    write_obj(folder / "round-arch.obj", stones)
    write_case(folder / "round-arch.toml", "A semicircular arch of 25 voussoirs", "round-arch.obj", friction=45.0)


def pointed_arch(folder, count=12, span=3.0, thickness=0.25, depth=0.5):
    """Two arcs, each about the other's springing; the joint at the crown is upright."""
    radius, stones = span, []
    for side in (1, -1):
        def at(r, i):
            if i == count:  # on the crown's joint, x = 0
                return 0.0, math.sqrt(r * r - (span / 2) ** 2)
            angle = math.acos(span / 2 / radius) * i / count
            return side * (r * math.cos(angle) - span / 2), r * math.sin(angle)
        name = "right" if side > 0 else "left"
        stones += [ring_of(f"{name}{i}", [at(radius - thickness / 2, k) for k in (i, i + 1)], [at(radius + thickness / 2, k) for k in (i, i + 1)], depth, name)
                   for i in range(count)]
    write_obj(folder / "pointed-arch.obj", stones)
    write_case(folder / "pointed-arch.toml", "A pointed arch of two arcs", "pointed-arch.obj", friction=45.0)


def dome(folder, rings=9, meridians=16, radius=2.0, thickness=0.2, eye=12.0):
    def at(r, i, k):
        up, around = math.radians((90 - eye) * i / rings), 2 * math.pi * (k % meridians) / meridians
        return r * math.cos(up) * math.cos(around), r * math.cos(up) * math.sin(around), r * math.sin(up)
    patch = lambda r, i, k: [at(r, i, k), at(r, i, k + 1), at(r, i + 1, k + 1), at(r, i + 1, k)]
    stones = [prism(f"ring{i}_{k}", [patch(radius - thickness / 2, i, k), patch(radius + thickness / 2, i, k)], f"ring{i}")
              for i in range(rings) for k in range(meridians)]
    write_obj(folder / "dome.obj", stones)
    write_case(folder / "dome.toml", "A dome of nine rings, open at the top", "dome.obj", friction=45.0)


def cross_vault(folder, courses=7, radius=1.8, thickness=0.25, arm=0.3):
    """Two barrels that cross: four webs that meet in upright planes through the diagonals (groins), and a boss in the middle."""
    last, end = math.radians(80.0), radius + thickness / 2 + arm
    at = lambda r, i: (r * math.cos(last * i / courses), r * math.sin(last * i / courses) if i else 0.0)  # across the web, up
    inner, outer, stones = radius - thickness / 2, radius + thickness / 2, []
    for quarter in range(4):
        c, s = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarter]

        def course(name, section, parts):
            """From the groin, where the way along the web is as long as the way across, to the end of the web."""
            cut = lambda f: [((1 - f) * abs(y) + f * end, y, z) for y, z in section]
            turned = lambda f: [(c * x - s * y, s * x + c * y, z) for x, y, z in cut(f)]
            stones.extend(prism(f"{name}_{j}", [turned(j / parts), turned((j + 1) / parts)], f"web{quarter}") for j in range(parts))

        for i in range(courses):
            right = [at(inner, i), at(outer, i), at(outer, i + 1), at(inner, i + 1)]
            for side, section in (("right", right), ("left", [(-y, z) for y, z in right])):
                course(f"web{quarter}_{side}{i}", section, 1 + i // 3)
        low, high = at(inner, courses), at(outer, courses)
        course(f"web{quarter}_crown", [low, high, (-high[0], high[1]), (-low[0], low[1])], 3)
    square = lambda p: [(a * p[0], b * p[0], p[1]) for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    stones.append(prism("boss", [square(at(inner, courses)), square(at(outer, courses))], "boss"))
    write_obj(folder / "cross-vault.obj", stones)
    write_case(folder / "cross-vault.toml", "A cross vault of four webs and a boss", "cross-vault.obj", 'supports = "ground"\n', friction=45.0)


def column(folder, drums=6, sides=16, height=0.6):
    """Drums that taper, and a square abacus."""
    ring = lambda r, z: [(r * math.cos(2 * math.pi * k / sides), r * math.sin(2 * math.pi * k / sides), z) for k in range(sides)]
    radius = lambda i: 0.40 - 0.015 * i
    stones = [prism(f"drum{i}", [ring(radius(i), i * height), ring(radius(i + 1), (i + 1) * height)]) for i in range(drums)]
    top, a = drums * height, 0.45
    square = lambda z: [(-a, -a, z), (a, -a, z), (a, a, z), (-a, a, z)]
    stones.append(prism("abacus", [square(top), square(top + 0.25)]))
    write_obj(folder / "column.obj", stones)
    write_case(folder / "column.toml", "A column of six drums under an abacus", "column.obj", rest="[base]\nz = 0.0\n")


def retaining_wall(folder, courses=8, length=3.0, height=0.22, seed=4):
    """Dry stones in courses, with a batter in front; the earth behind pushes the courses of the back."""
    rng, stones, loads = random.Random(seed), [], []
    for i in range(courses):
        low, high, front, back = i * height, (i + 1) * height, 0.06 * i, 0.9
        x, k = 0.0, 0
        while x < length - 1e-9:
            wide = rng.uniform(0.35, 0.65)
            end = length if length - x - wide < 0.3 else x + wide
            square = lambda z: [(x, front, z), (end, front, z), (end, back, z), (x, back, z)]
            stones.append(prism(f"c{i}_{k}", [square(low), square(high)], f"course{i}"))
            x, k = end, k + 1
        depth = (courses - i - 0.5) * height  # m, under the top of the earth
        push = 0.3 * 1700.0 * 9.8 * depth * height * length / k  # N on each stone: active pressure of loose earth
        loads.append(f'[[load]]\nblock = "course{i}"\nforce = [0.0, {-push:.1f}, 0.0]\nramp  = [0.0, 1.0]\n')
    write_obj(folder / "retaining-wall.obj", stones)
    write_case(folder / "retaining-wall.toml", "A dry-stone wall that holds back earth", "retaining-wall.obj", friction=35.0, rest="[base]\nz = 0.0\n\n" + "\n".join(loads))


def bridge(folder, count=31, span=8.0, rise=2.0, thickness=0.5, depth=2.0, cover=0.4):
    """A segmental arch on fixed springers; the fill over each voussoir as a load on it."""
    radius = (span * span / 4 + rise * rise) / (2 * rise)
    half, drop = math.asin(span / 2 / radius), radius - rise
    at = lambda r, i: (r * math.sin(half * (2 * i / count - 1)), r * math.cos(half * (2 * i / count - 1)) - drop)
    stones, loads = [], []
    for i in range(count):
        outer = [at(radius + thickness, k) for k in (i, i + 1)]
        stones.append(ring_of(f"v{i}", [at(radius, k) for k in (i, i + 1)], outer, depth))
        wide, level = outer[1][0] - outer[0][0], rise + thickness + cover
        weight = 1800.0 * 9.8 * depth * wide * (level - 0.5 * (outer[0][1] + outer[1][1]))
        if 0 < i < count - 1:
            loads.append(f'[[load]]\nblock = "v{i}"\nforce = [0.0, 0.0, {-weight:.1f}]\nramp  = [-2.0, -1.0]\n')
    write_obj(folder / "bridge.obj", stones)
    write_case(folder / "bridge.toml", "A segmental arch bridge under its fill", "bridge.obj", f'supports = ["v0", "v{count - 1}"]\n', friction=45.0, rest="\n".join(loads))


ALL = {"round-arch": round_arch, "pointed-arch": pointed_arch, "dome": dome, "cross-vault": cross_vault, "column": column,
       "retaining-wall": retaining_wall, "bridge": bridge}

if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    target = pathlib.Path(sys.argv[1])
    target.mkdir(parents=True, exist_ok=True)
    for chosen in sys.argv[2:] or ALL:
        if chosen not in ALL:
            sys.exit(f"make.py: {chosen} is no example; known: {' '.join(ALL)}")
        ALL[chosen](target)
