# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Study files: what cannot be read is refused in words. Each text was a finding of tests/fuzz/python_fuzz, or is its kin."""

import os
import pathlib
import subprocess
import sys

from fixture import ROOT, InAFolder

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "study"), str(pathlib.Path(__file__).resolve().parents[1] / "voussoir")]
import own_files  # noqa: E402
import plan  # noqa: E402
import versions  # noqa: E402


class StudyFiles(InAFolder):
    def runs(self, text):
        path = self.folder / "study.toml"
        path.write_text(text)
        return plan.expand(plan.read_study(path), path)

    def refuses(self, text, words):
        with self.assertRaisesRegex(plan.StudyError, words):
            self.runs(text)

    def test_each_module_finds_what_it_needs_by_itself(self):
        """Snakemake, the soak and the ensemble import some of them from elsewhere, with this folder alone on their path."""
        code = "import importlib, sys; sys.path.insert(0, sys.argv[1]); importlib.import_module(sys.argv[2])"
        for name in ("plan", "versions", "own_files", "gather", "job", "strength"):
            done = subprocess.run([sys.executable, "-c", code, str(ROOT / "scripts/study"), name], cwd=self.folder, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, (name, done.stderr))

    def test_integers_that_are_no_floats(self):
        for key in ("scales = [N]", "duration = N", "records = [{ name = 'a', L = 'b', dt = N }]", "[intensity]\nmeasure = 'PGA'\nlevels = [N]"):
            self.refuses("cases = ['flat20n']\n" + key.replace("N", "1" + 400 * "0"), "study.toml: .* allowed: ")

    def test_the_character_of_number_zero(self):
        for key in ("cases = ['flat20n', \"a\\u0000.toml\"]", "cases = ['flat20n']\nrecords = [\"a\\u0000b\"]", "cases = ['flat20n']\nset = [\"a=\\u0000\"]"):
            self.refuses(key, "study.toml: .* allowed: ")

    def test_names_too_long_for_files(self):
        self.assertEqual(len(self.runs(f"cases = ['{5000 * 'a'}']")), 1)  # the program says that there is no such case
        self.assertEqual(len(self.runs(f"cases = ['{5000 * 'a'}.toml']")), 1)

    def test_arrays_within_arrays(self):
        self.refuses("cases = " + 5000 * "[" + 5000 * "]", "too deep")

    def test_more_runs_than_can_be_meant(self):
        many = ", ".join(map(str, range(1, 1000)))
        self.refuses(f"cases = ['flat20n']\nset = ['scatter.variation=1']\nscales = [{many}]\nseeds = [{many}]", "stands for 998001 runs.*at most 50000")

    def test_known_tables_that_are_none(self):
        table = self.folder / "table.csv"
        for data in (b"run,identity,status\n\xf3,a,done\n", b'run\n"' + 200_000 * b"a" + b'"\n', b"run,name\na,b\n"):
            table.write_bytes(data)
            with self.assertRaisesRegex(plan.StudyError, "wanted a table.csv"):
                plan.finished_rows(table)


class WhatIsRead(InAFolder):
    """Regular files of a bounded size alone: a pipe blocks, a device does not end."""

    def odd(self, name):
        """A path under which there is a pipe, a device and a folder, in turn, and what is said of each."""
        path = self.folder / name
        os.mkfifo(path)
        yield path, "is not a regular file"
        path.unlink()
        path.symlink_to("/dev/zero")
        yield path, "is not a regular file"
        path.unlink()
        path.mkdir()
        yield path, "is a folder"
        path.rmdir()

    def test_pipes_and_devices_as_study_files_are_refused_at_once(self):
        for path, words in self.odd("s.toml"):
            done = subprocess.run([ROOT / "scripts/study/run", path, "-o", self.folder / "out"], capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (2, f"study: {path}: {words}; wanted a study file\n"))
            self.assertFalse((self.folder / "out").exists())

    def test_pipes_and_devices_as_case_files(self):
        for path, words in self.odd("c.toml"):
            with self.assertRaisesRegex(plan.StudyError, f"c.toml: {words}; wanted a case file"):
                plan.identity(str(path), [])
            self.assertTrue(versions.differs(str(path), []))

    def test_pipes_and_devices_as_known_tables(self):
        for path, words in self.odd("t.csv"):
            with self.assertRaisesRegex(plan.StudyError, f"t.csv: {words}; wanted a table.csv of a study"):
                plan.finished_rows(path)

    def test_pipes_among_what_is_there_of_a_run(self):
        for name in ("version", "identity"):
            path = self.folder / "runs/a" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            os.mkfifo(path)
            with self.assertRaisesRegex(plan.StudyError, f"{name}: is not a regular file"):
                plan.check_folder(self.folder, [{"name": "a", "identity": "0a"}], "0.1.0")
            path.unlink()

    def test_files_too_large_for_a_study_and_a_case(self):
        path = self.folder / "large.toml"
        with open(path, "wb") as file:
            file.truncate(own_files.LARGEST + 1)
        with self.assertRaisesRegex(plan.StudyError, "large.toml: has 16777217 bytes; a study file may have 16 MB"):
            plan.read_study(path)
        with self.assertRaisesRegex(plan.StudyError, "large.toml: has 16777217 bytes; a case file may have 16 MB"):
            plan.identity(str(path), [])

    def test_a_case_file_that_is_no_text(self):
        path = self.folder / "c.toml"
        path.write_bytes(b"name = '\xf3'\n")
        with self.assertRaisesRegex(plan.StudyError, "c.toml: .* wanted a case file"):
            plan.identity(str(path), [])

    def test_the_identity_of_a_run_is_that_of_earlier_versions(self):
        path = self.folder / "c.toml"
        path.write_bytes("name = 'Bóveda'\r\n".encode())
        self.assertEqual(plan.identity(str(path), ["a=1"]), "b10b4cda27c9505d")
        self.assertEqual(plan.identity("flat20n", []), "cb5b0bc9e8fe550c")
