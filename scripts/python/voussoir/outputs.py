# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Files that the package writes. They replace regular files of their own kind and nothing else: io/README.md, What an output replaces."""

import contextlib
import csv
import os
import pathlib
import re
import secrets
import stat
from collections.abc import Callable, Iterable
from dataclasses import fields
from typing import NamedTuple

from .errors import Fault, FileError
from .texts import odd_path, shown

Path = str | os.PathLike[str]

_HEAD = 4096  # bytes that tell the kind of a file


class Kind(NamedTuple):
    """A kind of file: its name, and whether these are the first bytes of one."""

    name: str
    fits: Callable[[bytes], bool]


def write(path: Path, contents: str | bytes, kind: Kind, *, overwrite: bool = False, inputs: Iterable[Path] = ()) -> pathlib.Path:
    """Writes a whole file, or none, and returns its path. inputs: files that it may not replace. Raises FileError."""
    path = pathlib.Path(path)
    if odd := odd_path(path):
        raise _error(path, odd)
    try:
        data = contents.encode() if isinstance(contents, str) else contents
    except UnicodeEncodeError as error:
        raise _error(path, "cannot be written: its text has half of a pair of surrogates, which is no character") from error
    try:
        _refuse(path, kind, overwrite, inputs)
        temporary = path.with_name(f".voussoir-{secrets.token_hex(8)}.tmp")
        file = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC, 0o666)
        try:
            with open(file, "wb") as stream:
                stream.write(data)
            _refuse(path, kind, overwrite, inputs)  # it may have come meanwhile
            os.replace(temporary, path)
        except BaseException:
            with contextlib.suppress(OSError):
                os.unlink(temporary)
            raise
    except OSError as error:
        missing = isinstance(error, FileNotFoundError) and not path.parent.is_dir()
        raise _error(path, f"cannot be written: {f'there is no folder {shown(path.parent)}' if missing else error.strerror}") from error
    return path


def _refuse(path: pathlib.Path, kind: Kind, overwrite: bool, inputs: Iterable[Path]) -> None:
    """Raises FileError for what may not be replaced; nothing there, and empty files, may."""
    try:
        mode = os.lstat(path).st_mode
    except FileNotFoundError:
        return
    if not stat.S_ISREG(mode):
        raise _error(path, f"is {_odd_kind(mode)}")
    if any(os.path.exists(other) and os.path.samefile(path, other) for other in inputs):
        raise _error(path, "is an input of what is written, which no output replaces; name another file")
    file = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    try:
        head = os.read(file, _HEAD)
    finally:
        os.close(file)
    if (head.strip() or len(head) == _HEAD) and not kind.fits(head):
        raise _error(path, f"is no {kind.name}, and is not replaced by one, with overwrite=True neither; name another file")
    if not overwrite:
        raise _error(path, "exists; overwrite=True replaces it")


def _odd_kind(mode: int) -> str:
    if stat.S_ISLNK(mode):
        return "a symbolic link; outputs neither follow nor replace links: name the file itself"
    if stat.S_ISDIR(mode):
        return "a folder; a file is wanted"
    what = "pipe" if stat.S_ISFIFO(mode) else "socket" if stat.S_ISSOCK(mode) else "device"
    return f"a {what}; outputs replace regular files only"


def _error(path: pathlib.Path, words: str) -> FileError:
    text = f"{shown(path)}: {words}"
    return FileError(text, [Fault(text, file=os.fspath(path))])


# Kinds

def _text_of(head: bytes) -> str:
    """The text without a byte order mark; empty of bytes that are none."""
    return "" if b"\0" in head else head.removeprefix(b"\xef\xbb\xbf").decode("utf-8", "replace")


def _first_line(head: bytes) -> str:
    """The first that is no comment."""
    return next((line for line in map(str.strip, _text_of(head).splitlines()) if line and not line.startswith("#")), "")


def _is_case(head: bytes) -> bool:
    """Whether it begins with a key or a table of a case, and has no others before its first table, as a study file has."""
    from .parts import Case  # here: a large module
    known = {one.name for one in fields(Case)}  # type: ignore[arg-type]
    first = re.match(r"(?:\[\[?\s*)?([A-Za-z0-9_-]+)\s*[=.\]]", _first_line(head))
    keys = re.findall(r"^([A-Za-z0-9_-]+)\s*=", re.split(r"^\[", _text_of(head), maxsplit=1, flags=re.MULTILINE)[0], re.MULTILINE)
    return first is not None and {first[1], *keys} <= known


def _is_table(head: bytes) -> bool:
    """Whether its first two rows have as many columns, two or more. A script is no table, nor is one line that ends a sentence."""
    rows = [row for row in _text_of(head).splitlines(keepends=True) if row.strip() and not row.lstrip().startswith("#")]
    line = rows[0].strip() if rows else ""
    comma, equals = line.find(","), line.find("=")
    if head.startswith(b"#!") or line[:1] in ("<", "{", "[") or comma < 0 or 0 <= equals < comma:
        return False
    if len(rows) == 1 or not rows[1].endswith("\n"):  # the head may end within the second
        return len(rows) > 1 or not line.endswith(".")
    columns = [len(next(csv.reader([row]), [])) for row in rows[:2]]
    return columns[0] == columns[1]


def _is_drawing(head: bytes) -> bool:
    return re.match(r"\s*(<\?xml.*?\?>\s*)?(<!DOCTYPE svg|<svg)", _text_of(head), re.DOTALL) is not None


CASE = Kind("case file (TOML)", _is_case)
TABLE = Kind("table (CSV)", _is_table)
SOLUTION = Kind("solution (JSON) that voussoir.compas.write wrote", lambda head: re.match(r'\{\s*"time":', _text_of(head)) is not None)
NOTE = Kind("note", lambda _: False)
FIGURES = {".png": Kind("picture (PNG)", lambda head: head.startswith(b"\x89PNG")), ".svg": Kind("drawing (SVG)", _is_drawing),
           ".pdf": Kind("document (PDF)", lambda head: head.startswith(b"%PDF"))}
