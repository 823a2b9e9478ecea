# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Opening run.h5 and its parts, and reading rows of them: only what was written, of this run, and makes sense."""

import contextlib
import fcntl
import os
import pathlib
import re
import warnings
from collections.abc import Iterator
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from . import rules
from .errors import FileError, ProgramWarning, VoussoirError
from .sealed import PagedFile, take_fault
from .texts import shown

SCHEMA, OLDEST_SCHEMA, SEALED_SCHEMA = 6, 4, 6  # the newest and the oldest layout of run.h5 that is known; the first whose files are sealed
_PART = re.compile(r"parts/\d+\.h5")
_DEEPEST = 16  # groups in each other; results have three


class NoData(FileError, KeyError, AttributeError):
    """A group, column or attribute that results do not have."""

    __str__ = Exception.__str__


@contextlib.contextmanager
def reading(what: str) -> Iterator[None]:
    """Makes every error of h5py a FileError, and every fault of a read that h5py has not told."""
    take_fault()
    try:
        yield
    except VoussoirError:
        raise
    except KeyError as error:
        raise take_fault() or NoData(f"{what}: {error.args[0] if error.args else error}") from error
    except (OSError, RuntimeError, ValueError, TypeError, MemoryError, UnicodeError, OverflowError, SystemError, AttributeError, IndexError) as error:
        raise take_fault() or FileError(f"{what}: cannot be read: {error}") from error
    if fault := take_fault():
        raise fault


def path_of(thing: Any) -> pathlib.Path:
    """The path of the file that a group or dataset is in. Raises FileError where that was closed."""
    try:
        file = thing.file
        name = str(file.filename)
    except (ValueError, RuntimeError, AttributeError) as error:
        raise FileError("the run.h5 that this was taken from was closed since; take it from the run again") from error
    return pathlib.Path(name.encode("ascii").decode("unicode_escape") if file.driver == "fileobj" else name)


def stamp_of(path: str | os.PathLike[str]) -> tuple[int, ...] | None:
    """What tells the run.h5 of a run, given as for open_paged, from another one in its place; None: there is none."""
    for name in (os.path.join(path, "run.h5"), path):
        with contextlib.suppress(OSError, ValueError):
            found = os.stat(name)
            return found.st_dev, found.st_ino, found.st_size, found.st_mtime_ns
    return None


def open_paged(path: str | os.PathLike[str]) -> h5py.File:
    """Opens the run.h5 of a run, given as its folder or as the file: what is read later is checked then. Raises FileError."""
    path = pathlib.Path(path)
    path = path / "run.h5" if os.path.isdir(path) else path
    if not os.path.exists(path):  # false, too, of what cannot be a path
        raise FileError(f"{shown(path)}: no such file; wanted the folder of a run, or its run.h5")
    file, pages = _open(path)
    try:
        _check_layout(file, path, pages.seal is not None)
    except BaseException:
        file.close()
        raise
    return file


def open_results(path: str | os.PathLike[str]) -> h5py.File:
    """As open_paged, for reading with h5py alone: all of the file is checked at once. Raises FileError."""
    file = open_paged(path)
    found = path_of(file)
    file.close()
    pages = PagedFile(found)
    pages.check_all()
    pages.close()
    with reading(str(found)):
        return h5py.File(found, "r")


def _open(path: pathlib.Path) -> tuple[h5py.File, PagedFile]:
    pages = PagedFile(path)
    try:
        with reading(str(path)):
            return h5py.File(pages, "r"), pages
    except BaseException:
        pages.close()
        raise


def _check_layout(file: h5py.File, path: pathlib.Path, sealed: bool) -> None:
    with reading(str(path)):
        known, version = file.attrs.get("format"), int(file.attrs.get("schema_version", 0))
    if known != "voussoir results":
        raise FileError(f"{path}: holds no results of Voussoir")
    if version > SCHEMA:
        raise FileError(f"{path}: has schema_version {version}; this package reads up to {SCHEMA}: a later program wrote it")
    if version < OLDEST_SCHEMA:
        raise FileError(f"{path}: has schema_version {version}; this package reads from {OLDEST_SCHEMA} on: a program of before 28 November 2026 wrote it")
    if version >= SEALED_SCHEMA and not sealed:
        raise FileError(f"{path}: is damaged: it has lost its seal")
    if not sealed:
        warnings.warn(f"{path}: not sealed (schema {version}): damage to it may stay unnoticed", ProgramWarning, stacklevel=4)
    datasets: list[str] = []
    with reading(str(path)), _naming(path):
        _walk(file, "/", {}, datasets, 0)
        for name in datasets:
            rules.check_shape(file, name)
        rules.check_counts(file)


