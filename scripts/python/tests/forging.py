# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Changed results with a seal that holds, as a forger makes them, and those of a program of before the seals."""

import pathlib
import re
import zlib
from collections.abc import Callable

import h5py

_HEAD, _PAGE = 512, 4096


def contents_of(path: pathlib.Path) -> bytes:
    """The HDF5 in a sealed file."""
    bytes_ = path.read_bytes()
    size = int(re.search(rb"(\d+) bytes of HDF5", bytes_[:_HEAD])[1])
    return bytes_[_HEAD:_HEAD + size]


def sealed(contents: bytes) -> bytes:
    """HDF5 with header and digests (io/input/files/sealed_pages.h)."""
    digests = b"".join(zlib.crc32(contents[at:at + _PAGE]).to_bytes(4, "little") for at in range(0, len(contents), _PAGE))
    head = (f"voussoir sealed HDF5 1\n{len(contents)} bytes of HDF5 follow this header of {_HEAD}, then the CRC-32 of each {_PAGE} of them\n"
            f"CRC-32 of these {zlib.crc32(digests):08x}\n")
    return head.encode().ljust(_HEAD, b"\n") + contents + digests


def forge(right: pathlib.Path, path: pathlib.Path, change: Callable[[h5py.File], None], seal: bool = True) -> None:
    """Writes a file with these results, changed. Without a seal, as of schema 5."""
    path.write_bytes(contents_of(right))
    with h5py.File(path, "r+") as file:
        change(file)
        if not seal:
            file.attrs["schema_version"] = 5
    if seal:
        path.write_bytes(sealed(path.read_bytes()))
