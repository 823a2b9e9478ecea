#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws the tables of perf/run: speed-up over threads, and time per joint over the number of houses.

usage: scripts/plot_bench.py FOLDER [-o PICTURE]      (needs python3-matplotlib)
"""
import argparse
import csv
import pathlib
import re

import matplotlib
import matplotlib.ticker

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def in_powers_of_two(axis, set_scale):
    set_scale("log", base=2)
    axis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))


def speedups(axes, tables):
    most = 1
    for path in tables:
        for scatter in ("colour", "gather"):
            mine = [r for r in rows(path) if r["scatter"] == scatter]
            threads = [int(r["threads"]) for r in mine]
            most = max(most, *threads)
            style = "-o" if scatter == "colour" else "--s"
            # What others did on the machine left out, if it was quiet often enough with every number of threads.
            quiet = all(int(r.get("quiet") or 0) >= 10 and r["quiet_speedup"] for r in mine)
            speedup = [float(r["quiet_speedup" if quiet else "speedup"]) for r in mine]
            axes.plot(threads, speedup, style, label=f"{path.stem}, {scatter}" + (", quiet" if quiet else ""))
    axes.plot([1, most], [1, most], color="grey", linewidth=0.8)
    axes.set(xlabel="threads", ylabel="speed-up")
    in_powers_of_two(axes.xaxis, axes.set_xscale)
    in_powers_of_two(axes.yaxis, axes.set_yscale)
    axes.legend(fontsize=7)


def growth(axes, tables):
    houses = {float(m.group(1)): rows(p) for p in tables if (m := re.search(r"-x([0-9.]+)$", p.stem))}
    for scatter, style in (("colour", "-o"), ("gather", "--s")):
        points = sorted((n, float(r["ns_per_joint"])) for n, table in houses.items() for r in table
                        if r["scatter"] == scatter and r["threads"] == "1")
        axes.plot([n for n, _ in points], [t for _, t in points], style, label=f"{scatter}, 1 thread")
    axes.set(xlabel="houses", ylabel="ns a joint and step")
    in_powers_of_two(axes.xaxis, axes.set_xscale)
    axes.set_ylim(bottom=0.0)
    axes.legend(fontsize=7)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, help="default: FOLDER/bench.png")
    words = parser.parse_args()
    tables = sorted(words.folder.glob("*.csv"))
    if not tables:
        parser.error(f"{words.folder}: holds no table (*.csv) of perf/run")
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), constrained_layout=True)
    speedups(left, tables)
    growth(right, tables)
    picture = words.output or words.folder / "bench.png"
    figure.savefig(picture, dpi=120)
    print(picture)


if __name__ == "__main__":
    main()
