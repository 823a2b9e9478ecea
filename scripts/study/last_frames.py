#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""How the runs of a study ended, in one picture: a column for each record, or for each set of options, and a row for all else.

usage: last_frames.py FOLDER [FOLDER ...] [-o last-frames.jpg] [--width 220] [--columns record|options]
FOLDER is that of a study (results/ensemble); several are shown as one. Only runs that are done are drawn. All pictures have the same view, and
cut off what lies farther from the house. Needs what `scripts/setup plots` installs. Some seconds a run; pictures are kept in the runs' folders.
"""
import argparse
import json
import pathlib
import sys

from matplotlib.font_manager import findfont
from PIL import Image, ImageDraw, ImageFont

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import render  # noqa: E402
from run_file import plt  # noqa: E402

ASIDE = (2.2, 1.0, 0.0)          # m around the house that are shown: to the sides, below and above
AZIMUTH, ELEVATION = -60.0, 22.0  # degrees
MARGIN, HEADING = 8, 24  # px, beside the names of rows; for the names of columns
KEPT = "last-frame-{}.png"  # beside run.h5, by its width


def picture(folder, width):
    """Picture of the last frame of a run; drawn if missing, or older than the run."""
    path = folder / KEPT.format(width)
    if not path.exists() or path.stat().st_mtime < (folder / "run.h5").stat().st_mtime:
        run = render.Run(str(folder))
        axis = render.view(AZIMUTH, ELEVATION)
        first = run.position(0) @ axis.T
        low, high = first.min(axis=0) - ASIDE, first.max(axis=0) + ASIDE
        size = high - low
        figure = plt.figure(figsize=(width / 100, width / 100 * size[1] / size[0]))
        axes = figure.add_axes((0, 0, 1, 1))
        render.draw(axes, run, len(run.time) - 1, axis)
        axes.set_title("")
        axes.set_xlim(low[0], low[0] + size[0])
        axes.set_ylim(low[1], high[1])
        axes.text(0.02, 0.97, f"{run.time[-1]:.1f} s", transform=axes.transAxes, fontsize=7, verticalalignment="top")
        figure.savefig(path, dpi=100)
        plt.close(figure)
    with Image.open(path) as image:
        return image.convert("RGB")


def runs_of(folders, columns):
    """(row, column, folder) of each finished run, in the order of the studies. `columns` is an axis of the study; the other axes make the row."""
    for study in folders:
        try:
            plan = json.loads((study / "plan.json").read_text())
        except OSError as error:
            sys.exit(f"{error.filename}: {error.strerror}; allowed: the folder of a study")
        for run in plan["runs"]:
            axes = run["axes"]
            row = tuple(str(v) for key, v in axes.items() if key != columns and v is not None)
            folder = study / "runs" / run["name"]
            if (folder / "done.json").exists():
                yield row, axes[columns] or "", folder


def name(values):
    """Label of a row or a column: for paths, the last part."""
    return " ".join(pathlib.Path(v).name for v in values)


def font():
    return ImageFont.truetype(findfont("DejaVu Sans"), 12)


def label(draw, place, text, anchor):
    draw.text(place, text, fill="black", anchor=anchor, font=font())


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("folders", nargs="+", type=pathlib.Path, metavar="FOLDER")
    p.add_argument("-o", "--output", type=pathlib.Path, default="last-frames.jpg")
    p.add_argument("--width", type=int, default=220, help="of a picture, px")
    p.add_argument("--columns", choices=("record", "options"), default="record", help="what differs from column to column")
    a = p.parse_args()
    pictures = {(row, column): picture(folder, a.width) for row, column, folder in runs_of(a.folders, a.columns)}
    if not pictures:
        sys.exit(f"{a.folders[0]}: holds no run that is done")
    rows = list(dict.fromkeys(row for row, _ in pictures))
    columns = list(dict.fromkeys(column for _, column in pictures))
    height = max(image.height for image in pictures.values())
    left = 2 * MARGIN + int(max(font().getlength(name(row)) for row in rows))
    sheet = Image.new("RGB", (left + a.width * len(columns), HEADING + height * len(rows)), "white")
    draw = ImageDraw.Draw(sheet)
    for j, column in enumerate(columns):
        label(draw, (left + a.width * (j + 0.5), HEADING / 2), name([column]), "mm")
    for i, row in enumerate(rows):
        label(draw, (MARGIN, HEADING + height * (i + 0.5)), name(row), "lm")
    for (row, column), image in pictures.items():
        sheet.paste(image, (left + a.width * columns.index(column), HEADING + height * rows.index(row)))
    sheet.save(a.output, quality=85)


if __name__ == "__main__":
    main()
