# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Results of every schema_version are read (tests/io/samples)."""

import gzip
import re
import warnings

import h5py
import numpy as np

import voussoir
from voussoir.reading import OLDEST_SCHEMA, SCHEMA
from fixture import ROOT, InAFolder


class Samples(InAFolder):
    def test_every_table_of_every_schema(self):
        samples = sorted((ROOT / "tests/io/samples").glob("schema-*.h5.gz"))
        self.assertEqual([sample.name for sample in samples], [f"schema-{n}.h5.gz" for n in range(OLDEST_SCHEMA, SCHEMA + 1)])
        for sample in samples:
            schema = int(re.search(r"schema-(\d+)", sample.name)[1])
            with self.subTest(schema=schema), warnings.catch_warnings():
                warnings.simplefilter("ignore", voussoir.ProgramWarning)  # not sealed
                folder = self.folder / str(schema)
                folder.mkdir()
                (folder / "run.h5").write_bytes(gzip.decompress(sample.read_bytes()))
                run = voussoir.Run(folder)
                self.assertTrue(run.finished)
                self.assertEqual(run.file.attrs["schema_version"], schema)
                self.assertEqual(run.case["title"], "a very small house on leaning ground")
                for name in ("energy", "forces", "damage", "cracks", "measures", "elements", "joints"):
                    table = getattr(run, name)
                    for column in table:
                        self.assertGreater(len(np.asarray(table[column])), 0)
                self.assertEqual(run.histories, ["top"])
                self.assertGreater(abs(run.history("top").displacement).max(), 0.001)
                last = run.frames[-1]
                self.assertEqual(last.vertices().shape[1], 3)
                self.assertTrue(np.isfinite(last.vertices()).all())
                self.assertEqual(run.summary["damage_grade"], 4)
                self.assertIn("front wall", list(run.walls))

    def test_other_structure_is_an_error_of_this_package(self):
        """Findings of tests/fuzz/python_fuzz: a dataset for a group, a missing one, other shapes and numbers."""
        def put(file, name, value):
            if name in file:
                del file[name]
            if value is not None:
                file[name] = value
        for name, value, read in (("energy", 1.0, lambda r: list(r.energy)), ("history", 1.0, lambda r: r.histories), ("history/top", 1.0, lambda r: r.history("top")),
                                  ("frames/quaternion", None, lambda r: r.frames[-1].vertices()), ("frames/quaternion", "a", lambda r: r.frames[-1].quaternion),
                                  ("frames/time", 1.0, lambda r: len(r.frames)), ("frames", 1.0, lambda r: r.frames[-1]), ("model/origin", "a", lambda r: r.elements.position0),
                                  ("model/element", None, lambda r: r.frames[-1].position), ("model/vertex", [1.0], lambda r: r.frames[-1].vertices()),
                                  ("summary/wall/name", None, lambda r: r.walls), ("summary/wall/peak_drift", [1.0], lambda r: r.walls), ("summary", 1.0, lambda r: r.walls),
                                  ("case", 1.0, lambda r: r.case), ("summary", None, lambda r: r.finished), ("model/origin", [1.0, 2.0], lambda r: r.frames[0].vertices())):
            with self.subTest(name=name, value=value), warnings.catch_warnings():
                warnings.simplefilter("ignore", voussoir.ProgramWarning)
                folder = self.folder / f"{len(list(self.folder.iterdir()))}"
                folder.mkdir()
                (folder / "run.h5").write_bytes(gzip.decompress((ROOT / "tests/io/samples/schema-5.h5.gz").read_bytes()))
                with h5py.File(folder / "run.h5", "r+") as file:
                    put(file, name, value)
                with self.assertRaises(voussoir.VoussoirError):
                    read(voussoir.Run(folder))
