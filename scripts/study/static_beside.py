#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Sets the static capacity of a building beside its incremental dynamic analysis: for each run of a study that is done, what it did, what two
pushovers say of the spectrum of its own motion, and whether they agree. Writes a table.csv; --show prints one as Markdown.

usage: static_beside.py STUDY --push DIR --back DIR --corner-period S [--axis x] [--point control] [-o FILE.csv]
       static_beside.py --show FILE.csv

STUDY: the folder of a study (table.csv, runs/); its cases must follow a point of that name, which is the control point of the pushovers too.
--push, --back: folders of pushovers along the axis and against it. The spectrum is that of the motion as applied along the axis, of each run;
T_C is no property of a record and must be said. Programs: VOUSSOIR, else build/release/io/voussoir.

A run is borne if it did not collapse and the point stayed within near collapse of both pushovers; the pushovers bear the motion if demand over
capacity by N2 (EC 8) is at most 1 in both. What they could not prove is in the column `open`.
"""
import argparse
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
NAMES = ["run", "record", "level", "dynamic_peak", "dynamic_back", "dynamic_shear", "collapsed", "static_shear", "near_collapse", "n2_target",
         "n2_back_target", "spectrum_target", "spectrum_back_target", "demand_over_capacity", "open", "verdict"]


def performance(program, push, motion, corner):
    """What `voussoir assess` says of a pushover under the spectrum of a motion: the object `capacity`."""
    words = [program, "assess", push, "--demand", f"record:{motion}", "--corner-period", str(corner), "--format", "json"]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{push}: {done.stderr.strip()}")
    return json.loads(done.stdout)["capacity"]


def write_motion(run, axis, path):
    time, a = run["motion/time"][()], run["motion/acceleration"][()][:, axis]
    path.write_text("t [s],a [m/s2]\n" + "".join(f"{t:.9g},{x:.9g}\n" for t, x in zip(time, a)))


def verdict(dynamic, static):
    if static is None:
        return "static not known"
    return {(True, True): "both bear it", (False, False): "neither bears it", (True, False): "static alone fails", (False, True): "dynamic alone fails"}[dynamic, static]


def row_of(row, a, scratch):
    import h5py  # --show needs none

    folder = a.study / "runs" / row["run"]
    with h5py.File(folder / "run.h5") as run:
        moved = run[f"history/{a.point}/displacement"][()][:, "xyz".index(a.axis)]
        motion = scratch / "motion.csv"
        write_motion(run, "xyz".index(a.axis), motion)
    sides = [performance(a.program, push, motion, a.corner_period) for push in (a.push, a.back)]
    methods = [{p["name"]: p for p in side["performance"]["points"]} for side in sides]
    peaks = [float(moved.max(initial=0.0)), float(-moved.min(initial=0.0))]
    limits = [side["near_collapse"] for side in sides]
    ratios = [m["n2_ec8"]["demand_over_capacity"] for m in methods]
    # Where a side gives no figure but its target lies beyond what the curve shows, nothing is known of it.
    static = None if None in ratios else max(ratios) <= 1.0
    dynamic = row["collapsed"] == "0" and all(limit is None or peak <= limit for peak, limit in zip(peaks, limits))
    open_words = sorted({s for m in methods for s in m["n2_ec8"]["not_proven"]})
    values = [row["run"], row["record"], row["level"], peaks[0], peaks[1], row["peak_base_shear"], row["collapsed"],
              min(side["peak_shear"] for side in sides), min(x for x in limits if x is not None) if any(x is not None for x in limits) else "",
              methods[0]["n2_ec8"]["target"], methods[1]["n2_ec8"]["target"], methods[0]["capacity_spectrum"]["target"],
              methods[1]["capacity_spectrum"]["target"], "" if None in ratios else max(ratios), "; ".join(open_words), verdict(dynamic, static)]
    return dict(zip(NAMES, ["" if v is None else v for v in values]))


def shown(text, factor, digits):
    return "–" if text == "" else f"{factor * float(text):.{digits}f}"


def show(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    print("| record | PGA, m/s2 | displacement, +x; −x, mm | N2, EC 8, mm | capacity spectrum, mm | largest base shear, kN: run; pushover "
          "| demand over capacity | verdict |")
    print("|---" * 8 + "|")
    for r in rows:
        pair = lambda a, b: f"{shown(r[a], 1e3, 1)}; {shown(r[b], 1e3, 1)}"
        print(f"| {r['record']} | {float(r['level']):g} | {pair('dynamic_peak', 'dynamic_back')} | {pair('n2_target', 'n2_back_target')} "
              f"| {pair('spectrum_target', 'spectrum_back_target')} | {shown(r['dynamic_shear'], 1e-3, 1)}; {shown(r['static_shear'], 1e-3, 1)} "
              f"| {shown(r['demand_over_capacity'], 1, 2)} | {r['verdict']} |")


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n\n")[0], usage=argparse.SUPPRESS)
    words.add_argument("study", nargs="?", type=pathlib.Path)
    words.add_argument("--show")
    words.add_argument("--push")
    words.add_argument("--back")
    words.add_argument("--corner-period", type=float)
    words.add_argument("--axis", choices=("x", "y"), default="x")
    words.add_argument("--point", default="control")
    words.add_argument("-o", dest="output", type=pathlib.Path)
    a = words.parse_args()
    if a.show:
        return show(a.show)
    if None in (a.study, a.push, a.back, a.corner_period):
        sys.exit("static_beside.py: wanted: STUDY, --push DIR, --back DIR and --corner-period S")
    a.program = os.environ.get("VOUSSOIR", str(ROOT / "build/release/io/voussoir"))
    with open(a.study / "table.csv", newline="", encoding="utf-8") as file:
        done = [row for row in csv.DictReader(file) if row["status"] == "done"]
    with tempfile.TemporaryDirectory() as scratch:
        rows = [row_of(row, a, pathlib.Path(scratch)) for row in done]
    with open(a.output, "w", newline="", encoding="utf-8") if a.output else sys.stdout as file:
        table = csv.DictWriter(file, NAMES, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


main()
