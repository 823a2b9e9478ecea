# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A small picture of a run without a browser: what a notebook shows where there is no WebGL. It needs matplotlib."""

import io
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from numpy.typing import NDArray

from .results import Results, rotation_matrices, rows_of

_TOWARDS = np.array([0.45, -0.75, 0.48])  # to who looks: from the front, the right and above
_LIGHT = np.array([0.15, -0.55, 0.82])
_COLOURS = ["#cdb48c", "#a9825a", "#b9bcc0", "#9fb3a2", "#c99a86"]  # of materials
_CRACKED = np.array([0.78, 0.16, 0.14])
_GROUND = "#ececea"


def png_of(results: Results, frame: int = -1, *, width: int = 640, height: int = 400) -> bytes:
    """The elements in a frame as a PNG of width x height pixels: coloured by material, redder the more of an element's bonds are broken."""
    polygons, colours, ground = _drawn(results, frame)
    figure = Figure(figsize=(width / 100, height / 100), dpi=100, facecolor="white")
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.add_collection(PolyCollection([ground], facecolors=_GROUND, edgecolors="none"))
    edge = 0.35 if len(polygons) < 6000 else 0.15
    axes.add_collection(PolyCollection(polygons, facecolors=colours, edgecolors=0.55 * np.asarray(colours), linewidths=edge))
    corners = np.concatenate([*polygons, ground])
    low, high = corners.min(axis=0), corners.max(axis=0)
    scale = 1.04 * max((high - low) / [width, height])
    middle, half = (low + high) / 2, scale * np.array([width, height]) / 2
    axes.set(xlim=(middle[0] - half[0], middle[0] + half[0]), ylim=(middle[1] - half[1], middle[1] + half[1]))
    return png_of_figure(figure)


def png_of_figure(figure: Figure) -> bytes:
    """A figure as PNG."""
    with io.BytesIO() as file:
        figure.savefig(file, format="png", metadata={"Software": None})
        return file.getvalue()


def _drawn(results: Results, row: int) -> tuple[list[NDArray[Any]], NDArray[Any], NDArray[Any]]:
    """Polygons on the picture from the farthest to the nearest, their colours, and the ground."""
    frame, model = results.frames[row], results._checked["model"]
    corners, first, element, normal, start, material = (rows_of(model[name]) for name in (
        "face/corners", "face/first_corner", "face/element", "face/normal", "vertex", "element/material"))
    turned = rotation_matrices(np.asarray(frame.quaternion))
    normal = np.einsum("fij,fj->fi", turned[element], normal)
    points = frame.vertices()
    flat, depth = points @ _axes(), points @ _TOWARDS
    faces = np.split(corners, first[1:])
    seen = np.flatnonzero(normal @ _TOWARDS > 1e-9)
    order = seen[np.argsort([depth[faces[f]].mean() for f in seen])]
    start = start + results.origin
    ground = _ground(np.concatenate([points, start]), float(start[:, 2].min())) @ _axes()
    return [flat[faces[f]] for f in order], _colours(material, np.asarray(frame.broken), element, normal)[order], ground


def _colours(material: NDArray[Any], broken: NDArray[Any], element: NDArray[Any], normal: NDArray[Any]) -> NDArray[Any]:
    """Red, green and blue of each face."""
    palette = np.array([[int(text[k:k + 2], 16) / 255 for k in (1, 3, 5)] for text in _COLOURS])
    share = np.nan_to_num(broken)[:, None]
    of_element = (1 - share) * palette[material % len(palette)] + share * _CRACKED
    light = 0.55 + 0.45 * np.clip(normal @ (_LIGHT / np.linalg.norm(_LIGHT)), 0.0, 1.0)
    shaded: NDArray[Any] = of_element[element] * light[:, None]
    return shaded


def _axes() -> NDArray[Any]:
    """3 x 2: to the right and up on the picture."""
    towards = _TOWARDS / np.linalg.norm(_TOWARDS)
    right = np.cross([0.0, 0.0, 1.0], towards)
    right /= np.linalg.norm(right)
    return np.column_stack([right, np.cross(towards, right)])


def _ground(points: NDArray[Any], level: float) -> NDArray[Any]:
    """The corners of a rectangle under all points, at the level of the lowest at the start."""
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.08 * max(high - low)
    (x0, y0), (x1, y1) = low[:2] - margin, high[:2] + margin
    return np.array([[x0, y0, level], [x1, y0, level], [x1, y1, level], [x0, y1, level]])
