# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the files that the package writes replace: files of their own kind, and nothing else."""

import json
import os
import re
import socket
import stat
import tempfile
from unittest import mock

import voussoir
from fixture import InAFolder, blocks
from voussoir import outputs

try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib.figure import Figure
    from voussoir import plots
except ImportError:
    plots = None


class Outputs(InAFolder):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.run_ = blocks().run(f"{scratch.name}/pair", until=0.01, threads=1, progress=False)

    def writers(self):
        """Functions of a path that write, with the end of its name."""
        model, study = blocks(), voussoir.Study(self.folder / "study", lambda size: voussoir.Model(), size=[1, 2])
        found = {".toml": lambda path: model.write(path, overwrite=True), ".csv": lambda path: study.write(path, overwrite=True),
                 ".json": lambda path: voussoir.compas.write(self.run_, path, overwrite=True), ".html": lambda path: model.view(path, overwrite=True)}
        if plots:
            for end in outputs.FIGURES:
                found[end] = lambda path: plots.save(Figure(), path)
        return found

    def refused(self, write, path, words):
        with self.assertRaisesRegex(voussoir.FileError, f"^{re.escape(str(path))}: .*{words}"):
            write(path)

    def test_what_is_no_table_is_told_from_one(self):
        for text in (b"# made\nt,x\n0,1\n", b"t,x\n", b'a,"b, c"\n1,2\n', b"1,2\n3,4", b"t,x,y\n0,1"):
            self.assertTrue(outputs.TABLE.fits(text), text)
        for text in (b"#!/bin/sh\necho 1, 2\n", b"Dear Sir, I write\nto tell you, briefly, and in short\n", b"One line, a sentence.", b"a = 1, 2", b"{1, 2}"):
            self.assertFalse(outputs.TABLE.fits(text), text)

    def test_links_folders_pipes_and_devices_are_refused(self):
        for end, write in self.writers().items():
            with self.subTest(end):
                path, other = self.folder / f"out{end}", self.folder / f"other{end}"
                write(other)
                before = other.read_bytes()
                path.symlink_to(other)
                self.refused(write, path, "is a symbolic link")
                self.assertEqual((other.read_bytes(), path.is_symlink()), (before, True))
                path.unlink()
                path.symlink_to(self.folder / "none")
                self.refused(write, path, "is a symbolic link")
                self.assertFalse((self.folder / "none").exists())
                path.unlink()
                path.mkdir()
                self.refused(write, path, "is a folder")
                path.rmdir()
                os.mkfifo(path)
                self.refused(write, path, "is a pipe")
                path.unlink()
                with socket.socket(socket.AF_UNIX) as bound:
                    bound.bind(str(path))
                    self.refused(write, path, "is a socket")
                path.unlink()
                try:
                    os.mknod(path, stat.S_IFCHR | 0o600, os.makedev(1, 3))  # a device of its own: a test that fails may replace it
                except PermissionError:
                    continue
                self.refused(write, path, "is a device")
                path.unlink()

    def test_a_file_of_another_kind_is_refused(self):
        strangers = {"notes": b"some notes\nof mine\n", "script": b"#!/bin/sh\nrm -r results\n", "bytes": bytes(range(256)), "json": b'{"model": [1, 2]}',
                     "array": b"[true, 1]", "toml": b'[project]\nname = "mine"\n', "study": b'title = "Two"\ncases = ["a.toml"]\n',
                     "record": b"# Accelerations in m/s2\nfiles = 1\n", "blanks": b" " * 5000}
        for end, write in self.writers().items():
            for name, contents in strangers.items():
                with self.subTest(end, stranger=name):
                    path = self.folder / f"out{end}"
                    path.write_bytes(contents)
                    self.refused(write, path, "and is not replaced by one")
                    self.assertEqual(path.read_bytes(), contents)

    def test_files_of_the_same_kind_and_empty_ones_are_replaced(self):
        for end, write in self.writers().items():
            with self.subTest(end):
                path = self.folder / f"out{end}"
                path.touch()
                write(path)
                first = path.stat()
                self.assertGreater(first.st_size, 0)
                write(path)
                self.assertNotEqual(path.stat().st_ino, first.st_ino)  # another file in its place, whole at any moment
        self.assertEqual([name for name in os.listdir(self.folder) if not name.startswith("out")], [])

    def test_without_overwrite_nothing_is_replaced(self):
        study = voussoir.Study(self.folder / "study", lambda size: voussoir.Model(), size=[1, 2])
        for name, write in {"a.toml": blocks().write, "a.csv": study.write, "a.json": lambda path: voussoir.compas.write(self.run_, path)}.items():
            path = write(self.folder / name)
            self.refused(write, path, "exists; overwrite=True replaces it")
        self.assertEqual(json.loads((self.folder / "a.json").read_text())["time"], self.run_.frames[-1].time)

    def test_a_case_does_not_replace_what_it_includes(self):
        path = blocks().write(self.folder / "case.toml")
        before, model = path.read_bytes(), voussoir.Model("Over it", include=path)
        os.link(path, self.folder / "second.toml")
        for name in (path, self.folder / "second.toml"):
            self.refused(lambda path: model.write(path, overwrite=True), name, "is an input")
        self.assertEqual(path.read_bytes(), before)

    def test_a_fault_leaves_what_was_there(self):
        path = blocks().write(self.folder / "case.toml")
        before = path.read_bytes()
        with mock.patch("os.replace", side_effect=OSError(28, "No space left on device")):
            self.refused(lambda path: blocks().write(path, overwrite=True), path, "cannot be written: No space left")
        self.assertEqual((path.read_bytes(), os.listdir(self.folder)), (before, ["case.toml"]))
        self.refused(blocks().write, self.folder / "none" / "case.toml", "there is no folder")
        with self.assertRaises(voussoir.FileError) as caught:
            blocks().write(path)
        self.assertEqual(caught.exception.file, str(path))

    def test_files_of_a_study_are_not_written_through_links(self):
        mine = self.folder / "mine.txt"
        mine.write_text("mine")
        for name in ("size=1.toml", "size=1.toml.tmp"):
            (self.folder / "study").mkdir(exist_ok=True)
            (self.folder / "study" / name).symlink_to(mine)
        study = voussoir.Study(self.folder / "study", lambda size: blocks(0.01), size=[1])
        with self.assertRaisesRegex(voussoir.FileError, "size=1.toml: is a symbolic link"):
            study.run(quiet=True)
        self.assertEqual(mine.read_text(), "mine")
        (self.folder / "study/size=1.toml").unlink()
        self.assertEqual(study.run(quiet=True).status("size=1"), "done")
        self.assertEqual(mine.read_text(), "mine")
