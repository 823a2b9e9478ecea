# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What can go wrong. The message of each error is the program's own, without "voussoir: " before it."""

import sys
import warnings


class VoussoirError(Exception):
    """Any failure of the program or of this package."""

    code: int | None = None  # the program's exit code, if it was the program that failed


class NumericalFailure(VoussoirError):
    """The run cannot continue: too much energy is unaccounted for, or a number is NaN."""

    code = 1


class InputError(VoussoirError):
    """A case or an option is invalid. The message names file, line, key, value and what is allowed."""

    code = 2


class FileError(VoussoirError):
    """A file or a folder cannot be read or written, or has other contents than expected."""

    code = 3


class ProcessorError(VoussoirError):
    """The program was built for newer processors than this one."""

    code = 4


class ProgramNotFound(VoussoirError):
    """The program was not found."""


class Stopped(KeyboardInterrupt):
    """A run was stopped, by Ctrl-C or a signal, and has saved its state: `Run(folder).resume()` goes on to the same bits.

    A KeyboardInterrupt, so that Ctrl-C also ends a script that does not expect it.
    """


class ProgramWarning(UserWarning):
    """A warning or a note of the program: a probable mistake, or something to know about the results."""


def _outside() -> int:
    """The level of the line that called this package, as warnings.warn counts from the function that calls this one."""
    frame, level = sys._getframe(1), 1
    while frame.f_back and frame.f_globals.get("__name__", "").partition(".")[0] in (__package__, "contextlib"):
        frame, level = frame.f_back, level + 1
    return level


_SAID = ("voussoir: warning: ", "voussoir: note: ")


def warn_of(said: str) -> str:
    """Passes the program's warnings and notes on to Python's `warnings`. Returns the other lines of its output."""
    others = []
    for line in said.splitlines():
        if line.startswith(_SAID):
            warnings.warn(line.removeprefix("voussoir: "), ProgramWarning, stacklevel=_outside())
        else:
            others.append(line)
    return "\n".join(others)


def error_of(code: int, message: str) -> VoussoirError:
    """The exception for an exit code of the program."""
    kinds: dict[int, type[VoussoirError]] = {kind.code: kind for kind in (NumericalFailure, InputError, FileError, ProcessorError) if kind.code}
    text = message.strip().removeprefix("voussoir: ")
    if code < 0:
        text = f"the program was ended by signal {-code}. {text}".strip()
    error = kinds.get(code, VoussoirError)(text or f"the program ended with exit code {code}")
    error.code = code
    return error
