# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Are the bytes of a file of results those that were written? The format: io/input/files/sealed_pages.h.

A whole file is checked before h5py gets it (about 1 s for 1 GB), and once as long as it stays as it is.
"""

import os
import re
import stat
import zlib

from .errors import FileError

_HEAD, _PAGE, _PIECE = 512, 4096, 4096 * 256
_HDF5 = b"\x89HDF\r\n\x1a\n"
_WORDS = re.compile(rb"voussoir sealed HDF5 1\n(\d{1,19}) bytes of HDF5 follow this header of 512, then the CRC-32 of each 4096 of them\n"
                    rb"CRC-32 of these ([0-9a-f]{8})\n+\Z")
_checked: set[tuple[int, int, int, int]] = set()  # device, inode, size, time of change


def check_seal(path: str | os.PathLike[str]) -> bool:
    """Whether a file is sealed; False: it is HDF5 of an earlier version, and not checked. Raises FileError, also for damage."""
    name = os.fspath(path)
    try:
        file = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError as error:
        raise FileError(f"{name}: cannot open: {error.strerror}") from error
    try:
        status = os.fstat(file)
        if not stat.S_ISREG(status.st_mode):
            raise FileError(f"{name}: is no regular file")
        head = _read(file, name, 0, min(_HEAD, status.st_size))
        if head.startswith(_HDF5):
            return False
        known = (status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns)
        if known not in _checked:
            _check_pages(file, name, head, status.st_size)
            _checked.add(known)
        return True
    finally:
        os.close(file)


def _check_pages(file: int, name: str, head: bytes, size: int) -> None:
    words = _WORDS.match(head)
    if not words or len(head) != _HEAD:
        raise FileError(f"{name}: is no HDF5 file, or its header is damaged")
    contents = int(words[1])
    end, pages = _HEAD + contents, -(-contents // _PAGE)
    if end + 4 * pages != size:
        raise FileError(f"{name}: is damaged: it has {size} bytes; {end + 4 * pages} were written")
    digests = _read(file, name, end, 4 * pages)
    if zlib.crc32(digests) != int(words[2], 16):
        raise FileError(f"{name}: is damaged: its digests are not those that were written")
    for at in range(_HEAD, end, _PIECE):
        piece = _read(file, name, at, min(_PIECE, end - at))
        for first in range(0, len(piece), _PAGE):
            page = (at - _HEAD + first) // _PAGE
            if zlib.crc32(piece[first:first + _PAGE]) != int.from_bytes(digests[4 * page:4 * page + 4], "little"):
                raise FileError(f"{name}: is damaged: bytes {at + first} to {min(end, at + first + _PAGE) - 1} are not those that were written")


def _read(file: int, name: str, at: int, count: int) -> bytes:
    pieces = []
    while count > 0:
        try:
            piece = os.pread(file, count, at)
        except OSError as error:
            raise FileError(f"{name}: cannot read: {error.strerror}") from error
        if not piece:
            raise FileError(f"{name}: is truncated")
        pieces.append(piece)
        at, count = at + len(piece), count - len(piece)
    return b"".join(pieces)
