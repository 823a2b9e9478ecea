# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The whole program as functions. Each starts a process of its own; two at a time are safe.

A case is a Model, a parts.Case, the path of a .toml file or the name of a ready case. All raise what errors.py lists: errors carry file, line,
key, value and what is allowed. Lengths are m, forces N, times s, angles degrees.
"""

import csv
import json
import os
import pathlib
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from . import bars, commands
from .answers import Assessed, Checked, Compared, Limit, Mode, Modes, MotionFigures, StudyTable, made
from .commands import Word
from .errors import Stopped, error_of
from .messages import Progress

if TYPE_CHECKING:
    from .model import Model
    from .parts import Case
    from .runs import Run

Path = str | os.PathLike[str]
T = TypeVar("T")


def check(case: "Model | Case | Path", *, draw: Path | None = None, overwrite: bool = False, options: Sequence[Word] = ()) -> Checked:
    """Reads and builds a case, without a run: counts, masses, step.

    draw: an .svg file for plans and elevations. overwrite: replace it. options: further ones of `voussoir check --help`.
    Raises InputError with all faults of the case (`error.faults`).
    """
    words = [*_option("--draw", _whole(draw)), *_flag("--overwrite", overwrite), *options]
    return made(Checked, _with_file(case, lambda file: commands.json_of("check", file, *words)))


def view(case: "Model | Case | Path", path: Path, *, view: str = "corner", overwrite: bool = False) -> pathlib.Path:
    """Writes one HTML page of the model, before any run; for a .png path a picture from the side `view`
    (by Chromium; without it plain, with no title, scale, legend or ties).

    Returns the whole path. A refused model is shown with its faults in red, and raises.
    """
    to = pathlib.Path(path).absolute()  # not resolve(): the program refuses to write through a link
    words = ["--still", to, "--view", view] if to.suffix == ".png" else ["-o", to]
    _with_file(case, lambda file: commands.call("view", file, *words, *_flag("--overwrite", overwrite)))
    return to


def modes(case: "Model | Case | Path", count: int = 6, *, impulse: bool = False, closed: bool = False, shapes: Path | None = None,
          overwrite: bool = False) -> Modes:
    """The first natural modes, from the eigenvalues of the stiffness.

    impulse: also by an impulse and a Fourier transform, which takes minutes. closed: joints without a bond held as by weight. shapes: a .vtu file
    for the mode shapes. overwrite: replace it.
    """
    words = ["--count", count, "--quiet", *_flag("--no-impulse", not impulse), *_flag("--closed", closed), *_option("--shapes", _whole(shapes)),
             *_flag("--overwrite", overwrite)]
    found = _with_file(case, lambda file: commands.json_of("modes", file, *words))
    points = found["impulse"] and {point["name"]: (point["x"], point["y"]) for point in found["impulse"]["points"]}
    return made(Modes, found, main={axis: made(Mode, mode) for axis, mode in found["main"].items()}, impulse=points)


def limit(case: "Model | Case | Path", *, direction: str | None = None, associated: bool = False, options: Sequence[Word] = ()) -> Limit:
    """The collapse multiplier of dry blocks and its mechanism, by limit analysis (needs Clp). `proven` says whether its bounds hold.

    direction: of the live load: x, -x, y, ..., degrees from x towards y, or X,Y,Z. associated: only associated flow, where
    joints open as they slide: an equal or larger multiplier, in a twentieth of the time. options: further ones of `voussoir limit --help`, as "--kinematic".
    """
    words = ["--quiet", *_option("--direction", direction), *_flag("--associated", associated), *options]
    text, code, said = _with_file(case, lambda file: commands.told("limit", file, *words, "--format", "json", codes=(0, 1)))
    if code == 1 and not text.strip():  # nothing was found
        raise error_of(code, said.faults, said.others, said.remarks)
    found = json.loads(text)
    best = found["coulomb"] or found["associated"]
    return made(Limit, found, multiplier=best["multiplier"], associated=found["associated"]["multiplier"], proven=code == 0)


def run(case: "Model | Case | Path", folder: Path | None = None, *, until: float | None = None, threads: int | None = None, overwrite: bool = False,
        progress: bool | Callable[[Progress], None] = True, options: Sequence[Word] = ()) -> "Run":
    """Settles a case under gravity, shakes it, writes results. Ctrl-C saves and stops: Stopped; `resume` goes on.

    folder: default results/NAME. until: s of shaking. threads: default all cores. progress: True: a line on standard error; a function: called with
    a Progress five times a second, in another thread; an error that it raises stops the run. options: further ones of `voussoir run --help`.
    """
    from .model import Model
    from .runs import Run  # first: what results need is missed now, not when the run has ended
    if not isinstance(case, (str, os.PathLike)):
        return Model.of(case).run(folder, until=until, threads=threads, overwrite=overwrite, progress=progress, options=options)
    to = pathlib.Path(folder or pathlib.Path("results") / pathlib.Path(case).stem)
    with bars.shown(to.name, progress) as told:
        commands.watch("run", case, "-o", to, *_option("--duration", until), *_option("-j", threads), *_flag("--overwrite", overwrite), *options,
                       progress=told)
    return Run(to)


def resume(folder: Path, *, until: float | None = None, threads: int | None = None, progress: bool | Callable[[Progress], None] = True) -> "Run":
    """Goes on with a run from its newest intact checkpoint, to the same bits: after Ctrl-C, a kill, or, with a later end `until` (s), after its
    end. progress: as for `run`."""
    from .runs import Run
    return Run(folder).resume(until=until, threads=threads, progress=progress)


def assess(folder: "Run | Path", *, time: float | None = None, levels: Sequence[float] = (), maps: Path | None = None, demand: str | None = None,
           overwrite: bool = False, options: Sequence[Word] = ()) -> Assessed:
    """Crack widths, drifts, forces through cuts, base shear over weight of a run; demand over capacity of a pushover.

    time: s, of cracks (default: the last frame). levels: m, heights of storeys above the base. maps: a folder for crack maps (SVG). demand: a spectrum, as
    ec8:1:B:0.25g. options: further ones of `voussoir assess --help`.
    """
    words = [*_option("--time", time), *_option("--levels", ",".join(map(repr, levels)) or None), *_option("--maps", maps), *_option("--demand", demand),
             *_flag("--overwrite", overwrite), *options]
    return made(Assessed, commands.json_of("assess", _folder(folder), *words))


def compare(first: "Run | Path", second: "Run | Path") -> Compared:
    """Whether two runs are the same, bit for bit, but for provenance; where not: what differs first, and their measures side by side."""
    return made(Compared, commands.json_of("compare", _folder(first), _folder(second), codes=(0, 1)))


def summary(folder: "Run | Path") -> dict[str, Any]:
    """All measures of a run, computed anew from its frames, also of one that goes on: as `voussoir summary --format json` prints them, in SI units
    (io/MEASURES.md)."""
    found: dict[str, Any] = commands.json_of("summary", _folder(folder))
    return found


def study(file: Path, folder: Path | None = None, *, cores: int | None = None, check: bool = False, table: bool = False,
          known: Sequence[Path] = ()) -> StudyTable:
    """Makes the runs of a study file (scripts/study/README.md), or goes on with them, and returns their table. For studies put together in Python:
    Study.

    folder: default results/NAME. cores: to use (default all). check: reads the file and tries its cases, runs nothing. table: the table of what is there so
    far. known: tables with runs that need not be made again. Ctrl-C saves and stops all runs at work: Stopped; the same call goes on.
    """
    to = pathlib.Path(folder or pathlib.Path("results") / pathlib.Path(file).stem)
    words = ["-o", to, *_option("--cores", cores), *_flag("--check", check), *_flag("--table", table)]
    try:
        code = commands.watched("study", file, *words, *(word for one in known for word in ("--known", one)), progress=False, codes=(0, 1))[1]
    except commands.Killed:
        raise
    except KeyboardInterrupt as interrupt:
        raise Stopped("the study was stopped; its runs are saved, and the same call goes on") from interrupt
    rows: tuple[dict[str, str], ...] = ()
    if os.path.exists(to / "table.csv") and not check:
        with open(to / "table.csv", newline="", encoding="utf-8") as lines:
            rows = tuple(csv.DictReader(line for line in lines if not line.startswith("#")))
    return StudyTable(to, code == 0 and not _unfinished(rows), rows)


def _unfinished(rows: Sequence[dict[str, str]]) -> list[str]:
    """Names of runs of a study that have not ended."""
    return [row["run"] for row in rows if row["status"] not in ("done", "numerical failure")]


def motion(*files: Path, spectra: Path | None = None, write: Path | None = None, damping: float | None = None, until: float | None = None,
           unit: str | None = None, overwrite: bool = False) -> tuple[MotionFigures, ...]:
    """Peaks, durations and Arias intensity of each component of ground motions.

    spectra: a CSV file for response spectra. write: a folder for the record as CSV. damping: of the spectra, of critical. until: s, the first ones alone. unit:
    g, m/s2 or cm/s2, where a file does not say. overwrite: replace files.
    """
    words = [*_option("--spectra", spectra), *_option("--write", write), *_option("--damping", damping), *_option("--until", until),
             *_option("--unit", unit), *_flag("--overwrite", overwrite)]
    return tuple(made(MotionFigures, one) for one in commands.json_of("motion", *files, *words))


def _with_file(case: Any, use: Callable[[Path], T]) -> T:
    """What `use` makes of the file or the name of a case; of a Model a file for a moment."""
    if isinstance(case, (str, os.PathLike)):
        return use(case)
    from .model import Model
    return Model.of(case)._with_file(use)


def _folder(run: Any) -> Path:
    """The folder of a run, which is closed: the program reads it."""
    if isinstance(run, (str, os.PathLike)):
        return run
    run.close()
    folder: Path = run.folder
    return folder


def _whole(path: Path | None) -> pathlib.Path | None:
    return None if path is None else pathlib.Path(path).absolute()


def _option(name: str, value: Any) -> list[Word]:
    return [] if value is None else [name, value]


def _flag(name: str, given: bool) -> list[Word]:
    return [name] if given else []
