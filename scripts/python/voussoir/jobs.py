# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Runs in the background of Python: `model.start(folder)`."""

import atexit
import os
import pathlib
import threading
import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .bars import Bar
from .commands import Progress, stop_all
from .errors import Stopped

if TYPE_CHECKING:
    from .runs import Run

_AT_EXIT = 4.0  # s that the end of Python waits for runs to save; Jupyter kills a kernel after five


class Job:
    """A run that goes on while Python does other things.

    job = model.start("results/hut", until=5.0)
    job                  # in a notebook: a bar that goes on by itself
    run = job.wait()     # an interrupt (Ctrl-C, the square of Jupyter) saves and stops
    job.stop()           # saves; `Run(folder).resume()` or `.start()` goes on to the same bits

    It is stopped, too, when Python ends; of a Python that is killed the program knows nothing, and goes on to the end of the run.
    """

    def __init__(self, folder: str | os.PathLike[str], work: Callable[[Callable[[Progress], None]], Any]) -> None:
        """Returns when the run has begun, or ended. Raises what the program says of a case that it refuses.

        work: makes the run and returns at its end; it is given what it has to call with its progress.
        """
        self.folder = pathlib.Path(folder)
        self.progress: Progress | None = None  # None before the first step
        self.error: BaseException | None = None  # how it ended, if not well
        self._bar = Bar(self.folder.name)
        self._stop = False
        # Events are waited for, not the thread: Python 3.11 takes a thread for ended once an interrupt has hit its join().
        self._begun, self._ended = threading.Event(), threading.Event()
        threading.Thread(target=self._run, args=(work,), name=f"voussoir {self.folder}", daemon=True).start()
        _jobs.add(self)
        try:
            self._begun.wait()
        except KeyboardInterrupt:
            self._end()
            raise
        if self.error is not None:
            raise self.error

    def _run(self, work: Callable[[Callable[[Progress], None]], Any]) -> None:
        try:
            work(self._look)
        except BaseException as error:
            self.error = error
        self._bar.end(self.error)
        self._ended.set()
        self._begun.set()

    def _look(self, progress: Progress) -> None:
        self.progress = progress
        self._bar(progress)
        self._begun.set()
        if self._stop:
            raise Stopped(f"the run was stopped at {progress.time:g} s; its state is saved, and Run({str(self.folder)!r}).resume() goes on")

    @property
    def state(self) -> str:
        """goes on; finished; stopped, and can go on; failed."""
        if not self._ended.is_set():
            return "goes on"
        if self.error is None:
            return "finished"
        return "stopped" if isinstance(self.error, Stopped) else "failed"

    @property
    def run(self) -> "Run":
        """The run: while it goes on, what it has written so far."""
        from .runs import Run
        return Run(self.folder)

    def wait(self, timeout: float | None = None) -> "Run":
        """Waits for the end and returns the run. timeout: s, then TimeoutError is raised, and the run goes on.

        An interrupt saves and stops the run, and raises Stopped; a second one does not wait until it has saved. Raises what the run has raised.
        """
        try:
            self._ended.wait(timeout)
        except KeyboardInterrupt:
            self._end()
        if not self._ended.is_set():
            raise TimeoutError(f"{self.folder}: goes on after {timeout:g} s")
        if self.error is not None:
            raise self.error
        return self.run

    def stop(self) -> None:
        """Saves and stops. Nothing happens to a run that has ended. Raises what the run has raised, if it has failed."""
        self._end()
        if self.error is not None and not isinstance(self.error, Stopped):
            raise self.error

    def _end(self, timeout: float | None = None) -> None:
        self._stop = True  # seen with the next progress, of which there are five a second
        self._ended.wait(timeout)

    def _ipython_display_(self) -> None:
        self._bar.show()

    def __repr__(self) -> str:
        return f"<Job {self.folder}: {self.state}, {self._bar.words}>"


_jobs: "weakref.WeakSet[Job]" = weakref.WeakSet()


@atexit.register
def _stop_all() -> None:
    for job in list(_jobs):
        job._stop = True
    stop_all()  # now, not with their next progress, which may be late
    for job in list(_jobs):
        job._end(_AT_EXIT)
