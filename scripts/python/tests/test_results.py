# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Results as arrays."""

import pathlib
import re
import shutil
import tempfile

import h5py
import numpy as np

import voussoir
from fixture import InAFolder, blocks
from forging import forge


class Results(InAFolder):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.seen = []
        cls.run_ = blocks().run(f"{cls.scratch.name}/pair", until=0.06, threads=1, progress=cls.seen.append)

    def test_histories_have_units_and_names(self):
        history = self.run_.history("upper")
        u = history.displacement
        self.assertEqual((u.unit, u.name, u.shape), ("m", "displacement", (len(history.time), 3)))
        self.assertEqual(u[:, 0].unit, "m")
        self.assertEqual(history.unit("rotation"), "rad")
        self.assertGreater(abs(history["velocity"]).max(), 0.0)
        self.assertNotIsInstance(u * u, voussoir.Array)
        self.assertEqual(list(history), ["time", "displacement", "rotation", "velocity"])
        with self.assertRaisesRegex(voussoir.VoussoirError, "no history 'lower'; there are: upper"):
            self.run_.history("lower")
        with self.assertRaisesRegex(AttributeError, "there are: .*kinetic"):
            self.run_.energy.heat

    def test_tables_agree_with_the_file(self):
        self.assertTrue(np.array_equal(self.run_.energy.kinetic, self.run_.file["energy/kinetic"][:]))
        self.assertEqual(self.run_.energy.kinetic.unit, "J")
        self.assertEqual(list(self.run_.elements.tag), ["lower", "upper"])
        self.assertAlmostEqual(float(self.run_.elements.mass.sum()), 32.0)
        self.assertEqual(self.run_.summary["state_hash"], self.run_.file["summary"].attrs["state_hash"])
        self.assertAlmostEqual(self.run_.summary["end_time"], 0.06, places=3)  # and a step
        self.assertTrue(self.run_.finished)
        self.assertEqual(self.run_.case["title"], "Two bonded blocks")
        self.assertTrue(self.run_.provenance["version"].startswith("0."))

    def test_loads_have_the_displacement_of_their_places(self):
        case = blocks()
        case.case["load"] = [{"block": "upper", "force": [5.0, 0.0, 0.0]}]
        run = case.run(f"{self.scratch.name}/loaded", until=0.06, threads=1)
        loaded, measures = run.loaded, run.loads["load 1"]
        self.assertEqual(loaded.displacement.shape, (len(loaded.time), 1, 3))
        self.assertTrue(np.allclose(loaded.force[:, 0], [5.0, 0.0, 0.0]))
        self.assertTrue(np.allclose(loaded.displacement[:, 0], run.history("upper").displacement, atol=1e-9))  # it acts at the centroid
        self.assertEqual(measures["peak_force"], 5.0)
        self.assertEqual(measures["end_displacement"], loaded.displacement[-1, 0, 0])
        self.assertEqual(self.run_.loads, {})

    def test_ties_and_walls_are_there_by_name(self):
        self.assertEqual((self.run_.ties, self.run_.walls), ({}, {}))

        def tied(file):
            group = file.create_group("summary/tie")
            group["name"] = np.array([b"rod", b"floor 1 deck"])
            group["peak_force"], group["utilisation"] = np.array([2e3, -5e2]), np.array([0.5, np.nan])
        forge(self.run_.folder / "run.h5", self.folder / "run.h5", tied)
        ties = voussoir.Results(self.folder).ties
        self.assertEqual((list(ties), ties["rod"]), (["rod", "floor 1 deck"], {"peak_force": 2e3, "utilisation": 0.5}))
        self.assertTrue(np.isnan(ties["floor 1 deck"]["utilisation"]))

    def test_frames_place_the_vertices(self):
        frames = self.run_.frames
        self.assertEqual(len(frames), len(frames.time))
        self.assertEqual(frames.at(0.04).time, frames[-2].time)
        placed, first = frames[-1].vertices(), self.run_.file["model/vertex"][:]
        self.assertEqual(placed.shape, first.shape)
        self.assertLess(abs(placed - first).max(), 0.01)
        self.assertGreater(abs(placed - first).max(), 0.0)
        with self.assertRaises(IndexError):
            frames[len(frames)]

    def test_far_off_points_have_the_coordinates_of_the_case(self):
        at = np.array([650001.0, 4820000.0, 312.0])
        run = blocks(at=at).run(self.folder / "far", until=0.06, threads=1, progress=False)
        self.assertEqual(run.origin.tolist(), at.tolist())
        self.assertEqual(self.run_.origin.tolist(), [0.0, 0.0, 0.0])
        for far, near in ((run.elements.position0, self.run_.elements.position0), (run.joints.centre, self.run_.joints.centre),
                          (run.frames[-1].position, self.run_.frames[-1].position), (run.frames[-1].vertices(), self.run_.frames[-1].vertices())):
            self.assertLess(abs(np.asarray(far) - at - near).max(), 1e-6)
        self.assertEqual((run.elements.position0.unit, run.elements.position0.name), ("m", "position0"))
        self.assertLess(abs(run.history("upper").displacement - self.run_.history("upper").displacement).max(), 1e-9)
        self.assertAlmostEqual(run.case["base"]["z"], 312.0)
        self.assertEqual(run.case["block"][0]["box"][1][0], at[0] + 0.2)

    def test_frames_of_files_before_schema_5(self):
        sealed = pathlib.Path(f"{self.scratch.name}/pair/run.h5").read_bytes()
        contents = int(re.search(rb"(\d+) bytes of HDF5", sealed[:512])[1])
        (self.folder / "run.h5").write_bytes(sealed[512:512 + contents])
        with h5py.File(self.folder / "run.h5", "r+") as file:
            file.attrs["schema_version"] = 4
            position = file["model/element/position0"][:] + file["frames/displacement"][:]
            del file["frames/displacement"], file["model/origin"]
            file["frames/position"] = position.astype("f4")
        with self.assertWarnsRegex(voussoir.ProgramWarning, "not sealed .schema 4."):
            old, new = voussoir.Run(self.folder).frames[-1], self.run_.frames[-1]
        self.assertLess(abs(np.asarray(old.displacement) - new.displacement).max(), 1e-7)
        self.assertLess(abs(np.asarray(old.position) - new.position).max(), 1e-7)
        self.assertLess(abs(old.vertices() - new.vertices()).max(), 1e-7)

    def copied(self):
        """A copy of the run's results, and their bytes."""
        shutil.copy(f"{self.scratch.name}/pair/run.h5", self.folder / "run.h5")
        return self.folder / "run.h5", bytearray((self.folder / "run.h5").read_bytes())

    def test_no_damaged_page_is_read(self):
        path, right = self.copied()
        kinetic = np.asarray(self.run_.energy.kinetic).tobytes()
        at = right.find(kinetic)
        self.assertGreater(at, 0)
        for place in (at, at + len(kinetic) - 1, 0, 100, len(right) - 1):
            wrong = bytearray(right)
            wrong[place] ^= 1
            path.write_bytes(wrong)
            with self.assertRaisesRegex(voussoir.FileError, "damaged"):
                _ = voussoir.Run(self.folder).energy.kinetic
        path.write_bytes(right[:-1])
        with self.assertRaisesRegex(voussoir.FileError, "were written"):
            _ = voussoir.Run(self.folder).finished

    def test_a_later_schema_an_early_one_and_a_lost_seal_are_refused(self):
        for version, words in ((7, "a later program wrote it"), (3, "reads from 4 on"), (6, "lost its seal")):
            with h5py.File(self.folder / "run.h5", "w") as file:
                file.attrs["format"], file.attrs["schema_version"] = "voussoir results", version
            with self.assertRaisesRegex(voussoir.FileError, words):
                _ = voussoir.Run(self.folder).finished

    def test_rows_in_missing_parts_are_an_error(self):
        with h5py.File(self.folder / "run.h5", "w") as file:
            file.attrs["format"], file.attrs["schema_version"] = "voussoir results", 5
            layout = h5py.VirtualLayout((2,), "f8")
            layout[:] = h5py.VirtualSource("parts/0000.h5", "/energy/kinetic", (2,))
            file.create_virtual_dataset("/energy/kinetic", layout, fillvalue=np.nan)
        with self.assertWarns(voussoir.ProgramWarning), self.assertRaisesRegex(voussoir.FileError, "parts/0000.h5: is missing"):
            _ = voussoir.Run(self.folder).energy.kinetic

    def test_rotations(self):
        axis, angle = np.array([2.0, -3.0, 6.0]) / 7.0, 0.7
        turn = voussoir.results.rotation_matrices(np.array([[np.cos(angle / 2), *(np.sin(angle / 2) * axis)]]))[0]
        for v in np.eye(3):  # Rodrigues
            turned = v * np.cos(angle) + np.cross(axis, v) * np.sin(angle) + axis * (axis @ v) * (1.0 - np.cos(angle))
            self.assertTrue(np.allclose(turn @ v, turned, atol=1e-14))

    def test_the_same_twice_and_from_the_command_line(self):
        again = blocks().run(self.folder / "again", until=0.06, threads=2, progress=False)
        self.assertTrue(again.same_as(self.run_))
        other = blocks().run(self.folder / "other", until=0.05, progress=False)
        self.assertFalse(other.same_as(self.run_))
        other.resume(until=0.06, progress=False)
        self.assertEqual(other.summary["state_hash"], self.run_.summary["state_hash"])

    def test_page_and_words(self):
        page = self.run_.report(output=self.folder / "page.html")
        self.assertIn("</html>", page.read_text())
        self.assertIn("grade", self.run_.describe())

    def test_plots(self):
        try:
            import matplotlib
        except ImportError:
            self.skipTest("no matplotlib")
        matplotlib.use("Agg")
        from voussoir import plots
        for figure in (self.run_.plot_histories(), self.run_.plot_energy(), self.run_.plot_damage(first=True),
                       plots.histories([self.run_, self.run_], ["upper:z"], quantity="velocity")):
            plots.save(figure, self.folder / "figure.svg")
            self.assertIn("time, s", (self.folder / "figure.svg").read_text())
        with self.assertRaisesRegex(voussoir.VoussoirError, "no history 'lower'"):
            self.run_.plot_histories(show=["lower:x"])
