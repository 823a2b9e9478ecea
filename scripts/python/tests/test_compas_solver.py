# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Problems of COMPAS solved to a state of rest."""

import json

import numpy as np

import voussoir
from fixture import InAFolder
from test_compas import PUSH, WEIGHT, mesh, problem
from voussoir.compas_solver import corner_forces, pair_forces

SQUARE = np.array([[0.0, 0.0, 0.2], [0.4, 0.0, 0.2], [0.4, 0.3, 0.2], [0.0, 0.3, 0.2]])


def axes(n, normal=(0, 0, 1), first=(1, 0, 0), second=(0, 1, 0)):
    return np.array([[normal, first, second]] * n, dtype=float)


def resultant(corners, ways, forces):
    each = np.einsum("nk,nkj->nj", forces, ways)
    return each.sum(axis=0), np.cross(corners, each).sum(axis=0)


class CornerForces(InAFolder):
    def test_they_have_the_resultant_and_push_where_that_can_be(self):
        random = np.random.default_rng(1)
        for _ in range(50):
            point = SQUARE[0] + [random.uniform(0, 0.4), random.uniform(0, 0.3), 0]
            force = np.array([*random.uniform(-30, 30, 2), random.uniform(50, 100)])
            moment = np.cross(point, force)
            found = corner_forces(SQUARE, axes(4), force, moment)
            got = resultant(SQUARE, axes(4), found)
            np.testing.assert_allclose(got[0], force, atol=1e-9)
            np.testing.assert_allclose(got[1], moment, atol=1e-9)
            self.assertGreater(found[:, 0].min(), -1e-7)

    def test_a_resultant_outside_the_face_needs_tension(self):
        point, force = np.array([0.6, 0.1, 0.2]), np.array([0.0, 0.0, 10.0])
        found = corner_forces(SQUARE, axes(4), force, np.cross(point, force))
        self.assertLess(found[:, 0].min(), -1.0)
        np.testing.assert_allclose(resultant(SQUARE, axes(4), found)[1], np.cross(point, force), atol=1e-9)

    def test_they_turn_and_move_with_the_face(self):
        angle, shift = 0.7, np.array([3.0, -2.0, 1.0])
        turn = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
        force, point = np.array([5.0, 3.0, 40.0]), np.array([0.1, 0.2, 0.2])
        one = corner_forces(SQUARE, axes(4), force, np.cross(point, force))
        corners = SQUARE @ turn.T + shift
        other = corner_forces(corners, axes(4) @ turn.T, turn @ force, np.cross(turn @ point + shift, turn @ force))
        np.testing.assert_allclose(one, other, atol=1e-8)


class PairForces(InAFolder):
    def test_pieces_of_two_stones_add_up_whichever_comes_first(self):
        one = {"blocks": ["a", "b"], "force": [1.0, 0.0, 5.0], "moment": [0.0, 2.0, 0.0], "point": [1.0, 0.0, 0.0], "area": 1.0}
        other = {"blocks": ["b", "a"], "force": [-2.0, 0.0, -7.0], "moment": [0.0, 0.0, 3.0], "point": [3.0, 0.0, 0.0], "area": 3.0}
        base = {**one, "blocks": ["a", None]}
        (pair, (force, moment, point)), = pair_forces([one, other, base]).items()
        self.assertEqual(pair, ("a", "b"))
        np.testing.assert_allclose(force, [-3.0, 0.0, -12.0])  # of a on b
        about = -np.array([0.0, 2.0, 0.0]) + np.cross([1, 0, 0], [-1.0, 0, -5.0]) + np.array([0.0, 0.0, 3.0]) + np.cross([3, 0, 0], [-2.0, 0, -7.0])
        np.testing.assert_allclose(moment, about)
        np.testing.assert_allclose(point, [2.5, 0.0, 0.0])


