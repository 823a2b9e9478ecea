# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Which versions of the program give the same results, bit for bit, so that a table may hold runs of both.

Physics 14 changed contacts with parts of the base and `analysis.level` alone: a case with neither has the results that it had with physics 13.
A study of cases with either goes on with the program that began it, or begins anew; `differs` says which cases these are.
"""
import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "python/voussoir"))
import own_files  # noqa: E402
import toml_reading  # noqa: E402

SAME = {"0.1.0 (physics 14)": "0.1.0 (physics 13)"}  # version: the earliest that gives its results
DIFFER = re.compile(r"\bbase\b|\banalysis\b.*\blevel\b")  # in an override
CATALOGUE = pathlib.Path(__file__).resolve().parents[2] / "cases" / "catalogue"


def results_of(version):
    """The earliest version with the same results."""
    return SAME.get(version, version)


def one_version(tables):
    """Refuses tables, rows by path, whose runs are of versions with different results, which are not comparable."""
    found = [(row["version"], path) for path, rows in tables.items() for row in rows
             if row["status"] == "done" and row.get("version")]
    for version, path in found:
        if results_of(version) != results_of(found[0][0]):
            sys.exit(f"{path}: a run of version {version}, and one of {found[0][1]} is of {found[0][0]}: their results may differ; "
                     "allowed: runs of one version")


def path_of(name, folder):
    """Path of a case: a name of the catalogue, or the path of a file from the folder."""
    return pathlib.Path(folder) / name if name.endswith(".toml") else CATALOGUE / f"{name}.toml"


def has_what_changed(path):
    """Whether a case file, or one of its includes, has parts of the base or blocks kept level."""
    case = toml_reading.loads(own_files.text_of(path, "a case file"))
    if case.get("base", {}).get("part") or case.get("analysis", {}).get("level"):
        return True
    included = case.get("include", [])
    return any(has_what_changed(path_of(name, path.parent)) for name in ([included] if isinstance(included, str) else included))


def differs(case, overrides):
    """Whether the results of a case may differ between versions that SAME joins. True if its text cannot be read (the catalogue of an installed
    program is built in)."""
    try:
        return any(map(DIFFER.search, overrides)) or has_what_changed(path_of(str(case), "."))
    except own_files.StudyError:
        return True
