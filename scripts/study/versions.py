# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Which versions of the program give the same results, bit for bit, so that a table may hold runs of both.

Physics 14 changed contacts with parts of the base and `analysis.level` alone: a case with neither has the results that it had with physics 13.
A study of cases with either goes on with the program that began it, or begins anew; `differs` says which cases these are.
"""
import pathlib
import re

SAME = {"0.1.0 (physics 14)": "0.1.0 (physics 13)"}  # version: the earliest that gives its results
DIFFER = re.compile(r"\bbase\.part|\bpart\s*=\s*\[\s*\{|\blevel\s*=\s*true")  # in a case file or an override
INCLUDE = re.compile(r'^include\s*=\s*"(.+)"', re.MULTILINE)
CATALOGUE = pathlib.Path(__file__).resolve().parents[2] / "cases" / "catalogue"


def results_of(version):
    """The earliest version with the same results."""
    return SAME.get(version, version)


def text_of(path):
    """Of a case file and all that it includes."""
    text = path.read_text()
    included = [path.parent / name if name.endswith(".toml") else CATALOGUE / f"{name}.toml" for name in INCLUDE.findall(text)]
    return "\n".join([text, *(text_of(p) for p in included if p.exists())])


def differs(case, overrides):
    """Whether a case (a name of the catalogue, or the path of a file) is one whose results versions that SAME joins may not share. It is taken for
    one if its text is not there to be read (an installed program has its catalogue inside)."""
    path = pathlib.Path(case) if str(case).endswith(".toml") else CATALOGUE / f"{case}.toml"
    return not path.exists() or bool(DIFFER.search("\n".join([text_of(path), *overrides])))
