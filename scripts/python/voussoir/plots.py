# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Figures of runs, one call each. They need matplotlib. Each returns the figure, which `save` writes, or a notebook shows."""

import io
import math
import os
import pathlib
from collections.abc import Mapping, Sequence
from typing import Any

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter
from numpy.typing import NDArray

from . import outputs
from .bars import in_notebook
from .errors import FileError, VoussoirError
from .results import Array, Results
from .texts import shown

# Okabe and Ito's colours, which colour-blind readers can tell apart, and dashes that survive a black and white print. The report page has the
# same ones for the same things (scripts/report/src/style.css); their vermilion is left out, as red is for cracks in all pictures.
COLOURS = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#8c6d31", "#000000"]
DASHES = ["-", "--", "-.", ":"]
LOOK = {"font.size": 8, "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.5, "axes.axisbelow": True,
        "legend.frameon": False, "lines.linewidth": 1.0, "svg.fonttype": "none", "pdf.fonttype": 42, "svg.hashsalt": "voussoir"}
AXES = "xyz"
UNITS = {"displacement": "m", "velocity": "m/s", "rotation": "rad"}
# Losses first, as they only grow; stores above them.
ENERGIES = {"damping": ("mass damping", "#999999"), "dashpot": ("dashpots", "#cc79a7"), "friction": ("friction", "#56b4e9"),
            "fracture": ("fracture", "#8c6d31"), "strain": ("strain", "#e69f00"), "contact": ("contacts", "#009e73"),
            "kinetic": ("kinetic", "#0072b2")}
MODES = {"tension": "#0072b2", "shear": "#e69f00", "compression": "#009e73"}


def label_of(run: Results) -> str:
    """The label of a run in a figure: its `label` if set, else the name of its folder."""
    return getattr(run, "label", None) or run.folder.absolute().name


def style(number: int) -> dict[str, Any]:
    """Colour and dashes of line `number`."""
    return {"color": COLOURS[number % len(COLOURS)], "linestyle": DASHES[number % len(DASHES)]}


def panels(rows: int, width: float = 16.0, height: float = 4.2, **options: Any) -> tuple[Figure, list[Axes]]:
    """A figure of `rows` panels, one above the other, sizes in cm; its axes as a list."""
    with matplotlib.rc_context(LOOK):
        figure, axes = plt.subplots(rows, 1, figsize=(width / 2.54, (height * rows + 1.2) / 2.54), squeeze=False, **options)
    if in_notebook():
        figure.set_tight_layout(True)  # as `save` does
        plt.close(figure)  # a notebook shows it as the value of its cell; open, it would be shown once more
    return figure, list(axes[:, 0])


def plain_numbers(axes: Axes) -> None:
    """Numbers such as 0.5, 2 and 10 along axes whose scale is logarithmic, and not powers of ten."""
    for axis in (axes.xaxis, axes.yaxis):
        if axis.get_scale() != "log":
            continue
        low, high = axis.get_view_interval()
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if high < 1000 * low else (1.0,)))
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter(NullFormatter())


def time_axis(axes: Axes, until: float | None, ends: Sequence[float]) -> None:
    """Time axis from the start of shaking to a given end, else to the end of the longest run."""
    axes.set(xlabel="time, s", xlim=(0.0, until or max(*ends, 0.01)))


def save(figure: Figure, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
    """Writes a .png, .pdf or .svg, the same bytes for the same figure. overwrite: replace a figure of the same kind. Raises FileError."""
    suffix, picture = pathlib.Path(path).suffix.lower(), io.BytesIO()
    if suffix not in outputs.FIGURES:
        raise FileError(f"{shown(path)}: wanted a name that ends in {', '.join(outputs.FIGURES)}")
    try:
        with matplotlib.rc_context(LOOK):
            figure.tight_layout()
            stable = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}.get(suffix)
            figure.savefig(picture, format=suffix[1:], dpi=200, metadata=stable)
    except (OSError, ValueError) as error:
        raise FileError(f"{shown(path)}: {error}") from error
    outputs.write(path, picture.getvalue(), outputs.FIGURES[suffix], overwrite=overwrite)


