# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Models, and what is wrong with them."""

import os
import unittest

import voussoir
from fixture import ROOT, InAFolder, blocks
from voussoir import toml_reading


class Errors(InAFolder):
    def test_the_message_is_the_programs(self):
        model = blocks()
        model["materials.stone.density"] = -3.0
        with self.assertRaisesRegex(voussoir.InputError, r"two-bonded-blocks\.toml:\d+: materials\.stone\.density.*-3.*> 0") as caught:
            model.check()
        error = caught.exception
        self.assertEqual((error.code, error.key, error.value), (2, "materials.stone.density", "-3 kg/m3"))
        self.assertTrue(error.file.endswith("two-bonded-blocks.toml"))
        self.assertEqual(model.text().splitlines()[error.line - 1], "density = -3.0")
        self.assertIn("> 0", error.allowed)
        self.assertEqual(error.faults[0].text, str(error))

    def test_all_faults_are_told(self):
        model = blocks()
        model["materials.stone.density"], model["time.duration"] = -3.0, -1.0
        with self.assertRaises(voussoir.InputError) as caught:
            model.check()
        self.assertEqual({fault.key for fault in caught.exception.faults}, {"materials.stone.density", "time.duration"})
        self.assertEqual(str(caught.exception), "\n".join(fault.text for fault in caught.exception.faults))

    def test_faults_of_files_and_options(self):
        with self.assertRaises(voussoir.FileError) as caught:
            voussoir.summary(self.folder / "none")
        self.assertTrue(caught.exception.file.startswith(str(self.folder / "none")))
        self.assertIsNone(caught.exception.key)
        blocks().run(self.folder / "run", progress=False)
        with self.assertRaises(voussoir.InputError) as caught:
            voussoir.resume(self.folder / "run", until=0.01, progress=False)
        self.assertEqual((caught.exception.key, caught.exception.line), ("--until", None))
        with self.assertRaises(voussoir.FileError) as caught:
            voussoir.Run(self.folder).energy
        self.assertEqual((caught.exception.file, caught.exception.faults), (None, ()))  # of the package itself

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

        def counts(text):  # without the lines that name the file, and those of how long a run takes on this machine
            return [line for line in text.splitlines()[1:] if not line.startswith("estimate") and "time.multirate" not in line]
        self.assertEqual(counts(model.describe()), counts(theirs.describe()))
        self.assertEqual(model.check().bill, theirs.check().bill)

    def test_frequencies(self):
        found = blocks().modes(2)
        self.assertEqual(len(found), 2)
        self.assertTrue(0.0 < found[0].frequency <= found[1].frequency)
        self.assertEqual(found.frequencies, (found[0].frequency, found[1].frequency))
        self.assertEqual((len(found[0].mass_share), found.impulse, found.held_by_nothing), (3, None, ()))

    def test_the_page_of_the_model(self):
        page = blocks().view(self.folder / "two.html")
        self.assertIn("Two bonded blocks", page.read_text())
        with self.assertRaisesRegex(voussoir.FileError, "exists"):
            blocks().view(page)
        model = blocks()
        model.box("third", [0, 0, 0.3], [0.2, 0.2, 0.5], material="stone")
        with self.assertRaisesRegex(voussoir.InputError, "overlaps"):
            model.view(page, overwrite=True)

    def test_limit_analysis(self):
        model = voussoir.Model("A slender block")
        model.material("stone", density=2000.0, young=1e9, poisson=0.2)
        model["base.z"] = 0.0
        model.box("a", [0, 0, 0], [0.2, 0.5, 1.0], material="stone")
        try:
            found = model.limit()
        except voussoir.VoussoirError as error:
            self.assertIn("Clp", str(error))  # a build without it
            return
        self.assertTrue(found.proven)
        self.assertLessEqual(found.multiplier, found.associated + 1e-9)
        self.assertEqual(found.data["associated"]["multiplier"], found.associated)
        self.assertAlmostEqual(found.associated, 0.2 * (1 - 1 / 4), places=9)  # width over height, with contact points at the centres of four segments

    def test_keys_by_their_path(self):
        model = voussoir.Model()
        model["time.duration"] = 3.0
        self.assertEqual(model["time.duration"], 3.0)
        model["time.duration"] = None
        with self.assertRaises(KeyError):
            model["time.duration"]

    def files_of(self, change):
        """The case file of a model after a change, in a folder with the files x.csv and "#1.csv"."""
        for name in ("x.csv", "#1.csv"):
            (self.folder / name).write_text("t [s],a [m/s2]\n0,0\n0.05,1\n0.1,0\n")
        here = os.getcwd()
        os.chdir(self.folder)
        try:
            model = blocks()
            change(model)
            return toml_reading.loads(model.write("case.toml", overwrite=True).read_text())
        finally:
            os.chdir(here)

    def test_files_are_named_from_anywhere(self):
        there = str((self.folder / "x.csv").resolve())
        self.assertEqual(self.files_of(lambda m: m.motion(x="x.csv"))["motion"]["x"], there)
        self.assertEqual(self.files_of(lambda m: m.motion("x.csv"))["motion"]["record"], there)
        self.assertEqual(self.files_of(lambda m: m.load("upper", history="x.csv"))["load"][0]["history"], there)
        moved = self.files_of(lambda m: m.box("b", [0, 0, 0], [1, 1, 1], material="stone", fixed=True, motion={"file": "x.csv"}))
        self.assertEqual(moved["block"][2]["motion"]["file"], there)
        with self.assertRaisesRegex(voussoir.FileError, "exists"):
            voussoir.Model().write(self.folder / "case.toml")

    def test_files_of_any_key_are_named_from_anywhere(self):
        there = str((self.folder / "x.csv").resolve())

        def sinks(model):
            model["base.part"] = [{"x": [0.0, 1.0], "y": [0.0, 1.0], "level": 0.2, "motion": {"file": "x.csv"}}]
        self.assertEqual(self.files_of(sinks)["base"]["part"][0]["motion"]["file"], there)
        self.assertEqual(self.files_of(lambda m: m.__setitem__("motion.x", "x.csv"))["motion"]["x"], there)
        self.assertEqual(self.files_of(lambda m: m.__setitem__("title", "x.csv"))["title"], "x.csv")  # no key of a file

    def test_a_component_of_a_file_is_named_from_anywhere(self):
        there = self.folder.resolve()
        self.assertEqual(self.files_of(lambda m: m.motion(x="x.csv#90 DEG"))["motion"]["x"], f"{there}/x.csv#90 DEG")
        self.assertEqual(self.files_of(lambda m: m.motion(x="#1.csv"))["motion"]["x"], f"{there}/#1.csv")  # a name of its own
        self.assertEqual(self.files_of(lambda m: m.motion("bam-like#7"))["motion"]["record"], "bam-like#7")


class Program(unittest.TestCase):
    def test_what_the_command_line_has(self):
        self.assertTrue(voussoir.version().startswith("voussoir "))
        self.assertIn("flat20n", voussoir.ready_cases())
        self.assertEqual([one.component for one in voussoir.motion("bam-like")], ["L", "T", "V"])
        self.assertIn("materials", voussoir.call("keys"))
