# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The program as a child process. `call` takes any words of the command line, so whatever the command line can do, Python can.

Calls share nothing: two of them may be at work at a time, in two threads.
"""

import contextlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from typing import Any

from .errors import Fault, FileError, InputError, ProgramNotFound, Stopped, error_of
from .messages import Progress, Said, said_in
from .program import program
from .texts import odd_path, shown

Word = str | os.PathLike[str] | float  # of the command line


def call(*words: Word, folder: str | os.PathLike[str] | None = None) -> str:
    """Runs `voussoir WORDS` to its end and returns what it printed. folder: where it runs (default: the working folder).

    Raises what errors.py lists.
    """
    return told(*words, folder=folder)[0]


def told(*words: Word, folder: str | os.PathLike[str] | None = None, codes: tuple[int, ...] = (0,)) -> tuple[str, int, Said]:
    """As `call`; returns also the exit code and the messages. codes: those that are no failure."""
    command = _command(words)
    _refuse_no_folder(folder)
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, encoding="utf-8", errors="replace", check=False)
    except OSError as error:
        raise _not_found(command[0], error) from error
    said = said_in(done.stderr)
    said.warn()
    if done.returncode not in codes:
        raise error_of(done.returncode, said.faults, said.others, said.remarks)
    return done.stdout, done.returncode, said


def json_of(*words: Word, codes: tuple[int, ...] = (0,)) -> Any:
    """What `voussoir WORDS --format json` prints, read."""
    return json.loads(told(*words, "--format", "json", codes=codes)[0])


def watch(*words: Word, progress: bool | Callable[[Progress], None] = True) -> str:
    """As `call`, for commands that take long: shows their progress.

    progress: True writes a line to sys.stderr, which is overwritten; a function is called with a Progress, five times a second; False: neither.
    Ctrl-C asks the program, and what it has started, to save and stop, waits for it, and raises Stopped. The program runs in a separate session,
    so that a Ctrl-C in a terminal reaches it only once, by way of Python.
    """
    return watched(*words, progress=progress)[0]


def watched(*words: Word, progress: bool | Callable[[Progress], None] = True, codes: tuple[int, ...] = (0,)) -> tuple[str, int]:
    """As `watch`; returns also the exit code. codes: those that are no failure."""
    command = _command(words)
    try:
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, encoding="utf-8",
                                 errors="replace", start_new_session=True)
    except OSError as error:
        raise _not_found(command[0], error) from error
    _at_work.add(child)
    shown, out = _Shown(child, progress), list[str]()
    ends = [_in_background(shown.read), _in_background(lambda: out.append(child.stdout.read() if child.stdout else ""))]
    interrupted = False
    while True:
        try:
            for end in ends:  # with the program; child.wait() would answer a Ctrl-C late
                end.wait()
            code = child.wait()
            break
        except KeyboardInterrupt:
            if interrupted:  # the second time: at once
                _signal(child, signal.SIGKILL)
                _at_work.discard(child)
                raise Killed from None
            interrupted = True
            _signal(child, signal.SIGINT)
    for pipe in (child.stdout, child.stderr):
        if pipe:
            pipe.close()
    _at_work.discard(child)
    said = shown.said
    if code not in (*codes, 128 + signal.SIGINT, 128 + signal.SIGTERM):
        raise error_of(code, said.faults, said.others, said.remarks) from shown.failed
    said.warn()
    if shown.failed:
        raise shown.failed
    if code in (128 + signal.SIGINT, 128 + signal.SIGTERM):
        raise _stopped(said)
    if interrupted:  # it came to its end meanwhile
        raise KeyboardInterrupt
    return "".join(out), code


_at_work: set["subprocess.Popen[str]"] = set()  # programs that are watched


def stop_all() -> None:
    """Asks all programs that are watched to save and stop, and does not wait for them."""
    for child in tuple(_at_work):
        _signal(child, signal.SIGTERM)


def _signal(child: "subprocess.Popen[str]", number: int) -> None:
    """Sends it to a program and to what this has started, as a terminal does."""
    if child.poll() is None:
        with contextlib.suppress(ProcessLookupError):  # it has ended meanwhile
            os.killpg(child.pid, number)


class Killed(KeyboardInterrupt):
    """A second Ctrl-C has ended a program before it had saved."""


def _in_background(work: Callable[[], None]) -> threading.Event:
    """Does it in another thread. Returns what is set at its end: Python 3.11 takes a thread for ended once a Ctrl-C has hit its join()."""
    end = threading.Event()

    def and_say_so() -> None:
        try:
            work()
        finally:
            end.set()
    threading.Thread(target=and_say_so, daemon=True).start()
    return end


class _Shown:
    """Reads what a program says and shows its progress."""

    def __init__(self, child: "subprocess.Popen[str]", progress: bool | Callable[[Progress], None]) -> None:
        self.said = Said()
        self.failed: BaseException | None = None  # of the caller's function
        self._child, self._progress, self._line = child, progress, False

    def read(self) -> None:
        for line in self._child.stderr or ():
            state = self.said.take(line)
            if state is not None and self.failed is None:
                self._show(state)
        if self._line:
            sys.stderr.write("\n")

    def _show(self, state: Progress) -> None:
        if callable(self._progress):
            try:
                self._progress(state)
            except BaseException as error:  # told to the caller of `watch`; the run is stopped as by Ctrl-C
                self.failed = error
                _signal(self._child, signal.SIGINT)
        elif self._progress:
            try:
                sys.stderr.write(f"\r{state.text}\x1b[K")
                self._line = True
            except (AttributeError, OSError, ValueError):  # there is no standard error, or no more; what the program says has to be read all the same
                self._progress, self._line = False, False


def _stopped(said: Said) -> Stopped:
    stopped = said.stopped or {}
    where = f" {stopped['text']}" if stopped else ""
    error = Stopped(f"the run was stopped{where}; its state is saved, and Run(folder).resume() goes on")
    error.folder, error.time = stopped.get("folder"), stopped.get("time")
    return error


def _command(words: tuple[Word, ...]) -> list[str]:
    texts = [os.fspath(word) if isinstance(word, os.PathLike) else str(word) for word in words]
    for before, text in zip(["", *texts], texts):
        if odd := odd_path(text):
            option = before if before.startswith("-") and before != "--" else None
            said = f"{f'{option}: ' if option else ''}{shown(text)}: {odd}"
            raise InputError(said, [Fault(said, key=option, value=shown(text))])
    return [program(), "--messages", "json", *texts]


def _refuse_no_folder(folder: str | os.PathLike[str] | None) -> None:
    if folder is not None and not os.path.isdir(folder):
        raise FileError(f"{shown(folder)}: is no folder; wanted one for the program to run in")


def _not_found(name: str, error: OSError) -> ProgramNotFound:
    return ProgramNotFound(f"{name}: {error.strerror}; build it (scripts/build), install it, or name it by VOUSSOIR=...")


def version() -> str:
    """The version, as "voussoir 0.1.0 (physics 13)"."""
    return call("--version").strip()


def ready_cases() -> dict[str, str]:
    """Names of the ready cases, with their titles."""
    return {case["name"]: case["title"] for case in json_of("cases")}


def absolute_if_file(path: str | os.PathLike[str]) -> str:
    """The absolute path, if it exists; else the text unchanged, which may be a name known to the program.

    FILE#COMPONENT, for a motion, exists if FILE does.
    """
    if os.path.exists(path):  # false, too, of what cannot be a path
        return str(pathlib.Path(path).resolve())
    file, mark, component = str(path).rpartition("#")
    return f"{pathlib.Path(file).resolve()}#{component}" if mark and os.path.isfile(file) else str(path)
