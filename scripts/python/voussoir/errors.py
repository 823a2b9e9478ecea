# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What can go wrong. The message of each error is the program's own."""

from collections.abc import Sequence
from typing import NamedTuple


class Fault(NamedTuple):
    """A fault that the program has told: its text, and what it is about; None where that is not known."""

    text: str
    file: str | None = None
    line: int | None = None  # from 1
    key: str | None = None  # path in the case file, as "house.opening[1].width", or an option, as "--until"
    value: str | None = None  # in words, with its unit
    allowed: str | None = None  # what the key allows, in words


class VoussoirError(Exception):
    """Any failure of the program or of this package.

    code: the program's exit code; None if it was not the program that failed. faults: all that the program told. file, line, key, value,
    allowed: those of the first fault, None where not known. remarks: what the program said beside them, as how to go on.
    """

    code: int | None = None

    def __init__(self, message: str, faults: Sequence[Fault] = (), remarks: Sequence[str] = ()) -> None:
        super().__init__(message)
        self.faults, self.remarks = tuple(faults), tuple(remarks)

    @property
    def file(self) -> str | None:
        """The file at fault."""
        return self.faults[0].file if self.faults else None

    @property
    def line(self) -> int | None:
        """Its line, from 1."""
        return self.faults[0].line if self.faults else None

    @property
    def key(self) -> str | None:
        """The key of the case, or the option."""
        return self.faults[0].key if self.faults else None

    @property
    def value(self) -> str | None:
        """The value that it has, in words."""
        return self.faults[0].value if self.faults else None

    @property
    def allowed(self) -> str | None:
        """What the key allows, in words."""
        return self.faults[0].allowed if self.faults else None


class NumericalFailure(VoussoirError):
    """The run cannot continue: too much energy is unaccounted for, or a number is NaN."""

    code = 1


class InputError(VoussoirError):
    """A case or an option is invalid."""

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

    A KeyboardInterrupt, so that Ctrl-C also ends a script that does not expect it. folder: that of the run; time: s of shaking, below 0 while it
    settled; None if the program did not say.
    """

    folder: str | None = None
    time: float | None = None


class ProgramWarning(UserWarning):
    """A warning or a note of the program: a probable mistake, or something to know about the results."""


def error_of(code: int, faults: Sequence[Fault], others: Sequence[str] = (), remarks: Sequence[str] = ()) -> VoussoirError:
    """The exception for an exit code of the program. others: what it said that is no message."""
    kinds: dict[int, type[VoussoirError]] = {kind.code: kind for kind in (NumericalFailure, InputError, FileError, ProcessorError) if kind.code}
    text = "\n".join([*(fault.text for fault in faults), *others]).strip()
    if code < 0:
        text = f"the program was ended by signal {-code}. {text}".strip()
    error = kinds.get(code, VoussoirError)(text or f"the program ended with exit code {code}", faults, remarks)
    error.code = code
    return error
