# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The program as functions: of a Model, of objects, of a path; two at a time."""

import dataclasses
import os
import stat
import sys
import threading
import warnings

import voussoir
from fixture import InAFolder, blocks


class Functions(InAFolder):
    def test_a_model_and_its_file_are_the_same_case(self):
        model = blocks()
        path = model.write(self.folder / "blocks.toml")
        of_model, of_path = voussoir.check(model), voussoir.check(str(path))
        self.assertEqual(dataclasses.replace(of_model, run_seconds=None), dataclasses.replace(of_path, run_seconds=None))
        self.assertEqual((of_model.elements, of_model.joints, of_model.base_joints, of_model.findings), (2, 1, 1, ()))
        self.assertAlmostEqual(of_model.mass, 2 * 0.2**3 * 2000.0)
        line, = of_model.bill
        self.assertEqual((line.material, line.count, [round(edge, 9) for edge in line.edges]), ("stone", 2, [0.2, 0.2, 0.2]))
        self.assertIn("no faults found", str(of_model))
        with self.assertRaises(dataclasses.FrozenInstanceError):
            of_model.mass = 3.0

    def test_a_ready_case_by_its_name(self):
        self.assertGreater(voussoir.check("arch").elements, 10)

    def test_findings_are_warnings_and_results(self):
        model = blocks()
        model["damping.ratio"], model["damping.frequency"] = 0.05, 300.0
        with self.assertWarnsRegex(voussoir.ProgramWarning, "^damping.frequency"):
            found = voussoir.check(model)
        self.assertEqual(len(found.findings), 1)
        for use in (model.check, lambda: model.run(self.folder / "run", threads=1, progress=False), lambda: voussoir.check(model)):
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                use()
            self.assertEqual({os.path.basename(one.filename) for one in told}, {"test_functions.py"})  # the caller's line

    def test_first_steps_that_go_wrong_are_an_error(self):
        model = blocks()
        model["time.step"] = 3e-3
        with self.assertRaisesRegex(voussoir.InputError, "first steps go wrong"):
            voussoir.check(model)

    def test_run_resume_compare_assess_summary(self):
        path = blocks(0.05).write(self.folder / "blocks.toml")
        first = voussoir.run(path, self.folder / "first", threads=1, progress=False)
        second = voussoir.run(blocks(0.02), self.folder / "second", threads=1, progress=False)
        found = voussoir.compare(first, self.folder / "second")
        self.assertFalse(found)
        self.assertGreater(found.differing, 0)
        self.assertIn("dataset", found.first)
        second = voussoir.resume(second.folder, until=0.05, threads=1, progress=False)
        self.assertTrue(second.finished)
        told = voussoir.summary(second)
        self.assertEqual((told["finished"], told["collapsed"]), (1, 0))
        self.assertAlmostEqual(told["end_time"], 0.05, delta=1e-3)
        assessed = voussoir.assess(first, time=0.02)
        self.assertAlmostEqual(assessed.time, 0.02)
        self.assertAlmostEqual(assessed.weight, 2 * 0.2**3 * 2000.0 * 9.81, delta=1.0)
        self.assertGreater(assessed.base_shear.value, 0.0)
        self.assertEqual(assessed.storeys, ())

    def test_a_study_from_a_file(self):
        study = self.folder / "two.toml"
        blocks(0.02).write(self.folder / "blocks.toml")
        study.write_text('title = "Two"\ncases = ["blocks.toml"]\nscales = [0.5, 1.0]\n')
        table = voussoir.study(study, self.folder / "out", cores=1)
        self.assertTrue(table.finished)
        self.assertEqual([row["status"] for row in table], ["done", "done"])
        with self.assertRaises(voussoir.InputError):  # with and without Snakemake, which takes any
            voussoir.study(study, self.folder / "out", cores=-1)

    def test_figures_of_a_motion(self):
        found = voussoir.motion("bam-like")
        self.assertEqual([one.component for one in found], ["L", "T", "V"])
        self.assertTrue(all(one.peak_acceleration > 1.0 and one.stated_peak is None for one in found))


class TwoAtATime(InAFolder):
    def test_two_runs_from_two_threads_are_those_of_one_after_the_other(self):
        models = {name: blocks(5.0) for name in ("a", "b")}
        models["b"]["motion.scale"] = 0.5
        seen = {name: [] for name in models}
        failed = []

        def work(name):
            try:
                voussoir.run(models[name], self.folder / name, threads=1, progress=seen[name].append)
            except BaseException as error:
                failed.append(error)
        threads = [threading.Thread(target=work, args=(name,)) for name in models]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failed, [])
        for name, model in models.items():
            self.assertEqual(seen[name][-1].end, 5.0)
            alone = voussoir.run(model, self.folder / f"{name}-alone", threads=1, progress=False)
            self.assertTrue(voussoir.compare(self.folder / name, alone))
        self.assertFalse(voussoir.compare(self.folder / "a", self.folder / "b"))

    def test_a_fault_in_one_leaves_the_other(self):
        bad = blocks()
        bad["materials.stone.density"] = -1.0
        errors = []

        def work():
            try:
                voussoir.check(bad)
            except voussoir.InputError as error:
                errors.append(error.key)
        other = threading.Thread(target=work)
        other.start()
        self.assertTrue(voussoir.run(blocks(1.0), self.folder / "run", threads=1, progress=False).finished)
        other.join()
        self.assertEqual(errors, ["materials.stone.density"])


class Messages(InAFolder):
    """A program in place of the real one, for what the real one seldom says."""

    def said(self, code, *lines):
        fake = self.folder / "voussoir"
        fake.write_text(f"#!{sys.executable}\nimport sys\nsys.stderr.write({chr(10).join(lines)!r})\nsys.exit({code})\n")
        fake.chmod(fake.stat().st_mode | stat.S_IXUSR)
        before = os.environ.get("VOUSSOIR")
        os.environ["VOUSSOIR"] = str(fake)
        try:
            return voussoir.call("check", "x")
        finally:
            os.environ.pop("VOUSSOIR") if before is None else os.environ.update(VOUSSOIR=before)

    def test_kinds_that_it_does_not_know_and_texts_go_by(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(self.said(0, '{"kind": "later", "text": "?"}', '{"kind": "info", "text": "doing"}', "{not JSON", "[1]", ""), "")

    def test_what_is_said_beside_a_fault(self):
        with self.assertRaises(voussoir.FileError) as caught:
            self.said(3, '{"kind": "info", "text": "resume goes on"}', '{"kind": "error", "code": 3, "text": "a.h5: full", "file": "a.h5", "more": 1}',
                      "of a library")
        error = caught.exception
        self.assertEqual((str(error), error.file, error.line, error.remarks), ("a.h5: full\nof a library", "a.h5", None, ("resume goes on",)))

    def test_other_codes(self):
        with self.assertRaisesRegex(voussoir.ProcessorError, "too old"):
            self.said(4, "voussoir: too old")
        with self.assertRaisesRegex(voussoir.VoussoirError, "exit code 77"):
            self.said(77)
