# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the plotting scripts share: the words of their command lines, and errors that end them with a message. Results are read, and most
figures drawn, by the package python/voussoir.

Needs python3-h5py, python3-numpy, python3-matplotlib.
"""

import argparse
import contextlib
import os
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "python"))
import voussoir
from voussoir import plots, results
from voussoir.plots import COLOURS, panels, style, time_axis  # for the scripts

plt.rcParams.update(plots.LOOK)
__all__ = ["COLOURS", "Run", "frame_times", "open_results", "or_exit", "panels", "parser", "plt", "save", "style", "time_axis"]


@contextlib.contextmanager
def or_exit():
    """Ends a script with the message of an error of the package."""
    try:
        yield
    except voussoir.VoussoirError as error:
        sys.exit(str(error))


def open_results(path):
    """Opens the run.h5 of a run, given as its folder or as the file."""
    with or_exit():
        return results.open_results(path)


def frame_times(file):
    """Times of the frames, s; an unfinished run may have none yet."""
    times = file["frames/time"][:]
    if not len(times):
        sys.exit(f"{file.filename}: has no frames yet")
    return times


class Run(voussoir.Run):
    """A run with a name for figures, finished or not."""

    def __init__(self, argument):
        """argument: DIR, DIR/run.h5, or either after "LABEL=". An existing path has no label, even with an = in it."""
        label, found, path = ("", "", argument) if os.path.exists(argument) else argument.partition("=")
        super().__init__(path if found else argument)
        self.label = label if found else plots.label_of(self)
        with or_exit():
            self.file  # now, so that a wrong name is told before anything is drawn

    def base(self):
        """Height of the base, m, relative to the run's origin; 0 without one."""
        return float(self.case["base"].get("z", 0.0) - self.origin[2]) if "base" in self.case else 0.0


def parser(documentation, output, over_time=False):
    """Arguments common to all scripts: the figure's file and size; for scripts that draw over time, the end of the axis."""
    p = argparse.ArgumentParser(description=documentation, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("-o", "--output", default=output, help=f"picture to write: .png, .pdf or .svg (default {output})")
    p.add_argument("--width", type=float, default=16.0, help="of the figure, cm (default 16)")
    if over_time:
        p.add_argument("--until", type=float, help="end of the time axis, s")
    return p


def save(figure, path):
    with or_exit():
        plots.save(figure, path)
