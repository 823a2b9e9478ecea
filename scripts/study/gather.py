# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""All runs of a study as rows of table.csv. usage: gather.py PLAN TABLE   (in the study's folder)

A row a run, in the order of the study file: its place in the study, its status, the attributes of /summary under their own names and in
their own units (interface page), the version of the program; then what it cost, which alone depends on interruptions.
"""
import csv
import json
import pathlib
import sys

import h5py

# Of /summary: what comes first in the table, and what is no result. All else that the program writes there follows.
FIRST = ("collapsed", "fallen_mass_fraction", "first_crack_time", "tension", "shear", "compression", "slipped", "peak_base_shear", "peak_speed")
NOT_RESULTS = ("finished", "units")


def results(path):
    """Attributes of /summary, and which program made them. Figures keep all digits."""
    with h5py.File(path) as file:
        there = dict(file["summary"].attrs)
        names = [name for name in FIRST if name in there] + [name for name in there if name not in (*FIRST, *NOT_RESULTS)]
        return {name: there[name] for name in names} | {"version": file["provenance"].attrs["version"]}


def costs(folder):
    """Core-hours: threads times wall-clock, of all starts. A kill without notice loses what it took since its last results."""
    path = folder / "sessions.json"
    sessions = json.loads(path.read_text()) if path.exists() else []
    seconds = [s["wall_clock"] or 0.0 for s in sessions]
    core_hours = sum(t * s["threads"] for t, s in zip(seconds, sessions)) / 3600.0
    return {"starts": len(sessions), "wall_clock": round(sum(seconds), 3), "core_hours": round(core_hours, 6)}


def row(run):
    folder = pathlib.Path("runs") / run["name"]
    axes = {name: "" if value is None else value for name, value in run["axes"].items()}
    done = folder / "done.json"
    status = json.loads(done.read_text())["status"] if done.exists() else "to be done"
    found = results(folder / "run.h5") if done.exists() else {}
    return {"run": run["name"]} | axes | {"status": status}, found, costs(folder)


def main():
    plan = json.loads(pathlib.Path(sys.argv[1]).read_text())
    rows = [row(run) for run in plan["runs"]]
    names = [dict.fromkeys(name for r in rows for name in r[part]) for part in range(3)]
    columns = [name for part in names for name in part]
    path = pathlib.Path(sys.argv[2])
    with open(path.with_name(path.name + ".tmp"), "w", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(a | b | c for a, b, c in rows)
    path.with_name(path.name + ".tmp").replace(path)


if __name__ == "__main__":
    main()