def curve(run: Results, name: str, quantity: str) -> tuple[Array, Array]:
    """Time (n) and displacement, velocity or rotation (n x 3) of a followed element. Raises VoussoirError if there is none."""
    try:
        history = run.history(name)
    except VoussoirError as error:
        raise VoussoirError(str(error).replace(str(run.folder), label_of(run), 1)) from error
    time = history["time"]
    if not len(time):
        raise VoussoirError(f"{label_of(run)}: the shaking has not begun")
    return time, history[quantity]


def rows_of(run: Results, group: str) -> dict[str, Array]:
    """All columns of a table of rows. Raises VoussoirError if it has no rows yet."""
    columns = dict(getattr(run, group))
    if not len(columns["time"]):
        raise VoussoirError(f"{label_of(run)}: has no rows of {group} yet")
    return columns


def history_panels(runs: Sequence[Results], show: Sequence[str] | None, quantity: str) -> list[tuple[str, str]]:
    """(name, axis) of each panel. By default every history of the first run, along the horizontal axis with the larger motion."""
    if show:
        wanted = [(text.rpartition(":")[0], text.rpartition(":")[2]) for text in show]
        for name, axis in wanted:
            if not name or axis not in tuple(AXES):
                raise VoussoirError(f"--show {name}:{axis}: wanted NAME:AXIS with the axis x, y or z")
        return wanted
    chosen = []
    for name in runs[0].histories:
        peaks = np.nanmax(abs(curve(runs[0], name, quantity)[1]), axis=0)
        chosen.append((name, AXES[int(np.argmax(peaks[:2]))]))
    if not chosen:
        raise VoussoirError(f"{label_of(runs[0])}: the case follows no element; see [[output.history]]")
    return chosen


def histories(runs: Sequence[Results], show: Sequence[str] | None = None, *, quantity: str = "displacement", limit: float | None = None,
              until: float | None = None, width: float = 16.0) -> Figure:
    """Motion of followed elements, several runs in one figure, a panel for each element.

    show: panels, as ["front:y", ...] (default: all, along the axis with the larger motion). quantity: displacement, velocity or rotation.
    limit: of the vertical axes, both ways. until: end of the time axis, s. width: cm.
    """
    if quantity not in UNITS:
        raise VoussoirError(f"quantity {quantity!r}: allowed: {', '.join(UNITS)}")
    chosen, ends = history_panels(runs, show, quantity), [0.0]
    figure, all_axes = panels(len(chosen), width, sharex=True)
    for axes, (name, axis) in zip(all_axes, chosen):
        for number, run in enumerate(runs):
            time, values = curve(run, name, quantity)
            ends.append(float(time[-1]))
            axes.plot(time, values[:, AXES.index(axis)], label=label_of(run), **style(number))
        axes.set_ylabel(f"{quantity} {axis}, {UNITS[quantity]}")
        axes.set_title(name, loc="left")
        if limit:
            axes.set_ylim(-limit, limit)
    all_axes[0].legend(ncols=min(4, len(runs)), loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2)
    time_axis(all_axes[-1], until, ends)
    return figure


def damage(runs: Sequence[Results], *, first: bool = False, until: float | None = None, width: float = 16.0) -> Figure:
    """Percent of all segments that are open over time, by the mode that opened them, a panel for each run; first: percent that have failed, by
    the limit that they reached first."""
    prefix, verb = ("first_", "reached first") if first else ("", "opened by")
    ends = [0.0]
    figure, all_axes = panels(len(runs), width, sharex=True, sharey=True)
    for axes, run in zip(all_axes, runs):
        rows = rows_of(run, "damage")
        percent = 100.0 / np.maximum(1, sum(rows[key] for key in ("bonded", *MODES)))  # 1: a case without bonds
        counts = [rows[prefix + mode] * percent for mode in MODES]
        axes.stackplot(rows["time"], *counts, labels=[f"{verb} {mode}" for mode in MODES], colors=list(MODES.values()), linewidth=0)
        if not first:
            axes.plot(rows["time"], rows["slipped"] * percent, color="black", linestyle="--", label="slipped, holds")
        axes.set_ylabel("% of segments")
        ends.append(float(rows["time"][-1]))
        axes.set_title(label_of(run), loc="left")
    all_axes[0].legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=4, borderaxespad=0.2)
    all_axes[0].set_ylim(bottom=0.0)  # all share it; earlier, it would stop the scale from growing
    time_axis(all_axes[-1], until, ends)
    return figure


