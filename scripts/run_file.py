# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the plotting scripts share: reading run.h5, the words of the command line, saving a figure.

Needs python3-h5py, python3-numpy, python3-matplotlib.
"""

import argparse
import pathlib
import sys
import tomllib

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Okabe and Ito's colours, which colour-blind readers can tell apart, and dashes that survive a black and white print.
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]
DASHES = ["-", "--", "-.", ":"]

plt.rcParams.update({"font.size": 8, "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.5, "axes.axisbelow": True,
                     "legend.frameon": False, "lines.linewidth": 1.0, "svg.fonttype": "none", "pdf.fonttype": 42,
                     "svg.hashsalt": "voussoir"})


def open_results(path):
    """The run.h5 of a run, named by its folder or by itself."""
    path = pathlib.Path(path)
    path = path / "run.h5" if path.is_dir() else path
    if not path.is_file():
        sys.exit(f"{path}: no such file; wanted the folder of a run, or its run.h5")
    try:
        file = h5py.File(path, "r")
    except OSError as error:
        sys.exit(f"{path}: {error}")
    if file.attrs.get("format") != "voussoir results":
        sys.exit(f"{path}: holds no results of Voussoir")
    return file


def frame_times(file):
    """s; a run at work may have none yet."""
    times = file["frames/time"][:]
    if not len(times):
        sys.exit(f"{file.filename}: has no frames yet")
    return times


class Run:
    """A run's results, of a finished run or of one that goes on."""

    def __init__(self, argument):
        """argument: DIR, DIR/run.h5, or either behind "LABEL="."""
        label, found, path = argument.partition("=")
        self.file = open_results(path if found else argument)
        self.label = label if found else pathlib.Path(self.file.filename).absolute().parent.name

    def base(self):
        """Height of the base, m; 0 without one."""
        return float(tomllib.loads(self.file["case"].attrs["toml"]).get("base", {}).get("z", 0.0))

    def names(self):
        """Of the histories."""
        return [name for name in self.file["history"] if name != "time"]

    def table(self, group):
        """All columns of a group of rows: {"time": ..., ...}."""
        columns = {name: data[:] for name, data in self.file[group].items() if isinstance(data, h5py.Dataset)}
        if not len(columns["time"]):
            sys.exit(f"{self.label}: has no rows of {group} yet")
        return columns

    def history(self, name, quantity):
        """Time (n) and displacement, velocity or rotation (n x 3) of a followed element."""
        if name not in self.names():
            sys.exit(f"{self.label}: no history '{name}'; there are: {', '.join(self.names()) or 'none'}")
        time = self.file["history/time"][:]
        if not len(time):
            sys.exit(f"{self.label}: the shaking has not begun")
        return time, self.file[f"history/{name}/{quantity}"][:]


def style(number):
    """Colour and dashes of the number-th line."""
    return {"color": COLOURS[number % len(COLOURS)], "linestyle": DASHES[number % len(DASHES)]}


def parser(documentation, output, over_time=False):
    """Arguments all scripts have: the figure's file and size; of those that draw over time, the end of the axis."""
    p = argparse.ArgumentParser(description=documentation, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("-o", "--output", default=output, help=f"picture to write: .png, .pdf or .svg (default {output})")
    p.add_argument("--width", type=float, default=16.0, help="of the figure, cm (default 16)")
    if over_time:
        p.add_argument("--until", type=float, help="end of the time axis, s")
    return p


def panels(rows, width, height=4.2, **options):
    """A figure of `rows` panels one above the other, cm; its axes as a list."""
    figure, axes = plt.subplots(rows, 1, figsize=(width / 2.54, (height * rows + 1.2) / 2.54), squeeze=False, **options)
    return figure, list(axes[:, 0])


def time_axis(axes, until, ends):
    """From the start of shaking until as told, else until the last run's end."""
    axes.set(xlabel="time, s", xlim=(0.0, until or max(*ends, 0.01)))


def save(figure, path):
    try:
        figure.tight_layout()
        stable = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}.get(pathlib.Path(path).suffix, None)
        figure.savefig(path, dpi=200, metadata=stable)
    except (OSError, ValueError) as error:
        sys.exit(f"{path}: {error}")
