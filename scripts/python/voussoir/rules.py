# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Do the shapes and numbers of results make sense? A seal does not tell: a forger computes it anew.

The rules are those of io/output/replay/values/value_rules.cpp.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from .errors import FileError

_LATEST = 1e8  # s, as the program has it
_UNIT = 1e-4  # of the square of a quaternion's length; the program keeps 1e-6


@dataclass(frozen=True)
class Rule:
    """What the values of a dataset may be: any, finite, positive, row (finite but in a run that was lost), time, late_time, unit, index, start."""

    shape: tuple[str, ...]  # each extent: a number, the dataset that has so many rows, or "*", any number
    values: str = "finite"
    items: str = ""  # of an index or a start: how many there are, a number or the dataset that has so many rows
    least: int = 0


_E, _V, _F, _C, _J = "/model/element/mass", "/model/vertex", "/model/face/element", "/model/face/corners", "/model/joint/area"
_M, _L, _CELLS, _FRAMES, _CRACKS, _TIES, _MESHES, _BARS, _LOADS = ("/model/material/density", "/model/law/tension", "/model/cell_type", "/frames/time",
                                                    "/cracks/time", "/model/tie", "/model/mesh", "/model/mesh_bar_breaking",
                                                    "/loads/element")

# By name; that of a group, with "/" at its end, is of each dataset in it that has no rule of its own. The first that fits.
_RULES = {
    "/model/origin": Rule(("3",)),
    "/model/element/material": Rule((_E,), "index", _M),
    "/model/element/kind": Rule((_E,), "index", "10"),
    "/model/element/mass": Rule((_E,), "positive"),
    "/model/element/inertia": Rule((_E, "3")),
    "/model/element/position0": Rule((_E, "3")),
    "/model/element/fixed": Rule((_E,), "index", "2"),
    "/model/element/house": Rule((_E,), "index", _E, -1),
    "/model/element/first_vertex": Rule((_E,), "start", _V),
    "/model/element/first_face": Rule((_E,), "start", _F),
    "/model/element/": Rule((_E,)),
    "/model/vertex": Rule((_V, "3")),
    "/model/cells": Rule((_CELLS, "8"), "index", _V, -1),
    "/model/cell_type": Rule((_CELLS,), "index", "14", 10),
    "/model/cell_element": Rule((_CELLS,), "index", _E),
    "/model/face/element": Rule((_F,), "index", _E),
    "/model/face/normal": Rule((_F, "3")),
    "/model/face/first_corner": Rule((_F,), "start", _C),
    "/model/face/corners": Rule((_C,), "index", _V),
    "/model/face/": Rule((_F,)),
    "/model/joint/element_a": Rule((_J,), "index", _E),
    "/model/joint/element_b": Rule((_J,), "index", _E, -1),
    "/model/joint/face_a": Rule((_J,), "index", _F),
    "/model/joint/face_b": Rule((_J,), "index", _F, -1),
    "/model/joint/law": Rule((_J,), "index", _L),
    "/model/joint/centre": Rule((_J, "3")),
    "/model/joint/normal": Rule((_J, "3")),
    "/model/joint/": Rule((_J,)),
    "/model/material/": Rule((_M,)),
    "/model/law/": Rule((_L,)),
    "/model/tie_ends": Rule((_TIES, "6")),
    "/model/tie_element": Rule((_TIES, "2"), "index", _E, -1),
    "/model/tie_strength": Rule((_TIES,), "any"),
    "/model/mesh_bars": Rule((_MESHES,), "positive"),
    "/model/mesh_bar_ends": Rule((_BARS, "6")),
    "/model/mesh_bar_element": Rule((_BARS, "2"), "index", _E, -1),
    "/model/mesh_bar_breaking": Rule((_BARS,), "any"),
    "/frames/time": Rule((_FRAMES,), "time"),
    "/frames/displacement": Rule((_FRAMES, _E, "3")),
    "/frames/position": Rule((_FRAMES, _E, "3")),
    "/frames/quaternion": Rule((_FRAMES, _E, "4"), "unit"),
    "/frames/broken": Rule((_FRAMES, _E)),
    "/cracks/time": Rule((_CRACKS,), "late_time"),
    "/cracks/joint": Rule((_CRACKS,), "index", _J),
    "/cracks/element_a": Rule((_CRACKS,), "index", _E),
    "/cracks/element_b": Rule((_CRACKS,), "index", _E, -1),
    "/cracks/position": Rule((_CRACKS, "3"), "row"),
    "/cracks/normal": Rule((_CRACKS, "3"), "row"),
    "/cracks/mode": Rule((_CRACKS,), "index", "4"),
    "/cracks/first_mode": Rule((_CRACKS,), "index", "4"),
    "/cracks/": Rule((_CRACKS,), "row"),
    **{f"/ties/{name}": Rule(("/history/time", _TIES), "row") for name in ("force", "elongation", "plastic", "broken")},
    **{f"/meshes/{name}": Rule(("/history/time", _MESHES), "row") for name in ("force", "elongation", "yielded", "broken")},
    "/meshes/utilisation": Rule(("/history/time", _MESHES), "any"),
    "/loaded/": Rule(("/history/time", "*", "3"), "any"),
    **{name: rule for table, width in (("history", ("3",)), ("acceleration", ("3",)), ("energy", ()), ("forces", ("3",)), ("cuts", ("3",)), ("damage", ()))
       for name, rule in ((f"/{table}/time", Rule((f"/{table}/time",), "time")), (f"/{table}/", Rule((f"/{table}/time", *width), "row")))},
    "/assessment/time": Rule(("/assessment/time",), "time"),
    "/assessment/unbalanced": Rule(("/assessment/time",), "any"),
    "/assessment/": Rule(("/assessment/time",), "row"),
    "/motion/factors": Rule(("3",)),
    "/motion/factor": Rule(("1",)),
    "/motion/time": Rule(("/motion/time",), "time"),
    "/motion/": Rule(("/motion/time", "3")),
    "/loads/load": Rule((_LOADS,), "index", "1000000000"),
    "/loads/element": Rule((_LOADS,), "index", _E),
    "/loads/point": Rule((_LOADS, "3")),
    "/loads/follows": Rule((_LOADS,), "index", "2"),
    "/loads/grows": Rule((_LOADS,), "index", "2"),
    "/loads/first_row": Rule((_LOADS,), "start", "/loads/time"),
    "/loads/time": Rule(("/loads/time",)),
    "/loads/force": Rule(("/loads/time", "3")),
    "/measures/time": Rule(("/measures/time",), "time"),
    "/measures/damage_grade": Rule(("/measures/time",), "index", "6", -1),
    **{f"/measures/{name}": Rule(("/measures/time", "/summary/wall/name"), "any") for name in ("drift", "in_plane_drift", "storey_drift")},
    "/measures/": Rule(("/measures/time",), "any"),
    "/summary/wall/": Rule(("/summary/wall/name",), "any"),
    "/summary/tie/": Rule(("/summary/tie/name",), "any"),
    "/summary/load/": Rule(("/summary/load/name",), "any"),
}
_TABLES = ("history", "energy", "forces", "damage", "cracks", "frames", "cuts", "assessment")


