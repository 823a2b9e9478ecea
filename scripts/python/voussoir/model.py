# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A case, put together in Python. Its keys are those of cases/KEYS.md; the program alone says what they allow."""

import copy
import os
import pathlib
import re
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from . import bars, commands, functions, outputs, toml
from .answers import Checked, Limit, Modes
from .commands import Progress, absolute_if_file
from .errors import Fault, InputError, error_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .jobs import Job
    from .notebook import Shown
    from .part import Part
    from .parts import Case
    from .runs import Run

Path = str | os.PathLike[str]
T = TypeVar("T")

# Keys whose text is the path of a file, or the name of something ready.
FILES = ("include", *(f"motion.{key}" for key in ("record", "x", "y", "z", "L", "T", "V")), "block.motion.file", "base.part.motion.file",
         "stones.file", "stones.motion.file", "load.history", "load.path")


class Model:
    """A case file under construction.

    model = Model("A wall", include="parts/adobe-house")     # a ready case, a .toml file, several of them, or nothing
    model.house(inner_size=[2.8, 2.0], height=2.0, brick=[0.4, 0.2, 0.2])
    model["damping.frequency"] = 8.0                         # any key, by its path
    run = model.run("results/wall", until=6.0)
    """

    def __init__(self, title: str = "", *, include: Path | Sequence[Path] = ()) -> None:
        """include: cases that this one extends, key by key: names of ready ones, or paths."""
        names = [include] if isinstance(include, (str, os.PathLike)) else list(include)
        self.case: dict[str, Any] = {"title": title} if title else {}
        if names:
            self.case["include"] = _from_anywhere("include", names)

    @staticmethod
    def of(case: "Model | Case") -> "Model":
        """A model as it is; of a parts.Case a model."""
        return case if isinstance(case, Model) else Model().add(case)

    def add(self, *parts: "Part") -> "Model":
        """Adds objects of the module `parts`: walls, ties, stones, ... behind those that are there; keys of a table that stands once, as House,
        replace those of before. Returns the model."""
        for part in parts:
            part.put_into(self.case, _from_anywhere)
        return self

    # Any key

    def __setitem__(self, path: str, value: Any) -> None:
        """model["time.duration"] = 5.0; None removes a key of this model (not one from an included case)."""
        *tables, key = path.split(".")
        table = self.case
        for name in tables:
            table = table.setdefault(name, {})
            if not isinstance(table, dict):
                raise KeyError(f"{path}: {name} is no table")
        if value is None:
            table.pop(key, None)
        else:
            table[key] = _from_anywhere(path, value)

    def __getitem__(self, path: str) -> Any:
        """The value that this model itself gives to a key; KeyError without one."""
        found: Any = self.case
        for name in path.split("."):
            if not isinstance(found, Mapping) or name not in found:
                raise KeyError(f"{path}: this model does not say it; `Run.case` has all keys")
            found = found[name]
        return found

    # Materials and laws

    def material(self, name: str, *, density: float, young: float, poisson: float) -> None:
        """density: kg/m3; young: Pa."""
        self.case.setdefault("materials", {})[name] = {"density": density, "young": young, "poisson": poisson}

    def joint_law(self, name: str, *, tension: float, cohesion: float, friction: float, compression: float, **more: float) -> None:
        """Strengths in Pa, friction in degrees. more: cap; and for the mortar thickness (m), young (Pa), poisson."""
        self.case.setdefault("joint_laws", {})[name] = {"tension": tension, "cohesion": cohesion, "friction": friction,
                                                        "compression": compression, **more}

    def joint(self, first: str, second: str, law: str) -> None:
        """Sets the law between two materials; "base" counts as one. The first of several rules that fit applies."""
        self.case.setdefault("joints", {}).setdefault("between", []).append({"materials": [first, second], "law": law})

    def friction(self, first: str, second: str, degrees: float) -> None:
        """Sets the angle of friction, degrees, between two materials without a bond."""
        self.case.setdefault("contact", {}).setdefault("between", []).append({"materials": [first, second], "friction": degrees})

    # What is built

    def house(self, *, openings: Sequence[Mapping[str, Any]] | None = None, **keys: Any) -> None:
        """Keys of [house]; roof, wood and reinforcement are dicts. openings: those of [[house.opening]], replacing included ones.

        model.house(height=2.4, roof={"kind": "flat"}, openings=[opening("front", start=1.0, width=0.8, height=1.6, lintel=1.2)])
        """
        house = self.case.setdefault("house", {})
        house.update(keys)
        if openings is not None:
            house["opening"] = [dict(o) for o in openings]

    def block(self, name: str, vertices: "ArrayLike", faces: Sequence[Sequence[int]] | None = None, *, material: str, **keys: Any) -> None:
        """A convex block from a mesh: n x 3 vertices in m and the corners of each face; without faces, the 8 vertices of a hexahedron in VTK's order.

        keys: fixed, free, velocity, angular_velocity, rotate, motion.
        """
        from .shapes import shape_of  # here, so that NumPy is needed by those alone who have meshes
        self._add_block(name, material, shape_of(name, vertices, faces), keys)

    def add_stones(self, file: Path, *, unit: str, **keys: Any) -> None:
        """All stones of a file (OBJ, PLY, STL, VTU, COMPAS JSON) or folder. unit: m, cm, mm, in, ft.

        keys: of [[stones]] (name, only, place, turn, material, joint, snap, gap, warped, fit, fit_limit, supports). `place` in m, `turn` in degrees about
        z or a dict.
        """
        self.case.setdefault("stones", []).append(_from_anywhere("stones", {"file": file, "unit": unit, **keys}))

    def box(self, name: str, low: "ArrayLike", high: "ArrayLike", *, material: str, **keys: Any) -> None:
        """A block between two opposite corners, m. keys: as for `block`."""
        self._add_block(name, material, {"box": [_row(low), _row(high)]}, keys)

    def prism(self, name: str, polygon: "ArrayLike", extrude: tuple[float, float], *, material: str, **keys: Any) -> None:
        """A block along x: its section in y and z, and its range in x, m. keys: as for `block`."""
        self._add_block(name, material, {"polygon": [_row(corner) for corner in polygon], "extrude": _row(extrude)}, keys)

    def _add_block(self, name: str, material: str, shape: Mapping[str, Any], keys: Mapping[str, Any]) -> None:
        block = {"name": name, "material": material, **shape, **keys}
        self.case.setdefault("block", []).append(_from_anywhere("block", block))

    def load(self, block: str, *, force: "ArrayLike" = (0.0, 0.0, 0.0), moment: "ArrayLike" = (0.0, 0.0, 0.0), **keys: Any) -> None:
        """A load on a block: force in N, moment in N m. keys: at (m), ramp (s, s), history (a file), follows, grows."""
        load = {"block": block, "force": _row(force), "moment": _row(moment), **keys}
        self.case.setdefault("load", []).append(_from_anywhere("load", load))

    # What happens to it, what is followed

    def motion(self, record: Path | None = None, **keys: Any) -> None:
        """Ground motion, replacing an earlier one of this model: a record, or files by axis (x, y, z or L, T, V); direction, scale, intensity,
        unit."""
        self.case["motion"] = _from_anywhere("motion", {**({"record": record} if record is not None else {}), **keys})

    def follow(self, name: str, point: "ArrayLike") -> None:
        """Records a history of the element nearest to a point, m. The first call replaces the points that an included case follows."""
        self.case.setdefault("output", {}).setdefault("history", []).append({"name": name, "point": _row(point)})

    # What the program does with it

    def text(self) -> str:
        """The text of the case file. Raises InputError with the key of a number or text that no file can hold."""
        try:
            return toml.document(self.case)
        except toml.NotWritable as error:
            raise InputError(str(error), [Fault(str(error), key=error.key)]) from error

    def write(self, path: Path, *, overwrite: bool = False) -> pathlib.Path:
        """Writes the case file, with absolute paths to its files. overwrite: replace a case file, but none that this one includes. Raises FileError."""
        return outputs.write(path, self.text(), outputs.CASE, overwrite=overwrite, inputs=_files_in(self.case))

    def check(self, *, draw: Path | None = None, overwrite: bool = False) -> Checked:
        """Builds the model without a run: counts, masses, step; see functions.check. `describe` has it in words."""
        return functions.check(self, draw=draw, overwrite=overwrite)

    def describe(self) -> str:
        """The model in words, as `voussoir check` prints it: also joint laws, bill of blocks, how long a run takes."""
        return self._with_file(lambda path: commands.call("check", path))

    def view(self, path: Path, *, view: str = "corner", overwrite: bool = False) -> pathlib.Path:
        """One HTML page of the model, before any run; for a .png path a picture; see functions.view."""
        return functions.view(self, path, view=view, overwrite=overwrite)

    def limit(self, *options: commands.Word, direction: str | None = None, associated: bool = False) -> Limit:
        """Collapse multiplier and mechanism of dry blocks by limit analysis; see functions.limit."""
        return functions.limit(self, direction=direction, associated=associated, options=options)

    def modes(self, count: int = 6, *, impulse: bool = False, closed: bool = False, shapes: Path | None = None, overwrite: bool = False) -> Modes:
        """The first natural modes; see functions.modes."""
        return functions.modes(self, count, impulse=impulse, closed=closed, shapes=shapes, overwrite=overwrite)

    def verify(self, *, threads: int | None = None) -> bool:
        """Whether the bits of the first second are independent of threads and stops (takes about a minute)."""
        more: list[Any] = ["-j", threads] if threads else []
        code, said = self._with_file(lambda path: commands.told("run", path, "--verify", *more, codes=(0, 1)))[1:]
        if said.faults:  # the run itself failed
            raise error_of(code, said.faults)
        return code == 0

    def run(self, folder: Path | None = None, *, until: float | None = None, threads: int | None = None, overwrite: bool = False,
            progress: bool | Callable[[Progress], None] = True, options: Sequence[commands.Word] = ()) -> "Run":
        """Settles the model under gravity, shakes it, writes results. Ctrl-C saves and stops: Stopped; `Run(folder).resume()` goes on.

        folder: default results/TITLE. until: s of shaking. progress: see commands.watch; in a notebook True is a bar. options: further ones of
        `voussoir run --help`.
        """
        from .runs import Run  # first: what results need is missed now, not when the run has ended
        folder = self._folder(folder)
        words: list[Any] = ["-o", folder, *(["--duration", until] if until is not None else []), *(["-j", threads] if threads else []),
                            *(["--overwrite"] if overwrite else []), *options]
        with bars.shown(folder.name, progress) as told:
            self._with_file(lambda path: commands.watch("run", path, *words, progress=told))
        return Run(folder)

    def start(self, folder: Path | None = None, *, until: float | None = None, threads: int | None = None, overwrite: bool = False,
              options: Sequence[commands.Word] = ()) -> "Job":
        """As `run`, but returns as soon as the run has begun, and it goes on in the background. Faults of the case are raised here."""
        from .jobs import Job
        model, folder = copy.deepcopy(self), self._folder(folder)
        return Job(folder, lambda look: model.run(folder, until=until, threads=threads, overwrite=overwrite, progress=look, options=options))

    def show(self, *, height: int = 520) -> "Shown":
        """In a notebook: what is in the model, and its page to turn, however large it is. height: of the page, pixels."""
        from . import notebook
        return notebook.Shown(notebook.html_of_model(self, most=None, height=height))

    def _repr_html_(self) -> str:
        from . import notebook
        return notebook.html_of_model(self)

    def _folder(self, folder: Path | None) -> pathlib.Path:
        return pathlib.Path(folder or pathlib.Path("results") / self._file_name())

    def _file_name(self) -> str:
        return re.sub(r"[^A-Za-z0-9]+", "-", self.case.get("title", ""))[:80].strip("-").lower() or "model"

    def _with_file(self, use: Callable[[pathlib.Path], T]) -> T:
        with tempfile.TemporaryDirectory(prefix="voussoir-") as scratch:
            return use(self.write(pathlib.Path(scratch) / f"{self._file_name()}.toml"))


