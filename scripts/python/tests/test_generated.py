# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What scripts write from others: the classes of parts.py, the reference; and the page that promises what stays."""

import pathlib
import re
import subprocess
import sys
import unittest

import voussoir

HERE = pathlib.Path(__file__).resolve().parents[1]


class Generated(unittest.TestCase):
    def up_to_date(self, script):
        done = subprocess.run([sys.executable, HERE / script, "--check"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_the_classes_are_the_keys_of_the_program(self):
        self.up_to_date("make_parts")

    def test_the_reference_is_that_of_the_package(self):
        self.up_to_date("make_reference")


class Promised(unittest.TestCase):
    def test_the_page_names_all_that_is_public_and_no_more(self):
        text = (HERE / "API.md").read_text(encoding="utf-8")
        words = set(re.findall(r"`(\w+)`", text))
        self.assertEqual(set(voussoir.__all__) - words, set())
        self.assertLessEqual(len(text.split()), 1000)
        self.assertIn(f"interface {voussoir.API}", text)

    def test_every_public_name_is_there(self):
        for name in voussoir.__all__:
            getattr(voussoir, name)