def rule_of(dataset: str) -> tuple[str, Rule] | None:
    """The rule of a dataset, with the name that it has there; None if anything goes."""
    if dataset in _RULES:
        return dataset, _RULES[dataset]
    return next(((name, rule) for name, rule in _RULES.items() if name.endswith("/") and dataset.startswith(name)), None)


def _count(file: h5py.File, what: str) -> int | None:
    """A number, or the number of rows of a dataset; None if the file, of an earlier version, has no such dataset."""
    if what.isdigit():
        return int(what)
    if what not in file:
        return None
    if not file[what].shape:
        raise FileError(f"{what} has no rows")
    return int(file[what].shape[0])


def check_shape(file: h5py.File, name: str) -> None:
    """Checks the extents of a dataset against those of others. Raises FileError without the name of the file."""
    found = rule_of(name)
    if found is None:
        return
    shape, (_, rule) = file[name].shape, found
    fits, wanted = len(shape) == len(rule.shape), ""
    for there, what in zip(shape, rule.shape, strict=False):
        count = _count(file, what) if fits else None
        if count is not None and there != count:
            fits, wanted = False, f", and not {count} as {what}"
    if not fits:
        raise FileError(f"{name} is of {' x '.join(map(str, shape)) or 'one value'}{wanted}: it does not fit the rest of the file")


def check_counts(file: h5py.File) -> None:
    """Checks the counts of rows that the file states. Raises FileError without the name of the file."""
    for table in _TABLES:
        said, there = file.attrs.get(f"rows_{table}"), _count(file, f"/{table}/time")
        if said is not None and (said < 0 or (there is not None and said != there)):
            raise FileError(f"/{table}/time has {there or 0} rows, and attribute rows_{table} says {said}")


def check_values(file: h5py.File, name: str, first: int, values: NDArray[Any]) -> None:
    """Checks rows of a dataset that have been read, from row `first` on. Raises FileError without the name of the file."""
    found = rule_of(name)
    if found is None or values.dtype.kind not in "fiu" or values.size == 0:
        return
    rule = found[1]
    if rule.values == "any" or (rule.values == "row" and "summary" in file and "failure" in file["summary"].attrs):
        return

    def refuse(wrong: NDArray[Any], allowed: str, shown: NDArray[Any] = values) -> None:
        if wrong.any():
            at = np.argwhere(wrong)[0]
            raise FileError(f"{name}: row {first + at[0]} holds {shown[tuple(at)]}; allowed: {allowed}")

    if rule.values in ("index", "start"):
        count = _count(file, rule.items)
        last = None if count is None else count - (rule.values == "index")
        refuse(~(values >= rule.least), f"{rule.least} or more")
        if last is not None:
            refuse(~(values <= last), f"{rule.least} to {last}")
    else:
        refuse(~np.isfinite(values), "a finite number")
        if rule.values in ("time", "late_time"):
            refuse(abs(values) > _LATEST, "-1e8 to 1e8 s")
    checks: dict[str, Callable[[], None]] = {
        "start": lambda: refuse(_after(values) & (values < _before(values)), "no less than in the row before"),
        "positive": lambda: refuse(values <= 0, "above 0"),
        "time": lambda: refuse(_after(values) & (values <= _before(values)), "a time after that of the row before"),
        "late_time": lambda: refuse(_after(values) & (values < _before(values)), "no time before that of the row before"),
        "unit": lambda: refuse(abs(_squares(values) - 1.0) > _UNIT, "1, the length of a unit quaternion", np.sqrt(_squares(values))),
    }
    checks.get(rule.values, lambda: None)()


def _after(values: NDArray[Any]) -> NDArray[Any]:
    """Whether a row has one before it."""
    return np.arange(len(values)) > 0


def _before(values: NDArray[Any]) -> NDArray[Any]:
    return np.concatenate([values[:1], values[:-1]])


def _squares(values: NDArray[Any]) -> NDArray[Any]:
    squares: NDArray[Any] = np.square(values.astype(float)).sum(axis=-1)
    return squares
