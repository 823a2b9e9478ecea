# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Results that have a seal and make no sense are refused by every reader, with the name of what is wrong."""

import pathlib
import re
import subprocess
import tempfile

import h5py
import numpy as np

import voussoir
from fixture import InAFolder, blocks
from forging import contents_of, forge

LONGEST = 60.0  # s, far more than a reader takes


def put(name, index, value):
    def change(file):
        file[name][index] = value
    return change


def crack(**values):
    """Two rows of cracks, one of them with these values."""
    def change(file):
        for name, dataset in list(file["cracks"].items()):
            rows = np.zeros((2, *dataset.shape[1:]), dataset.dtype)
            del file["cracks"][name]
            if name in values:
                rows[1] = values[name]
            file["cracks"][name] = rows
        file.attrs["rows_cracks"] = 2
    return change


def replaced(name, value):
    def change(file):
        del file[name]
        file[name] = value
    return change


def cycle(file):
    file["energy/again"] = file["/"]


def external_storage(file):
    del file["energy/kinetic"]
    file.create_dataset("energy/kinetic", file["energy/time"].shape, "f8", external=[("/etc/passwd", 0, 8 * len(file["energy/time"]))])


def nested(file):
    group = file["energy"]
    for _ in range(200):
        group = group.create_group("deeper")


# What is changed, and how it is refused: at once, by all readers.
STRUCTURE = [
    (replaced("energy/kinetic", h5py.SoftLink("/energy/strain")), "/energy/kinetic is a soft link"),
    (replaced("energy/kinetic", h5py.ExternalLink("other.h5", "/x")), "/energy/kinetic is a link to another file"),
    (cycle, "is the same object as"),
    (lambda file: file.__setitem__("energy/kinetic2", file["energy/kinetic"]), "is the same object as /energy/kinetic"),
    (external_storage, "/energy/kinetic has its values in another file"),
    (lambda file: file.__setitem__("energy/type", np.dtype("f8")), "/energy/type is neither a group nor a dataset"),
    (nested, "is deeper than 16 groups"),
    (replaced("frames/time", 1.0), "/frames/time"),
    (replaced("model/element/house", np.zeros(3, "i4")), "/model/element/house is of 3, and not 2 as /model/element/mass"),
    (replaced("energy/kinetic", np.zeros(2)), "/energy/kinetic is of 2, and not"),
    (replaced("frames/quaternion", np.zeros((3, 2))), "/frames/quaternion"),
    (lambda file: replaced("forces/base_shear", np.zeros((len(file["forces/time"]), 1)))(file), "/forces/base_shear is of .* and not 3 as 3"),
    (lambda file: replaced("motion/acceleration", np.zeros(len(file["motion/time"])))(file), "/motion/acceleration is of"),
    (lambda file: replaced("energy/strain", np.zeros((len(file["energy/time"]), 0)))(file), "/energy/strain is of"),
    (lambda file: file.attrs.__setitem__("rows_energy", 10**12), "attribute rows_energy says 1000000000000"),
    (lambda file: file.attrs.__setitem__("rows_frames", -1), "attribute rows_frames says -1"),
]