def energy(run: Results, *, until: float | None = None, width: float = 16.0) -> Figure:
    """Energy since the shaking began: above, input against stored and lost energy; below, the residual of the ledger."""
    rows = rows_of(run, "energy")
    start = int(np.searchsorted(rows["time"], 0.0))
    if start == len(rows["time"]):
        raise VoussoirError(f"{label_of(run)}: the shaking has not begun")
    kilo = {key: (values[start:] - values[start]) / 1000.0 for key, values in rows.items()}
    time = rows["time"][start:]
    figure, (axes, below) = panels(2, width, 5.5, sharex=True, gridspec_kw={"height_ratios": [4, 1]})
    axes.stackplot(time, *(kilo[key] for key in ENERGIES), labels=[word for word, _ in ENERGIES.values()],
                   colors=[colour for _, colour in ENERGIES.values()], linewidth=0)
    axes.plot(time, kilo["input"] - kilo["gravity"], color="black", label="ground and gravity")
    axes.plot(time, kilo["input"], color="black", linestyle="--", label="ground alone")
    axes.set_ylabel("energy, kJ")
    axes.set_title(label_of(run), loc="left")
    handles, words = axes.get_legend_handles_labels()
    axes.legend(handles[::-1], words[::-1], loc="upper left", bbox_to_anchor=(1.0, 1.0))  # in the order of the picture
    below.plot(time, rows["residual"][start:], color="black")
    below.set_ylabel("residual")
    below.set_ylim(bottom=0.0)
    time_axis(below, until, [0.0, float(time[-1])])
    return figure


def base_shear(run: Results) -> NDArray[Any]:
    """Base shear along the push at each row of `run.assessment`, N: the mean over a first period (io/MEASURES.md, Capacity)."""
    rows, push = rows_of(run, "assessment"), run.case["analysis"]["direction"]
    time = np.asarray(rows["time"])
    k = np.searchsorted(run.forces.time, time - 1e-9)
    shear = -(np.asarray(run.forces.base_shear)[k, :2] @ push) / np.hypot(*push)
    step = time[1] - time[0] if len(time) > 1 else 1.0
    half = int(0.5 / run._at("assessment").attrs["frequency"] / step + 1e-9)
    sums = np.concatenate([[0.0], np.cumsum(shear)])
    widths = np.minimum(half, np.minimum(np.arange(len(shear)), np.arange(len(shear))[::-1]))
    at = np.arange(len(shear))
    mean: NDArray[Any] = (sums[at + widths + 1] - sums[at - widths]) / (2 * widths + 1)
    return mean


def capacity(runs: Sequence[Results], *, bilinear: bool = False, width: float = 16.0) -> Figure:
    """Capacity curves of quasi-static analyses: base shear against the displacement of the control point; of cyclic tests the loops, load
    factor against the displacement of the loads.

    bilinear: also the elastic-perfectly plastic forms, of EC 8 dashed, of NTC 2018 dotted. width: cm.
    """
    figure, (axes,) = panels(1, width, 8.0)
    for number, run in enumerate(runs):
        if "assessment" not in run._checked or not len(run.assessment["time"]):
            raise VoussoirError(f"{label_of(run)}: is no quasi-static analysis; it has no rows of assessment")
        rows, found, line = rows_of(run, "assessment"), run.capacity, style(number)
        if found.get("kind") == "cyclic":
            axes.plot(1e3 * rows["moved"], rows["factor"], label=label_of(run), **line)
            axes.set(xlabel="displacement of the forces, mm", ylabel="load factor")
            continue
        axes.plot(1e3 * rows["displacement"], 1e-3 * base_shear(run), label=label_of(run), **line)
        axes.set(xlabel="displacement of the control point, mm", ylabel="base shear, kN")
        for code, dashes in (("ec8", "--"), ("ntc", ":")) if bilinear and found else ():
            _bilinear(axes, found, code, dashes, line["color"])
    axes.legend(loc="best")
    return figure


def _bilinear(axes: Axes, found: Mapping[str, Any], code: str, dashes: str, colour: str) -> None:
    force, first, end = found[f"{code}_force"], found[f"{code}_yield"], found["ultimate_displacement"]
    end = found["peak_displacement"] if math.isnan(end) else end
    if not math.isnan(first):
        axes.plot([0.0, 1e3 * first, 1e3 * max(end, first)], [0.0, 1e-3 * force, 1e-3 * force], linestyle=dashes, color=colour)
