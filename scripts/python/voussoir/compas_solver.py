# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Voussoir as a solver of compas_dem: a problem in, its state of rest out, in the form that compas_dem's own solvers give."""

import contextlib
import importlib
import os
import pathlib
import tempfile
from dataclasses import dataclass
from typing import Any

from .compas import follow_contacts, model_of, solution
from .compas_problem import Problem
from .errors import FileError, NumericalFailure
from .runs import Run

import numpy as np  # isort: skip
from numpy.typing import NDArray  # isort: skip

Array = NDArray[np.float64]

_NAME = "Voussoir"
_LOST = 2.0  # assessment.over of the row at which no further state of rest was found
_SMALL = 1e-9  # of the largest force: round-off


@dataclass(frozen=True)
class Solution:
    """The state of rest of a problem, or the last one that was found.

    status: "equilibrium" (all loads and displacements are on), "partial" (no state of rest beyond `share` of them), "no rest" (none under the weight
    alone, or the run failed: `note` has what the program says, and the Problem is left as it was). share: of loads and prescribed displacements, from 0 to 1. unbalanced: largest unbalanced force over the mean weight of a block.
    blocks: by name, "translation" of the centroid, m, and "transformation", 4 x 4. contacts: the two "blocks", "point", "normal" (out of the first),
    "area", "force" and "moment" about the point (N, N m), which the second exerts on the first. folder: of the run, if it was kept.
    """

    status: str
    share: float
    unbalanced: float
    blocks: dict[str, dict[str, Any]]
    contacts: list[dict[str, Any]]
    folder: pathlib.Path | None
    note: str = ""

    def __repr__(self) -> str:
        return f"Solution({self.status}, {len(self.blocks)} blocks, {len(self.contacts)} contacts, unbalanced {self.unbalanced:.1e})"


def solve(problem: Any, *, folder: str | os.PathLike[str] | None = None, threads: int | None = None, young: float | None = None,
          tolerance: float = 1e-4, unprescribed: str = "refuse", progress: bool = False, **stones: Any) -> Solution:
    """The state of rest of a problem under weights, loads, prescribed displacements and rotations.

    problem: a compas_dem Problem, or a file that `compas.json_dump` wrote. A Problem gets the results as compas_dem's solvers write them: nodes of
    the graph a "transformation"; edges "force" (N, of the first block on the second, in global axes), "force_magnitude", "contact_point",
    "contact_polygon", "contact_data" (a FrictionContact with forces at its corners) and "face_contact". folder: where the run is kept (default: nowhere). young: Pa, in
    place of the Ecm of all stones; needed where they have none. tolerance: largest unbalanced force over the mean weight of a block. unprescribed, stones: as for model_of.

    Raises InputError for what cannot be had; a structure that finds no rest raises nothing: see Solution.status. NumericalFailure: the run ended
    before its end.
    """
    with tempfile.TemporaryDirectory(prefix="voussoir-") as scratch:
        path = problem if isinstance(problem, (str, os.PathLike)) else _written(problem, pathlib.Path(scratch))
        model = model_of(path, young=young, at_rest=True, unprescribed=unprescribed, **stones)
        model["analysis.tolerance"] = tolerance
        follow_contacts(model)
        kept = pathlib.Path(folder) if folder else None
        try:
            run = model.run(folder or pathlib.Path(scratch) / "run", threads=threads, progress=progress)
        except NumericalFailure as error:
            if _rows_of_rest(folder or pathlib.Path(scratch) / "run"):
                raise  # it stood, and the computation failed
            return Solution("no rest", 0.0, np.nan, {}, [], kept, str(error))
        with contextlib.closing(run):
            found = _solution(run, kept)
        if path is not problem:
            _write_into(problem, Problem(path), found)
    return found


def register() -> bool:
    """Makes `Solver.Voussoir(...)` and `problem.solve(solver)` of the installed compas_dem know this solver. False: there is no compas_dem.

    compas_dem has no place for solvers of others, so its Problem.solve is wrapped: solvers with other names go where they went.
    """
    try:
        problems = importlib.import_module("compas_dem.problem")
    except ImportError:
        return False
    if getattr(problems.Solver, _NAME, None) is not None:
        return True
    others = problems.Problem.solve

    def voussoir(cls: Any, **options: Any) -> Any:
        """Voussoir. Options: those of voussoir.compas.solve."""
        solver = cls()
        solver.name, solver.parameters = _NAME, options
        return solver

    def solve_by_name(self: Any, solver: Any) -> Any:
        if solver.name != _NAME:
            return others(self, solver)
        self.check_model_validity()
        return solve(self, **solver.parameters)

    solve_by_name.__doc__ = others.__doc__
    setattr(problems.Solver, _NAME, classmethod(voussoir))
    problems.Problem.solve = solve_by_name
    return True


def _written(problem: Any, folder: pathlib.Path) -> pathlib.Path:
    path = folder / "problem.json"
    importlib.import_module("compas").json_dump(problem, str(path))
    return path


def _solution(run: Run, folder: pathlib.Path | None) -> Solution:
    capacity = run.capacity
    if capacity.get("ended") not in ("all is on", "no further state of rest", "collapse"):
        raise NumericalFailure(f"the run ended before its end: {capacity.get('ended')}")
    rows = run.assessment
    at_rest = np.asarray(rows.time)[np.asarray(rows.over) != _LOST]
    if capacity["ended"] == "collapse":
        at_rest = at_rest[:-1]  # what has fallen rests, too
    if not len(at_rest):
        return Solution("no rest", 0.0, np.nan, {}, [], folder, "it falls under its weight: " + "; ".join(map(str, capacity.get("mechanism_at_end", []))))
    state = solution(run, float(at_rest[-1]))
    status = "equilibrium" if capacity["ended"] == "all is on" else "partial"
    return Solution(status, float(capacity["share"]), float(capacity["unbalanced"]), state["blocks"], state["contacts"], folder)


