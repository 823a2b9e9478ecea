# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What models, runs, capacities and tables show of themselves in a notebook, and tables as data frames."""

import base64
import gzip
import html
import importlib.util
import re
import subprocess
import sys
import unittest
from unittest import mock

import numpy as np

import voussoir
import voussoir.notebook
from fixture import HERE, InAFolder, blocks

DRAWS = importlib.util.find_spec("matplotlib") is not None
PANDAS = importlib.util.find_spec("pandas") is not None


def page_in(text):
    """The page that is packed in some HTML."""
    return gzip.decompress(base64.b64decode(re.search('data-page="([^"]*)"', text)[1])).decode()


class Shown(InAFolder):
    def test_a_model(self):
        text = blocks()._repr_html_()
        self.assertIn("<b>Two bonded blocks</b>", text)
        self.assertRegex(text, r"elements</span>&ensp;2")
        self.assertIn("WebGL", page_in(text))
        self.assertEqual("data:image/png;base64," in text, DRAWS)

    def test_a_model_that_is_refused_shows_its_faults(self):
        model = blocks()
        model["title"] = "a < b"
        model["materials.stone.young"] = -1.0
        text = model._repr_html_()
        self.assertIn("a &lt; b", text)
        self.assertRegex(html.unescape(text), r"young.*-1")
        self.assertNotIn("data-page", text)

    def test_a_run(self):
        run = blocks().run(self.folder / "run", threads=1, progress=False)
        held = run.energy
        text = run._repr_html_()
        self.assertGreater(len(held.kinetic), 0)  # a table from before can still be read
        self.assertRegex(text, "state</span>&ensp;finished, 0.10 s")
        self.assertRegex(text, r"largest base shear</span>&ensp;[\d.]+ kN")
        self.assertIn("Two bonded blocks", page_in(text))
        self.assertEqual("At 0.10 s. The redder, the more bonds are broken." in text, DRAWS)
        self.assertEqual([path.name for path in (self.folder / "run").iterdir() if path.suffix == ".html"], [])  # nothing is left beside the results
        short = voussoir.notebook.html_of_run(run, most=10)
        self.assertNotIn("data-page", short)
        self.assertIn(".show()", short)
        self.assertEqual("data:image/png;base64," in short, DRAWS)
        self.assertIn("height:300px", run.show(height=300)._repr_html_())

    def test_a_run_that_was_stopped(self):
        job = blocks().start(self.folder / "run", until=300.0, threads=1)
        job.stop()
        self.assertIn("stopped, can go on", job.run._repr_html_())

    def test_no_script_of_a_title_is_run(self):
        model = blocks()
        model["title"] = '"; alert(1); "</script><script>alert(2)</script>'
        text = model._repr_html_()
        self.assertEqual(text.count("<script>"), 2)  # the second is a text in the first
        self.assertEqual(text.count("</script>"), 1)
        self.assertNotIn('"; alert(1)', text)

    def test_a_capacity(self):
        model = blocks()
        model["analysis"] = {"kind": "pushover", "direction": [1.0, 0.0], "largest_drift": 0.001}
        run = model.run(self.folder / "run", threads=1, progress=False)
        capacity = run.capacity
        self.assertEqual((capacity.unit("peak_shear"), capacity.unit("multiplier")), ("N", "1"))
        self.assertEqual(capacity["kind"], "pushover")
        self.assertIsInstance(capacity.mechanism, list)
        text = capacity._repr_html_()
        self.assertRegex(text, r"largest base shear</span>&ensp;[\d.]+ kN")
        self.assertIn("ended by", text)
        self.assertEqual("data:image/png;base64," in text, DRAWS)
        self.assertRegex(run._repr_html_(), r"largest load factor</span>&ensp;[\d.]+")

    def test_a_time_history_has_no_capacity(self):
        run = blocks().run(self.folder / "run", threads=1, progress=False)
        self.assertEqual(run.capacity, {})
        self.assertIn("no quasi-static analysis", run.capacity._repr_html_())

    def test_a_table(self):
        run = blocks().run(self.folder / "run", threads=1, progress=False)
        text = run.history("upper")._repr_html_()
        self.assertRegex(text, r"<td>displacement</td><td>\(\d+, 3\)</td><td>m</td><td>[^<]")


class Pictures(InAFolder):
    @unittest.skipUnless(DRAWS, "needs matplotlib")
    def test_what_is_drawn(self):
        from voussoir import picture
        run = blocks().run(self.folder / "run", threads=1, progress=False)
        polygons, colours, ground = picture._drawn(run, 0)
        self.assertEqual((len(polygons), len(colours), len(ground)), (6, 6, 4))  # of a cube three faces are seen
        heights = [polygon[:, 1].mean() for polygon in polygons]
        self.assertGreater(min(heights[3:]), max(heights[:2]))  # the upper block hides the lower one
        self.assertEqual(picture.png_of(run)[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(picture.png_of(run, 0), picture.png_of(run, 0))


class DataFrames(InAFolder):
    def test_without_pandas_an_error_names_it(self):
        run = blocks().run(self.folder / "run", threads=1, progress=False)
        with mock.patch.dict(sys.modules, {"pandas": None}), self.assertRaisesRegex(ImportError, "data frames need pandas: pip install"):
            run.energy.to_pandas()

    @unittest.skipUnless(PANDAS, "needs pandas: scripts/setup notebooks")
    def test_columns_index_and_units(self):
        run = blocks().run(self.folder / "run", threads=1, progress=False)
        frame = run.history("upper").to_pandas()
        self.assertEqual(frame.index.name, "time")
        self.assertIn("displacement_y", frame.columns)
        self.assertEqual(frame.attrs["units"]["velocity_x"], "m/s")
        np.testing.assert_array_equal(frame["displacement_y"].to_numpy(), np.asarray(run.history("upper").displacement)[:, 1])
        elements = run.elements.to_pandas()
        self.assertEqual((list(elements["tag"]), elements.attrs["units"]["mass"]), (["lower", "upper"], "kg"))
        self.assertEqual(len(run.cracks.to_pandas()), len(run.cracks.time))
        for table in (run.energy, run.forces, run.damage, run.measures, run.joints, run.assessment):
            self.assertEqual(len(table.to_pandas()), len(table[next(iter(table))]))


class Lazily(unittest.TestCase):
    def test_a_case_needs_nothing_of_jupyter(self):
        code = ("import sys, voussoir; m = voussoir.Model('a'); m['time.duration'] = 1.0; m.text()\n"
                "print([name for name in ('numpy', 'h5py', 'IPython', 'pandas', 'matplotlib') if name in sys.modules])")
        done = subprocess.run([sys.executable, "-c", code], cwd=HERE.parent, capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.strip(), "[]")
