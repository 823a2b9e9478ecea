# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The rules for values of run.h5 stand twice, in C++ and here: both are the same."""

import pathlib
import re
import unittest

from voussoir import rules

SOURCE = pathlib.Path(__file__).resolve().parents[3] / "io/output/replay/values/value_rules.cpp"


def of_the_program():
    """The rules in the source of the program, by dataset: (extents, values, items, least)."""
    text = SOURCE.read_text()
    names = dict(re.findall(r'(k\w+) = "([^"]+)"', text))
    word = lambda item: names.get(item.strip(), item.strip().strip('"'))
    found = {}
    for name, shape, rest in re.findall(r'\{"(/[^"]+)", \{([^}]*)\}((?:, [^{}]*?)?)\}', text):
        values, items, least, *_ = [word(item) for item in rest.split(",")[1:]] + ["finite", "", "0"][len(rest.split(",")) - 1:]
        found[name] = (tuple(word(item) for item in shape.split(",")), values, items, int(least))
    return found


class Rules(unittest.TestCase):
    def test_the_rules_are_those_of_the_program(self):
        program = of_the_program()
        self.assertGreater(len(program), 60)
        self.assertEqual({name: (r.shape, r.values, r.items, r.least) for name, r in rules._RULES.items()}, program)
