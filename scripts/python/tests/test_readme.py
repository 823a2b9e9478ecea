# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The examples of the documents, run as they stand but for how long they shake."""

import os
import re

import fixture
import voussoir

SHORT = [(re.compile(r"until=[0-9.]+"), "until=0.01"), (re.compile('"flat20n"'), '"arch"')]  # a smaller house
CUBE = ([[x, y, 0.2 + z] for x in (0.1, 0.3) for y in (0.1, 0.3) for z in (0.0, 0.2)],
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])


def examples(path):
    """The blocks of Python in a document, each with its line."""
    text = (fixture.ROOT / path).read_text()
    for block in re.finditer(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        code, line = block.group(1), text.count("\n", 0, block.start()) + 2
        for pattern, instead in SHORT:
            code = pattern.sub(instead, code)
        yield line, compile("\n" * (line - 1) + code, path, "exec")


class Documents(fixture.InAFolder):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)

    def run_all(self, path, names, leave_out=()):
        ran = 0
        for line, code in examples(path):
            if any(word in code.co_names for word in leave_out):
                continue
            with self.subTest(path=path, line=line):
                exec(code, names)
            ran += 1
        return ran

    def test_every_example_is_python(self):
        for path in fixture.ROOT.rglob("*.md"):
            if "node_modules" not in path.parts and "build" not in path.parts:
                list(examples(path.relative_to(fixture.ROOT)))

    def test_the_package(self):
        names = {"voussoir": voussoir, "vertices": CUBE[0], "faces": CUBE[1]}
        # Examples with files of the user have their own tests (test_compas.py, test_shapes.py).
        self.assertEqual(self.run_all("scripts/python/README.md", names, leave_out=("add_stones", "compas")), 5)

    def test_the_tutorial(self):
        model = voussoir.Model(include=str(fixture.ROOT / "cases/tutorial/hut.toml"))
        model.run("results/hut", until=0.01, threads=1)
        self.assertEqual(self.run_all("cases/tutorial/README.md", {}), 1)
