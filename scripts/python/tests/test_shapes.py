# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Blocks from meshes; TOML."""

import tempfile
import unittest

import numpy as np

import voussoir
from voussoir import shapes, toml, toml_reading


class Toml(unittest.TestCase):
    def test_what_is_written_reads_back(self):
        table = {"a": 1, "b": -0.1, "digits": 0.1 + 0.2, "c": "quote \" backslash \\ line\nend \x7f ü", "d": True, "e": [[1.0, 2.0], [3.0, 1e-300]], "f": [],
                 "with space": {"x": np.float64(0.1), "y": np.int64(7), "z": np.array([1.5, 2.5])},
                 "many": [{"n": 1, "in": {"k": "v"}}, {"n": 2, "deep": [{"q": 0}]}]}
        back = toml_reading.loads(toml.document(table))
        table["with space"]["z"] = [1.5, 2.5]
        self.assertEqual(back, table)

    def test_none_is_left_out_and_what_is_no_number_is_refused(self):
        self.assertEqual(toml.document({"a": None, "b": 1}), "b = 1\n")
        with self.assertRaises(ValueError):
            toml.document({"a": float("nan")})
        with self.assertRaises(TypeError):
            toml.document({"a": object()})


def box_mesh(low, high):
    """Eight vertices and twelve triangles."""
    low, high = np.array(low, float), np.array(high, float)
    vertices = np.array([[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return vertices, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


class Shapes(unittest.TestCase):
    def check(self, *shape):
        """The program's result for a block with this shape: volume from its mass."""
        model = voussoir.Model("One block")
        model.material("stone", density=1000.0, young=1e8, poisson=0.2)
        model["gravity.settle"] = False
        model["time.duration"] = 0.0
        model.block("a", *shape, material="stone", free=True)
        with tempfile.TemporaryDirectory() as folder:
            return float(model.run(f"{folder}/run", progress=False).elements.mass[0]) / 1000.0

    def test_a_box_of_triangles_in_any_order_is_a_hexahedron(self):
        vertices, triangles = box_mesh([0, 0, 0], [0.3, 0.2, 0.1])
        self.assertIn("vertices", shapes.shape_of("a", vertices, triangles))
        self.assertAlmostEqual(self.check(vertices, triangles), 0.006, places=12)
        turned = [t[::-1] for t in triangles]
        self.assertAlmostEqual(self.check(vertices, turned), 0.006, places=12)

    def test_a_hexahedron_that_is_no_box(self):
        vertices, triangles = box_mesh([0, 0, 0], [0.4, 0.2, 0.2])
        vertices[vertices[:, 2] > 0.1] *= [0.5, 1.0, 1.0]  # a wedge of a wall: narrower above
        self.assertAlmostEqual(self.check(vertices, triangles), 0.2 * 0.2 * 0.3, places=12)

    def test_a_prism_along_x(self):
        angles = 2.0 * np.pi * np.arange(6) / 6
        ring = 0.1 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        vertices = np.concatenate([np.insert(ring, 0, x, axis=1) for x in (0.0, 0.5)])
        faces = [tuple(range(6)), tuple(range(6, 12)), *((k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k) for k in range(6))]
        self.assertEqual(shapes.shape_of("a", vertices, faces)["extrude"], [0.0, 0.5])
        self.assertAlmostEqual(self.check(vertices, faces), 0.5 * 1.5 * np.sqrt(3.0) * 0.01, places=12)

    def test_any_other_polyhedron(self):
        vertices = np.array([[9, 9, 9], [0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])  # the first is of no face
        faces = [(1, 2, 3), (1, 2, 4), (2, 3, 4), (1, 4, 3)]  # in any sense
        shape = shapes.shape_of("tetra", vertices, faces)
        self.assertEqual(len(shape["vertices"]), 4)
        self.assertEqual(sorted(map(len, shape["faces"])), [3, 3, 3, 3])
        self.assertAlmostEqual(self.check(vertices, faces), 1.0 / 6.0, places=12)

    def test_what_a_case_cannot_take_is_refused_by_name(self):
        vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
        with self.assertRaisesRegex(voussoir.InputError, "0 to 3"):
            shapes.shape_of("tetra", vertices, [(0, 1, 4)])
        with self.assertRaisesRegex(voussoir.InputError, "no area"):
            shapes.shape_of("flat", [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 0, 1]], [(0, 1, 2)])
        with self.assertRaisesRegex(voussoir.InputError, "not finite"):
            shapes.shape_of("nan", [[np.nan, 0, 0]] * 8)
        with self.assertRaisesRegex(voussoir.InputError, "without faces"):
            shapes.shape_of("four", vertices)
