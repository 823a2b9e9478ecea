# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Many runs over parameters, from Python. For studies on a cluster, from a file: scripts/study."""

import concurrent.futures
import csv
import io
import itertools
import os
import pathlib
import re
import sys
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from . import bars, outputs
from .errors import FileError, InputError, NumericalFailure, Stopped
from .model import Model
from .results import Results
from .runs import Run
from .texts import odd_path, shown

if TYPE_CHECKING:
    import pandas


class Study:
    """One run for each combination of parameters.

    def wall(height, mortar):
        model = voussoir.Model(include=["parts/adobe-house", f"parts/{mortar}-mortar"])
        ...
        return model

    study = voussoir.Study("results/heights", wall, height=[2.0, 2.4], mortar=["weak", "strong"])
    study.run(until=6.0, workers=2)      # again after Ctrl-C or a kill: the same call goes on
    study.write("heights.csv", overwrite=True)
    """

    def __init__(self, folder: str | os.PathLike[str], build: Callable[..., Model], **parameters: Sequence[Any]) -> None:
        """build: a function that makes the model of one combination; its arguments are the names of `parameters`, each with its values."""
        self.folder = pathlib.Path(folder)
        self._build = build
        self.runs: dict[str, dict[str, Any]] = {}  # by name of the folder: its parameters
        for values in itertools.product(*parameters.values()):
            point = dict(zip(parameters, values))
            name = ",".join(f"{key}={_short(value)}" for key, value in point.items()) or "run"
            if name in self.runs:
                raise InputError(f"study {self.folder}: two runs have the name {name}; give values that differ in letters, digits, '.', '+' or '-'")
            self.runs[name] = point

    def run(self, *, until: float | None = None, threads: int = 1, workers: int = 1, quiet: bool = False) -> "Study":
        """Runs all combinations that have not ended yet, `workers` at a time with `threads` each.

        Runs that were stopped or killed continue from their checkpoint.

        All models are built and checked before anything runs. A numerical failure is a result. Raises InputError if the model of an
        existing run has changed since, with the name of its folder; Stopped after Ctrl-C, when all active runs have saved.
        """
        models = {name: self._build(**point) for name, point in self.runs.items()}
        for name, model in models.items():
            if until is not None:
                model["time.duration"] = until
            self._refuse_other(name, model.text())
            if not os.path.exists(self.folder / name / "run.h5"):
                model.check()
        _make(self.folder)
        pool = concurrent.futures.ThreadPoolExecutor(workers)
        stop: list[bool] = []
        bar = bars.Bar(self.folder.name) if bars.in_notebook() and not quiet else None
        if bar:
            bar.show()

        def work(name: str) -> None:
            if stop or self.status(name) in ("done", "numerical failure"):
                return
            if not quiet and not bar:
                print(f"{self.folder / name}", file=sys.stderr)
            self._one(name, models[name], threads, lambda _: _raise_if(stop))

        jobs = [pool.submit(work, name) for name in models]
        try:
            for number, job in enumerate(concurrent.futures.as_completed(jobs), 1):
                job.result()
                if bar:
                    bar.say(number / len(jobs), f"{number} of {len(jobs)} runs")
        except BaseException as error:
            stop.append(True)  # each run at work sees it with its next line of progress, saves and stops
            pool.shutdown(wait=True, cancel_futures=True)
            if bar:
                bar.end(error)
            if isinstance(error, KeyboardInterrupt) and not isinstance(error, Stopped):
                raise Stopped("the study was stopped; its runs are saved, and the same call goes on") from error
            raise
        pool.shutdown()
        if bar:
            bar.end(None)
        return self

    def _one(self, name: str, model: Model, threads: int, look: Callable[[Any], None]) -> None:
        folder = self.folder / name
        try:
            if any(folder.glob("checkpoint-*.h5")):
                Run(folder).resume(threads=threads, progress=look)
                return
            outputs.write(self.folder / f"{name}.toml", model.text(), outputs.CASE, overwrite=True)
            model.run(folder, threads=threads, overwrite=True, progress=look)
        except NumericalFailure as error:
            _make(folder)
            outputs.write(folder / "failure.txt", f"{error}\n", outputs.NOTE)

    def _refuse_other(self, name: str, text: str) -> None:
        before = self.folder / f"{name}.toml"
        if not os.path.exists(self.folder / name / "run.h5") or not os.path.exists(before):
            return
        try:
            same = before.read_bytes() == text.encode()
        except OSError as error:
            raise FileError(f"{shown(before)}: cannot be read: {error.strerror}") from error
        if not same:
            raise InputError(f"{self.folder / name}: was run with another model ({before}); remove the folder, or give the study another one")

    def status(self, name: str) -> str:
        """Status of each run: done, numerical failure, stopped (can be resumed), to be done."""
        folder = self.folder / name
        if os.path.exists(folder / "failure.txt"):
            return "numerical failure"
        if not os.path.exists(folder / "run.h5"):
            return "to be done"
        results = Results(folder)
        results._tells = False
        try:
            return "done" if results.finished else "stopped"
        finally:
            results.close()

    def __iter__(self) -> Iterator[tuple[dict[str, Any], Run]]:
        """Parameters and run of each finished combination."""
        return ((point, Run(self.folder / name)) for name, point in self.runs.items() if self.status(name) == "done")

    def table(self) -> list[dict[str, Any]]:
        """One row per run: parameters, status, and for finished ones all of `Run.summary`."""
        rows = []
        for name, point in self.runs.items():
            row = {"run": name, **point, "status": self.status(name)}
            if row["status"] == "done":
                results = Results(self.folder / name)
                row |= results.summary
                results.close()
            rows.append(row)
        return rows

    def _repr_html_(self) -> str:
        from . import notebook
        shown = ("damage_grade", "collapsed", "fallen_mass_fraction", "peak_drift", "peak_base_shear", "multiplier_at_rest")
        return notebook.html_of_rows([{**self.runs[row["run"]], "status": row["status"], **{name: row[name] for name in shown if name in row}}
                                      for row in self.table()])

    def to_pandas(self) -> "pandas.DataFrame":
        """The table as a data frame. Raises ImportError without pandas."""
        from . import pandas_tables
        return pandas_tables.frame_of_rows(self.table())

    def write(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> pathlib.Path:
        """Writes the table as CSV. overwrite: replace a table. Raises FileError."""
        rows = self.table()
        names = list(dict.fromkeys(key for row in rows for key in row))
        text = io.StringIO()
        writer = csv.DictWriter(text, names, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        return outputs.write(path, text.getvalue(), outputs.TABLE, overwrite=overwrite)


def _short(value: Any) -> str:
    """A value in short form for the name of a folder."""
    text = f"{value:g}" if isinstance(value, float) else str(value)
    return re.sub(r"[^A-Za-z0-9.+-]+", "_", text).strip("_") or "_"


def _raise_if(stop: list[bool]) -> None:
    if stop:
        raise Stopped("the study was stopped; the same call goes on")


def _make(folder: pathlib.Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (OSError, ValueError) as error:
        raise FileError(f"{shown(folder)}: cannot be made: {odd_path(folder) or getattr(error, 'strerror', error)}") from error
