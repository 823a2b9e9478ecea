# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Paths and texts that nothing can hold are refused as faults of the package, which name them; nothing is written, nothing is run."""

import os

import voussoir
from fixture import InAFolder, blocks

ODD = {"zero": ("a\0b", r"a\\x00b.*number zero"), "half": ("a\ud800b", r"a\\ud800b.*surrogates")}


class OddNames(InAFolder):
    def setUp(self):
        super().setUp()
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)

    def test_words_of_the_program(self):
        """All functions that start it."""
        model, run = blocks(), voussoir.Run("none")
        calls = {"check": voussoir.check, "limit": voussoir.limit, "modes": voussoir.modes, "run": voussoir.run, "resume": voussoir.resume,
                 "assess": voussoir.assess, "summary": voussoir.summary, "study": voussoir.study, "motion": voussoir.motion, "call": voussoir.call,
                 "compare": lambda odd: voussoir.compare("none", odd), "view": lambda odd: voussoir.view(odd, "a.html"),
                 "-o": lambda odd: model.view(f"{odd}.html"), "--draw": lambda odd: model.check(draw=odd), "--shapes": lambda odd: model.modes(shapes=odd),
                 "--maps": lambda odd: voussoir.assess("none", maps=odd), "--spectra": lambda odd: voussoir.motion("bam-like", spectra=odd),
                 "--known": lambda odd: voussoir.study("a.toml", known=[odd]), "options": lambda odd: voussoir.run("flat20n", options=[odd]),
                 "run to": lambda odd: voussoir.run("flat20n", odd), "Model.run": lambda odd: model.run(odd), "Model.start": lambda odd: model.start(odd),
                 "Model.limit": lambda odd: model.limit(direction=odd), "Run": lambda odd: voussoir.Run(odd).describe(),
                 "film": run.film, "stills": lambda odd: run.stills([0.0], views=[odd]), "report": lambda odd: run.report(output=odd)}
        for kind, (odd, words) in ODD.items():
            for name, use in calls.items():
                with self.subTest(name, kind=kind):
                    with self.assertRaisesRegex(voussoir.InputError, words) as caught:
                        use(odd)
                    str(caught.exception).encode()  # it can be printed
                    if name.startswith("-"):
                        self.assertEqual(caught.exception.key, name)
        self.assertEqual(os.listdir(), [])

    def test_texts_of_a_case(self):
        for kind, (odd, words) in ODD.items():
            for key, model in {"title": voussoir.Model(odd), "include": voussoir.Model(include=odd), "motion.record": self.model("motion", odd),
                               "stones.file": self.model("add_stones", odd, unit="m"), "title ": voussoir.Model().add(voussoir.parts.Case(title=odd)),
                               "load.block": self.model("load", odd)}.items():
                for use in (model.text, model.check, model.describe, lambda: model.write("case.toml"), lambda: model.run("run")):
                    with self.subTest(key, kind=kind), self.assertRaisesRegex(voussoir.InputError, f"^{key.strip()}: .*{words}") as caught:
                        use()
                    self.assertEqual(caught.exception.key, key.strip())
        with self.assertRaisesRegex(voussoir.InputError, r"materials\.a\\x00b"):
            self.model("material", "a\0b", density=1.0, young=1.0, poisson=0.0).check()
        with self.assertRaisesRegex(voussoir.InputError, "time.duration: nan is not a finite number"):
            blocks(float("nan")).check()
        self.assertEqual(os.listdir(), [])

    def model(self, method, *values, **keys):
        made = voussoir.Model()
        getattr(made, method)(*values, **keys)
        return made

    def test_paths_that_the_package_itself_opens(self):
        study = voussoir.Study("none", lambda size: blocks(), size=[1])
        for odd in ("a\0b", "a\ud800b", 5000 * "x"):
            for name, use in {"Run": lambda odd: voussoir.Run(odd).state, "file": lambda odd: voussoir.Run(odd).file, "Model.write": blocks().write,
                              "compas": voussoir.compas.model_of, "Study.write": study.write, "call": lambda odd: voussoir.call("--version", folder=odd),
                              "Study": lambda odd: voussoir.Study(odd, lambda size: blocks(), size=[1]).run(quiet=True)}.items():
                with self.subTest(name, odd=odd[:3]), self.assertRaises(voussoir.FileError) as caught:
                    use(odd)
                self.assertTrue(str(caught.exception).startswith(odd if odd.isprintable() else ascii(odd)), str(caught.exception)[:80])
        self.assertEqual(os.listdir(), [])

    def test_a_text_too_long_for_a_path_is_a_name(self):
        with self.assertRaisesRegex(voussoir.InputError, "x{5000}"):
            voussoir.Model(include=5000 * "x").check()
        self.assertEqual(self.model("motion", 5000 * "x")["motion.record"], 5000 * "x")
        with self.assertRaisesRegex(voussoir.FileError, "none: is no folder"):
            voussoir.call("--version", folder="none")
