# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Writes TOML. Python's own tomllib only reads it. Numbers keep all their digits."""

import contextlib
import json
import math
import pathlib
import re
from collections.abc import Iterator, Mapping
from typing import Any

from .texts import odd_text, shown

class NotWritable(ValueError):
    """A value that TOML cannot hold. key: its path, where that is known."""

    key: str | None = None


_BARE = re.compile(r"[A-Za-z0-9_-]+")


def key_text(key: str) -> str:
    """A key as TOML text: bare if possible, else quoted."""
    return key if _BARE.fullmatch(key) else _string(key)


def value_text(value: Any) -> str:
    """A value as TOML text for "=" and `--set KEY=`: numbers, texts, lists, tables in a line, and NumPy equivalents.

    Raises TypeError for other types, NotWritable for numbers that are not finite and texts that no case can hold.
    """
    if hasattr(value, "tolist"):  # an array or a number of NumPy, which need not be there
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            raise NotWritable(f"{value} is not a finite number")
        return repr(value)
    if isinstance(value, (str, pathlib.PurePath)):
        return _string(str(value))
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(value_text, value)) + "]"
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key_text(key)} = {value_text(inner)}" for key, inner in value.items()) + " }"
    raise TypeError(f"a case cannot hold {value!r}")


def document(table: Mapping[str, Any]) -> str:
    """A whole file: tables as [sections], lists of tables as [[sections]]."""
    return "\n".join(_lines(table, "")).lstrip("\n") + "\n"


def _string(text: str) -> str:
    if odd := odd_text(text):
        raise NotWritable(f"{ascii(text)} {odd}")
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


@contextlib.contextmanager
def _naming(key: str) -> Iterator[None]:
    """Puts the key before what cannot be written."""
    try:
        yield
    except NotWritable as error:
        named = NotWritable(f"{shown(key)}: {error}")
        named.key = shown(key)
        raise named from error


def _is_tables(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and bool(value) and all(isinstance(v, Mapping) for v in value)


def _lines(table: Mapping[str, Any], path: str) -> list[str]:
    lines, later = [], []
    for key, value in table.items():
        with _naming(path + key):
            name = path + key_text(key)
        if isinstance(value, Mapping):
            later += ["", f"[{name}]", *_lines(value, name + ".")]
        elif _is_tables(value):
            for inner in value:
                later += ["", f"[[{name}]]", *_lines(inner, name + ".")]
        elif value is not None:
            with _naming(name):
                lines.append(f"{key_text(key)} = {value_text(value)}")
    return lines + later
