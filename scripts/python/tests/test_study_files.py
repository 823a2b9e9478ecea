# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Study files: what cannot be read is refused in words. Each text was a finding of tests/fuzz/python_fuzz, or is its kin."""

import pathlib
import sys

from fixture import InAFolder

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "study"), str(pathlib.Path(__file__).resolve().parents[1] / "voussoir")]
import plan  # noqa: E402


class StudyFiles(InAFolder):
    def runs(self, text):
        path = self.folder / "study.toml"
        path.write_text(text)
        return plan.expand(plan.read_study(path), path)

    def refuses(self, text, words):
        with self.assertRaisesRegex(plan.StudyError, words):
            self.runs(text)

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
