# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Tests of the package, with the real program. Run by `scripts/python/test`, which counts them."""

import csv
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import textwrap
import time
import tomllib
import unittest

import numpy as np

import voussoir
from voussoir import commands, shapes, toml


def blocks(duration=0.1):
    """Two bonded blocks on the base, shaken."""
    model = voussoir.Model("Two bonded blocks")
    model["gravity.settle"] = False
    model["time.duration"] = duration
    model.material("stone", density=2000.0, young=1e8, poisson=0.2)
    model.joint_law("mortar", tension=1e5, cohesion=1e5, friction=30.0, compression=1e6)
    model["joints.default"] = "mortar"
    model["base.z"] = 0.0
    model.box("lower", [0, 0, 0], [0.2, 0.2, 0.2], material="stone")
    model.box("upper", [0, 0, 0.2], [0.2, 0.2, 0.4], material="stone")
    model.follow("upper", [0.1, 0.1, 0.3])
    model.motion("bam-like")
    return model


class InAFolder(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)


class Toml(unittest.TestCase):
    def test_what_is_written_reads_back(self):
        table = {"a": 1, "b": -0.1, "c": "quote \" backslash \\ line\nend \x7f ü", "d": True, "e": [[1.0, 2.0], [3.0, 1e-300]], "f": [],
                 "with space": {"x": np.float64(0.1), "y": np.int64(7), "z": np.array([1.5, 2.5])},
                 "many": [{"n": 1, "in": {"k": "v"}}, {"n": 2, "deep": [{"q": 0}]}]}
        back = tomllib.loads(toml.document(table))
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
        """What the program makes of a block with this shape: volume by its mass."""
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

    def test_what_a_case_cannot_take_is_refused_by_name(self):
        vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
        faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
        with self.assertRaisesRegex(voussoir.InputError, 'block "tetra".*hexahedra, and prisms'):
            shapes.shape_of("tetra", vertices, faces)
        with self.assertRaisesRegex(voussoir.InputError, "0 to 3"):
            shapes.shape_of("tetra", vertices, [(0, 1, 4)])
        with self.assertRaisesRegex(voussoir.InputError, "no area"):
            shapes.shape_of("flat", [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 0, 1]], [(0, 1, 2)])
        with self.assertRaisesRegex(voussoir.InputError, "not finite"):
            shapes.shape_of("nan", [[np.nan, 0, 0]] * 8)
        with self.assertRaisesRegex(voussoir.InputError, "without faces"):
            shapes.shape_of("four", vertices)


class Errors(InAFolder):
    def test_the_message_is_the_programs(self):
        model = blocks()
        model["materials.stone.density"] = -3.0
        with self.assertRaisesRegex(voussoir.InputError, r"two-bonded-blocks\.toml:\d+: materials\.stone\.density.*-3.*> 0") as caught:
            model.check()
        self.assertEqual(caught.exception.code, 2)

    def test_keys_that_it_does_not_know(self):
        model = voussoir.Model(include="flat20n")
        model.house(colour="red")
        with self.assertRaisesRegex(voussoir.InputError, "colour"):
            model.check()

    def test_a_folder_without_results(self):
        with self.assertRaisesRegex(voussoir.FileError, "no such file"):
            voussoir.Run(self.folder).summary
        with self.assertRaises(voussoir.FileError):
            voussoir.Run(self.folder).resume(progress=False)

    def test_results_that_are_there_are_not_replaced(self):
        blocks().run(self.folder / "run", progress=False)
        with self.assertRaisesRegex(voussoir.FileError, "overwrite"):
            blocks().run(self.folder / "run", progress=False)
        blocks().run(self.folder / "run", progress=False, overwrite=True)

    def test_a_program_that_is_not_there(self):
        before = os.environ.get("VOUSSOIR")
        os.environ["VOUSSOIR"] = str(self.folder / "voussoir")
        try:
            with self.assertRaisesRegex(voussoir.ProgramNotFound, "No such file.*VOUSSOIR="):
                voussoir.version()
        finally:
            os.environ.pop("VOUSSOIR") if before is None else os.environ.update(VOUSSOIR=before)


class Models(InAFolder):
    def test_a_house_from_keyword_arguments_is_the_tutorials(self):
        model = voussoir.Model("A hut of large mud blocks", include="flat20w")
        model.house(inner_size=[2.8, 2.0], height=2.0, brick=[0.4, 0.2, 0.2],
                    openings=[voussoir.opening("front", start=1.0, width=0.8, height=1.6, lintel={"length": 1.2, "height": 0.2})])
        model["damping.frequency"] = 8.0
        model.motion("bam-like", direction="TLV")
        model["time.duration"] = 6.0
        for name, point in {"left": [0.1, 1.2, 1.7], "front": [2.4, 0.1, 1.7], "rear": [1.6, 2.3, 1.7]}.items():
            model.follow(name, point)
        theirs = voussoir.Model(include=ROOT / "cases/tutorial/hut.toml")

        def counts(text):  # without the lines that name the file
            return text.splitlines()[1:]
        self.assertEqual(counts(model.check()), counts(theirs.check()))

    def test_frequencies(self):
        found = blocks().modes(2)
        self.assertEqual(len(found), 2)
        self.assertTrue(0.0 < found[0] <= found[1])

    def test_keys_by_their_path(self):
        model = voussoir.Model()
        model["time.duration"] = 3.0
        self.assertEqual(model["time.duration"], 3.0)
        model["time.duration"] = None
        with self.assertRaises(KeyError):
            model["time.duration"]

    def test_files_are_named_from_anywhere(self):
        (self.folder / "x.csv").write_text("t [s],a [m/s2]\n0,0\n0.05,1\n0.1,0\n")
        here = os.getcwd()
        os.chdir(self.folder)
        try:
            model = blocks()
            model.motion(x="x.csv")
            path = model.write("case.toml")
            self.assertTrue(os.path.isabs(tomllib.loads(path.read_text())["motion"]["x"]))
            with self.assertRaisesRegex(voussoir.FileError, "exists"):
                model.write("case.toml")
        finally:
            os.chdir(here)


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

    def test_rotations(self):
        half = np.sqrt(0.5)
        turn = voussoir.results.rotation_matrices(np.array([[half, 0, 0, half]]))[0]  # 90 degrees about z
        self.assertTrue(np.allclose(turn @ [1, 0, 0], [0, 1, 0]))

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


