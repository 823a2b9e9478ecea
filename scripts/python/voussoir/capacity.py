# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What a quasi-static analysis has found: a dictionary that can show itself."""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import matplotlib.figure

    from .results import Results


class Capacity(dict[str, Any]):
    """The figures of io/MEASURES.md, Capacity, by name. `unit(name)`: of a figure. A notebook shows the main ones with their curve."""

    def __init__(self, values: Mapping[str, Any], units: str, results: "Results") -> None:
        """units: the attribute of /capacity that tells them, as "peak_shear: N; peak_displacement: m"."""
        super().__init__(values)
        self._results = results
        told = (entry.partition(": ") for entry in units.split("; "))
        self._units = {name: unit for names, _, unit in told for name in names.split(", ")}

    def unit(self, name: str) -> str:
        """As "N", "m (NaN: not reached)" or "1", a number; KeyError for a name without one."""
        return self._units[name]

    @property
    def mechanism(self) -> list[str]:
        """Parts that move as one from the largest load factor on, and what they do."""
        return self._texts("mechanism")

    @property
    def mechanism_at_end(self) -> list[str]:
        """The same at the end."""
        return self._texts("mechanism_at_end")

    def _texts(self, name: str) -> list[str]:
        from .results import array_of
        return [str(text) for text in array_of(self._results._at(f"capacity/{name}"))] if self else []

    def plot(self, **options: Any) -> "matplotlib.figure.Figure":
        """The capacity curve. options: those of plots.capacity."""
        from . import plots
        return plots.capacity([self._results], **options)

    def figures(self) -> list[tuple[str, str]]:
        """The main figures: words, and a value with its unit."""
        texts = [(words, str(self[name])) for name, words in (("kind", "analysis"), ("ended", "ended by")) if name in self]
        return texts + [(words, f"{factor * self[name]:.{digits}f} {unit}".strip()) for name, words, factor, digits, unit in _MAIN
                        if _is_number(self.get(name))]

    def _repr_html_(self) -> str:
        from . import notebook
        return notebook.html_of_capacity(self)


_MAIN = (("multiplier", "largest load factor", 1.0, 4, ""), ("multiplier_at_rest", "of it static", 1.0, 4, ""), ("least_factor", "the other way", 1.0, 4, ""),
         ("peak_shear", "largest base shear", 1e-3, 2, "kN"), ("peak_displacement", "at a displacement of", 1e3, 2, "mm"),
         ("first_stiffness", "first stiffness", 1e-6, 2, "kN/mm"), ("ultimate_displacement", "ultimate displacement", 1e3, 2, "mm"),
         ("ultimate_drift", "ultimate drift", 1e2, 2, "%"), ("near_collapse", "near collapse", 1e3, 2, "mm"),
         ("ec8_ductility", "ductility, EC 8", 1.0, 1, ""), ("ntc_ductility", "ductility, NTC 2018", 1.0, 1, ""),
         ("collapse_movement", "movement of the support at the fall", 1e3, 1, "mm"))


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not math.isnan(value)
