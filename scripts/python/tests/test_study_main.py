# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""main.csv of a study: a few columns of its table.csv."""

import csv
import pathlib
import sys
from unittest import mock

from fixture import ROOT, InAFolder

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "study"), str(pathlib.Path(__file__).resolve().parents[1] / "voussoir")]
import main_table  # noqa: E402

STUDIES = ROOT / "cases/catalogue/studies"


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class MainColumns(InAFolder):
    def made(self, table):
        with mock.patch.object(sys, "argv", ["main_table.py", str(table), str(self.folder / "main.csv")]):
            main_table.main()
        return rows_of(self.folder / "main.csv")

    def test_the_columns_of_studies_that_ship(self):
        outcome = ["status", "damage_grade", "collapsed", "collapse_time", "fallen_mass_fraction", "peak_drift", "residual_drift"]
        for name, varied, last in (("fragility/fragility.csv", ["case", "scale", "seed"], None),
                                   ("twenty-runs/twenty.csv", ["case", "direction"], "peak_base_shear"),
                                   ("push-combinations/push-24.csv", ["options"], "capacity: peak_displacement")):
            table, rows = rows_of(STUDIES / name), self.made(STUDIES / name)
            names = list(rows[0])
            with self.subTest(name=name):
                self.assertEqual([n for n in names if n in main_table.AXES], [n for n in main_table.AXES if len({r.get(n) for r in table}) > 1])
                self.assertLessEqual(set(varied), set(names))
                self.assertEqual([n for n in names if n in outcome], outcome)
                self.assertEqual(names[0], "run")
                self.assertLessEqual(len(names), 20)
                self.assertIn(last or "status", names)
                self.assertEqual(rows, [{n: row[n] for n in names} for row in table])  # the same rows, the same texts

    def table(self, *rows):
        path = self.folder / "table.csv"
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)
        return path

    def test_a_level_stands_with_its_measure(self):
        place = {"case": "hut", "direction": "LTV", "record": "r", "scale": "", "intensity": "PGA"}
        rows = self.made(self.table({"run": "a", **place, "level": "1.0", "status": "done"}, {"run": "b", **place, "level": "2.0", "status": "to be done"}))
        self.assertEqual(list(rows[0].items()), [("run", "a"), ("intensity", "PGA"), ("level", "1.0"), ("status", "done")])

    def test_one_run_has_its_case(self):
        rows = self.made(self.table({"run": "arch", "case": "arch", "direction": "", "status": "done", "collapsed": "0", "free_volume": ""}))
        self.assertEqual(list(rows[0].items()), [("run", "arch"), ("case", "arch"), ("status", "done"), ("collapsed", "0")])

    def test_no_study_has_more_columns(self):
        both = [{name: name + number for name in ("run", *main_table.AXES, *main_table.OUTCOME, "front wall: peak_drift")} for number in "ab"]
        for row in both:
            row["scale"] = ""  # none beside levels
        self.assertEqual(len(self.made(self.table(*both))[0]), 20)
