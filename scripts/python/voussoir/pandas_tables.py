# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of results as data frames. pandas is imported here alone, when one is asked for."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas

    from .results import Table


def frame_of(table: "Table") -> "pandas.DataFrame":
    """A row each, `time` as the index where there is one; `attrs["units"]` has the unit of each column.

    Columns of vectors become name_x, name_y, name_z; of other rows of numbers name_0, name_1, ... Raises ImportError without pandas.
    """
    pandas = imported()
    columns: dict[str, Any] = {}
    units: dict[str, str] = {}
    for name in table:
        values = table[name]
        for column, numbers in _parts(name, values):
            columns[column], units[column] = numbers, values.unit
    frame = pandas.DataFrame(columns)
    frame = frame.set_index("time") if "time" in columns else frame
    frame.attrs["units"] = units
    return frame


def frame_of_rows(rows: Sequence[Mapping[str, Any]]) -> "pandas.DataFrame":
    """A data frame of dictionaries. Raises ImportError without pandas."""
    return imported().DataFrame(list(rows))


def imported() -> Any:
    """The module pandas."""
    try:
        import pandas  # type: ignore[import-untyped, unused-ignore]
    except ModuleNotFoundError as missing:
        raise ImportError("data frames need pandas: pip install \"voussoir[notebooks]\", or Debian's python3-pandas") from missing
    return pandas


def _parts(name: str, values: Any) -> Iterator[tuple[str, Any]]:
    """A column of numbers, or the columns of an array with more dimensions."""
    if values.ndim < 2:
        yield name, values.tolist() if values.dtype == object else values.view(type=_plain())
        return
    letters = "xyz" if values.shape[1] == 3 else "wxyz" if values.shape[1] == 4 and name == "quaternion" else range(values.shape[1])
    for k, letter in enumerate(letters):
        yield from _parts(f"{name}_{letter}", values[:, k])


def _plain() -> type:
    import numpy
    return numpy.ndarray