def opening(wall: str, *, start: float, width: float, height: float, sill: float = 0.0,
            lintel: float | Mapping[str, float] | None = None) -> dict[str, Any]:
    """A door or a window for Model.house, m. start: position along the wall, from the outer corner of the house. lintel: its length, or its keys."""
    keys: dict[str, Any] = {"wall": wall, "from": start, "width": width, "sill": sill, "height": height}
    if lintel is not None:
        keys["lintel"] = dict(lintel) if isinstance(lintel, Mapping) else {"length": lintel}
    return keys


def _from_anywhere(path: str, value: Any) -> Any:
    """The value of a key with the files that it and its tables name replaced by absolute paths."""
    if isinstance(value, Mapping):
        return {key: _from_anywhere(f"{path}.{key}", v) for key, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [_from_anywhere(path, v) for v in value]
    return absolute_if_file(value) if path in FILES and isinstance(value, (str, os.PathLike)) else value


def _files_in(value: Any, path: str = "") -> Iterator[str]:
    """The absolute paths that a case names."""
    if isinstance(value, Mapping):
        for key, inner in value.items():
            yield from _files_in(inner, f"{path}.{key}" if path else str(key))
    elif isinstance(value, (list, tuple)):
        for inner in value:
            yield from _files_in(inner, path)
    elif path in FILES and isinstance(value, str) and os.path.isabs(value):
        yield value


def _row(values: "ArrayLike") -> list[float]:
    return [float(v) for v in values]
