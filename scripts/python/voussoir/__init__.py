# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Voussoir from Python: cases, runs, results.

    import voussoir

    model = voussoir.Model("A hut", include="flat20w")
    model.house(inner_size=[2.8, 2.0], height=2.0, brick=[0.4, 0.2, 0.2],
                openings=[voussoir.opening("front", start=1.0, width=0.8, height=1.6, lintel={"length": 1.2, "height": 0.2})])
    model.follow("front", [2.4, 0.1, 1.7])
    run = model.run(until=5.0, threads=2)          # Ctrl-C saves and stops; run.resume() goes on
    front = run.history("front")
    print(abs(front.displacement).max(), front.displacement.unit, run.summary["damage_grade"])
    run.plot_histories(show=["front:y"]).savefig("front.png")

scripts/python/README.md tells the rest.
"""

import importlib
from typing import TYPE_CHECKING, Any

from .errors import FileError, InputError, NumericalFailure, ProcessorError, ProgramNotFound, ProgramWarning, Stopped, VoussoirError
from .program import program

if TYPE_CHECKING:
    from . import compas
    from .commands import Progress, call, motion, ready_cases, version
    from .model import Model, opening
    from .results import Array, Frame, Frames, History, Results, Table
    from .run import Run
    from .study import Study

# The rest is imported when it is asked for: results need NumPy and h5py, which take longer to import than most calls of the program.
_MODULES = {"Progress": "commands", "call": "commands", "motion": "commands", "ready_cases": "commands", "version": "commands",
            "Model": "model", "opening": "model", "Run": "run", "Study": "study",
            **dict.fromkeys(("Array", "Frame", "Frames", "History", "Results", "Table"), "results")}
_SUBMODULES = ("compas", "plots")

__all__ = ["Array", "FileError", "Frame", "Frames", "History", "InputError", "Model", "NumericalFailure", "ProcessorError", "Progress",
           "ProgramNotFound", "ProgramWarning", "Results", "Run", "Stopped", "Study", "Table", "VoussoirError", "call", "compas", "motion", "opening", "program",
           "ready_cases", "version"]


def __getattr__(name: str) -> Any:
    module = name if name in _SUBMODULES else _MODULES.get(name)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = importlib.import_module(f".{module}", __name__)
    value = found if name in _SUBMODULES else getattr(found, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*__all__, *_SUBMODULES})