def _rows_of_rest(folder: str | os.PathLike[str]) -> bool:
    """Whether a run that has failed had found states of rest."""
    try:
        with contextlib.closing(Run(folder)) as run:
            return len(np.asarray(run.assessment.time)) > 0
    except (FileError, AttributeError, KeyError):
        return False


def _write_into(problem: Any, read: Problem, found: Solution) -> None:
    """Into the graph of the problem's model, as compas_dem.analysis does."""
    geometry = importlib.import_module("compas.geometry")
    graph = problem.model.graph
    for name, block in found.blocks.items():
        node = read.node(name)
        if node is not None:
            graph.node_attribute(node, "transformation", geometry.Transformation(matrix=block["transformation"]["data"]["matrix"]))
    for (first, second), (force, moment, point) in pair_forces(found.contacts).items():
        edge, sign = ((read.node(first), read.node(second)), 1.0) if graph.has_edge((read.node(first), read.node(second))) else \
            ((read.node(second), read.node(first)), -1.0)
        if not graph.has_edge(edge):
            graph.add_edge(*edge)
        _write_edge(graph, edge, sign * force, sign * moment, point)


def pair_forces(contacts: list[dict[str, Any]]) -> dict[tuple[str, str], tuple[Array, Array, Array]]:
    """By two stones that touch: force of the first on the second, its moment about the origin, and the middle of where they touch.

    A stone that is not convex is in pieces, each of which may touch the other stone; the base is left out.
    """
    sums: dict[tuple[str, str], list[Any]] = {}
    for contact in contacts:
        first, second = contact["blocks"]
        if first is None or second is None:
            continue
        pair, sign = ((second, first), 1.0) if (second, first) in sums else ((first, second), -1.0)
        force, point = sign * np.array(contact["force"]), np.array(contact["point"])
        moment = sign * np.array(contact["moment"]) + np.cross(point, force)
        entry = sums.setdefault(pair, [np.zeros(3), np.zeros(3), np.zeros(3), 0.0])
        for k, value in enumerate((force, moment, contact["area"] * point, contact["area"])):
            entry[k] = entry[k] + value
    return {pair: (force, moment, place / area) for pair, (force, moment, place, area) in sums.items()}


def _write_edge(graph: Any, edge: tuple[Any, Any], force: Array, moment: Array, point: Array) -> None:
    """force, moment about the origin: of the first block on the second."""
    graph.edge_attribute(edge, "force", force.tolist())
    graph.edge_attribute(edge, "force_magnitude", float(np.linalg.norm(force)))
    faces = graph.edge_attribute(edge, "contacts") or []
    if not faces:
        graph.edge_attribute(edge, "contact_point", [point.tolist()])
        return
    corners = np.array([list(p) for face in faces for p in face.points])
    axes = np.array([[list(face.frame.zaxis), list(face.frame.xaxis), list(face.frame.yaxis)] for face in faces for _ in face.points])
    shares = corner_forces(corners, axes, force, moment)
    kind = getattr(importlib.import_module("compas_dem.interactions"), "FrictionContact")
    at, solved = 0, []
    for face in faces:
        mine = kind(points=face.points, frame=face.frame)
        mine.forces = [{"c_np": max(n, 0.0), "c_nn": max(-n, 0.0), "c_u": u, "c_v": v} for n, u, v in shares[at:at + len(face.points)].tolist()]
        at += len(face.points)
        solved.append(mine)
    largest = max(solved, key=lambda f: sum(c["c_np"] for c in f.forces))
    for name, value in (("contacts", solved), ("contact_data", largest), ("face_contact", True), ("contact_polygon", largest.polygon),
                        ("contact_point", [list(p) for p in largest.points])):
        graph.edge_attribute(edge, name, value)


def corner_forces(corners: Array, axes: Array, force: Array, moment: Array) -> Array:
    """Forces at the corners of contact faces with a given resultant: n x 3, N, along normal and two tangents. Compression is positive.

    corners: n x 3, m. axes: n x 3 x 3, rows normal and two tangents of each corner's face. force, moment: about the origin, N and N m. Of all that have
    the resultant it is the one with the least sum of squares, without tension where that can be had.
    """
    n = len(corners)
    ways = axes.reshape(3 * n, 3)
    arms = np.repeat(corners, 3, axis=0)
    middle = corners.mean(axis=0)
    shift = np.vstack([ways.T, np.cross(arms - middle, ways).T])  # about the middle, which is better conditioned
    wanted = np.concatenate([force, moment - np.cross(middle, force)])
    active = np.ones(3 * n, dtype=bool)
    scale = np.linalg.norm(force) + np.linalg.norm(wanted[3:]) / max(np.ptp(corners, axis=0).max(), 1e-12)
    best = _least(shift, wanted, active)
    forces = best
    for _ in range(n):
        normal = forces[0::3]
        if normal.min() >= -_SMALL * scale:
            return forces.reshape(n, 3)
        corner = int(np.argmin(normal))
        active[3 * corner:3 * corner + 3] = False
        forces = _least(shift, wanted, active)
        if np.linalg.norm(shift @ forces - wanted) > 1e-6 * max(np.linalg.norm(wanted), 1e-300):
            break  # the resultant is not within the faces: tension is needed
    return best.reshape(n, 3)


def _least(matrix: Array, wanted: Array, active: NDArray[np.bool_]) -> Array:
    found = np.zeros(matrix.shape[1])
    found[active] = np.linalg.lstsq(matrix[:, active], wanted, rcond=None)[0]
    return found
