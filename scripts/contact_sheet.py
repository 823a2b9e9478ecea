#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Moments of several runs side by side in one picture: a row for each run, a column for each time (empty where a run ended before).

usage: scripts/contact_sheet.py DIR... [--times T ...] [--view corner] [--stills FOLDER] [--width 4.5] [--dpi 150] [-o sheet.png]
       [--voussoir PROGRAM]
DIR is the folder of a run, or a folder with folders of runs in it: scripts/contact_sheet.py results -o all.png shows all of them at four moments.
Each picture is a still of `voussoir report DIR --stills` (plain without Chromium), kept in DIR/stills or in FOLDER; those that are there and not older than
the run are used as they are. Their titles are cut off: the sheet has its own. Needs what `scripts/setup plots` installs.
"""

import argparse
import hashlib
import os
import pathlib
import subprocess
import sys

from PIL import Image

import run_file
from run_file import plt, voussoir

WIDTH = 4.5  # of a picture, inches: the type in it is then as large as a caption in print
TITLE = 0.086  # part of a still that its title takes, at the top (scripts/report/src/overlay.js)
POINTS, LETTER = 12, 0.6  # size of a title; width of a letter in parts of its size
PARTS = (0.2, 0.4, 0.6, 1.0)  # of the longest run: the four moments if none are named


def end_of(folder):
    """The end of a run, s."""
    with run_file.open_results(os.path.join(folder, "run.h5")) as file:
        return float(run_file.frame_times(file)[-1])


def runs_in(folder):
    """The folder itself if it is that of a run, else the folders of runs in it."""
    if os.path.exists(os.path.join(folder, "run.h5")):
        return [folder]
    inside = sorted(str(path.parent) for path in pathlib.Path(folder).glob("*/run.h5"))
    if not inside:
        sys.exit(f"{folder}: holds no run.h5, nor does a folder in it")
    return inside


def stills(folder, view, times, program, kept=None):
    """Paths of a run's pictures, one for each time up to its end. kept: the folder for them; None: DIR/stills."""
    end = end_of(folder)
    times = [t for t in times if t <= end + 1e-6]
    kept = kept or os.path.join(folder, "stills")
    paths = [os.path.join(kept, f"{view}-{t:g}s.png") for t in times]
    ran = os.path.getmtime(os.path.join(folder, "run.h5"))
    old = [t for t, path in zip(times, paths) if not os.path.exists(path) or os.path.getmtime(path) < ran]
    if old:
        words = [program, "report", folder, "--output", kept, "--overwrite", "--view", view, "--stills", ",".join(f"{t:g}" for t in old)]
        try:
            done = subprocess.run(words)
        except OSError as error:
            sys.exit(f"{program}: {error.strerror}; build it, or name the program by --voussoir")
        if done.returncode != 0:
            sys.exit(done.returncode)  # the program has said why
    return paths


def name_of_its_own(folder):
    """A unique name for a run, among runs in folders of the same name."""
    path = os.path.realpath(folder)
    return f"{os.path.basename(path)}-{hashlib.sha256(path.encode()).hexdigest()[:8]}"


def sheet(rows, names, times, output, dpi=150, width=WIDTH):
    """Draws the pictures of `rows`, each a list of paths in the order of `times`, `width` inches wide."""
    with Image.open(max(rows, key=len)[0]) as first:
        height = width * (1 - TITLE) * first.height / first.width
    size = (width * len(times), (height + 0.3) * len(rows))
    titles = [[f"{name}, {t:.2f} s" if t == times[0] else f"{t:.2f} s" for t in times] for name in names]
    longest = max(len(title) for of_row in titles for title in of_row)
    points = min(POINTS, 72 * width / (LETTER * longest))  # none runs into the next picture
    figure, grid = plt.subplots(len(rows), len(times), figsize=size, squeeze=False, layout="constrained")
    for axes_of_row, paths, of_row in zip(grid, rows, titles):
        for axes in axes_of_row:
            axes.set_axis_off()
        for axes, path, title in zip(axes_of_row, paths, of_row):
            with Image.open(path) as still:
                axes.imshow(still.crop((0, round(TITLE * still.height), still.width, still.height)), interpolation="antialiased")
            axes.set_title(title, fontsize=points, loc="left")
    figure.savefig(output, dpi=dpi)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("folders", nargs="+", metavar="DIR")
    p.add_argument("--times", type=float, nargs="+", help="s (default: four moments of the longest run)")
    p.add_argument("--view", default="corner", choices=["corner", "rearcorner", "front", "rear", "left", "side", "top", "plan"])
    p.add_argument("--stills", metavar="FOLDER", help="keep the pictures in FOLDER/NAME-HASH of each run (a hash of its path) and not in DIR/stills")
    p.add_argument("--width", type=float, default=WIDTH, help="of a picture, inches")
    p.add_argument("--dpi", type=int, default=150)
    p.add_argument("-o", "--output", default="sheet.png")
    p.add_argument("--voussoir", default=voussoir.program(), metavar="PROGRAM", help="default: %(default)s")
    a = p.parse_args()
    folders = [run for folder in a.folders for run in runs_in(folder)]
    last = max(map(end_of, folders))
    times = sorted(a.times or {round(part * last, 2) for part in PARTS})
    if times[0] > last + 1e-6:
        sys.exit(f"--times {times[0]:g}: no run goes so far; the longest ends at {last:g} s")
    names = [os.path.basename(os.path.normpath(f)) for f in folders]
    rows = [stills(f, a.view, times, a.voussoir, a.stills and os.path.join(a.stills, name_of_its_own(f))) for f in folders]
    sheet(rows, names, times, a.output, a.dpi, a.width)


if __name__ == "__main__":
    main()
