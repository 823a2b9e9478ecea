#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Draws the tables of perf/run: speed-up over threads, time per joint over the number of houses, and where the time of a step goes.

usage: scripts/plot_bench.py FOLDER [-o PICTURE]      (needs python3-matplotlib)
       scripts/plot_bench.py perf/stages.csv          the figure of perf/README.md: perf/stages.svg
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
        mine = rows(path)
        threads = [int(r["threads"]) for r in mine]
        most = max(most, *threads)
        # What others did on the machine left out, if it was quiet often enough with every number of threads.
        quiet = all(int(r.get("quiet") or 0) >= 10 and r["quiet_speedup"] for r in mine)
        speedup = [float(r["quiet_speedup" if quiet else "speedup"]) for r in mine]
        axes.plot(threads, speedup, "-o", label=path.stem + (", quiet" if quiet else ""))
    axes.plot([1, most], [1, most], color="grey", linewidth=0.8)
    axes.set(xlabel="threads", ylabel="speed-up")
    in_powers_of_two(axes.xaxis, axes.set_xscale)
    in_powers_of_two(axes.yaxis, axes.set_yscale)
    axes.legend(fontsize=7)


def growth(axes, tables):
    houses = {float(m.group(1)): rows(p) for p in tables if (m := re.search(r"-x([0-9.]+)$", p.stem))}
    points = sorted((n, float(r["ns_per_joint"])) for n, table in houses.items() for r in table if r["threads"] == "1")
    axes.plot([n for n, _ in points], [t for _, t in points], "-o", label="1 thread")
    axes.set(xlabel="houses", ylabel="ns a joint and step")
    in_powers_of_two(axes.xaxis, axes.set_xscale)
    axes.set_ylim(bottom=0.0)
    axes.legend(fontsize=7)


def stages(axes, tables):
    """One bar a subject and number of threads: shares of a step; in each part how near it comes to the machine's limits."""
    bars = []
    for path in tables:
        mine = [r for r in rows(path) if r["part_of_the_step"] != "step"]
        for threads in dict.fromkeys(r["threads"] for r in mine):
            name = path.stem.removesuffix("-stages")
            bars.append((f"{name}, {threads} thread{'s' if threads != '1' else ''}", [r for r in mine if r["threads"] == threads]))
    parts = list(dict.fromkeys(r["part_of_the_step"] for _, bar in bars for r in bar))
    colours = dict(zip(parts, plt.get_cmap("tab10").colors))
    for y, (_, bar) in enumerate(bars):
        left = 0.0
        for r in bar:
            share = float(r["share_of_step"])
            axes.barh(y, share, left=left, color=colours[r["part_of_the_step"]], label=r["part_of_the_step"] if y == 0 else None)
            limits = [f"{name} {100 * float(r[key]):.0f} %" for name, key in (("P", "share_of_peak"), ("M", "share_of_triad")) if r[key]]
            if share > 0.05:
                axes.text(left + share / 2, y, "\n".join(limits), ha="center", va="center", fontsize=6)
            left += share
    axes.set(yticks=range(len(bars)), xlim=(0.0, 1.0), xlabel="share of a step (P: of the peak of multiply-adds, M: of STREAM's triad)")
    axes.set_yticklabels([name for name, _ in bars], fontsize=7)
    axes.invert_yaxis()
    axes.legend(fontsize=7, ncols=5, loc="lower center", bbox_to_anchor=(0.5, 1.0))


def by_state(path, picture):
    """Times of a step from a table of state, threads, part and ms: one panel per state, one bar per number of threads."""
    plt.rcParams.update({"font.size": 8, "svg.fonttype": "none", "svg.hashsalt": "voussoir"})
    table = rows(path)
    parts = [p for p in dict.fromkeys(r["part"] for r in table) if any(float(r["ms"]) > 0.0 for r in table if r["part"] == p)]
    colours = dict(zip(parts, plt.get_cmap("tab10").colors))
    states = list(dict.fromkeys(r["state"] for r in table))
    figure, panels = plt.subplots(1, len(states), figsize=(7.5, 1.9), constrained_layout=True)
    for axes, state in zip(panels, states):
        left = dict.fromkeys((r["threads"] for r in table if r["state"] == state), 0.0)
        for r in (r for r in table if r["state"] == state):
            axes.barh(r["threads"], float(r["ms"]), left=left[r["threads"]], color=colours[r["part"]], height=0.6)
            left[r["threads"]] += float(r["ms"])
        axes.set(title=f"Flat20N, {state}", xlabel="ms a step", ylabel="threads")
        axes.invert_yaxis()
    figure.legend([plt.Rectangle((0, 0), 1, 1, color=colours[p]) for p in parts], parts, loc="lower center",
                  ncols=len(parts), frameon=False, bbox_to_anchor=(0.5, -0.14))
    figure.savefig(picture, bbox_inches="tight", metadata={"Date": None} if picture.suffix == ".svg" else None)
    print(picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, help="default: FOLDER/bench.png")
    words = parser.parse_args()
    if words.folder.is_file():
        by_state(words.folder, words.output or words.folder.with_suffix(".svg"))
        return
    by_stage = sorted(words.folder.glob("*-stages.csv"))
    tables = sorted(set(words.folder.glob("*.csv")) - set(by_stage))
    if not tables or not by_stage:
        parser.error(f"{words.folder}: holds no tables (NAME.csv, NAME-stages.csv) of perf/run")
    figure = plt.figure(figsize=(11, 5.5 + 0.4 * len(by_stage)), constrained_layout=True)
    axes = figure.subplot_mosaic([["speedup", "growth"], ["stages", "stages"]], height_ratios=[4.5, 1 + 0.4 * len(by_stage)])
    speedups(axes["speedup"], tables)
    growth(axes["growth"], tables)
    stages(axes["stages"], by_stage)
    picture = words.output or words.folder / "bench.png"
    figure.savefig(picture, dpi=120)
    print(picture)


if __name__ == "__main__":
    main()
