# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What `import voussoir` needs: nothing beside Python until results are read; and which program an installed package starts."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parents[1] / "voussoir"


def said_by(code: str, path: pathlib.Path, **environment: str) -> str:
    """What a Python prints that finds the package below `path`, and neither NumPy nor h5py."""
    hide = "import sys; sys.modules['numpy'] = sys.modules['h5py'] = None\n"
    keep = {name: value for name, value in os.environ.items() if name != "VOUSSOIR"}
    done = subprocess.run([sys.executable, "-c", hide + code], env={**keep, "PYTHONPATH": str(path), **environment}, cwd=path, capture_output=True, text=True,
                          check=False)
    return done.stdout.strip() or done.stderr.strip().rpartition("\n")[2]


class Import(unittest.TestCase):
    def test_a_case_needs_neither_numpy_nor_h5py(self) -> None:
        code = "import voussoir; m = voussoir.Model('two'); m.box('a', (0, 0, 0), [1, 1.5, 1], material='stone'); print(m.text())"
        self.assertIn("box = [[0.0, 0.0, 0.0], [1.0, 1.5, 1.0]]", said_by(code, PACKAGE.parent))

    def test_results_say_what_they_need_before_anything_runs(self) -> None:
        for code in ("import voussoir; voussoir.Run", "import voussoir; voussoir.Model('two').run('nowhere')"):
            self.assertRegex(said_by(code, PACKAGE.parent), r"ImportError: results need (numpy|h5py): pip install")

    def test_it_is_quick_and_takes_nothing_large(self) -> None:
        code = ("import sys, time; start = time.process_time(); import voussoir; took = time.process_time() - start; "
                "print(took, sorted({'numpy', 'h5py', 'matplotlib', 'voussoir.parts', 'voussoir.results'} & {*sys.modules}))")
        said = [subprocess.run([sys.executable, "-c", code], env={**os.environ, "PYTHONPATH": str(PACKAGE.parent)}, capture_output=True, text=True,
                               check=True).stdout.split(None, 1) for _ in range(3)]
        self.assertLess(min(float(took) for took, _ in said), 0.2)  # s of a processor
        self.assertEqual({others.strip() for _, others in said}, {"[]"})

    def test_names_are_listed_and_others_refused(self) -> None:
        self.assertIn("Model", said_by("import voussoir; print(dir(voussoir))", PACKAGE.parent))
        self.assertIn("no attribute 'Modell'", said_by("import voussoir; voussoir.Modell", PACKAGE.parent))

    def test_an_installed_package_starts_the_program_beside_it(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            at = pathlib.Path(folder)
            shutil.copytree(PACKAGE, at / "voussoir", ignore=shutil.ignore_patterns("__pycache__"))
            beside = at / "bin/voussoir"
            beside.parent.mkdir()
            beside.write_text("#!/bin/sh\n")
            beside.chmod(0o755)
            code = "import voussoir; print(voussoir.program())"
            self.assertEqual(said_by(code, at, PATH=""), str(beside))
            self.assertEqual(said_by(code, at, PATH="", VOUSSOIR="/opt/other"), "/opt/other")


if __name__ == "__main__":
    unittest.main()
