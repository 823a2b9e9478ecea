# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""scripts/validation: what it reads of tables and curves, the cases that it writes, and one dry wall against its closed form."""
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent.parent / "validation"
sys.path.insert(0, str(SCRIPTS))
import case_file
import measures
import tables
import verdicts
import walls

PROGRAM = os.environ.get("VOUSSOIR", str(SCRIPTS.parent.parent / "build/release/io/voussoir"))

DRY = """reference,Test unit name,H [mm],L [mm],t [mm],H0 [mm],Epc [MPa],hb [mm],lb [mm],Eb [MPa],"σ0,pc [MPa]","dmax,+ [%]","Vmax,+ [kN]",\
"dmax,- [%]","Vmax,- [kN]","Kel,+ [kN/mm]","Kel,- [kN/mm]",From test report: Failure ty
A,SW.30.1,900.0,1000.0,200.0,1000.0,566.0,100.0,200.0,15500.0,0.15,2.0,20.0,NaN,NaN,15.0,NaN,"F, R"
A,SW.30.2,900.0,1000.0,200.0,1000.0,566.0,100.0,200.0,15500.0,0.15,1.0,22.0,NaN,NaN,15.0,NaN,"F, R"
B,WS1.100,1200.0,1000.0,200.0,1325.0,3287.0,150.0,200.0,20200.0,0.5,2.0,39.0,3.0,43.0,12.0,17.0,R
"""

BRICK = """source,wall,H_m,L_m,t_m,unit_l_mm,unit_w_mm,unit_h_mm,fb_MPa,mortar_MPa,fm_MPa,Em_MPa,fv0_MPa,mu,H0_over_H,sigma0_MPa,mode,\
drift_Vmax_plus_pct,drift_Vmax_minus_pct,Vmax_plus_kN,Vmax_minus_kN
M,MI1,0.26,0.52,0.38,250,120,55,20,4,8,3000,0.21,0.81,0.5,1.2,shear,0.2,0.18,270,260
A,ISP1,0.26,0.52,0.25,250,120,55,30,3,6,,0.28,0.58,0.5,0.6,shear,0.2,0.2,81,84
"""


def rigid_pier():
    """A pier one unit wide, of stiff blocks with rough joints: it rotates about its toe as one body."""
    return walls.Wall(name="pier", tests=[], kind="SW", height=0.4, length=0.2, thickness=0.2, unit=(0.2, 0.1), shear_span=0.5, stress=5e4,
                      density=2000.0, unit_modulus=4e9, wall_modulus=2e9, friction=2.0)


