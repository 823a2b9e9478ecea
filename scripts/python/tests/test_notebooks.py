# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The notebooks of notebooks/, from top to bottom, and an interrupt in a real kernel."""

import importlib.util
import json
import os
import unittest

import voussoir
from fixture import HERE, ROOT, InAFolder, blocks

NOTEBOOKS = sorted((ROOT / "scripts/python/notebooks").glob("*.ipynb"))
MISSING = [name for name in ("nbformat", "nbclient", "ipykernel", "matplotlib") if importlib.util.find_spec(name) is None]
NEEDED = f"needs {', '.join(MISSING)}: scripts/setup notebooks"
LONG = 1500.0  # s of two blocks: 7 s of computing on a fast machine
# Words that stand in what the cells of each print or show, and how many pages of the program are in it.
SAYS = {"engineer": ["without rods", "with rods", "yield force", "finished"], "researcher": ["tilt/limit", "largest load factor"],
        "ensemble": ["median", "runs"]}
PAGES = {"engineer": 4, "researcher": 2, "ensemble": 1}


def environment(test):
    """The kernels of a test find the package and the program."""
    before = dict(os.environ)
    test.addCleanup(lambda: (os.environ.clear(), os.environ.update(before)))
    os.environ.update(PYTHONPATH=str(HERE.parent), VOUSSOIR=voussoir.program(), PYDEVD_DISABLE_FILE_VALIDATION="1")


class AsTheyStand(unittest.TestCase):
    def test_there_is_one_for_each_audience(self):
        self.assertEqual([path.stem for path in NOTEBOOKS], sorted(SAYS))

    def test_they_hold_no_outputs(self):
        for path in NOTEBOOKS:
            cells = json.loads(path.read_text())["cells"]
            self.assertEqual([c for c in cells if c.get("outputs") or c.get("execution_count") or c["metadata"]], [], path.name)
            self.assertEqual(cells[0]["cell_type"], "markdown")
            self.assertEqual(len({c["id"] for c in cells}), len(cells))

    def test_their_links_lead_somewhere(self):
        for path in NOTEBOOKS:
            text = "".join("".join(c["source"]) for c in json.loads(path.read_text())["cells"] if c["cell_type"] == "markdown")
            for link in (part.partition(")")[0] for part in text.split("](")[1:]):
                self.assertTrue((path.parent / link.partition("#")[0]).exists(), f"{path.name}: {link}")


@unittest.skipIf(MISSING, NEEDED)
class TopToBottom(InAFolder):
    def test_engineer(self):
        self.execute("engineer")

    def test_researcher(self):
        self.execute("researcher")

    def test_ensemble(self):
        self.execute("ensemble")

    def execute(self, name):
        import nbclient
        import nbformat
        environment(self)
        path = next(path for path in NOTEBOOKS if path.stem == name)
        notebook = nbformat.read(path, as_version=4)
        nbformat.validate(notebook)
        nbclient.NotebookClient(notebook, timeout=600, kernel_name="python3", resources={"metadata": {"path": str(self.folder)}}).execute()
        if keep := os.environ.get("VOUSSOIR_NOTEBOOKS"):
            nbformat.write(notebook, os.path.join(keep, path.name))
        outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
        shown = [output["data"].get("text/html", "") for output in outputs if "data" in output]
        said = " ".join([*shown, *(output["text"] for output in outputs if output["output_type"] == "stream")])
        for words in SAYS[name]:
            self.assertIn(words, said)
        self.assertNotIn("failed:", said)
        self.assertNotIn("Traceback", said)
        pages = [text for text in shown if "data-page=" in text]
        self.assertGreaterEqual(len(pages), PAGES[name])
        for text in pages:
            self.assertIn("data:image/png;base64,", text)  # what stays where there is no WebGL
            self.assertLess(len(text), 2.2e6)


@unittest.skipIf(MISSING, NEEDED)
class Interrupts(InAFolder):
    def setUp(self):
        super().setUp()
        import jupyter_client
        environment(self)
        self.manager, self.client = jupyter_client.manager.start_new_kernel(kernel_name="python3", cwd=str(self.folder))
        self.addCleanup(lambda: (self.client.stop_channels(), self.manager.shutdown_kernel(now=True)))
        self.client.execute_interactive(f"import sys; sys.path.insert(0, {str(HERE)!r})\nimport fixture, voussoir", timeout=60)

    def interrupted(self, code, after=""):
        """The reply to a cell that is interrupted once it shows a bar that has moved, after it has printed `after`; and what it has shown."""
        shown, said, sent = [], [], []
        def look(message):
            content = message["content"]
            if "text" in content:
                said.append(content["text"])
            if "data" in content:
                shown.append(content["data"]["text/plain"])
                if f" of {LONG:g} s" in shown[-1] and not sent and after in "".join(said):
                    sent.append(True)
                    self.manager.interrupt_kernel()
        # Without stop_on_error=False the kernel aborts what comes soon after a cell that was interrupted.
        return self.client.execute_interactive(code, timeout=120, stop_on_error=False, output_hook=look)["content"], shown

    def test_a_run_that_a_cell_waits_for(self):
        straight = blocks().run(self.folder / "straight", until=LONG, threads=1, progress=False)
        for name, code in {"run": f"fixture.blocks().run('run', until={LONG}, threads=1)",
                           "job": f"from IPython.display import display\njob = fixture.blocks().start('job', until={LONG}, threads=1)\ndisplay(job)\nprint('waits', flush=True)\njob.wait()"}.items():
            with self.subTest(name):
                reply, shown = self.interrupted(code, after="waits" if name == "job" else "")
                self.assertEqual((reply["status"], reply["ename"]), ("error", "Stopped"))
                self.assertRegex(shown[-1], f"stopped at .* of {LONG:g} s; saved, so that it can go on")
                run = voussoir.Run(self.folder / name)
                self.assertEqual((run.state, run.finished), ("stopped", False))
                run.close()
                reply = self.client.execute_interactive(f"done = voussoir.Run({name!r}).resume().finished", timeout=120,
                                                        output_hook=lambda _: None)["content"]
                self.assertEqual(reply["status"], "ok")
                run = voussoir.Run(self.folder / name)
                self.assertEqual(run.summary["state_hash"], straight.summary["state_hash"])
                self.assertTrue(run.same_as(straight))

    def test_a_bar_moves_while_other_cells_run(self):
        shown = []
        def look(message):
            if "data" in message["content"]:
                shown.append((message["msg_type"], message["content"]["data"]["text/plain"]))
        self.client.execute_interactive(f"job = fixture.blocks().start('run', until={LONG}, threads=1)\njob", timeout=60, output_hook=look)
        self.client.execute_interactive("import time; time.sleep(1.5)", timeout=60, output_hook=look)
        self.client.execute_interactive("job.stop()", timeout=60, output_hook=look)
        self.assertEqual([kind for kind, _ in shown[:2]], ["display_data", "update_display_data"])
        self.assertGreater(len(shown), 3)
