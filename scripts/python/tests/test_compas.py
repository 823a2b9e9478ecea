# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Problems of COMPAS, written as compas_dem writes them."""

import json

import numpy as np

import voussoir
from fixture import InAFolder
from test_shapes import box_mesh

WEIGHT = 0.4 * 0.3 * 0.2 * 2000.0 * 9.81  # N, of the upper block
PUSH = 40.0  # N


def mesh(low, high):
    """A mesh of COMPAS, with its outward faces."""
    vertices, triangles = box_mesh(low, high)
    centre, faces = vertices.mean(axis=0), {}
    for k, (a, b, c) in enumerate(triangles):
        outward = np.cross(vertices[b] - vertices[a], vertices[c] - vertices[a]) @ (vertices[a] - centre) > 0.0
        faces[str(k)] = [a, b, c] if outward else [a, c, b]
    return {"dtype": "compas.datastructures/Mesh",
            "data": {"vertex": {str(k): dict(zip("xyz", map(float, v))) for k, v in enumerate(vertices)}, "face": faces}}


def problem(**conditions):
    def block(low, high):
        return {"dtype": "compas_dem.elements/Block", "data": {"transformation": None, "name": "Block", "geometry": mesh(low, high)}}
    return {"dtype": "compas_dem.problem/Problem", "data": {
        "model": {"dtype": "compas_dem.models/BlockModel", "data": {
            "elements": {"guid-b": block([0, 0, 0], [0.4, 0.3, 0.2]), "guid-a": block([0, 0, 0.2], [0.4, 0.3, 0.4])},
            "materials": {"guid-m": {"dtype": "compas_dem.material/Stone", "data": {"Ecm": 2000, "density": 2000, "poisson": 0.2}}},
            "graph": {"node": {"0": {"element": "guid-b"}, "1": {"element": "guid-a"}}, "edge": {}}}},
        "boundary_conditions": {"dtype": "compas_dem.problem/BoundaryConditions", "data": {
            "gravity": True, "g": 9.81, "body_forces": [], "point_loads": [], "surface_loads": [],
            "displacements": [{"block_index": 0, "translation": [0.0, 0.0, 0.0], "rotation": [0.0, 0.0, 0.0]}], **conditions}},
        "contact_properties": {"dtype": "compas_dem.interactions/ContactProperties", "data": {
            "contact_model": {"dtype": "compas_dem.interactions/MohrCoulomb", "data": {"phi": 35.0, "mu": 0.7, "c": None}}}}}}


class Compas(InAFolder):
    def written(self, content):
        path = self.folder / "problem.json"
        path.write_text(json.dumps(content))
        return path

    def test_a_problem_in_and_its_solution_out(self):
        square = [[0.1, 0.1, 0.4], [0.3, 0.1, 0.4], [0.3, 0.2, 0.4], [0.1, 0.2, 0.4]]
        polygon = {"dtype": "compas.geometry/Polygon", "data": {"points": square}}
        model = voussoir.compas.model_of(self.written(problem(
            point_loads=[{"block_index": 1, "force": [PUSH, 0, 0], "moment": None, "point": [0.2, 0.15, 0.3], "loading_type": "ramp"}],
            surface_loads=[{"block_index": 1, "polygon": polygon, "magnitude": 1000.0, "direction": [0, 0, -1]}])))
        self.assertEqual(model["contact.friction"], 35.0)
        self.assertEqual(model["materials.stone.young"], 2e9)
        self.assertEqual(voussoir.compas.follow_contacts(model), 1)
        run = model.run(self.folder / "run", until=1.0, progress=False)
        path = voussoir.compas.write(run, self.folder / "solution.json")
        solution = json.loads(path.read_text())
        self.assertEqual(list(solution["blocks"]), ["0", "1"])
        np.testing.assert_allclose(solution["blocks"]["0"]["translation"], 0.0, atol=1e-7)  # frames are float32
        contact, = solution["contacts"]
        self.assertEqual(contact["blocks"], ["0", "1"])
        self.assertAlmostEqual(contact["area"], 0.12, places=12)
        # what the upper block exerts on the lower one: its weight, the load of 1000 N/m2 on 0.02 m2, and the push
        np.testing.assert_allclose(contact["force"], [PUSH, 0.0, -WEIGHT - 20.0], rtol=2e-3, atol=0.2)
        matrix = np.array(solution["blocks"]["1"]["transformation"]["data"]["matrix"])
        moved = matrix @ [0.2, 0.15, 0.3, 1.0] - [0.2, 0.15, 0.3, 1.0]
        np.testing.assert_allclose(moved[:3], solution["blocks"]["1"]["translation"], atol=1e-12)
        self.assertLess(np.abs(moved).max(), 1e-4)
        with self.assertRaises(voussoir.FileError):
            voussoir.compas.write(run, path)

    def test_what_is_not_taken_over_is_told(self):
        with self.assertRaisesRegex(voussoir.InputError, "block 0 has a prescribed displacement"):
            voussoir.compas.model_of(self.written(problem(displacements=[{"block_index": 0, "translation": [0, 0, 0.01], "rotation": None}])))
        with self.assertWarnsRegex(voussoir.ProgramWarning, "neither gravity nor body forces"):
            self.assertEqual(voussoir.compas.model_of(self.written(problem(gravity=False)))["gravity.acceleration"], [0.0, 0.0, -9.81])
        content = problem()
        content["data"]["model"]["data"]["materials"] = {}
        with self.assertRaisesRegex(voussoir.InputError, "give young"):
            voussoir.compas.model_of(self.written(content))
        self.assertEqual(voussoir.compas.model_of(self.written(content), young=1e9)["materials.stone.young"], 1e9)
        with self.assertRaises(voussoir.FileError):
            voussoir.compas.model_of(self.folder / "none.json")
