# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""All runs of a study as rows of table.csv. usage: gather.py PLAN TABLE   (in the study's folder)

A row a run, in the order of the study file: its place in the study, its status, what `voussoir summary` says of it under the same names and
in the same units (io/MEASURES.md), the version of the program that made it; then what it cost, which alone depends on interruptions. Of a run
made elsewhere: the row that is known of it. A run whose results cannot be read is to be done, with a warning on standard error.
"""
import csv
import json
import pathlib
import subprocess
import sys

import h5py

import own_files

# What comes first in the table, and what is no result. All else that the program says follows, the walls last.
FIRST = ("collapsed", "damage_grade", "fallen_mass_fraction", "first_crack_time", "first_fallen_time", "first_fallen_wall", "peak_drift",
         "residual_drift", "first_tension", "first_shear", "first_compression", "tension", "shear", "compression", "slipped",
         "peak_base_shear", "peak_speed")
NOT_RESULTS = ("finished", "grade_time", "walls", "points", "capacity", "chance", "ties", "loads")
OF_NO_RUN = ("name", "storey", "foot", "top")  # of a wall: what the model says
STRENGTH = ("intensity", "level")  # of the place in a study with [intensity] alone
COSTS = ("starts", "wall_clock", "core_hours")


def flat(summary):
    """One value per name: `grade_2_time`, `front wall: peak_drift`. Undefined values, as the drift of a fallen wall, are empty."""
    names = [name for name in FIRST if name in summary] + [name for name in summary if name not in (*FIRST, *NOT_RESULTS)]
    out = {name: summary[name] for name in names}
    out |= {f"grade_{grade}_time": time for grade, time in enumerate(summary["grade_time"], 1)}
    for wall in summary["walls"]:
        out |= {f"{wall['name']}: {name}": value for name, value in wall.items() if name not in OF_NO_RUN}
    for tie in summary.get("ties", []):
        out |= {f"{tie['name']}: {name}": tie[name] for name in ("peak_force", "utilisation", "broken")}
    out |= {f"{point['name']}: peak_acceleration": point["peak_acceleration"] for point in summary.get("points", [])}
    capacity = {name: value for name, value in summary.get("capacity", {}).items() if name not in ("performance", "loops", "control")}  # tables of their own
    out |= {f"capacity: {name}": "; ".join(value) if isinstance(value, list) else value for name, value in capacity.items()}
    if summary.get("chance"):
        out["chaotic_from"] = summary["chance"]["from"]
    return {name: "" if value is None else value for name, value in out.items()}


class Unreadable(Exception):
    """The results of a run cannot be read, with the reason."""


def motion_factor(file):
    """By which its [intensity] was reached: the factor of the vertical component, which is that of all, or the geometric mean of the two others'."""
    for name in ("motion/factors", "motion/factor"):  # the second: of an older run
        if name in file:
            return {"motion_factor": float(file[name][-1])}
    return {}


def results(voussoir, folder):
    """Results of a run, measured anew, and the program that made it. Numbers keep all digits."""
    said = subprocess.run([voussoir, "summary", str(folder), "--format", "json"], capture_output=True, text=True, check=False)
    if said.returncode != 0:
        raise Unreadable(said.stderr.strip())
    try:
        with h5py.File(folder / "run.h5") as file:
            factor = motion_factor(file)
            return flat(json.loads(said.stdout)) | factor | {"version": file["provenance"].attrs["version"]}
    except (OSError, KeyError) as error:
        raise Unreadable(str(error)) from error


def costs(folder):
    """Core-hours: threads times wall-clock time, of all starts. A kill without notice loses the time since the last results."""
    path = folder / "sessions.json"
    sessions = json.loads(path.read_text()) if path.exists() else []
    seconds = [s["wall_clock"] or 0.0 for s in sessions]
    core_hours = sum(t * s["threads"] for t, s in zip(seconds, sessions)) / 3600.0
    return dict(zip(COSTS, (len(sessions), round(sum(seconds), 3), round(core_hours, 6))))


def place(run, status):
    axes = {name: "" if value is None else value for name, value in run["axes"].items()}
    return {"run": run["name"]} | axes | {"identity": run["identity"], "status": status}


def outcome(voussoir, folder):
    """Status of a run, with its results."""
    done = folder / "done.json"
    try:
        if done.exists():
            return json.loads(done.read_text())["status"], results(voussoir, folder)
    except Unreadable as error:
        print(f"warning: {folder}: {error}; its row is left empty; remove {folder} to run it anew", file=sys.stderr)
    return "to be done", {}


def row(voussoir, run):
    folder = pathlib.Path("runs") / run["name"]
    status, found = outcome(voussoir, folder)
    return place(run, status), found, costs(folder)


def known_row(known, run):
    """A known row in the form of this table: its place becomes this study's, its columns may be in another order."""
    here = place(run, known["status"])
    found = {name: value for name, value in known.items() if name not in (*here, *STRENGTH, *COSTS)}
    return here, found, {name: known[name] for name in COSTS}


def main():
    plan = json.loads(pathlib.Path(sys.argv[1]).read_text())
    known = plan["known"]
    rows = [known_row(known[run["name"]], run) if run["name"] in known else row(plan["voussoir"], run) for run in plan["runs"]]
    names = [dict.fromkeys(name for r in rows for name in r[part]) for part in range(3)]
    columns = [name for part in names for name in part]
    with own_files.replacing(sys.argv[2]) as file:  # `run --table` may make a table beside the study's own
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(a | b | c for a, b, c in rows)


if __name__ == "__main__":
    try:
        main()
    except own_files.StudyError as error:
        sys.exit(str(error))