@contextlib.contextmanager
def _naming(path: pathlib.Path) -> Iterator[None]:
    """Puts the path before errors that do not name it."""
    try:
        yield
    except FileError as error:
        raise error if str(error).startswith(str(path)) else FileError(f"{path}: {error}") from error


def _walk(file: h5py.File, name: str, known: dict[int, str], datasets: list[str], depth: int) -> None:
    """Looks at all objects. In the order that the file has them in: where HDF5 1.10 sorts names and cannot read all, it crashes."""
    if depth > _DEEPEST:
        raise FileError(f"{name} is deeper than {_DEEPEST} groups")
    found = h5py.h5o.open(file.id, name.encode())
    address = h5py.h5o.get_info(found).addr
    if address in known:
        raise FileError(f"{name} is the same object as {known[address]}; results have one name for each")
    known[address] = name
    h5py.h5a.iterate(found, lambda _: None, index_type=h5py.h5.INDEX_NAME, order=h5py.h5.ITER_NATIVE)
    if isinstance(found, h5py.h5d.DatasetID):
        if found.get_create_plist().get_external_count() != 0:
            raise FileError(f"{name} has its values in another file; not followed")
        datasets.append(name)
    elif isinstance(found, h5py.h5g.GroupID):
        links: list[bytes] = []
        found.links.iterate(links.append, idx_type=h5py.h5.INDEX_NAME, order=h5py.h5.ITER_NATIVE)
        for link in sorted(links):
            inner, kind = f"{name.rstrip('/')}/{link.decode()}", found.links.get_info(link).type
            if kind != h5py.h5l.TYPE_HARD:
                what = "a soft link" if kind == h5py.h5l.TYPE_SOFT else "a link to another file"
                raise FileError(f"{inner} is {what}; not followed")
            _walk(file, inner, known, datasets, depth + 1)
    else:
        raise FileError(f"{name} is neither a group nor a dataset")


def parts_of(file: h5py.File) -> dict[str, str]:
    """The parts that a file names, with their seals; none if it has all rows itself."""
    words = str(file.attrs.get("part_seals", "")).split()
    return dict(zip(words[::2], words[1::2], strict=False))


def missing_parts(file: h5py.File) -> list[str]:
    """Parts that a file names and that are not beside it."""
    return [name for name in parts_of(file) if not (path_of(file).parent / name).exists()]


def state_of(file: h5py.File) -> tuple[str, str]:
    """(finished, lost, goes on, stopped or unknown; what to know of rows that may come yet)."""
    path = path_of(file)
    if "summary" not in file:
        return "unknown", "whether the run goes on is not known"
    with reading(f"{path}, summary"):
        summary, provenance = file["summary"].attrs, file["provenance"].attrs if "provenance" in file else {}
        if summary["finished"]:
            return "finished", ""
        if "failure" in summary:
            return "lost", ""
        rows = f"rows written until {provenance['written']}" if "written" in provenance else "rows written so far"
    holder = _holder_of(path.parent)
    if holder is None:
        return "unknown", f"{rows}; a copy, the run may go on elsewhere"
    if not holder:
        return "stopped", f"{rows}; the run was stopped or killed, and Run(folder).resume() goes on with it"
    return "goes on", f"{rows}; the run goes on ({holder})"