# What is changed, how it is refused when it is read, the table of Python that holds it, and which of summary, assess and report read it, if
# not all of them.
VALUES = [
    (put("frames/time", 2, np.nan), "/frames/time: row 2 holds -?nan", "frames"),
    (put("frames/time", 2, -1.0), "/frames/time: row 2 holds -1[.0]*; allowed: a time after", "frames"),
    (put("frames/time", 2, 1e100), "/frames/time: row 2 holds 1.*e\\+100; allowed: -1e8 to 1e8 s", "frames"),
    (put("frames/quaternion", (1, 0), [0, 0, 0, 0]), "/frames/quaternion: row 1 holds 0", "frames"),
    (put("frames/quaternion", (1, 0), [2, 0, 0, 0]), "/frames/quaternion: row 1 holds 2", "frames"),
    (put("frames/displacement", (1, 0), [np.inf, 0, 0]), "/frames/displacement: row 1 holds inf", "frames"),
    (put("energy/time", 3, np.nan), "/energy/time: row 3 holds -?nan", "energy", ("summary", "report")),
    (put("energy/strain", 3, np.inf), "/energy/strain: row 3 holds inf", "energy", ("report",)),
    (put("model/element/house", 1, 2147483647), "/model/element/house: row 1 holds 2147483647", "elements"),
    (put("model/element/material", 1, 7), "/model/element/material: row 1 holds 7; allowed: 0 to 0", "elements", ("report",)),
    (put("model/element/material", 0, -1), "/model/element/material: row 0 holds -1", "elements", ("report",)),
    (put("model/element/mass", 1, 0.0), "/model/element/mass: row 1 holds 0[.0]*; allowed: above 0", "elements"),
    (put("model/element/kind", 1, 200), "/model/element/kind: row 1 holds 200", "elements"),
    (put("model/element/first_vertex", 1, 99), "/model/element/first_vertex: row 1 holds 99", "elements"),
    (put("model/joint/element_a", 0, 2), "/model/joint/element_a: row 0 holds 2; allowed: 0 to 1", "joints"),
    (put("model/joint/element_b", 0, -2), "/model/joint/element_b: row 0 holds -2", "joints"),
    (put("model/joint/law", 0, 1000), "/model/joint/law: row 0 holds 1000", "joints", ("assess", "report")),
    (crack(joint=-1), "/cracks/joint: row 1 holds -1", "cracks"),
    (crack(element_a=5), "/cracks/element_a: row 1 holds 5; allowed: 0 to 1", "cracks", ()),
    (crack(time=-1.0), "/cracks/time: row 1 holds -1[.0]*; allowed: no time before", "cracks"),
    (crack(mode=4), "/cracks/mode: row 1 holds 4", "cracks", ()),
]


class Forged(InAFolder):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.right = blocks().run(f"{cls.scratch.name}/pair", until=0.06, threads=1, progress=False).folder / "run.h5"

    def said(self, *words):
        """Exit code of the program and its last words."""
        done = subprocess.run([voussoir.program(), *map(str, words)], capture_output=True, text=True, timeout=LONGEST, check=False)
        return done.returncode, done.stderr

    def refuses(self, words, *command):
        code, error = self.said(*command)
        self.assertEqual((code, bool(re.search(words, error))), (3, True), f"{command}: {error}")

    def readers(self):
        page = self.folder / "page.html"
        return [("summary", self.folder), ("assess", self.folder), ("report", self.folder, "-o", page, "--overwrite"), ("check", self.folder),
                ("compare", self.folder, self.folder)]

    def test_structure_is_refused_by_all_readers(self):
        for change, words in STRUCTURE:
            for seal in (True, False):
                with self.subTest(words, seal=seal):
                    forge(self.right, self.folder / "run.h5", change, seal)
                    for command in self.readers():
                        self.refuses(words, *command)
                    with self.assertRaisesRegex(voussoir.FileError, f"run.h5: .*{words}"):
                        _ = voussoir.Run(self.folder).energy

    def test_values_are_refused_where_they_are_read(self):
        for change, words, table, *some in VALUES:
            with self.subTest(words):
                forge(self.right, self.folder / "run.h5", change)
                for command in self.readers():
                    if command[0] in ("check", "compare", *(some[0] if some else ("summary", "assess", "report"))):
                        self.refuses(words, *command)
                    else:
                        self.assertEqual(self.said(*command)[0], 0, command)
                run = voussoir.Run(self.folder)
                with self.assertRaisesRegex(voussoir.FileError, f"run.h5: {words}"):
                    self.read(run, table)

    def read(self, run, table):
        if table == "frames":
            return [(run.frames.time, frame.vertices()) for frame in run.frames]
        return {name: getattr(run, table)[name] for name in getattr(run, table)}

    def test_other_numbers_of_a_lost_run_are_shown(self):
        def lost(file):
            file["energy/kinetic"][-1] = np.nan
            file["summary"].attrs["finished"], file["summary"].attrs["failure"] = 0, "too fast"
        forge(self.right, self.folder / "run.h5", lost)
        self.assertEqual(self.said("check", self.folder)[0], 0)
        self.assertTrue(np.isnan(voussoir.Run(self.folder).energy.kinetic[-1]))
        self.assertEqual(voussoir.Run(self.folder).state, "lost")

    def test_a_sound_copy_is_read_with_and_without_a_seal(self):
        for seal in (True, False):
            forge(self.right, self.folder / "run.h5", lambda file: None, seal)
            for command in self.readers():
                self.assertEqual(self.said(*command)[0], 0)
        self.assertGreater(len(contents_of(self.right)), 0)
