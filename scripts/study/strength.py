# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""How strong the motion of a run is, by its row in a study's table: the level of the study's [intensity], or else the scale of the motion."""

UNITS = {"PGA": "m/s2", "PGV": "m/s", "Sa": "m/s2"}  # of the measures of motion.intensity (io/input/motion/spectra/intensity.h)


def text_of(row):
    """The number as in the table; empty if the strength is that of the case."""
    return row.get("level") or row.get("scale") or ""


def strength_of(row):
    """The strength as a number. Raises ValueError if there is not exactly one."""
    return float(text_of(row))


def unit_of(measure):
    """Unit of a measure by its name in a table: PGA, or Sa(0.3 s)."""
    return UNITS[measure.partition("(")[0]]


def words_of(row):
    """Strength in words: 'PGV = 0.3', 'x0.5'; empty as text_of."""
    if row.get("level"):
        return f"{row['intensity']} = {row['level']}"
    return f"x{row['scale']}" if row.get("scale") else ""


def axis_of(rows):
    """Name and unit of the axis for the strength of these runs. Raises ValueError if the measures of intensity differ."""
    measures = sorted({row.get("intensity") or "" for row in rows})
    if len(measures) > 1:
        raise ValueError(f"runs with different measures of intensity ({', '.join(m or 'none' for m in measures)}); wanted one")
    measure = measures[0] if measures else ""
    return f"{measure}, {unit_of(measure)}" if measure else "scale of the motion"
