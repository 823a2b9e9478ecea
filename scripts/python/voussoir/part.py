# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What the classes of parts.py share: a table of the case file as an object."""

import copy
import keyword
from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import Any, ClassVar


class Part:
    """A table of the case file. Its arguments are the keys; one that is None is not written."""

    __slots__ = ()
    _table: ClassVar[str] = ""  # as "house.opening"; of tables by name without the name
    _array: ClassVar[bool] = False  # may stand several times
    _by_name: ClassVar[bool] = False

    def keys(self) -> dict[str, Any]:
        """The keys that are given, by the words of the case file, with tables as dicts."""
        given = {word_of(one.name): _plain(getattr(self, one.name)) for one in fields(self)}  # type: ignore[arg-type]
        return {key: value for key, value in given.items() if value is not None}

    def put_into(self, case: dict[str, Any], prepared: Callable[[str, Any], Any]) -> None:
        """Puts it where it belongs in a case. prepared: what is done to a value, by its path."""
        *tables, last = self._table.split(".") if self._table else [""]
        if self._by_name:
            raise TypeError(f"{type(self).__name__} needs a name: Case({self._table}={{\"NAME\": {type(self).__name__}(...)}})")
        keys = copy.deepcopy(self.keys())
        table, value = case, prepared(self._table, keys) if last else {key: prepared(key, inner) for key, inner in keys.items()}
        for name in tables:
            table = table.setdefault(name, {})
            if not isinstance(table, dict):
                raise TypeError(f"{type(self).__name__} belongs in one of several [[{name}]]: give it to that as an argument")
        if self._array:
            table.setdefault(last, []).append(value)
        else:
            _lay_over(value, table.setdefault(last, {}) if last else table)


def word_of(name: str) -> str:
    """The key of a field: those that are words of Python, as from_ and yield_, end in "_"."""
    return name[:-1] if name.endswith("_") and keyword.iskeyword(name[:-1]) else name


def _plain(value: Any) -> Any:
    if isinstance(value, Part):
        return value.keys()
    if isinstance(value, Mapping):
        return {key: _plain(inner) for key, inner in value.items()}
    return [_plain(inner) for inner in value] if isinstance(value, (list, tuple)) else value


def _lay_over(top: Mapping[str, Any], under: dict[str, Any]) -> None:
    """Tables key by key; arrays of tables behind those that are there; all else in place of it."""
    for key, value in top.items():
        there = under.get(key)
        if isinstance(value, Mapping) and isinstance(there, dict):
            _lay_over(value, there)
        elif isinstance(there, list) and isinstance(value, list) and value and all(isinstance(one, Mapping) for one in [*there, *value]):
            there.extend(value)
        else:
            under[key] = value
