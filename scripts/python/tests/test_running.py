# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Runs that are stopped and go on; studies."""

import csv
import json
import os
import shutil
import signal
import subprocess
import sys
import textwrap
import time
import warnings
from unittest import mock

import numpy as np

import voussoir
from fixture import HERE, InAFolder, blocks

LONG = 300.0  # s of two blocks: some seconds of computing, so that a run is still going on when it has told its first progress


class Running(InAFolder):
    def test_progress_of_a_run(self):
        seen = []
        blocks().run(self.folder / "run", until=LONG, threads=1, progress=seen.append)
        self.assertGreater(len(seen), 1)
        last = seen[-1]
        self.assertEqual((last.end, last.settling, last.broken, last.states), (LONG, False, 0, None))
        self.assertTrue(0.0 < seen[0].time < last.time <= LONG)
        self.assertGreater(last.steps_per_second, 0.0)
        self.assertGreater(seen[-2].seconds_left, 0.0)
        self.assertTrue(last.text.startswith(f"{last.time:.3f} of 300 s"))

    def test_warnings_of_the_program_are_warnings_of_python(self):
        model = blocks(0.01)
        model["damping.ratio"], model["damping.frequency"] = 0.05, 300.0
        with self.assertWarnsRegex(voussoir.ProgramWarning, "damping.frequency"):
            model.check()
        with self.assertWarnsRegex(voussoir.ProgramWarning, "damping.frequency"):
            model.run(self.folder / "run", threads=1, progress=False)

    def test_ctrl_c_stops_cleanly_and_the_run_goes_on(self):
        script = textwrap.dedent(f"""
            import sys
            sys.path[:0] = [{str(HERE)!r}, {str(HERE.parent)!r}]
            import voussoir, fixture
            try:
                fixture.blocks().run({str(self.folder / "run")!r}, until={LONG}, threads=1, progress=lambda p: print(p.time, flush=True))
            except voussoir.Stopped as error:
                print("stopped:", error, error.folder, error.time)
        """)
        straight = blocks().run(self.folder / "straight", until=LONG, threads=1, progress=False)
        # A shell starts what runs in its background with SIGINT ignored, and that is inherited; a user's Python is not started so.
        child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True,
                                 preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        first = child.stdout.readline()
        child.send_signal(signal.SIGINT)
        rest = child.stdout.read()
        child.stdout.close()
        self.assertEqual(child.wait(), 0)
        self.assertRegex(rest, r"stopped: the run was stopped at \d+\.\d+ of 300 s, shaking; its state is saved.* \S*/run \d+\.\d+\n")
        run = voussoir.Run(self.folder / "run")
        self.assertFalse(run.finished)
        self.assertLess(float(first), LONG)
        run.resume(progress=False)
        self.assertTrue(run.finished)
        self.assertTrue(run.same_as(straight))

    def test_a_run_goes_on_to_its_end_when_python_is_killed(self):
        code = (f"import sys\nsys.path[:0] = [{str(HERE)!r}, {str(HERE.parent)!r}]\nfrom fixture import blocks\n"
                f"blocks().run({str(self.folder / 'run')!r}, until={LONG}, threads=1, progress=lambda state: print(state.time, flush=True))")
        with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as python:
            python.stdout.readline()
            python.kill()
        end = time.monotonic() + 60.0
        while time.monotonic() < end:
            time.sleep(0.2)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                try:
                    if voussoir.Run(self.folder / "run").state == "finished":
                        return
                except voussoir.FileError:
                    pass  # not there yet
        self.fail("the run has ended with the Python that began it")

    def test_a_fault_in_the_callers_progress_stops_the_run(self):
        def bad(_):
            raise RuntimeError("of the caller")
        with self.assertRaisesRegex(RuntimeError, "of the caller"):
            blocks().run(self.folder / "run", until=LONG, threads=1, progress=bad)
        self.assertFalse(voussoir.Run(self.folder / "run").finished)


    def test_a_reader_that_was_open_while_the_run_ended_has_rows_or_an_error(self):
        case, folder = blocks(LONG).write(self.folder / "blocks.toml"), self.folder / "run"
        child = subprocess.Popen([voussoir.program(), "run", case, "-o", folder, "-j", "1", "--quiet", "--checkpoint-every", "0.1"],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        opened, states, last = [], set(), 0
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", voussoir.ProgramWarning)
            while child.poll() is None:
                parts = self.parts_of(folder)
                if (folder / "run.h5").exists() and parts > last and len(opened) < 20:
                    last = parts
                    run = voussoir.Run(folder)
                    damage = run.damage
                    opened.append((run, damage, len(damage._dataset("bonded"))))  # taken now, read after the end
                    states.add(run.state)
                    for time in self.rows_or_error(run.energy):
                        self.assertFalse(np.isnan(time).any())
            self.assertEqual(child.returncode, 0)
            self.assertIn("goes on", states)
            self.assertLessEqual(states, {"goes on", "finished"})
            errors = 0
            for _, damage, rows in opened:
                found = self.rows_or_error(damage)
                errors += not found
                for column in found:
                    self.assertEqual(len(column), len(found[0]))
                    self.assertFalse(np.isnan(column).any())
                    self.assertGreaterEqual(column.min(initial=0), 0)  # counts and times; a fill value is NaN or -1
                if rows and found:
                    self.assertEqual(len(found[-1]), rows)
            self.assertGreater(errors, 0)  # some were open with parts that are gone now
            self.assertEqual({run.state for run, _, _ in opened}, {"finished"})
            self.assertEqual({len(run.energy.time) for run, _, _ in opened}, {len(voussoir.Run(folder).energy.time)})

    def test_a_run_that_ended_since_it_was_opened_is_read_as_it_is_now(self):
        folder = self.killed(look=False)
        with self.assertWarnsRegex(voussoir.ProgramWarning, "stopped or killed"):
            run = voussoir.Run(folder)
            self.assertEqual((run.state, run.finished, bool(run.file["summary"].attrs["finished"])), ("stopped", False, False))
        energy, frame, frames, count = run.energy, run.frames[0], run.frames, len(run.frames)
        first, rows = (np.asarray(frame.displacement), len(energy._dataset("time")))
        before = shutil.copy(folder / "run.h5", self.folder / "before.h5")
        subprocess.run([voussoir.program(), "resume", folder, "-j", "1", "--quiet"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            now = voussoir.Run(folder)
            self.assertEqual((run.state, run.finished, run.missing_parts), ("finished", True, []))
            self.assertIn("damage_grade", run.summary)
            self.assertEqual(repr((run.summary, run.provenance)), repr((now.summary, now.provenance)))  # some are NaN
            self.assertGreater(len(run.frames), count)
            self.assertEqual({len(frames), len(run.frames), len(run.frames.time)}, {len(now.frames)})
            self.assertEqual(run.frames[-1].time, now.frames[-1].time)
            self.assertTrue(run.file["summary"].attrs["finished"])
            for taken in (lambda: energy.time, lambda: frame.displacement):  # of the time when they were taken, or an error
                try:
                    self.assertIn(len(taken()), (rows, len(first)))
                except voussoir.FileError as error:
                    self.assertRegex(str(error), r"parts/\d+\.h5.*(is missing|is not the part)")
        energy = run.energy
        run.close()
        with self.assertRaisesRegex(voussoir.FileError, "take it from the run again"):
            _ = energy.time

        # It ends between the look at run.h5, which is then the one of before, and the look at the lock.
        after = shutil.copy(folder / "run.h5", self.folder / "after.h5")
        for ask, wanted in ((lambda r: r.state, "finished"), (lambda r: r.missing_parts, [])):
            shutil.copy(before, self.folder / "moved.h5")
            os.replace(self.folder / "moved.h5", folder / "run.h5")
            run, looked = voussoir.Run(folder), []

            def ends(real):
                def look(file):
                    found = real(file)
                    if not looked:
                        looked.append(found)
                        shutil.copy(after, self.folder / "moved.h5")
                        os.replace(self.folder / "moved.h5", folder / "run.h5")
                    return found
                return look
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                with mock.patch("voussoir.results.state_of", ends(voussoir.results.state_of)):
                    self.assertEqual(ask(run), wanted)
            self.assertEqual(looked[0][0], "stopped")

    def parts_of(self, folder):
        """Parts of the run so far; the program may take the folder of parts away at any moment."""
        try:
            return sum(name.endswith(".h5") for name in os.listdir(folder / "parts"))
        except FileNotFoundError:
            return 0

    def rows_or_error(self, *tables):
        try:
            return [np.asarray(table[name]) for table in tables for name in ("time", "bonded") if name in table]
        except voussoir.FileError as error:
            self.assertRegex(str(error), r"parts/\d+\.h5.*(is missing|is not the part)")
            return []

    def test_a_copy_without_its_parts(self):
        run = self.killed()
        copy = self.folder / "copy"
        copy.mkdir()
        shutil.copy(run / "run.h5", copy)
        with self.assertWarnsRegex(voussoir.ProgramWarning, r"(\d+) of \1 parts are missing beside it, the first is parts/0000.h5"):
            found = voussoir.Run(copy)
            self.assertEqual(list(found.elements.tag), ["lower", "upper"])
        self.assertEqual((found.state, found.finished, found.case["title"]), ("unknown", False, "Two bonded blocks"))
        self.assertIn(len(list((run / "parts").iterdir())) - len(found.missing_parts), (0, 1))  # killed before run.h5 named the last
        with self.assertRaisesRegex(voussoir.FileError, r"parts/0000.h5: is missing \((\d+) of \1 parts are\)"):
            _ = found.energy.kinetic
        done = subprocess.run([voussoir.program(), "summary", copy, "--format", "json"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 3)
        self.assertRegex(done.stderr, "parts are missing beside it, the first is parts/0000.h5")
        said = json.loads(done.stdout)
        self.assertEqual((said["state"], said["elements"], len(said["missing_parts"])), ("unknown", 2, len(found.missing_parts)))
        self.assertEqual(said["rows_of"]["energy"], len(found.energy._dataset("time")))
        (copy / "parts").mkdir()
        shutil.copy(run / "parts/0000.h5", copy / "parts")
        self.assertEqual(float(voussoir.Run(copy).frames[0].time), 0.0)  # its rows are there

    def killed(self, look=True):
        case, folder = blocks(LONG).write(self.folder / "blocks.toml"), self.folder / "run"
        child = subprocess.Popen([voussoir.program(), "run", case, "-o", folder, "-j", "1", "--quiet", "--checkpoint-every", "0.1"],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not (folder / "parts/0002.h5").exists() and child.poll() is None:
            time.sleep(0.01)
        child.kill()
        child.wait()
        if not look:
            return folder
        self.assertEqual(voussoir.Run(folder).state, "stopped")
        assess = subprocess.run([voussoir.program(), "assess", folder], capture_output=True, text=True, check=False)
        self.assertRegex(assess.stderr, "not finished: rows written until 20.*; the run was stopped or killed")
        self.assertIn("stopped or killed", voussoir.Run(folder).report().read_text())
        self.assertIn("stopped or killed", voussoir.Run(folder).describe())
        return folder


class Studies(InAFolder):
    @staticmethod
    def build(young, scale):
        model = blocks(0.02)
        model["materials.stone.young"] = young
        model["motion.scale"] = scale
        return model

    def test_a_run_for_each_combination_and_no_run_twice(self):
        def study():
            return voussoir.Study(self.folder / "study", self.build, young=[1e8, 2e8], scale=[0.5, 1.0])
        study().run(workers=2, quiet=True)
        before = (self.folder / "study/young=1e+08,scale=0.5/run.h5").stat().st_mtime_ns
        done = study().run(quiet=True)
        self.assertEqual((self.folder / "study/young=1e+08,scale=0.5/run.h5").stat().st_mtime_ns, before)
        self.assertEqual(len(list(done)), 4)
        self.assertEqual([point["scale"] for point, _ in done], [0.5, 1.0, 0.5, 1.0])
        with open(done.write(self.folder / "table.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["status"] for row in rows], ["done"] * 4)
        self.assertGreater(float(rows[1]["peak_speed"]), float(rows[0]["peak_speed"]))

    def test_another_model_is_refused(self):
        voussoir.Study(self.folder, self.build, young=[1e8], scale=[1.0]).run(quiet=True)
        with self.assertRaisesRegex(voussoir.InputError, "another model"):
            voussoir.Study(self.folder, self.build, young=[1e8], scale=[1.0]).run(until=0.03, quiet=True)

    def test_faults_come_before_runs(self):
        with self.assertRaises(voussoir.InputError):
            voussoir.Study(self.folder, self.build, young=[1e8, -1.0], scale=[1.0]).run(quiet=True)
        self.assertFalse((self.folder / "young=1e+08,scale=1").exists())
