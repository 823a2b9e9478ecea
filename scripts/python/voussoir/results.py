# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Results of a run as NumPy arrays, read when they are asked for, also while the run goes on.

Names, shapes and meanings are those of io/RESULTS.md.
"""

import contextlib
import os
import pathlib
import warnings
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

try:
    import h5py
    import numpy as np
except ModuleNotFoundError as missing:
    raise ImportError(f"results need {missing.name}: pip install \"voussoir[results]\", or Debian's python3-numpy and python3-h5py") from missing
from numpy.typing import NDArray

from . import toml_reading
from .capacity import Capacity
from .errors import FileError, ProgramWarning, VoussoirError
from .reading import NoData, missing_parts, open_paged, open_results, parts_of, path_of, reading, rows_of, stamp_of, state_of

__all__ = ["Array", "Frame", "Frames", "History", "Results", "Table", "array_of", "displacement_of", "open_results", "origin_of", "rotation_matrices",
           "rows_of"]

if TYPE_CHECKING:
    import pandas


T = TypeVar("T")


class Array(np.ndarray[Any, Any]):
    """A NumPy array with `unit`, `name` and `description`. Results of computations with it are plain arrays, as their unit may differ."""

    unit: str
    name: str
    description: str

    def __new__(cls, values: Any, unit: str = "", name: str = "", description: str = "") -> "Array":
        array = np.asarray(values).view(cls)
        array.unit, array.name, array.description = unit, name, description
        return array

    def __array_finalize__(self, source: Any) -> None:
        for attribute in ("unit", "name", "description"):
            setattr(self, attribute, getattr(source, attribute, ""))

    def __array_wrap__(self, array: NDArray[Any], context: Any = None, return_scalar: bool = False) -> Any:
        plain = np.asarray(array)
        return plain[()] if plain.ndim == 0 else plain


def array_of(dataset: h5py.Dataset, rows: Any = ()) -> Array:
    """A dataset, or some of its rows. Texts become str."""
    values = rows_of(dataset, rows)
    if h5py.check_string_dtype(dataset.dtype):
        values = np.array([v.decode() if isinstance(v, bytes) else v for v in np.atleast_1d(values)], dtype=object)
    attributes = dataset.attrs
    return Array(values, str(attributes.get("unit", "")), dataset.name.rsplit("/", 1)[-1], str(attributes.get("description", "")))


def origin_of(file: h5py.File) -> NDArray[Any]:
    """What the coordinates in run.h5 are relative to, m, in the axes of the case file; zero in runs that do not say."""
    found: NDArray[Any] = rows_of(file["model/origin"]) if "model/origin" in file else np.zeros(3)
    return found


def displacement_of(file: h5py.File, rows: Any = slice(None)) -> NDArray[Any]:
    """Of the centroids from position0 in frames of run.h5, m: one row, or a slice of them. Files of layouts before 5 held positions."""
    if "frames/displacement" in file:
        moved: NDArray[Any] = rows_of(file["frames/displacement"], rows).astype(float)
        return moved
    moved = rows_of(file["frames/position"], rows) - rows_of(file["model/element/position0"])
    return moved


def _shifted(points: Array, by: NDArray[Any]) -> Array:
    """The array with its unit, name and description, moved."""
    return Array(np.asarray(points) + by, points.unit, points.name, points.description)


# Datasets of points, which Table gives in the axes of the case file.
_POINTS = {"/model/element/position0", "/model/joint/centre", "/cracks/position"}


class Table(Mapping[str, Array]):
    """A group of run.h5: `table["kinetic"]` or `table.kinetic` reads a column, `list(table)` names them, `table.unit("kinetic")` reads nothing.

    Points have the coordinates of the case file.
    """

    def __init__(self, group: h5py.Group) -> None:
        if not isinstance(group, h5py.Group):
            raise FileError(f"{path_of(group)}: {group.name} is no group of columns")
        self._group = group

    def _dataset(self, name: str) -> h5py.Dataset:
        with reading(f"{path_of(self._group)}, {self._group.name}"):
            found = self._group.get(name)
        if not isinstance(found, h5py.Dataset):
            raise NoData(f"{self._group.name} has no '{name}'; there are: {', '.join(self) or 'none'}")
        return found

    def __getitem__(self, name: str) -> Array:
        dataset = self._dataset(name)
        with reading(f"{path_of(dataset)}, {dataset.name}"):
            values = array_of(dataset)
            return _shifted(values, origin_of(dataset.file)) if dataset.name in _POINTS else values

    def __getattr__(self, name: str) -> Array:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self) -> Iterator[str]:
        with reading(f"{path_of(self._group)}, {self._group.name}"):
            return iter([name for name, data in self._group.items() if isinstance(data, h5py.Dataset)])

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]

    def unit(self, name: str) -> str:
        return self._note(name, "unit")

    def description(self, name: str) -> str:
        return self._note(name, "description")

    def _note(self, name: str, attribute: str) -> str:
        dataset = self._dataset(name)
        with reading(f"{path_of(dataset)}, {dataset.name}"):
            return str(dataset.attrs.get(attribute, ""))

    def to_pandas(self) -> "pandas.DataFrame":
        """As a data frame: see pandas_tables.frame_of. Raises ImportError without pandas."""
        from . import pandas_tables
        return pandas_tables.frame_of(self)

    def _repr_html_(self) -> str:
        from . import notebook
        return notebook.html_of_rows([{"column": name, "shape": self._dataset(name).shape, "unit": self.unit(name), "what it is": self.description(name)}
                                      for name in self])

    def __repr__(self) -> str:
        columns = (f"{name} {self._dataset(name).shape} {self.unit(name)}" for name in self)
        return f"<{self._group.name}: {', '.join(columns)}>"


class History(Table):
    """A followed element: time (rows), displacement, velocity, rotation (rows x 3), from time zero, relative to the base."""

    def __init__(self, group: h5py.Group, time: h5py.Dataset) -> None:
        super().__init__(group)
        self._time = time

    def _dataset(self, name: str) -> h5py.Dataset:
        return self._time if name == "time" else super()._dataset(name)

    def __iter__(self) -> Iterator[str]:
        yield "time"
        yield from super().__iter__()


class Frame:
    """All elements at one time. `displacement` n x 3 m, from the start; `position` n x 3 m, in the axes of the case file; `quaternion`
    n x 4 (w, x, y, z); `broken` n: share of bonds, 0 to 1."""

    def __init__(self, results: "Results", row: int) -> None:
        self._path, self._file, self.row = results._path, results._checked, row  # of one file, whatever comes in its place
        with self._reading():
            self._group = self._file["frames"]

    def _reading(self) -> contextlib.AbstractContextManager[None]:
        return reading(f"{self._path}, frame {self.row}")

    @property
    def time(self) -> float:
        with self._reading():
            return float(rows_of(self._group["time"], self.row))

    @property
    def displacement(self) -> Array:
        with self._reading():
            return Array(displacement_of(self._file, self.row), "m", "displacement", "centroids of all elements from position0")

    @property
    def position(self) -> Array:
        with self._reading():
            start = np.asarray(Table(self._file["model/element"])["position0"])
            return Array(start + np.asarray(self.displacement), "m", "position", "centroids of all elements")

    @property
    def quaternion(self) -> Array:
        with self._reading():
            return array_of(self._group["quaternion"], self.row)

    @property
    def broken(self) -> Array:
        with self._reading():
            return array_of(self._group["broken"], self.row)

    def vertices(self) -> NDArray[Any]:
        """Current positions of the vertices of all elements: v x 3, m, in the rows of /model/vertex and the axes of the case file."""
        with self._reading():
            return self._placed()

    def _placed(self) -> NDArray[Any]:
        model = self._file["model"]
        first = rows_of(model["element/first_vertex"])
        corners, start = rows_of(model["vertex"]), rows_of(model["element/position0"])
        if corners.shape != (len(corners), 3) or start.shape != (len(first), 3) or np.shape(self.quaternion) != (len(first), 4):
            raise FileError(f"{self._path}: /model and /frames do not fit together")
        owner = np.searchsorted(first, np.arange(len(corners)), side="right") - 1
        position, rotation = start + np.asarray(self.displacement), rotation_matrices(self.quaternion)
        placed: NDArray[Any] = position[owner] + np.einsum("vij,vj->vi", rotation[owner], corners - start[owner])
        return placed + origin_of(self._file)


def rotation_matrices(quaternions: NDArray[Any]) -> NDArray[Any]:
    """Rotation matrices, n x 3 x 3, from quaternions, n x 4 (w, x, y, z)."""
    w, x, y, z = np.asarray(quaternions, dtype=float).T
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return np.moveaxis(np.array(rows), 2, 0)


class Frames:
    """`frames[i]`, `frames[-1]`, `frames.at(2.5)`, `len(frames)`; a frame is read when its data are used."""

    def __init__(self, results: "Results") -> None:
        self._results = results

    @property
    def time(self) -> Array:
        return array_of(self._results._at("frames/time"))

    def __len__(self) -> int:
        with reading(f"{self._results._path}, frames"):
            return int(self._results._at("frames/time").shape[0])

    def __getitem__(self, row: int) -> Frame:
        count = len(self)
        if not -count <= row < count:
            raise IndexError(f"frame {row} of {count}")
        return Frame(self._results, row % count)

    def __iter__(self) -> Iterator[Frame]:
        return (self[row] for row in range(len(self)))

    def at(self, time: float) -> Frame:
        """The frame nearest to a time, s."""
        if not len(self):
            raise VoussoirError(f"{self._results.folder}: has no frames yet")
        return self[int(np.argmin(abs(self.time - time)))]


class Results:
    """Contents of run.h5. Data are read when used, of run.h5 as it is then, also when a run that goes on has written it anew. A table, a history or
    a frame stays of the time when it was taken; where its rows are gone since, it raises FileError."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        """folder: that of a run, or its run.h5."""
        path = pathlib.Path(folder)
        self.folder = path.parent if path.name == "run.h5" else path
        self._path, self._paged, self._file = path, None, None
        self._stamp: tuple[int, ...] | None = None  # of the file that is open as _paged
        self._file_stamp: tuple[int, ...] | None = None
        self._tells = True  # warns of a run that is not at its end
        self._told: Any = None  # of what it has warned

    @property
    def file(self) -> h5py.File:
        """The HDF5 file itself, for data without a method here: all of it is checked first. Of rows in parts that are gone HDF5 makes NaN."""
        now = stamp_of(self._path)
        if self._file is None or now not in (None, self._file_stamp):
            self._file, self._file_stamp = open_results(self._path), now
        return self._file

    @property
    def _checked(self) -> h5py.File:
        """The file as it is now, of which what is read is checked. Tables that were taken from one of before keep that open."""
        now = stamp_of(self._path)
        if self._paged is None or now not in (None, self._stamp):
            self._paged, self._stamp = open_paged(self._path), now
            if self._tells:
                self._tell()
        return self._paged

    def _of_now(self, ask: Callable[[h5py.File], T]) -> T:
        """What it says of the file and of what is beside it. A run that ends writes its file first: what is beside an older one says nothing."""
        while True:
            file = self._checked
            found = ask(file)
            if self._checked is file:
                return found

    def _tell(self) -> None:
        path, (state, words), missing = path_of(self._paged), state_of(self._paged), missing_parts(self._paged)
        if (state, bool(missing)) == self._told or stamp_of(self._path) != self._stamp:  # told; written meanwhile: told when that is opened
            return
        self._told = state, bool(missing)
        if words:
            warnings.warn(f"{path}: not finished: {words}", ProgramWarning, stacklevel=4)
        if missing:
            warnings.warn(f"{path}: {len(missing)} of {len(parts_of(self._paged))} parts are missing beside it, the first is {missing[0]}; their rows "
                          "cannot be read", ProgramWarning, stacklevel=4)

    @property
    def missing_parts(self) -> list[str]:
        """Parts of an unfinished run that are not beside run.h5, as in a copy without them: reading their rows is a FileError."""
        return self._of_now(missing_parts)

    @property
    def state(self) -> str:
        """finished; lost: to a numerical failure; goes on: a process works on it; stopped, also by a kill: none does; unknown: a copy of an
        unfinished run. As it is now."""
        return self._of_now(state_of)[0]

    @property
    def origin(self) -> NDArray[Any]:
        """m, in the axes of the case file: what coordinates in the file itself are relative to. What has a name here has it added."""
        with reading(f"{self._path}, origin"):
            return origin_of(self._checked)

    def refresh(self) -> None:
        """Closes run.h5, and with it all tables, histories and frames that were taken from it; it is opened again when it is used. What an
        unfinished run has written since is seen also without this."""
        self.close()

    def close(self) -> None:
        """As `refresh`."""
        for file in (self._file, self._paged):
            if file is not None:
                file.close()
        self._file = self._paged = self._told = None

    def _table(self, name: str) -> Table:
        return Table(self._at(name))

    def _at(self, name: str) -> Any:
        """A group or dataset of the file. Raises FileError."""
        with reading(f"{self._path}, {name}"):
            return self._checked[name]

    @property
    def histories(self) -> list[str]:
        """Names of the followed elements."""
        with reading(f"{self._path}, history"):
            return [name for name in self._at("history") if name != "time"]

    def history(self, name: str) -> History:
        """Motion of a followed element, by its name in [[output.history]]."""
        if name not in self.histories:
            raise VoussoirError(f"{self.folder}: no history '{name}'; there are: {', '.join(self.histories) or 'none'}")
        both = self._at("history")
        with reading(f"{self._path}, history"):
            return History(both[name], both["time"])

    @property
    def energy(self) -> Table:
        """The ledger of energy, J, also during settling: time, kinetic, strain, contact, gravity, input, four losses, residual."""
        return self._table("energy")

    @property
    def forces(self) -> Table:
        """Forces of the base on the structure: time, base_shear (N), base_moment (N m)."""
        return self._table("forces")

    @property
    def damage(self) -> Table:
        """Counts of segment sides over time."""
        return self._table("damage")

    @property
    def cracks(self) -> Table:
        """Breaks of springs, one row each, in order of time."""
        return self._table("cracks")

    @property
    def measures(self) -> Table:
        """Measures of the collapse, one row per frame."""
        return self._table("measures")

    @property
    def assessment(self) -> Table:
        """The rows of a quasi-static analysis; empty for a time history."""
        return self._table("assessment")

    @property
    def capacity(self) -> Capacity:
        """Results of a quasi-static analysis (io/MEASURES.md, Capacity), by name; empty until the run has ended or stopped."""
        file = self._checked
        attributes = file["capacity"].attrs if "capacity" in file else {}
        return Capacity(_plain(attributes), str(attributes.get("units", "")), self)

    @property
    def elements(self) -> Table:
        """Constant data of each element: material, tag, mass, position0, ..."""
        return self._table("model/element")

    @property
    def joints(self) -> Table:
        return self._table("model/joint")

    @property
    def frames(self) -> Frames:
        return Frames(self)

    @property
    def case(self) -> dict[str, Any]:
        """The resolved case: all keys with their values."""
        with reading(f"{self._path}, case"):
            return toml_reading.loads(self._at("case").attrs["toml"])

    @property
    def summary(self) -> dict[str, Any]:
        """The summary by name, as in io/RESULTS.md: collapsed, first_crack_time, peak_base_shear, damage_grade, ..."""
        return _plain(self._at("summary").attrs)

    @property
    def walls(self) -> dict[str, dict[str, float]]:
        """Measures of each wall: fallen_mass_fraction, peak_drift, ..."""
        with reading(f"{self._path}, summary/wall"):
            group = self._at("summary").get("wall")
            if group is None:
                return {}
            return _by_name(Table(group))

    @property
    def ties(self) -> dict[str, dict[str, float]]:
        """Measures of each tie, then of each deck and mesh: peak_force, peak_elongation, utilisation, ... Forces over time: `file["ties"]`."""
        with reading(f"{self._path}, summary/tie"):
            group = self._at("summary").get("tie")
            return {} if group is None else _by_name(Table(group))

    @property
    def loads(self) -> dict[str, dict[str, float]]:
        """Measures of each load: peak_force, displacement_at_peak_force, peak_displacement, end_force, end_displacement, ..."""
        with reading(f"{self._path}, summary/load"):
            group = self._at("summary").get("load")
            return {} if group is None else _by_name(Table(group), leave_out=("place",))

    @property
    def loaded(self) -> History:
        """Loads over time: `time` (s), `force` (N) and `displacement` (m, of the place where a load acts), rows x loads x 3."""
        with reading(f"{self._path}, loaded"):
            file = self._checked
            return History(file["loaded"], file["history/time"])

    @property
    def provenance(self) -> dict[str, Any]:
        return _plain(self._at("provenance").attrs)

    @property
    def finished(self) -> bool:
        """Whether the run has reached its end."""
        with reading(f"{self._path}, summary"):
            return bool(self.summary["finished"])


def _by_name(table: Table, leave_out: tuple[str, ...] = ()) -> dict[str, dict[str, float]]:
    """The rows of a table by their column `name`."""
    columns = {name: table[name] for name in table if name not in leave_out}
    names = columns.pop("name")
    return {name: {key: float(values[k]) for key, values in columns.items()} for k, name in enumerate(names)}


def _plain(attributes: Any) -> dict[str, Any]:
    """Attributes as Python's own types, without the attribute of units."""
    def value(v: Any) -> Any:
        return v.decode() if isinstance(v, bytes) else v.item() if isinstance(v, np.generic) else v
    with reading("attributes of results"):
        return {name: value(v) for name, v in attributes.items() if name != "units"}
