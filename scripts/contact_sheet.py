#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Moments of several runs side by side in one picture: a row for each run, a column for each time (empty where a run ended before).

usage: scripts/contact_sheet.py DIR... --times T ... [--view front] [--dpi 150] [-o sheet.png] [--voussoir PROGRAM]
Each picture is a still of `voussoir report DIR --stills` (needs Chromium); those that are there and not older than the run are used as they are.
Needs what `scripts/setup plots` installs.
"""

import argparse
import os
import subprocess
import sys

from PIL import Image

import run_file
from run_file import plt, voussoir

WIDTH = 3.2  # of a picture, inches


def end_of(folder):
    """Of a run, s."""
    with run_file.open_results(os.path.join(folder, "run.h5")) as file:
        return float(run_file.frame_times(file)[-1])


def stills(folder, view, times, program):
    """Paths of a run's pictures, one a time up to its end."""
    end = end_of(folder)
    times = [t for t in times if t <= end + 1e-6]
    paths = [os.path.join(folder, "stills", f"{view}-{t:g}s.png") for t in times]
    ran = os.path.getmtime(os.path.join(folder, "run.h5"))
    old = [t for t, path in zip(times, paths) if not os.path.exists(path) or os.path.getmtime(path) < ran]
    if old:
        words = [program, "report", folder, "--overwrite", "--view", view, "--stills", ",".join(f"{t:g}" for t in old)]
        try:
            done = subprocess.run(words)
        except OSError as error:
            sys.exit(f"{program}: {error.strerror}; build it, or name the program by --voussoir")
        if done.returncode != 0:
            sys.exit(done.returncode)  # the program has said why
    return paths


def sheet(rows, names, times, output, dpi=150):
    """Draws the pictures of `rows`, each a list of paths in the order of `times`."""
    with Image.open(max(rows, key=len)[0]) as first:
        height = WIDTH * first.height / first.width
    size = (WIDTH * len(times), (height + 0.25) * len(rows))
    figure, grid = plt.subplots(len(rows), len(times), figsize=size, squeeze=False, layout="constrained")
    for axes_of_row, paths, name in zip(grid, rows, names):
        for axes in axes_of_row:
            axes.set_axis_off()
        for axes, path, t in zip(axes_of_row, paths, times):
            axes.imshow(Image.open(path), interpolation="antialiased")
            axes.set_title(f"{name}, {t:.2f} s" if t == times[0] else f"{t:.2f} s", fontsize=8, loc="left")
    figure.savefig(output, dpi=dpi)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("folders", nargs="+", metavar="DIR")
    p.add_argument("--times", type=float, nargs="+", required=True, help="s")
    p.add_argument("--view", default="front", choices=["corner", "front", "rear", "side", "top"])
    p.add_argument("--dpi", type=int, default=150, help="pictures are 3.2 inches wide")
    p.add_argument("-o", "--output", default="sheet.png")
    p.add_argument("--voussoir", default=voussoir.program(), metavar="PROGRAM", help="default: %(default)s")
    a = p.parse_args()
    a.times.sort()
    last = max(map(end_of, a.folders))
    if a.times[0] > last + 1e-6:
        sys.exit(f"--times {a.times[0]:g}: no run goes so far; the longest ends at {last:g} s")
    names = [os.path.basename(os.path.normpath(f)) for f in a.folders]
    sheet([stills(f, a.view, a.times, a.voussoir) for f in a.folders], names, a.times, a.output, a.dpi)


if __name__ == "__main__":
    main()