class AtRest(InAFolder):
    def written(self, content):
        path = self.folder / "problem.json"
        path.write_text(json.dumps(content))
        return path

    def test_contact_forces_bear_weight_and_loads(self):
        found = voussoir.compas.solve(self.written(problem(point_loads=[
            {"block_index": 1, "force": [PUSH, 0, 0], "moment": None, "point": [0.2, 0.15, 0.3], "loading_type": "ramp"}])))
        self.assertEqual(found.status, "equilibrium")
        self.assertAlmostEqual(found.share, 1.0, places=12)
        self.assertLess(found.unbalanced, 1e-4)
        contact, = found.contacts
        self.assertEqual(contact["blocks"], ["0", "1"])
        np.testing.assert_allclose(contact["force"], [PUSH, 0.0, -WEIGHT], atol=2e-4 * WEIGHT)
        moment = np.cross([0.2, 0.15, 0.3] - np.array(contact["point"]), [PUSH, 0.0, -WEIGHT])
        np.testing.assert_allclose(contact["moment"], moment, atol=2e-4 * WEIGHT)

    def test_what_slides_away_is_partly_borne(self):
        slope = 2.0 * np.tan(np.radians(35.0)) * WEIGHT
        found = voussoir.compas.solve(self.written(problem(point_loads=[
            {"block_index": 1, "force": [slope, 0, 0], "moment": None, "point": [0.2, 0.15, 0.21], "loading_type": "ramp"}])))
        self.assertEqual(found.status, "partial")
        self.assertAlmostEqual(found.share, 0.5, delta=0.01)

    def test_cohesion_holds_it(self):
        slope = 2.0 * np.tan(np.radians(35.0)) * WEIGHT
        content = problem(point_loads=[{"block_index": 1, "force": [slope, 0, 0], "moment": None, "point": [0.2, 0.15, 0.21], "loading_type": "ramp"}])
        content["data"]["contact_properties"]["data"]["contact_model"]["data"].update(c=1e5, t_c=1e5, k_n=1e10, k_t=5e9)
        self.assertEqual(voussoir.compas.solve(self.written(content)).status, "equilibrium")

    def test_prescribed_displacements_and_rotations(self):
        moved = {"block_index": 0, "translation": [0.01, 0.0, -0.02], "rotation": [0.0, 0.1, 0.0]}
        found = voussoir.compas.solve(self.written(problem(displacements=[moved])))
        self.assertEqual(found.status, "equilibrium")
        matrix = np.array(found.blocks["0"]["transformation"]["data"]["matrix"])
        np.testing.assert_allclose(found.blocks["0"]["translation"], [0.01, 0.0, -0.02], atol=1e-7)
        np.testing.assert_allclose(matrix[:3, :3], [[np.cos(0.1), 0, np.sin(0.1)], [0, 1, 0], [-np.sin(0.1), 0, np.cos(0.1)]], atol=1e-6)
        np.testing.assert_allclose(np.array(found.blocks["1"]["transformation"]["data"]["matrix"]), matrix, atol=1e-4)  # it rides on it

    def test_densities_by_block(self):
        content = problem()
        model = content["data"]["model"]["data"]
        model["materials"]["guid-h"] = {"dtype": "compas_dem.material/Stone", "data": {"Ecm": 2000, "density": 6000, "poisson": 0.2}}
        model["elements"]["guid-b"]["data"]["material"], model["elements"]["guid-a"]["data"]["material"] = "guid-m", "guid-h"
        contact, = voussoir.compas.solve(self.written(content)).contacts
        np.testing.assert_allclose(contact["force"], [0.0, 0.0, -3.0 * WEIGHT], atol=1e-3 * WEIGHT)

    def test_what_cannot_be_had_is_refused_by_name(self):
        partial = {"block_index": 0, "translation": [0.01, None, None], "rotation": None}
        with self.assertRaisesRegex(voussoir.InputError, "block 0 has prescribed components, but these are free: translation y, translation z, rotation x"):
            voussoir.compas.solve(self.written(problem(displacements=[partial])))
        self.assertEqual(voussoir.compas.solve(self.written(problem(displacements=[partial])), unprescribed="hold").status, "equilibrium")
        content = problem()
        content["data"]["contact_properties"]["data"]["joint_model"] = {"dtype": "compas_dem.interactions/JointModel", "data": {"kn": 1e9, "kt": 1e9}}
        with self.assertRaisesRegex(voussoir.InputError, r"joint_model\.kn = 1000000000\.0 N/m is of a whole contact"):
            voussoir.compas.solve(self.written(content))
        content = problem()
        content["data"]["contact_properties"]["data"]["contact_model"]["data"]["k_n"] = 1e9
        with self.assertRaisesRegex(voussoir.InputError, "one of k_n and k_t"):
            voussoir.compas.solve(self.written(content))

    def test_a_block_without_support_falls(self):
        content = problem()
        content["data"]["model"]["data"]["elements"]["guid-a"]["data"]["geometry"] = mesh([0.35, 0, 0.2], [0.75, 0.3, 0.4])
        found = voussoir.compas.solve(self.written(content))
        self.assertEqual((found.status, found.contacts, found.blocks), ("no rest", [], {}))
        self.assertIn("finds no rest while gravity is put on", found.note)

    def test_what_topples_and_lies_on_a_floor_does_not_stand(self):
        content = problem(displacements=[{"block_index": k, "translation": [0.0] * 3, "rotation": [0.0] * 3} for k in (0, 2)])
        model = content["data"]["model"]["data"]
        model["elements"]["guid-a"]["data"]["geometry"] = mesh([0.25, 0, 0.2], [0.75, 0.3, 0.4])
        model["elements"]["guid-c"] = {"dtype": "compas_dem.elements/Block",
                                       "data": {"transformation": None, "name": "Block", "geometry": mesh([-2, -2, -0.6], [2, 2, -0.4])}}
        model["graph"]["node"]["2"] = {"element": "guid-c"}
        for load in ([], [{"block_index": 1, "force": [1.0, 0, 0], "moment": None, "point": None, "loading_type": "ramp"}]):
            content["data"]["boundary_conditions"]["data"]["point_loads"] = load
            self.assertEqual(voussoir.compas.solve(self.written(content)).status, "no rest")
