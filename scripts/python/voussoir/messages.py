# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the program says on standard error: a JSON object a line (io/README.md, Messages)."""

import json
import os
import sys
import warnings
from dataclasses import dataclass, field, fields
from typing import Any

from .errors import Fault, ProgramWarning

_HERE = os.path.dirname(__file__) + os.sep


@dataclass(frozen=True)
class Progress:
    """Progress of a run."""

    time: float  # s of shaking; below 0 while it settles
    end: float | None  # s; None while it settles, and for states of rest
    settling: bool
    steps_per_second: float  # of wall-clock
    seconds_left: float | None  # s of wall-clock; None while not known
    broken: int  # segments
    residual: float  # of the energy balance, a ratio
    states: int | None  # of rest, found so far; None for a run in time
    text: str  # all of it, as the program says it


@dataclass
class Said:
    """All messages of a program but those of progress."""

    faults: list[Fault] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)  # and notes
    remarks: list[str] = field(default_factory=list)
    others: list[str] = field(default_factory=list)  # lines that are no messages
    stopped: dict[str, Any] | None = None

    def take(self, line: str) -> Progress | None:
        """Keeps a line; that of progress is returned."""
        message = _object_of(line)
        kind = message.get("kind")
        if kind == "progress":
            return _only(Progress, message)
        if kind == "error":
            self.faults.append(_only(Fault, message))
        elif kind in ("warning", "note"):
            self.warnings.append(message["text"])
        elif kind == "info":
            self.remarks.append(message["text"])
        elif kind == "stopped":
            self.stopped = message
        elif line.strip():
            self.others.append(line.rstrip())
        return None

    def warn(self) -> None:
        """Passes the program's warnings and notes on to Python's `warnings`, as of the line that called this package."""
        level, frame = 1, sys._getframe()
        while frame.f_back is not None and frame.f_code.co_filename.startswith(_HERE):
            level, frame = level + 1, frame.f_back
        for text in self.warnings:
            warnings.warn(text, ProgramWarning, stacklevel=level)


def said_in(text: str) -> Said:
    """The messages of a program that has ended."""
    said = Said()
    for line in text.splitlines():
        said.take(line)
    return said


def _object_of(line: str) -> dict[str, Any]:
    if not line.startswith("{"):
        return {}
    try:
        found = json.loads(line)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _only(kind: Any, message: dict[str, Any]) -> Any:
    """A dataclass from the members of a message that it has; later programs may say more."""
    names = kind._fields if hasattr(kind, "_fields") else [one.name for one in fields(kind)]
    return kind(**{name: message.get(name) for name in names})
