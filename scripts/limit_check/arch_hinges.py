# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The multiplier of an arch that does not slide, by trying all mechanisms of four hinges. No linear programme."""
import itertools
import math

import numpy

from shapes import across, volume_and_centroid


def cross(omega, arm):
    """Velocity of the end of an arm (x, z) that turns at omega, from x towards z."""
    return omega * numpy.array([-arm[1], arm[0]])


class Arch:
    """sections: corners (x, z) of the voussoirs from one springing to the other, each inner, outer, outer, inner."""

    def __init__(self, sections):
        self.joints = [(numpy.array(s[0]), numpy.array(s[1])) for s in sections] + [(numpy.array(sections[-1][3]), numpy.array(sections[-1][2]))]
        stones = [volume_and_centroid(*(lambda b: (b.vertices, b.faces))(across("", s, 0.0, 1.0))) for s in sections]
        self.weights = numpy.array([volume for volume, _ in stones])
        self.centres = numpy.array([(centre[0], centre[2]) for _, centre in stones])
        self.ahead = []  # normals of joints, towards the stone behind each; at the end out of the last stone
        for i, (inner, outer) in enumerate(self.joints):
            along = (outer - inner) / numpy.linalg.norm(outer - inner)
            normal = numpy.array([-along[1], along[0]])
            way = self.centres[i] - inner if i < len(sections) else inner - self.centres[-1]
            self.ahead.append(normal if normal @ way > 0.0 else -normal)

    def multiplier(self, push):
        """The least multiplier of all mechanisms; push: +1 or -1, along x."""
        hinges = itertools.product(itertools.combinations(range(len(self.joints)), 4), ((0, 1, 0, 1), (1, 0, 1, 0)))
        return min(self.of(joints, ends, push) for joints, ends in hinges)

    def of(self, joints, ends, push):
        """The multiplier of one mechanism: three parts rotate, the first about the first hinge, the last about the last one."""
        h = [self.joints[j][end] for j, end in zip(joints, ends)]
        matrix = numpy.column_stack([h[2] - h[1], h[3] - h[2]])  # the ends of the chain stand still
        if abs(numpy.linalg.det(matrix)) < 1e-12:
            return math.inf
        omegas = numpy.array([1.0, *numpy.linalg.solve(matrix, h[0] - h[1])])
        velocities = numpy.zeros_like(self.centres)
        start = numpy.zeros(2)
        for k in range(3):
            stones = slice(joints[k], joints[k + 1])
            velocities[stones] = [start + cross(omegas[k], c - h[k]) for c in self.centres[stones]]
            start = start + cross(omegas[k], h[k + 1] - h[k])
        jumps = numpy.diff([0.0, *omegas, 0.0])
        opening = [cross(jump, self.joints[j][1 - end] - at) @ self.ahead[j] for jump, j, end, at in zip(jumps, joints, ends, h)]
        live = push * float(self.weights @ velocities[:, 0])
        sign = 1.0 if live > 0.0 else -1.0
        if abs(live) < 1e-12 or min(sign * numpy.array(opening)) < -1e-12:
            return math.inf
        return float(self.weights @ velocities[:, 1]) / live
