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

from .errors import (Fault, FileError, InputError, NumericalFailure, ProcessorError, ProgramNotFound, ProgramWarning, Stopped,
                     VoussoirError)
from .program import program

if TYPE_CHECKING:
    from . import compas, parts
    from .answers import (Assessed, BillLine, Checked, Compared, Crack, Limit, Mode, Modes, MotionFigures, Part, Peak, Storey,
                          StudyTable)
    from .commands import call, ready_cases, version
    from .functions import assess, check, compare, limit, modes, motion, resume, run, study, summary, view
    from .messages import Progress
    from .model import Model, opening
    from .results import Array, Frame, Frames, History, Results, Table
    from .runs import Run
    from .studies import Study

API = "1.0"  # what API.md promises

# The rest is imported when it is asked for: results need NumPy and h5py, which take longer to import than most calls of the program.
_MODULES = {"Progress": "messages", "Model": "model", "opening": "model", "Run": "runs", "Study": "studies",
            **dict.fromkeys(("call", "ready_cases", "version"), "commands"),
            **dict.fromkeys(("assess", "check", "compare", "limit", "modes", "motion", "resume", "run", "study", "summary", "view"), "functions"),
            **dict.fromkeys(("Assessed", "BillLine", "Checked", "Compared", "Crack", "Limit", "Mode", "Modes", "MotionFigures", "Part", "Peak", "Storey",
                             "StudyTable"), "answers"),
            **dict.fromkeys(("Array", "Frame", "Frames", "History", "Results", "Table"), "results")}
_SUBMODULES = ("compas", "parts", "plots")

__all__ = ["API", "Array", "Assessed", "BillLine", "Checked", "Compared", "Crack", "Fault", "FileError", "Frame", "Frames", "History", "InputError",
           "Limit", "Mode", "Model", "Modes", "MotionFigures", "NumericalFailure", "Part", "Peak", "ProcessorError", "Progress", "ProgramNotFound",
           "ProgramWarning", "Results", "Run", "Stopped", "Storey", "Study", "StudyTable", "Table", "VoussoirError", "assess", "call", "check",
           "compare", "compas", "limit", "modes", "motion", "opening", "parts", "program", "ready_cases", "resume", "run", "study", "summary",
           "version", "view"]


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
