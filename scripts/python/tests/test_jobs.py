# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Runs in the background: waited for, stopped, interrupted, gone on with."""

import signal
import subprocess
import sys
import textwrap
import threading
import unittest

import voussoir
from fixture import HERE, InAFolder, blocks
from voussoir import bars
from voussoir.commands import Progress

LONG = 300.0  # s of two blocks: some seconds of computing


class Jobs(InAFolder):
    def test_a_run_goes_on_while_python_does_other_things(self):
        model = blocks(LONG)
        job = model.start(self.folder / "run", threads=1)
        model["time.duration"] = 1.0  # the model of the run is that of the call
        self.assertEqual((job.state, job.progress.end), ("goes on", LONG))
        self.assertIn("goes on", repr(job))
        with self.assertRaisesRegex(TimeoutError, "goes on after 0.01 s"):
            job.wait(timeout=0.01)
        run = job.wait()
        self.assertEqual((job.state, job.error, run.finished, run.state), ("finished", None, True, "finished"))
        job.stop()  # nothing happens

    def test_stopped_and_gone_on_with_to_the_same_bits(self):
        straight = blocks().run(self.folder / "straight", until=LONG, threads=1, progress=False)
        job = blocks().start(self.folder / "run", until=LONG, threads=1)
        job.stop()
        self.assertEqual(job.state, "stopped")
        with self.assertRaisesRegex(voussoir.Stopped, "was stopped at .* s; its state is saved"):
            job.wait()
        run = voussoir.Run(self.folder / "run")
        self.assertEqual((run.state, run.finished), ("stopped", False))
        self.assertLess(run.summary["end_time"], LONG)
        run.close()
        again = run.start(threads=1)
        again.stop()
        run = run.resume(progress=False)
        self.assertEqual(run.summary["state_hash"], straight.summary["state_hash"])
        self.assertTrue(run.same_as(straight))

    def test_what_the_program_refuses_is_raised_at_once(self):
        model = blocks(LONG)
        model["materials.stone.young"] = -1.0
        with self.assertRaisesRegex(voussoir.InputError, "young"):
            model.start(self.folder / "run")

    def test_an_interrupt_while_waiting_stops_the_run(self):
        done = self.python("""
            job = fixture.blocks().start(folder, until=LONG, threads=1)
            threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
            try:
                job.wait()
            except voussoir.Stopped as error:
                print("stopped:", job.state, error)
        """)
        self.assertIn("stopped: stopped the run was stopped", done)
        self.assertEqual(voussoir.Run(self.folder / "run").state, "stopped")

    def test_an_interrupt_of_something_else_leaves_the_run_alone(self):
        done = self.python("""
            job = fixture.blocks().start(folder, until=LONG, threads=1)
            threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
            try:
                time.sleep(20)
            except KeyboardInterrupt:
                print("interrupted:", job.state)
            print(job.wait().finished)
        """)
        self.assertEqual(done.split(), ["interrupted:", "goes", "on", "True"])

    def test_the_end_of_python_saves_and_stops(self):
        self.python("job = fixture.blocks().start(folder, until=LONG, threads=1)")
        self.assertEqual(voussoir.Run(self.folder / "run").state, "stopped")

    def test_the_end_of_python_stops_a_run_that_is_silent(self):
        program, log = self.folder / "silent", self.folder / "log"
        line = '{"kind": "progress", "time": 1.0, "settling": false, "steps_per_second": 1.0, "broken": 0, "residual": 0.0, "text": "1 s"}'
        program.write_text(f"#!/bin/sh\ntrap 'echo saved >{log}; exit 143' TERM\necho '{line}' >&2\nsleep 60 &\nwait\n")
        program.chmod(0o755)
        self.python(f"os.environ['VOUSSOIR'] = {str(program)!r}\njob = voussoir.jobs.Job(folder, lambda look: voussoir.commands.watch('run', progress=look))")
        self.assertEqual(log.read_text(), "saved\n")

    def test_an_interrupted_study_stops_its_runs_and_goes_on(self):
        blocks(LONG).write(self.folder / "blocks.toml")
        study, out = self.folder / "two.toml", self.folder / "out"
        study.write_text('title = "Two"\ncases = ["blocks.toml"]\nscales = [0.5, 1.0]\n')
        done = self.python(f"""
            def interrupt():
                while not list(pathlib.Path({str(out)!r}).rglob("program.log")):
                    time.sleep(0.05)
                time.sleep(0.5)
                os.kill(os.getpid(), signal.SIGINT)
            threading.Thread(target=interrupt).start()
            try:
                voussoir.study({str(study)!r}, {str(out)!r}, cores=1)
            except voussoir.Stopped as error:
                print(error)
        """)
        self.assertIn("the study was stopped; its runs are saved, and the same call goes on", done)
        self.assertEqual(subprocess.run(["pgrep", "-f", str(out)], capture_output=True, text=True, check=False).stdout, "")
        self.assertFalse(voussoir.study(study, out, table=True).finished)
        table = voussoir.study(study, out, cores=1)
        self.assertEqual((table.finished, [row["status"] for row in table]), (True, ["done", "done"]))

    def python(self, code):
        """What another Python prints that does this."""
        head = f"import os, pathlib, signal, sys, threading, time\nsys.path[:0] = [{str(HERE)!r}, {str(HERE.parent)!r}]\nimport voussoir, fixture\nimport voussoir.jobs\n"
        names = f"folder, LONG = {str(self.folder / 'run')!r}, {LONG}\n"
        done = subprocess.run([sys.executable, "-c", head + names + textwrap.dedent(code)], capture_output=True, text=True, check=False, timeout=120,
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler))  # it may be ignored, and is inherited
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout


class Bars(unittest.TestCase):
    def test_what_a_bar_says(self):
        bar = bars.Bar("<hut>")
        bar(Progress(-0.5, None, True, 100.0, None, 0, 0.0, None, ""))
        self.assertIn("settles under gravity, -0.50 s", repr(bar))
        bar._shown = -1.0
        bar(Progress(1.5, 6.0, False, 100.0, 2.0, 1234, 0.0, None, ""))
        self.assertEqual(repr(bar), "<hut>: 25 %, 1.50 of 6 s, 2 s left, 1,234 broken")
        self.assertIn("<b>&lt;hut&gt;</b>", bar._repr_html_())
        self.assertIn("width:25%", bar._repr_html_())
        bar.end(voussoir.Stopped())
        self.assertIn("stopped at 1.50 of 6 s; saved", repr(bar))
        bar.end(voussoir.NumericalFailure("no\nballast"))
        self.assertIn("failed: no", repr(bar))
        bar.end(None)
        self.assertIn("100 %, finished", repr(bar))

    def test_without_a_notebook_a_line_of_text_stays(self):
        self.assertFalse(bars.in_notebook())
        with bars.shown("run", True) as told:
            self.assertIs(told, True)

    def test_a_bar_that_cannot_be_shown_stops_nothing(self):
        class Broken:
            def update(self, *_, **__):
                raise RuntimeError("no output")
        bar = bars.Bar("run")
        bar._handles.append(Broken())
        thread = threading.Thread(target=bar.end, args=(None,))
        thread.start()
        thread.join()
        self.assertIn("finished", repr(bar))
