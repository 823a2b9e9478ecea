# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What a study replaces in its folder: files of its own alone, no links, nothing of the user's (io/README.md, "What an output replaces")."""

import contextlib
import csv
import importlib.machinery
import importlib.util
import io
import json
import os
import pathlib
import subprocess
import sys
from unittest import mock

from fixture import ROOT, InAFolder

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "study"), str(pathlib.Path(__file__).resolve().parents[1] / "voussoir")]
import own_files  # noqa: E402
import plan  # noqa: E402
import program  # noqa: E402

SCRIPT = ROOT / "scripts/study/run"
LOADER = importlib.machinery.SourceFileLoader("study_run", str(SCRIPT))
study_run = importlib.util.module_from_spec(importlib.util.spec_from_loader("study_run", LOADER))
LOADER.exec_module(study_run)

MINE = {
    "plan.json": '{"name": "a plan of mine"}\n',
    "table.csv": "name,price\nlime,3\n",
    "main.csv": "name,price\nlime,3\n",
    "index.html": "<!DOCTYPE html>\n<title>Mine</title><p>3 of 4 runs done</p>\n",
    "plots/damage_grade.svg": "not a drawing\n",
}
OLD_PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>A study</title><style>body { font: 14px/1.4 sans-serif }</style></head><body>
<h1>A study</h1>
<p>0 of 1 runs done, 0 collapsed, 0 core-hours. Times in s, forces in N, speeds in m/s; first crack −1: none.</p>
"""


class Folder(InAFolder):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"
        self.out.mkdir()
        self.study = self.folder / "s.toml"
        self.study.write_text("cases = ['arch']\n")

    def words(self, *more):
        return [str(SCRIPT), str(self.study), "-o", str(self.out), "--cores", "1", *map(str, more)]

    def refused(self, path, words, *more):
        """The script says so and ends before it starts any program; here it is run in this process, which starts none."""
        said = io.StringIO()
        with mock.patch.object(sys, "argv", self.words(*more)), mock.patch("subprocess.run", side_effect=AssertionError), contextlib.redirect_stderr(said):
            self.assertEqual(study_run.main(), 2)
        self.assertIn(f"study: {path}: {words}", said.getvalue())
        self.assertIn("give another folder by -o", said.getvalue())
        self.assertFalse((self.out / "runs/arch/identity").exists())

    def test_links_are_neither_followed_nor_replaced(self):
        for name in (".study", "plan.json", "table.csv", "main.csv", "index.html", "plots/damage_grade.svg", "runs/arch/program.log", "runs/arch/.job"):
            target, link = self.folder / "target", self.out / name
            link.parent.mkdir(parents=True, exist_ok=True)
            link.symlink_to(target)
            with self.subTest(name=name):
                self.refused(link, "is a symbolic link")
                self.assertFalse(target.exists())
                target.write_text("mine")
                self.refused(link, "is a symbolic link")
                self.assertEqual(target.read_text(), "mine")
                self.assertTrue(link.is_symlink())
                target.unlink()
            link.unlink()

    def test_folders_that_are_links(self):
        for name in ("runs", "plots", "runs/arch", ".snakemake"):
            link, target = self.out / name, self.folder / "elsewhere"
            target.mkdir()
            link.parent.mkdir(exist_ok=True)
            link.symlink_to(target)
            self.refused(link, "is a symbolic link")
            self.assertEqual(list(target.iterdir()), [])
            link.unlink()
            target.rmdir()

    def test_pipes_and_folders_in_place_of_files(self):
        for name in (".study", "plan.json", "table.csv", "index.html"):
            path = self.out / name
            os.mkfifo(path)
            self.refused(path, "is a pipe")
            path.unlink()
            path.mkdir()
            self.refused(path, "is a folder")
            path.rmdir()

    def test_what_no_study_wrote_stays(self):
        for name, text in MINE.items():
            path = self.out / name
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)
            self.refused(path, "is no ")
            self.refused(path, "is no ", "--check")
            self.assertEqual(path.read_text(), text)
            path.unlink()

    def test_a_run_that_no_study_made_stays(self):
        path = self.out / "runs/arch/run.h5"
        path.parent.mkdir(parents=True)
        path.write_text("mine")
        self.refused(path.parent, "holds a run that no study made")
        self.assertEqual(path.read_text(), "mine")

    def test_a_table_of_what_is_there_replaces_nothing_else_either(self):
        (self.out / "plan.json").write_text(json.dumps({"voussoir": "voussoir", "threads": 1, "runs": []}))
        (self.out / "index.html").write_text(MINE["index.html"])
        self.refused(self.out / "index.html", "is no page of a study", "--table")
        self.assertFalse((self.out / "table.csv").exists())

    def test_a_file_in_place_of_the_folder(self):
        self.out.rmdir()
        self.out.write_text("mine")
        self.refused(self.out, "is no folder")
        file, self.out = self.out, self.out / "in"
        self.refused(file, "is no folder")

    def test_a_folder_of_an_earlier_study_goes_on(self):
        runs = plan.expand(plan.read_study(self.study), self.study)
        version = plan.version_of(program.program())
        known = self.folder / "known.csv"
        known.write_text(f"run,case,identity,status,version,starts,wall_clock,core_hours\narch,arch,{runs[0]['identity']},done,{version},1,1.0,0.1\n")
        (self.out / "plan.json").write_text('{\n "title": "",\n "threads": 1,\n "voussoir": "v",\n "runs": []\n}\n')
        (self.out / "table.csv").write_text("run,case,direction,record,scale,options,seed,status\narch,arch,,,,,,to be done\n")
        (self.out / "index.html").write_text(OLD_PAGE)
        (self.out / ".study").touch()
        done = subprocess.run(self.words("--known", known), capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 of 1 runs done", (self.out / "index.html").read_text())
        with open(self.out / "table.csv", newline="") as file:
            self.assertEqual([row["status"] for row in csv.DictReader(file)], ["done"])
        self.assertEqual((self.out / "main.csv").read_text(), "run,case,status\narch,arch,done\n")
        self.assertEqual([path.name for path in self.out.iterdir() if path.name.endswith(".tmp")], [])
        own_files.check_outputs(self.out, plan.PLOTS, ["arch"])  # its own files of today
        for left in ('{\n "title": "", "thr', ""):  # by a kill of an earlier version
            (self.out / "plan.json").write_text(left)
            own_files.check_outputs(self.out, plan.PLOTS, ["arch"])

    def test_what_appears_later_is_not_written_through(self):
        target, link = self.folder / "target", self.out / "table.csv"
        link.symlink_to(target)
        for write in (lambda: own_files.opened(link, os.O_RDWR), lambda: own_files.replacing(link).__enter__()):
            with self.assertRaisesRegex(plan.StudyError, "table.csv: is a symbolic link"):
                write()
        link.unlink()
        temporary = self.out / "table.csv.tmp"
        temporary.symlink_to(target)
        with self.assertRaisesRegex(plan.StudyError, "table.csv.tmp: is a symbolic link"):
            own_files.replacing(link, ".tmp").__enter__()
        self.assertFalse(target.exists())
