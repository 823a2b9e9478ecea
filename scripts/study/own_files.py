# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What a study may read: regular files alone, up to a size. A pipe would block, a device never ends. Whatever else is there raises StudyError,
which names it.
"""
import io
import os
import stat

LARGEST = 16 * 2**20  # bytes of a study file, as of a case file
LARGEST_TABLE = 2**30


class StudyError(Exception):
    pass


def bytes_of(path, wanted, most=LARGEST):
    """The bytes of a regular file. wanted: what it should be, for the message."""
    try:
        refuse_irregular(path, os.stat(path).st_mode, wanted)  # before it is opened, which a device may notice
        number = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
        with open(number, "rb") as file:
            is_now = os.fstat(number)
            refuse_irregular(path, is_now.st_mode, wanted)
            if is_now.st_size > most:
                raise StudyError(f"{path}: has {is_now.st_size} bytes; {wanted} may have {most // 2**20} MB")
            data = file.read(most + 1)
    except OSError as error:
        raise StudyError(f"{path}: {error.strerror}; wanted {wanted}") from error
    if len(data) > most:
        raise StudyError(f"{path}: does not end; {wanted} may have {most // 2**20} MB")
    return data


def refuse_irregular(path, mode, wanted):
    if not stat.S_ISREG(mode):
        raise StudyError(f"{path}: is {'a folder' if stat.S_ISDIR(mode) else 'not a regular file'}; wanted {wanted}")


def text_of(path, wanted, most=LARGEST):
    """The text of a regular file, its lines ended by "\\n"."""
    try:
        return io.TextIOWrapper(io.BytesIO(bytes_of(path, wanted, most)), encoding="utf-8").read()
    except ValueError as error:  # of UTF-8
        raise StudyError(f"{path}: {error}; wanted {wanted}") from error
