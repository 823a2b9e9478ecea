# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the tests share: a small model, and a folder of their own. All of them start the real program."""

import pathlib
import tempfile
import unittest

import voussoir

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]


def blocks(duration=0.1, at=(0.0, 0.0, 0.0)):
    """Two bonded blocks on the base, under a ground motion. at: their place, m."""
    def moved(x, y, z):
        return [x + at[0], y + at[1], z + at[2]]
    model = voussoir.Model("Two bonded blocks")
    model["gravity.settle"] = False
    model["time.duration"] = duration
    model.material("stone", density=2000.0, young=1e8, poisson=0.2)
    model.joint_law("mortar", tension=1e5, cohesion=1e5, friction=30.0, compression=1e6)
    model["joints.default"] = "mortar"
    model["base.z"] = float(at[2])
    model.box("lower", moved(0, 0, 0), moved(0.2, 0.2, 0.2), material="stone")
    model.box("upper", moved(0, 0, 0.2), moved(0.2, 0.2, 0.4), material="stone")
    model.follow("upper", moved(0.1, 0.1, 0.3))
    model.motion("bam-like")
    return model


class InAFolder(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