class Running(InAFolder):
    def test_lines_of_progress(self):
        seen = commands.parse_progress("3.214 of 10 s  12,345 steps/s  2 min 10 s left  1,234 broken  residual 1.2e-06")
        self.assertEqual((seen.time, seen.end, seen.settling, seen.steps_per_second, seen.left, seen.broken, seen.residual),
                         (3.214, 10.0, False, 12345.0, "2 min 10 s left", 1234, 1.2e-06))
        self.assertEqual(commands.parse_progress("settling, -0.500 s  12 steps/s  time left unknown  0 broken  residual 0.0e+00").time, -0.5)
        self.assertIsNone(commands.parse_progress("voussoir: warning: something else"))

    def test_ctrl_c_stops_cleanly_and_the_run_goes_on(self):
        script = textwrap.dedent(f"""
            import sys
            sys.path[:0] = [{str(HERE)!r}, {str(HERE.parent)!r}]
            import voussoir, test_voussoir
            try:
                test_voussoir.blocks().run({str(self.folder / "run")!r}, until=10.0, threads=1, progress=lambda p: print(p.time, flush=True))
            except voussoir.Stopped as error:
                print("stopped:", error)
        """)
        straight = blocks().run(self.folder / "straight", until=10.0, threads=1, progress=False)
        child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
        first = child.stdout.readline()
        child.send_signal(signal.SIGINT)
        rest = child.stdout.read()
        child.stdout.close()
        self.assertEqual(child.wait(), 0)
        self.assertIn("stopped: the run was stopped", rest)
        run = voussoir.Run(self.folder / "run")
        self.assertFalse(run.finished)
        self.assertLess(float(first), 10.0)
        run.resume(progress=False)
        self.assertTrue(run.finished)
        self.assertTrue(run.same_as(straight))

    def test_a_fault_in_the_callers_progress_stops_the_run(self):
        def bad(_):
            raise RuntimeError("of the caller")
        with self.assertRaisesRegex(RuntimeError, "of the caller"):
            blocks().run(self.folder / "run", until=5.0, threads=1, progress=bad)
        self.assertFalse(voussoir.Run(self.folder / "run").finished)


class Studies(InAFolder):
    @staticmethod
    def build(young, scale):
        model = blocks(0.02)
        model["materials.stone.young"] = young
        model["motion.scale"] = scale
        return model

    def test_a_run_for_each_combination_and_no_run_twice(self):
        def study():
            return voussoir.Study(self.folder / "study", self.build, young=[1e8, 2e8], scale=[0.5, 1.0])
        study().run(workers=2, quiet=True)
        before = (self.folder / "study/young=1e+08,scale=0.5/run.h5").stat().st_mtime_ns
        done = study().run(quiet=True)
        self.assertEqual((self.folder / "study/young=1e+08,scale=0.5/run.h5").stat().st_mtime_ns, before)
        self.assertEqual(len(list(done)), 4)
        self.assertEqual([point["scale"] for point, _ in done], [0.5, 1.0, 0.5, 1.0])
        with open(done.write(self.folder / "table.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["status"] for row in rows], ["done"] * 4)
        self.assertGreater(float(rows[1]["peak_speed"]), float(rows[0]["peak_speed"]))

    def test_another_model_is_refused(self):
        voussoir.Study(self.folder, self.build, young=[1e8], scale=[1.0]).run(quiet=True)
        with self.assertRaisesRegex(voussoir.InputError, "another model"):
            voussoir.Study(self.folder, self.build, young=[1e8], scale=[1.0]).run(until=0.03, quiet=True)

    def test_faults_come_before_runs(self):
        with self.assertRaises(voussoir.InputError):
            voussoir.Study(self.folder, self.build, young=[1e8, -1.0], scale=[1.0]).run(quiet=True)
        self.assertFalse((self.folder / "young=1e+08,scale=1").exists())


class Program(unittest.TestCase):
    def test_what_the_command_line_has(self):
        self.assertTrue(voussoir.version().startswith("voussoir "))
        self.assertIn("flat20n", voussoir.ready_cases())
        self.assertIn("L", voussoir.motion("bam-like"))
        self.assertIn("materials", voussoir.call("keys"))


HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]

if __name__ == "__main__":
    unittest.main()
