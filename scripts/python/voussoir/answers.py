# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the functions of functions.py return. `data` is all that the program said, as `--format json` prints it (io/README.md)."""

import pathlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any, TypeVar

T = TypeVar("T")
Point = tuple[float, float, float]


@dataclass(frozen=True)
class BillLine:
    """Blocks of equal shape and material. edges: m, of a box, descending; None for any other shape. volume: m3, of all of them."""

    material: str
    kind: str
    whole: bool  # False: cut
    edges: Point | None
    count: int
    volume: float


@dataclass(frozen=True)
class Part:
    """A wall, all lintels, all beams, ... whole, cut: numbers of blocks. volume: m3. mass: kg."""

    name: str
    whole: int
    cut: int
    volume: float
    mass: float


@dataclass(frozen=True)
class Checked:
    """A model that can be run. volume: m3, mass: kg, both without fixed blocks. step_bound: s, the largest stable step. step: s, that of a run.
    run_seconds: of wall-clock, of a run in which nothing breaks. findings: likely mistakes, also given as warnings."""

    title: str
    elements: int
    joints: int  # of two elements
    base_joints: int  # of an element and the base
    volume: float
    mass: float
    step_bound: float
    step: float
    run_seconds: float | None
    parts: tuple[Part, ...] = field(metadata={"of": Part})
    bill: tuple[BillLine, ...] = field(metadata={"of": BillLine})
    findings: tuple[str, ...]

    def __str__(self) -> str:
        found = f"{len(self.findings)} warnings" if self.findings else "no faults found"
        return (f"{self.title}: {self.elements:,} elements, {self.joints:,} joints and {self.base_joints:,} with the base, {self.volume:.4g} m3, "
                f"{self.mass:.6g} kg, step {self.step:.4g} s; {found}")


@dataclass(frozen=True)
class Mode:
    """A natural mode. frequency: Hz; 0: a mechanism. mass_share: effective mass along x, y, z over all mass, 0 to 1."""

    frequency: float
    mass_share: Point


@dataclass(frozen=True)
class Modes(Sequence[Mode]):
    """The lowest natural modes, in order: a sequence of Mode. main: by axis ("x", "y") the mode of the building above many local ones.
    held_by_nothing: names of what moves freely. impulse: by point the frequencies (Hz) along x and y that an impulse shows, where asked for."""

    title: str
    modes: tuple[Mode, ...] = field(metadata={"of": Mode})
    main: Mapping[str, Mode]
    held_by_nothing: tuple[str, ...]
    impulse: Mapping[str, tuple[float, float]] | None

    @property
    def frequencies(self) -> tuple[float, ...]:
        """Hz."""
        return tuple(mode.frequency for mode in self.modes)

    def __len__(self) -> int:
        return len(self.modes)

    def __getitem__(self, index: Any) -> Any:
        return self.modes[index]

    def __iter__(self) -> Iterator[Mode]:
        return iter(self.modes)


@dataclass(frozen=True)
class Limit:
    """A collapse multiplier by limit analysis. multiplier: of the live load, by Coulomb's friction, or where `associated` was asked for by
    associated flow. associated: the multiplier of associated flow, at or above the other. proven: whether the bounds of the multiplier hold."""

    title: str
    multiplier: float
    associated: float
    proven: bool
    data: Mapping[str, Any] = field(repr=False)  # mechanisms, seams, kinematics


@dataclass(frozen=True)
class Peak:
    """The largest value over time, and when, s. None where there is none."""

    value: float | None
    time: float | None


@dataclass(frozen=True)
class Storey:
    """Drifts of a storey between two heights (m above the base): x, y: largest, ratios; x_now, y_now: at the time asked for."""

    house: int
    low: float
    high: float
    x: Peak = field(metadata={"of": Peak})
    y: Peak = field(metadata={"of": Peak})
    x_now: float | None
    y_now: float | None


@dataclass(frozen=True)
class Crack:
    """Open joints that hang together. wall: its wall. length: m. width, peak, at_end: m, now, largest, at the end. peak_time: s. along, z: m,
    where the widest place lies in the wall."""

    wall: str
    length: float
    width: float
    peak: float
    peak_time: float
    at_end: float
    along: float
    z: float


@dataclass(frozen=True)
class Assessed:
    """What engineers ask of a run (io/MEASURES.md). time: s, of cracks. weight: N. base_shear: N. storeys, cracks: see there."""

    time: float
    weight: float
    base_shear: Peak = field(metadata={"of": Peak})
    base_shear_over_weight: float | None
    storeys: tuple[Storey, ...] = field(metadata={"of": Storey})
    cracks: tuple[Crack, ...] = field(metadata={"of": Crack})
    data: Mapping[str, Any] = field(repr=False)  # walls, corners, cuts, points, capacity


@dataclass(frozen=True)
class Compared:
    """Two runs. identical: bit for bit. datasets: how many were compared; differing: those that differ. first: the first difference, its dataset,
    what it is, and its time, s. measures: of both side by side; None where a file is no run. True where identical."""

    identical: bool
    datasets: int
    differing: int
    first: Mapping[str, Any] | None
    measures: Any

    def __bool__(self) -> bool:
        return self.identical


@dataclass(frozen=True)
class MotionFigures:
    """A component of a record. dt, duration, peak_time, d5_75, d5_95: s. peak_acceleration, stated_peak (of the file's head): m/s2.
    peak_velocity: m/s. peak_displacement: m. arias: m/s."""

    record: str
    component: str
    dt: float
    samples: int
    duration: float
    peak_acceleration: float
    peak_time: float
    peak_velocity: float
    peak_displacement: float
    arias: float
    d5_75: float
    d5_95: float
    stated_peak: float | None


@dataclass(frozen=True)
class StudyTable(Sequence[dict[str, str]]):
    """The table of a study, a row a run, by names of columns; texts as in its file. finished: whether all runs have ended. folder: with table.csv,
    index.html and the runs."""

    folder: pathlib.Path
    finished: bool
    rows: tuple[dict[str, str], ...] = field(repr=False)

    def __len__(self) -> int:
        return len(self.rows)

    def __getitem__(self, index: Any) -> Any:
        return self.rows[index]


def made(kind: type[T], data: Mapping[str, Any], **more: Any) -> T:
    """A dataclass from the JSON of the program; of members that it has no field for, none."""
    found = {**data, "data": data, **more}
    return kind(**{one.name: _value(found.get(one.name), one.metadata.get("of")) for one in fields(kind)})  # type: ignore[arg-type]


def _value(value: Any, of: Any) -> Any:
    if isinstance(value, list):
        return tuple(_value(one, of) for one in value)
    return made(of, value) if of and isinstance(value, Mapping) else value
