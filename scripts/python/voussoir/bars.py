# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Progress of runs in Jupyter: a bar in the output of a cell, updated in place. It needs no widgets."""

import contextlib
import html
import sys
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

from .commands import Progress
from .errors import Stopped

BLUE, GREEN, GREY, RED = "#0072b2", "#009e73", "#8c8c8c", "#c1272d"
_INTERVAL = 0.25  # s between two updates


def in_notebook() -> bool:
    """Whether this Python is the kernel of a notebook."""
    ipython = sys.modules.get("IPython")  # a kernel has imported it; nothing else needs to
    shell = ipython.get_ipython() if ipython else None
    return shell is not None and hasattr(shell, "kernel")


class Bar:
    """A bar that can be shown in several cells; all of them are updated. Called with a Progress it shows that; threads may do so."""

    def __init__(self, title: str) -> None:
        self.title = title
        self.share, self.words, self.colour = 0.0, "begins", BLUE
        self._handles: list[Any] = []
        self._guard = threading.Lock()
        self._shown = -_INTERVAL  # s, of time.monotonic

    def __call__(self, progress: Progress) -> None:
        of = f" of {progress.end:g} s" if progress.end else " s"
        words = f"settles under gravity, {progress.time:.2f} s" if progress.settling else \
            f"{progress.states} states of rest" if progress.states is not None else f"{progress.time:.2f}{of}"
        left = "" if progress.seconds_left is None else f"{duration(progress.seconds_left)} left"
        self.say(0.0 if progress.settling else share_of(progress), ", ".join(filter(None, [words, left, f"{progress.broken:,} broken"])))

    def say(self, share: float, words: str, colour: str = BLUE, *, last: bool = False) -> None:
        """share: 0 to 1. last: shown in any case; others are left out where they come too fast."""
        with self._guard:
            self.share, self.words, self.colour = share, words, colour
            now = time.monotonic()
            if not last and now - self._shown < _INTERVAL:
                return
            self._shown = now
            with contextlib.suppress(Exception):  # a picture that cannot be shown is no reason to stop a run
                for handle in self._handles:
                    handle.update(self._bundle(), raw=True)

    def end(self, error: BaseException | None) -> None:
        """The last thing that the bar says."""
        at = self.words.partition(",")[0]
        if error is None:
            self.say(1.0, "finished", GREEN, last=True)
        elif isinstance(error, KeyboardInterrupt):
            self.say(self.share, f"stopped at {at}; saved, so that it can go on" if isinstance(error, Stopped) else f"stopped at {at}", GREY, last=True)
        else:
            self.say(self.share, f"failed: {str(error).partition(chr(10))[0]}", RED, last=True)

    def show(self) -> None:
        """Shows the bar in the output of the current cell."""
        from IPython.display import display  # type: ignore[import-not-found, unused-ignore]
        with self._guard:
            self._handles.append(display(self._bundle(), raw=True, display_id=True))

    def _bundle(self) -> dict[str, str]:
        return {"text/html": self._repr_html_(), "text/plain": repr(self)}

    def _repr_html_(self) -> str:
        percent = f"{100 * min(max(self.share, 0.0), 1.0):.0f}"
        title, words = html.escape(self.title), html.escape(self.words)
        return (f'<div style="display:flex;flex-wrap:wrap;gap:4px 12px;align-items:center"><b>{title}</b>'
                f'<div role="progressbar" aria-label="{title}" aria-valuenow="{percent}" '
                'style="flex:0 0 220px;height:10px;border:1px solid #8c8c8c;border-radius:6px;overflow:hidden">'
                f'<div style="width:{percent}%;height:100%;background:{self.colour}"></div></div><span>{words}</span></div>')

    def __repr__(self) -> str:
        return f"{self.title}: {100 * self.share:.0f} %, {self.words}"


def duration(seconds: float) -> str:
    """A time of wall-clock, in words."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes} min" if hours else f"{minutes} min {rest} s" if minutes else f"{rest} s"


def share_of(progress: Progress) -> float:
    """How much of a run is done, 0 to 1, by its own time."""
    return progress.time / progress.end if progress.end and not progress.settling else 0.0


@contextlib.contextmanager
def shown(title: str, progress: bool | Callable[[Progress], None]) -> Iterator[bool | Callable[[Progress], None]]:
    """What `commands.watch` is given as progress: in a notebook a bar in place of True, which also tells how it ended."""
    if progress is not True or not in_notebook():
        yield progress
        return
    bar = Bar(title)
    bar.show()
    try:
        yield bar
    except BaseException as error:
        bar.end(error)
        raise
    bar.end(None)
