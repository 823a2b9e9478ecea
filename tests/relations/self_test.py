# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Faults put into the numbers of one run, or into what a relation does with the case: each must be found, and without any nothing is."""
import copy
import random

import numpy

import compare
import limits
import relations


def worst(command, first, second, change):
    apart = compare.differences(first, second, change)
    return max(v / limits.of(command, k, change) for k, v in apart.items())


def expected_all(first, change):
    """The second case's numbers if all is right."""
    out = copy.deepcopy(first)
    for v in out.values():
        v.data = numpy.array(compare.expected(v, change))
    return out


def put(numbers, name, fault):
    out = copy.deepcopy(numbers)
    out[name].data = fault(out[name].data)
    return out


def swapped(rows):
    rows = rows.copy()
    rows[[0, -1]] = rows[[-1, 0]]
    return rows


FAULTS = {  # name: (the number, what is wrong with it)
    "a mass of a thousandth more": ("element mass", lambda x: x * 1.001),
    "two elements' masses exchanged": ("element mass", swapped),
    "a segment size that is another": ("element segment size", lambda x: x + 1e-6),
    "an area of a joint": ("joint area", lambda x: x * (1.0 + 1e-6)),
    "gravity that did not turn: x and y of the base's force exchanged": ("base shear", lambda x: x[:, [1, 0, 2]]),
    "the sign of a moment, as of a vector that is mirrored": ("base moment", lambda x: -x),
    "a rotation about the wrong axis": ("rotation", None),
    "a history one step late": ("history top: displacement", lambda x: numpy.roll(x, 1, axis=0)),
    "a frame a tenth of a millimetre off": ("frames: last", lambda x: x + 1e-4),
    "a force that passes the cut from the other side": ("cut across: force", lambda x: -x),
    "an energy of another second": ("energy: strain", lambda x: x * (1.0 + 1e-5)),
    "a crack less": ("cracks", lambda x: x + 1),
    "one side more that slipped": ("damage: slipped", lambda x: x + 1)}


def main(run_first):
    """run_first: makes a case and its numbers. Returns the exit code."""
    case, first = run_first()
    faults = []
    changes = {"nothing": relations.Change(), "turned": relations.Change(turn=relations.rotation(37.0)),
               "mirrored": relations.Change(turn=numpy.diag([-1.0, 1.0, 1.0])), "scaled": relations.Change(scale=2.5)}
    for words, change in changes.items():
        right = expected_all(first, change)
        if worst("run", first, right, change) > 1.0:
            faults.append(f"{words}: what is right is not found right")
        for name, (number, fault) in FAULTS.items():
            number, fault = ("history top: rotation", lambda x: x[:, [1, 2, 0]]) if fault is None else (number, fault)
            if not worst("run", first, put(right, number, fault), change) > 1.0:
                faults.append(f"{words}: not found: {name}")
    same = relations.Change(equal=relations.BITS)
    if not worst("run", first, put(first, "history foot: velocity", lambda x: numpy.nextafter(x, 1.0)), same) > 1.0:
        faults.append("a last bit is not found")
    faults += of_relations(case)
    print("\n".join(faults) if faults else f"{len(changes) * len(FAULTS) + 1} faults found")
    return 1 if faults else 0


def of_relations(case):
    """Relations that must be undone by their opposite."""
    R = relations.rotation(90.0)
    back = relations.turn_all(relations.turn_all(case, R), R.T)
    yield from (f"turned and back: {b.name} is elsewhere" for a, b in zip(case.blocks, back.blocks) if not numpy.allclose(a.vertices, b.vertices))
    there, _ = relations.other_order(random.Random(1), case)
    if sorted(b.name for b in there.blocks) != sorted(b.name for b in case.blocks):
        yield "another order: blocks are lost"
