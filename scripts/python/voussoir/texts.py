# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Texts that nothing can hold, and how messages show what they name."""

import os
from typing import Any

_ZERO, _HALF = "has the character of number zero", "has half of a pair of surrogates, which is no character"


def odd_text(text: str) -> str:
    """What a case file cannot hold of a text, in words; empty: it can hold it."""
    return _ZERO if "\0" in text else _HALF if any("\ud800" <= c <= "\udfff" for c in text) else ""


def odd_path(path: Any) -> str:
    """Why there is no such path or word of a command line, in words; empty: there may be."""
    text = os.fspath(path) if isinstance(path, os.PathLike) else str(path)
    if "\0" in text:
        return _ZERO
    try:
        os.fsencode(text)
    except UnicodeEncodeError:
        return _HALF
    return ""


def shown(path: Any) -> str:
    """A path for a message: in ASCII if it has what cannot be printed."""
    text = os.fspath(path) if isinstance(path, os.PathLike) else str(path)
    return text if text.isprintable() else ascii(text)
