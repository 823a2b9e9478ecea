# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The program's commands, one call each. `call` takes any words of the command line, so whatever the command line can do, Python can."""

import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from .errors import ProgramNotFound, Stopped, error_of, warn_of
from .program import program

Word = str | os.PathLike[str] | float  # of the command line

_PROGRESS = re.compile(r"(?:(settling), (-?[\d.]+) s|(-?[\d.]+) of (\S+) s)  (\S+) steps/s  (.*?)  ([\d,]+) broken  energy error (\S+)")


@dataclass(frozen=True)
class Progress:
    """Progress of a run."""

    time: float  # s of shaking; below 0 while it settles
    end: float | None  # s; None while it settles
    settling: bool
    steps_per_second: float
    left: str  # "2 min 10 s left", in the program's words
    broken: int  # segments
    residual: float  # of the energy balance, a ratio
    text: str  # all of it, as the program says it


def call(*words: Word, folder: str | os.PathLike[str] | None = None) -> str:
    """Runs `voussoir WORDS` to its end and returns what it printed. folder: where it runs (default: the working folder).

    Raises what errors.py lists.
    """
    done = _ended(words, folder)
    said = warn_of(done.stderr)
    if done.returncode != 0:
        raise error_of(done.returncode, said)
    return done.stdout


def holds(*words: Word) -> bool:
    """The answer of a command that asks a question, such as `compare`: True for exit code 0, False for 1. Raises for other codes."""
    done = _ended(words, None)
    said = warn_of(done.stderr)
    if done.returncode not in (0, 1):
        raise error_of(done.returncode, said)
    return done.returncode == 0


def _ended(words: tuple[Word, ...], folder: str | os.PathLike[str] | None) -> subprocess.CompletedProcess[str]:
    command = [program(), *map(_word, words)]
    try:
        return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    except OSError as error:
        raise _not_found(command[0], error) from error


def watch(*words: Word, progress: bool | Callable[[Progress], None] = True) -> str:
    """As `call`, for commands that take long: shows their progress.

    progress: True writes a line to sys.stderr, which is overwritten; a function is called with a Progress, five times a second; False: neither.
    Ctrl-C asks the program to save and stop, waits for it, and raises Stopped. The program runs in a separate session, so that
    a Ctrl-C in a terminal reaches it only once, by way of Python.
    """
    command = [program(), *map(_word, words)]
    terminal, theirs = os.openpty()  # on a terminal the program says five times a second how far it is
    try:
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=theirs, text=True, start_new_session=True)
    except OSError as error:
        os.close(terminal)
        raise _not_found(command[0], error) from error
    finally:
        os.close(theirs)
    said: list[str] = []
    failed: list[BaseException] = []

    def show() -> None:
        shown = False
        for line in _lines_of(terminal):
            state = parse_progress(line)
            if state is None:
                said.append(line)
            elif callable(progress):
                try:
                    progress(state)
                except BaseException as error:  # told to the caller, below; the run is stopped as by Ctrl-C
                    failed.append(error)
                    child.send_signal(signal.SIGINT)
                    return _drain(terminal)
            elif progress:
                sys.stderr.write(f"\r{state.text}\x1b[K")
                shown = True
        if shown:
            sys.stderr.write("\n")

    out: list[str] = []
    threads = [threading.Thread(target=show, daemon=True), threading.Thread(target=lambda: out.append(child.stdout.read() if child.stdout else ""), daemon=True)]
    for thread in threads:
        thread.start()
    interrupted = False
    while True:
        try:
            for thread in threads:  # they end with the program; child.wait() would answer a Ctrl-C late
                thread.join()
            code = child.wait()
            break
        except KeyboardInterrupt:
            if interrupted:  # the second time: at once
                child.kill()
                raise
            interrupted = True
            child.send_signal(signal.SIGINT)
    os.close(terminal)
    if child.stdout:
        child.stdout.close()
    others = warn_of("\n".join(line.strip() for line in said))
    if failed:
        raise failed[0]
    if code in (128 + signal.SIGINT, 128 + signal.SIGTERM):
        place = re.search(r"^stopped +(.*)$", "".join(out), re.MULTILINE)
        where = f" {place[1]}" if place else ""
        raise Stopped(f"the run was stopped{where}; its state is saved, and Run(folder).resume() goes on")
    if code != 0:
        raise error_of(code, others)
    if interrupted:  # it came to its end meanwhile
        raise KeyboardInterrupt
    return "".join(out)


def parse_progress(line: str) -> Progress | None:
    """Progress from a line that the program writes about a run; None for other lines."""
    found = _PROGRESS.search(line)
    if found is None:
        return None
    settling, before, time, end, speed, left, broken, residual = found.groups()
    return Progress(float(before or time), float(end) if end else None, bool(settling), float(speed.replace(",", "")), left,
                    int(broken.replace(",", "")), float(residual), found.group())


def version() -> str:
    """The version, as "voussoir 0.1.0 (physics 13)"."""
    return call("--version").strip()


def ready_cases() -> dict[str, str]:
    """Names of the ready cases, with their titles."""
    lines = (line.split(None, 1) for line in call("cases").splitlines())
    return {words[0]: words[1].strip() if len(words) > 1 else "" for words in lines if words}


def motion(*files: str | os.PathLike[str], spectra: str | os.PathLike[str] | None = None, write: str | os.PathLike[str] | None = None,
           damping: float | None = None, until: float | None = None, unit: str | None = None, overwrite: bool = False) -> str:
    """Peaks, durations, Arias intensity of ground motions, as `voussoir motion` prints them. spectra: also response spectra, as CSV."""
    options = {"--spectra": spectra, "--write": write, "--damping": damping, "--until": until, "--unit": unit}
    words = [word for name, value in options.items() if value is not None for word in (name, value)]
    return call("motion", *files, *words, *(["--overwrite"] if overwrite else []))


def _word(word: Word) -> str:
    return os.fspath(word) if isinstance(word, os.PathLike) else str(word)


def _not_found(name: str, error: OSError) -> ProgramNotFound:
    return ProgramNotFound(f"{name}: {error.strerror}; build it (scripts/build), install it, or name it by VOUSSOIR=...")


def _lines_of(terminal: int) -> Iterator[str]:
    """Lines that a program writes to its terminal, including overwritten ones, without control characters."""
    rest = b""
    while True:
        try:
            piece = os.read(terminal, 65536)
        except OSError:  # the program has ended
            piece = b""
        rest += piece
        *lines, rest = re.split(rb"[\r\n]+", rest) if piece else [rest, b""]
        for line in lines:
            text = re.sub(r"\x1b\[[?0-9;]*[a-zA-Z]", "", line.decode(errors="replace")).strip()
            if text:
                yield text
        if not piece:
            return


def _drain(terminal: int) -> None:
    for _ in _lines_of(terminal):
        pass


def absolute_if_file(path: str | os.PathLike[str]) -> str:
    """The absolute path, if it exists; else the text unchanged, which may be a name known to the program.

    FILE#COMPONENT, for a motion, exists if FILE does.
    """
    if pathlib.Path(path).exists():
        return str(pathlib.Path(path).resolve())
    file, mark, component = str(path).rpartition("#")
    return f"{pathlib.Path(file).resolve()}#{component}" if mark and pathlib.Path(file).is_file() else str(path)