class Tables(unittest.TestCase):
    def test_dry_walls(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "dry_walls.csv").write_text(DRY, encoding="utf-8")
            found = {w.name: w for w in walls.dry_walls(folder)}
            self.assertEqual(list(found), ["SW.30", "WS*.100"])
            sw = found["SW.30"]
            self.assertEqual(sw.tests, ["SW.30.1", "SW.30.2"])
            self.assertAlmostEqual(sw.load, 30e3)
            self.assertAlmostEqual(sw.rocking_bound, (30e3 + 2040 * 9.81 * 0.18) * 0.5 / 1.0)
            self.assertFalse(sw.cyclic)
            self.assertTrue(found["WS*.100"].cyclic)
            rows = walls.measured_rows(folder, sw)
            self.assertEqual([r["force"] for r in rows], [20e3, 22e3])  # NaN: not pulled
            self.assertEqual(len(walls.measured_rows(folder, found["WS*.100"])), 2)

    def test_brick_walls(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "brick_walls.csv").write_text(BRICK, encoding="utf-8")
            mi, isp = walls.brick_walls(folder)
            self.assertEqual((mi.name, mi.kind, isp.name, isp.kind), ("MI1", "MI", "ISP1", "ISP"))
            self.assertAlmostEqual(isp.wall_modulus, 6e6 * 3000e6 / 8e6)  # the share of f_m that the first measured wall has
            self.assertAlmostEqual(isp.bond["tension"], 0.2e6)
            self.assertAlmostEqual(isp.rocking_bound, (isp.load + isp.weight) * 0.52 / 0.26)  # held level
            self.assertAlmostEqual(isp.sliding_bound, (isp.load + isp.weight) * 0.58 + 0.28e6 * 0.52 * 0.25)
            self.assertEqual([r["force"] for r in walls.measured_rows(folder, mi)], [270e3, 260e3])
            self.assertAlmostEqual(mi.unit[0], 2 * isp.unit[0])
            text = case_file.case_text(isp, **case_file.drive_of(isp))
            self.assertEqual(text.count("[[block]]"), 1 + 2 * 2 + 2 * 3)
            self.assertEqual(text.count("halves   = true"), 2 * 2 + 2 * 1)  # whole units alone
            path = pathlib.Path(folder) / "case.toml"
            path.write_text(text, encoding="utf-8")
            done = subprocess.run([PROGRAM, "check", str(path)], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr + done.stdout)

    def test_curve(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "FD_SW301_x.csv"
            path.write_text("Test unit,SW.30.1\nReference,A\ntop_displacement,horizontal_force,drift\n[mm],[kN],[%]\n0,0,0\n2.5,12,0.25\n")
            self.assertEqual(walls.read_curve(path), ([0.0, 0.0025], [0.0, 12000.0]))
            self.assertEqual(walls.curve_files(folder, walls.Wall(**{**vars(rigid_pier()), "tests": ["SW.30.1"]})), {"SW.30.1": path})
            path.write_text("a\nb\ntop_displacement,horizontal_force\n[m],[kN]\n0,0\n")
            with self.assertRaisesRegex(ValueError, r"wanted \[mm\] and \[kN\]"):
                walls.read_curve(path)

    def test_absent(self):
        done = subprocess.run([sys.executable, str(SCRIPTS / "report"), "--measured", "/nowhere"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0)
        self.assertIn("no measured walls in /nowhere", done.stderr)


class Curves(unittest.TestCase):
    def test_peak_stiffness_and_drop(self):
        u = np.linspace(0.0, 0.03, 301)
        f = np.where(u < 0.01, 2e6 * u, np.where(u < 0.02, 2e4, 1e4))
        curve = measures.Curve(u, f)
        self.assertAlmostEqual(curve.peak, 2e4)
        self.assertAlmostEqual(curve.stiffness, 2e6, delta=1.0)
        self.assertAlmostEqual(curve.first_drop, 0.02, delta=1e-3)
        self.assertTrue(math.isnan(measures.Curve(u[:200], f[:200]).first_drop))
        self.assertAlmostEqual(measures.mean_error(curve, measures.Curve(u, 1.1 * f)), 0.1, delta=1e-9)

    def test_first_rise(self):
        rise = measures.first_rise([0.0, 1e-3, 2e-3, 1e-3, -1e-3, 5e-3], [0.0, 2e3, 4e3, 3e3, -1e3, 9e3])
        self.assertEqual(list(rise.displacement), [0.0, 1e-3, 2e-3])
        self.assertAlmostEqual(rise.stiffness, 2e6)

    def test_envelope(self):
        t = np.linspace(0.0, 6 * np.pi, 3001)
        u = 0.001 * t * np.sin(t)
        loops = np.where(np.sin(t) * np.cos(t) > 0, 1.0, 0.6) * 1e6 * u  # unloads lower
        push, pull = measures.both_ways(*measures.envelope(u, loops))
        inner = push.displacement < 0.9 * push.displacement.max()
        self.assertLess(np.abs(push.force[inner] / (1e6 * push.displacement[inner]) - 1.0).max(), 1e-9)
        self.assertGreater(pull.displacement.max(), 0.01)


class Verdicts(unittest.TestCase):
    def test_modes(self):
        self.assertEqual(verdicts.measured_modes(["F, R", "R, SL"]), {"R": 2, "SL": 1})
        self.assertEqual(verdicts.counts_in_words({"R": 2, "SL": 1}, 2), "rocking, sliding (1 of 2)")
        self.assertEqual(verdicts.modes_of_slip(0.5), {"R", "SL"})
        self.assertEqual(verdicts.modes_of_slip(0.9), {"SL"})
        self.assertEqual(verdicts.compare_modes({"R": 2, "SL": 2}, 2, {"R", "SL"}), "yes")
        self.assertEqual(verdicts.compare_modes({"R": 4, "TC": 1}, 4, {"R", "SL"}), "partly: sliding as well")
        self.assertEqual(verdicts.compare_modes({"R": 2, "TC": 2}, 2, {"R"}), "**no**: no toe crushing")

    def test_loss_and_loops(self):
        u = np.linspace(0.0, 0.03, 301)
        falls, holds = (measures.Curve(u, np.where(u < 0.015, 2e4, last)) for last in (1e4, 2e4))

        class Found:
            wall = rigid_pier()  # lever height 0.5 m
            curves, ways, residual_share = {}, [falls], 0.1

            @staticmethod
            def first_drop(way):
                return way.first_drop

        wall = Found()
        self.assertEqual(verdicts.loss(wall), "none")  # at 3 %: beyond what is watched
        wall.wall.shear_span = 1.0
        self.assertIn("**miss**", verdicts.loss(wall))
        wall.curves = {"a": (falls.displacement, falls.force)}
        self.assertIn("as in tests", verdicts.loss(wall))
        wall.ways = [holds]
        self.assertEqual(verdicts.loss(wall), "none; 1 of the tests' curves have one")
        self.assertEqual(verdicts.centred(wall), "–")
        wall.wall.drifts = (0.01,)
        self.assertEqual(verdicts.centred(wall), "10 % remains: yes")
        wall.residual_share = 0.3
        self.assertIn("**miss**", verdicts.centred(wall))


class QuotedTables(unittest.TestCase):
    def test_quoted(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "a.txt").write_text("`by`, today\n| x |\n|---|\n| 1 |\n", encoding="utf-8")
            self.assertEqual(tables.quoted("before\n{table a}\nafter", folder), "before\n| x |\n|---|\n| 1 |\n\n(`by`, today)\nafter")
            with self.assertRaises(FileNotFoundError):
                tables.quoted("{table b}", folder)

    def test_tables_of_the_report_are_there(self):
        """Every table quoted in the notes exists, and every existing table is quoted."""
        notes = (SCRIPTS.parent.parent / "tests/validation/notes.md").read_text(encoding="utf-8")
        wanted = {line[7:-1] for line in notes.splitlines() if line.startswith("{table ")}
        self.assertEqual(wanted, {path.stem for path in tables.FOLDER.glob("*.txt")})


class Cases(unittest.TestCase):
    def test_courses(self):
        wall = rigid_pier()
        boxes = case_file.courses(wall)
        self.assertEqual(len(boxes), 2 * 1 + 2 * 2)
        self.assertAlmostEqual(sum((b - a) * (d - c) for _, a, b, c, d in boxes), 0.4 * 0.2)

    def test_joint_stiffness(self):
        wall = rigid_pier()
        normal, _ = case_file.joint_stiffness(wall, wall.unit_modulus)
        plane = wall.unit_modulus / (1.0 - 0.2**2)
        self.assertAlmostEqual(1.0 / (0.1 / plane + 1.0 / normal) * 0.1 / wall.wall_modulus, 1.0)
        with self.assertRaisesRegex(ValueError, "is not above the wall's"):
            case_file.joint_stiffness(wall, 1e9)

    def test_rocking_strength(self):
        """A rigid pier on its toe at the displacement u bears (N (L/2 − u) + W (L/2 − u H/2 H0)) / H0, and a little less for its soft edge."""
        wall = rigid_pier()
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "case.toml"
            case.write_text(case_file.case_text(wall, pace=0.5, largest_drift=0.02))
            done = subprocess.run([PROGRAM, "run", str(case), "-j", "1", "-o", folder + "/run"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            run = measures.RunOfWall(folder + "/run", wall)
            u = float(run.displacement[-1])
            half, top = 0.5 * wall.length, wall.shear_span
            rigid = (wall.load * (half - u) + wall.weight * (half - 0.5 * u * wall.height / top)) / top
            self.assertGreater(u, 0.0099)
            self.assertLess(float(run.force[-1]), rigid)
            self.assertGreater(float(run.force[-1]), 0.97 * rigid)
            self.assertLess(run.peak_residual, 1e-3)
            self.assertLess(abs(run.slip_share(-1)), 0.05)


if __name__ == "__main__":
    unittest.main()