def _holder_of(folder: pathlib.Path) -> str | None:
    """The process that holds the folder of a run, in words; empty: none does. None: there is no lock of a run, as in a copy."""
    try:
        lock = os.open(folder / ".lock", os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:
        return None
    try:
        text = os.pread(lock, 32, 0).decode("ascii", "replace").strip()
        if text and not text.isdigit():
            return None
        fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
        return ""
    except BlockingIOError:
        return f"process {text}" if text else "another process"
    except OSError:
        return None
    finally:
        os.close(lock)


def rows_of(dataset: h5py.Dataset, rows: Any = ()) -> NDArray[Any]:
    """Values of a dataset: all, a row, or a slice of rows. Rows in parts are read from there; HDF5 itself would give NaN for those it cannot
    read. Raises FileError, also for numbers that make no sense."""
    path = path_of(dataset)
    with reading(f"{path}, {dataset.name}"), _naming(path):
        if not dataset.shape or dataset.shape[0] == 0:
            _check_size(dataset)
            whole: NDArray[Any] = np.asarray(dataset[()])
            return whole
        count = dataset.shape[0]
        wanted = slice(None) if isinstance(rows, tuple) else rows
        first, last = (range(count)[wanted], range(count)[wanted] + 1) if not isinstance(wanted, slice) else _extent(range(count)[wanted])
        values = _between(dataset, first, last)
        rules.check_values(dataset.file, dataset.name, first, values)
        if not isinstance(wanted, slice):
            row: NDArray[Any] = values[0]
            return row
        taken: NDArray[Any] = values[np.array(range(count)[wanted], dtype=int) - first]
        return taken


def _extent(rows: range) -> tuple[int, int]:
    return (min(rows), max(rows) + 1) if rows else (0, 0)


def _check_size(dataset: h5py.Dataset) -> None:
    if dataset.external:
        raise FileError(f"{dataset.name} has its values in another file; not followed")
    if dataset.nbytes > dataset.id.get_storage_size():
        raise FileError(f"{dataset.name} claims {dataset.nbytes} bytes; the file has fewer")


def _between(dataset: h5py.Dataset, first: int, last: int) -> NDArray[Any]:
    """Rows [first, last)."""
    if not dataset.is_virtual:
        _check_size(dataset)
        plain: NDArray[Any] = dataset[first:last]
        return plain
    pieces, row = [np.empty((0, *dataset.shape[1:]), dataset.dtype)], 0
    for source in dataset.virtual_sources():
        if not _PART.fullmatch(source.file_name) or source.dset_name.replace("%%", "%") != dataset.name:  # % begins a format there
            raise FileError(f"{dataset.name} refers to {source.file_name}; only parts/NNNN.h5 in the same folder are read")
        begin, end = source.vspace.get_select_bounds()
        if begin[0] != row:
            raise FileError(f"{dataset.name} has rows out of order")
        row = end[0] + 1
        if begin[0] < last and row > first:
            pieces.append(_piece(dataset, source.file_name, max(first, begin[0]) - begin[0], min(last, row) - begin[0]))
    if row != dataset.shape[0]:
        raise FileError(f"{dataset.name} has rows that are in no file")
    return np.concatenate(pieces)


def _piece(dataset: h5py.Dataset, part: str, first: int, last: int) -> NDArray[Any]:
    """Rows [first, last) of a part."""
    path = path_of(dataset).parent / part
    if not path.exists():
        named = parts_of(dataset.file)
        gone = f" ({len(missing_parts(dataset.file))} of {len(named)} parts are)" if named else ""
        raise FileError(f"{path}: is missing{gone}. Rows of a run that has not ended are in parts/ beside run.h5, and a copy needs them; "
                        "if the run has gone on or ended since, take this table from the run again")
    file, pages = _open(path)
    try:
        if pages.seal is None and int(dataset.file.attrs["schema_version"]) >= SEALED_SCHEMA:
            raise FileError(f"{path}: is damaged: it has lost its seal")
        wanted = parts_of(dataset.file).get(part, pages.seal)
        if wanted != pages.seal:
            raise FileError(f"{path}: is not the part that {path_of(dataset)} was written with (its seal is {pages.seal}, that of the part "
                            f"{wanted}): it is of another run, or of another time of this one")
        with reading(f"{path}, {dataset.name}"):
            rows = file[dataset.name]
            if rows.is_virtual or rows.shape[1:] != dataset.shape[1:] or rows.shape[0] < last:
                raise FileError(f"{path}: {dataset.name} has not the rows that {path_of(dataset)} names")
            return _between(rows, first, last)
    finally:
        file.close()
        pages.close()
