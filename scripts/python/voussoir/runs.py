# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A run: its results, and what the program can still do with it."""

import os
import pathlib
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from . import bars, commands, functions
from .commands import Progress
from .results import Results

if TYPE_CHECKING:
    import matplotlib.figure

    from .jobs import Job
    from .notebook import Shown


class Run(Results):
    """Results of a run, and the commands that take one: `Run("results/hut").history("front").displacement`."""

    def resume(self, *, until: float | None = None, threads: int | None = None, progress: bool | Callable[[Progress], None] = True) -> "Run":
        """Continues from the newest intact checkpoint: after Ctrl-C, a kill, or, with a later end in s, after the end. To the same bits."""
        self.close()
        words: list[Any] = ["resume", self.folder]
        words += ["--until", until] if until is not None else []
        words += ["-j", threads] if threads else []
        with bars.shown(self.folder.name, progress) as told:
            commands.watch(*words, progress=told)
        return self

    def start(self, *, until: float | None = None, threads: int | None = None) -> "Job":
        """As `resume`, but returns as soon as the run goes on, and it does so in the background."""
        from .jobs import Job
        run = Run(self.folder)
        return Job(self.folder, lambda look: run.resume(until=until, threads=threads, progress=look))

    def report(self, *, other: "Run | None" = None, output: str | os.PathLike[str] | None = None, overwrite: bool = False) -> pathlib.Path:
        """Writes one HTML page that shows the run, or this one and another side by side. Returns its path."""
        words: list[Any] = ["report", self.folder, *([other.folder] if other else []), *(["-o", output] if output else [])]
        commands.call(*words, *(["--overwrite"] if overwrite else []))
        return pathlib.Path(output) if output else self.folder / ("comparison.html" if other else "report.html")

    def stills(self, times: Sequence[float], *, views: Sequence[str] = ("corner",), overwrite: bool = False) -> pathlib.Path:
        """Writes pictures at these times, s (by Chromium; without it plain, with no title, scale, legend or ties). Returns their folder."""
        words: list[Any] = ["report", self.folder, "--stills", ",".join(f"{t:g}" for t in times), "--view", ",".join(views)]
        commands.call(*words, *(["--overwrite"] if overwrite else []))
        return self.folder / "stills"

    def film(self, file: str | os.PathLike[str], *, view: str = "corner", speed: float = 1.0, overwrite: bool = False) -> pathlib.Path:
        """Writes a film: .mp4, .webm or .gif (needs Chromium and ffmpeg)."""
        commands.call("report", self.folder, "--film", file, "--view", view, "--speed", speed, *(["--overwrite"] if overwrite else []))
        return pathlib.Path(file)

    def same_as(self, other: "Run") -> bool:
        """Whether the results of two runs are equal, bit for bit (except provenance)."""
        return functions.compare(self, other).identical

    def describe(self) -> str:
        """Results in words, as `voussoir summary` prints them."""
        return commands.call("summary", self.folder)

    def show(self, *, height: int = 520) -> "Shown":
        """In a notebook: state, figures and replay, however large it is. height: of the page, pixels."""
        from . import notebook
        return notebook.Shown(notebook.html_of_run(self, most=None, height=height))

    def _repr_html_(self) -> str:
        from . import notebook
        return notebook.html_of_run(self)

    def plot_histories(self, **options: Any) -> "matplotlib.figure.Figure":
        """Displacements of the followed elements. options: those of plots.histories."""
        from . import plots  # here, so that matplotlib is needed by those alone who plot
        return plots.histories([self], **options)

    def plot_energy(self, **options: Any) -> "matplotlib.figure.Figure":
        """Input, stored and lost energy over time."""
        from . import plots
        return plots.energy(self, **options)

    def plot_damage(self, **options: Any) -> "matplotlib.figure.Figure":
        """Open segments over time, by the mode that opened them."""
        from . import plots
        return plots.damage([self], **options)

    def plot_capacity(self, **options: Any) -> "matplotlib.figure.Figure":
        """The capacity curve of a quasi-static analysis. options: those of plots.capacity."""
        from . import plots
        return plots.capacity([self], **options)

    def __repr__(self) -> str:
        return f"Run({str(self.folder)!r})"
