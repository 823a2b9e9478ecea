# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Are the bytes of a file of results those that were written? The format: io/input/files/sealed_pages.h.

h5py reads through PagedFile, so that it gets only pages that agree with their digests, and only what is read is checked.
"""

import io
import os
import re
import stat
import threading
import zlib
from typing import Any

from .errors import FileError

_HEAD, _PAGE, _PIECE = 512, 4096, 4096 * 256
_HDF5 = b"\x89HDF\r\n\x1a\n"
_WORDS = re.compile(rb"voussoir sealed HDF5 1\n(\d{1,19}) bytes of HDF5 follow this header of 512, then the CRC-32 of each 4096 of them\n"
                    rb"CRC-32 of these ([0-9a-f]{8})\n+\Z")
_last = threading.local()


def take_fault() -> FileError | None:
    """The fault of the last read that failed, if there has been one since the last call: HDF5 passes on no exception, and ignores some."""
    fault: FileError | None = getattr(_last, "fault", None)
    _last.fault = None
    return fault


class PagedFile(io.RawIOBase):
    """A regular file whose pages are checked as they are read; HDF5 of an earlier version, which is not sealed, is read unchecked."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Raises FileError, also for a damaged header."""
        self.name, self._at, self._known = os.fspath(path), 0, set[int]()
        self.seal: str | None = None  # CRC-32 of the digests, as text
        try:
            self._file = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
        except OSError as error:
            raise FileError(f"{self.name}: cannot open: {error.strerror}") from error
        try:
            status = os.fstat(self._file)
            if not stat.S_ISREG(status.st_mode):
                raise FileError(f"{self.name}: is no regular file")
            self._end = status.st_size
            self._read_head(self._bytes(0, min(_HEAD, self._end)))
        except BaseException:
            os.close(self._file)
            raise

    def __repr__(self) -> str:
        """The path, in ASCII: h5py makes it the name of the file (path_of)."""
        return self.name.encode("unicode_escape").decode("ascii")

    def _read_head(self, head: bytes) -> None:
        if head.startswith(_HDF5):
            return
        words = _WORDS.match(head)
        if not words or len(head) != _HEAD:
            raise FileError(f"{self.name}: is no HDF5 file, or its header is damaged")
        size, self._end = self._end, _HEAD + int(words[1])
        pages = -(-int(words[1]) // _PAGE)
        if self._end + 4 * pages != size:
            raise FileError(f"{self.name}: is damaged: it has {size} bytes; {self._end + 4 * pages} were written")
        self._digests = self._bytes(self._end, 4 * pages)
        self.seal = words[2].decode()
        if zlib.crc32(self._digests) != int(self.seal, 16):
            raise FileError(f"{self.name}: is damaged: its digests are not those that were written")

    def _bytes(self, at: int, count: int) -> bytes:
        pieces = []
        while count > 0:
            try:
                piece = os.pread(self._file, count, at)
            except OSError as error:
                raise FileError(f"{self.name}: cannot read: {error.strerror}") from error
            if not piece:
                raise FileError(f"{self.name}: is truncated")
            pieces.append(piece)
            at, count = at + len(piece), count - len(piece)
        return b"".join(pieces)

    def _checked(self, at: int, count: int) -> bytes:
        """Bytes of which the pages are right."""
        if at + count > self._end:
            raise FileError(f"{self.name}: is damaged: it refers to bytes behind its end")
        if self.seal is None or count == 0:
            return self._bytes(at, count)
        if at < _HEAD:  # HDF5 looks for its signature from the first byte on; the header was checked
            head = min(count, _HEAD - at)
            return self._bytes(at, head) + self._checked(at + head, count - head)
        first, last = (at - _HEAD) // _PAGE, (at + count - 1 - _HEAD) // _PAGE
        begin = _HEAD + first * _PAGE
        pages = self._bytes(begin, min(self._end, _HEAD + (last + 1) * _PAGE) - begin)
        for page in range(first, last + 1):
            if page not in self._known:
                self._check(page, pages[(page - first) * _PAGE:(page - first + 1) * _PAGE])
        return pages[at - begin:at - begin + count]

    def _check(self, page: int, contents: bytes) -> None:
        if zlib.crc32(contents) != int.from_bytes(self._digests[4 * page:4 * page + 4], "little"):
            at = _HEAD + page * _PAGE
            raise FileError(f"{self.name}: is damaged: bytes {at} to {at + len(contents) - 1} are not those that were written")
        self._known.add(page)

    def check_all(self) -> None:
        """Checks all pages. Raises FileError."""
        for at in range(_HEAD, self._end, _PIECE):
            self._checked(at, min(_PIECE, self._end - at))

    def readable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def tell(self) -> int:
        return self._at

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        self._at = offset + {os.SEEK_SET: 0, os.SEEK_CUR: self._at, os.SEEK_END: self._end}[whence]
        return self._at

    def readinto(self, buffer: Any) -> int:
        view = memoryview(buffer).cast("B")
        try:
            view[:] = self._checked(self._at, len(view))
        except FileError as fault:
            _last.fault = fault
            raise OSError(str(fault)) from fault
        self._at += len(view)
        return len(view)

    def close(self) -> None:
        if not self.closed:
            os.close(self._file)
        super().close()
