# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Problems of COMPAS (compas_dem, or any assembly in its JSON) in, displacements and contact forces out. COMPAS itself is not needed.

    solution = voussoir.compas.solve(problem)              # a compas_dem Problem, or a file of one: forces and displacements at rest

    model = voussoir.compas.model_of("problem.json")       # or step by step: stones, supports, materials, contact law, loads
    voussoir.compas.follow_contacts(model)                 # the force between every two stones that touch
    run = model.run("results/problem", until=1.0)
    voussoir.compas.write(run, "solution.json")            # compas.json_load reads it
"""

import json
import math
import os
import pathlib
import tempfile
import warnings
from collections.abc import Iterator
from typing import Any

from . import outputs
from .compas_problem import Motion, Problem
from .errors import InputError, ProgramWarning
from .model import Model
from .results import Results, rotation_matrices  # first: says which package is missing

import numpy as np  # isort: skip

__all__ = ["Solution", "follow_contacts", "model_of", "register", "solution", "solve", "write"]

_RAMP = [0.0, 0.5]  # s, of loads that COMPAS calls "ramp"
_HALF = 1e-3  # m, of the box about the middle of two stones, by which their contact is told from others


def model_of(path: str | os.PathLike[str], *, unit: str = "m", young: float | None = None, at_rest: bool = False, unprescribed: str = "refuse",
             **stones: Any) -> Model:
    """A Model from a problem, a model, an assembly or a list of meshes, as written by `compas.json_dump`.

    Used: stones by the numbers of their nodes (or their names, where all differ), supports, materials by block (density, Ecm in MPa, poisson), the
    contact law (angle of friction; c and t_c in Pa, k_n and k_t in Pa/m), gravity, body forces, point loads and surface loads. Without gravity and
    body forces, weight acts all the same, since nothing else would hold an assembly together. Refused by InputError: the stiffness of a joint_model
    (N/m of a whole contact); prescribed displacements other than zero, unless at_rest (those of zero fix a block). Where nothing is said: 2400 kg/m3,
    poisson 0.2, coefficient of friction 0.6.

    young: Pa, in place of Ecm. at_rest: the run finds the state of rest under weights, all loads and all prescribed displacements and rotations
    (analysis.kind = "rest"), in place of time. unprescribed: components of a block's displacement that a problem leaves free beside prescribed ones:
    "refuse", or "hold", as if they were zero. stones: keys of [[stones]], as snap, gap, place.
    """
    problem = Problem(path)
    model = Model(problem.path.stem)
    materials = problem.materials()
    names = [f"stone-{k}" for k in range(len(materials))] if len(materials) > 1 else ["stone"]
    for name, (data, _) in zip(names, materials):
        model.material(name, **_material(problem, data, young))
    model["contact.friction"] = problem.friction()
    law = problem.joint_law()
    if law:
        model.joint_law("contact", **law)
        model["joints.default"] = "contact"
    _add_stones(model, problem, names, [of for _, of in materials], {"unit": unit, **stones}, at_rest, unprescribed)
    model["gravity.acceleration"] = _acceleration(problem)
    for load in _loads(problem):
        if at_rest:
            load = {**{key: value for key, value in load.items() if key != "ramp"}, "grows": True}
        model.load(**load)
    if at_rest:
        model["analysis.kind"], model["segments.rule"] = "rest", "rim"  # hinges at the edges, as rigid blocks have them
    else:
        model["damping.alpha"] = 2.0
    return model


def follow_contacts(model: Model) -> int:
    """Adds a cut for every two stones in contact (and for stones on the base), which records their contact force over time. Returns the number of
    cuts."""
    probe = Model()
    probe.case = json.loads(json.dumps(model.case))
    probe["gravity.settle"], probe["time.duration"], probe["load"], probe["analysis"] = False, 0.0, None, None
    for stones in probe.case.get("stones", []):
        stones.pop("motion", None)
    with tempfile.TemporaryDirectory(prefix="voussoir-") as folder:
        pairs = list(_pairs(probe.run(pathlib.Path(folder) / "run", progress=False)))
    cuts = model.case.setdefault("output", {}).setdefault("cut", [])
    for k, pair in enumerate(pairs):
        cuts.append({"name": f"contact-{k}", "point": pair["point"], "normal": pair["normal"],
                     "box": [[x - _HALF for x in pair["middle"]], [x + _HALF for x in pair["middle"]]]})
    return len(pairs)


def solution(run: Results, time: float | None = None) -> dict[str, Any]:
    """State of the stones at a time, s (default: the last frame): a dict of plain numbers and of COMPAS objects.

    "blocks": by name, "translation" of the centroid, m (to some 1e-8 m: frames are float32), and "transformation" from the initial to the current
    position, a compas.geometry/Transformation. "contacts" (after follow_contacts): the two "blocks" (None: the base), "point" and "normal" (out of the first),
    "area", and "force" and "moment" about the point, N and N m, that the second exerts on the first.
    """
    frame = run.frames[-1] if time is None else run.frames.at(time)
    names, start = [_stone(tag) for tag in run.elements.tag], np.asarray(run.elements.position0, dtype=float)
    moved, turn = np.asarray(frame.displacement, dtype=float), rotation_matrices(frame.quaternion)
    blocks: dict[str, Any] = {}
    for k, name in enumerate(names):
        if name in blocks:
            continue  # a further piece of a stone that is not convex
        matrix = np.eye(4)
        matrix[:3, :3] = turn[k]
        matrix[:3, 3] = moved[k] + start[k] - turn[k] @ start[k]
        blocks[name] = {"translation": moved[k].tolist(),
                        "transformation": {"dtype": "compas.geometry/Transformation", "data": {"matrix": matrix.tolist()}}}
    contacts = []
    if "cuts" in run.file and "contact-0" in run.file["cuts"]:
        cuts = run.file["cuts"]
        row = int(np.argmin(abs(cuts["time"][:] - (frame.time if time is None else time))))
        for k, pair in enumerate(_pairs(run)):
            cut = cuts[f"contact-{k}"]
            contacts.append({"blocks": pair["blocks"], "point": pair["point"], "normal": pair["normal"], "area": pair["area"],
                             "force": cut["force"][row].tolist(), "moment": cut["moment"][row].tolist()})
    return {"time": frame.time, "units": {"length": "m", "force": "N", "time": "s"}, "blocks": blocks, "contacts": contacts}


def write(run: Results, path: str | os.PathLike[str], *, time: float | None = None, overwrite: bool = False) -> pathlib.Path:
    """Writes the solution as a file for `compas.json_load`. overwrite: replace an earlier solution. Raises FileError."""
    return outputs.write(path, json.dumps(solution(run, time), indent=1), outputs.SOLUTION, overwrite=overwrite)


def _stone(tag: str) -> str:
    return tag.split("/")[0]


def _material(problem: Problem, stone: dict[str, Any], young: float | None) -> dict[str, float]:
    if young is None and stone.get("Ecm"):
        young = 1e6 * float(stone["Ecm"])
    if young is None:
        raise InputError(f"{problem.path}: says no modulus (Ecm) of its stones; give young, in Pa")
    return {"density": float(stone.get("density") or 2400.0), "young": float(young), "poisson": float(stone.get("poisson") or 0.2)}


def _add_stones(model: Model, problem: Problem, names: list[str], of_material: list[list[str]], keys: dict[str, Any], at_rest: bool,
                unprescribed: str) -> None:
    """One table of stones for each material, and one for each block that is moved."""
    fixed, moved = [], {}
    for motion in problem.motions():
        if not any(motion.values):
            fixed.append(motion.block)
        elif not at_rest:
            raise InputError(f"{problem.path}: block {motion.block} has a prescribed displacement other than zero; only a state of rest takes it over "
                             "(at_rest=True, or voussoir.compas.solve)")
        else:
            moved[motion.block] = _motion(motion)
        if motion.missing() and unprescribed != "hold":
            raise InputError(f"{problem.path}: block {motion.block} has prescribed components, but these are free: {', '.join(motion.missing())}; "
                             "allowed: all six, or unprescribed=\"hold\", which sets the others to zero")
    if len(names) == 1 and not moved:
        model.add_stones(problem.path, **({"supports": fixed} if fixed else {}), **keys)
        return
    for name, stones in zip(names, of_material):
        stones = stones or list(problem.names())
        still = [stone for stone in stones if stone not in moved]
        if still:
            held = [stone for stone in still if stone in fixed]
            model.add_stones(problem.path, only=still, material=name, **({"supports": held or "none"} if held or moved else {}), **keys)
        for stone in stones:
            if stone in moved:
                model.add_stones(problem.path, only=[stone], material=name, supports=[stone], motion=moved[stone], **keys)


def _motion(motion: Motion) -> dict[str, Any]:
    """Keys of stones.motion."""
    found: dict[str, Any] = {"to": [x or 0.0 for x in motion.translation]}
    if any(motion.rotation):
        found["turn"] = [math.degrees(x or 0.0) for x in motion.rotation]
    return found


def _acceleration(problem: Problem) -> list[float]:
    conditions, total = problem.conditions, np.zeros(3)
    if conditions.get("gravity"):
        total[2] -= float(conditions.get("g") or 9.81)
    for force in conditions.get("body_forces", []):
        total += np.asarray(force, dtype=float)
    if not total.any():
        if conditions:
            warnings.warn(f"{problem.path}: has neither gravity nor body forces; its weight acts, with 9.81 m/s2", ProgramWarning, stacklevel=3)
        total[2] = -9.81
    return [float(x) for x in total]


def _loads(problem: Problem) -> Iterator[dict[str, Any]]:
    for entry in problem.conditions.get("point_loads", []):
        load = {"block": problem.name(entry["block_index"]), "force": entry["force"]}
        for key, value in (("moment", entry.get("moment")), ("at", entry.get("point"))):
            if value is not None:
                load[key] = _point(value)
        yield {**load, "ramp": _RAMP if entry.get("loading_type", "ramp") == "ramp" else [0.0, 0.0]}
    for entry in problem.conditions.get("surface_loads", []):
        polygon = entry["polygon"]
        corners = np.array([_point(p) for p in polygon.get("data", polygon)["points"]])
        area = 0.5 * np.cross(corners - corners[0], np.roll(corners, -1, axis=0) - corners[0]).sum(axis=0)
        way = np.asarray(_point(entry["direction"])) if entry.get("direction") is not None else area / np.linalg.norm(area)
        yield {"block": problem.name(entry["block_index"]), "force": (float(entry["magnitude"]) * np.linalg.norm(area) * way).tolist(),
               "at": _centroid(corners).tolist(), "ramp": _RAMP}


def _point(value: Any) -> list[float]:
    return [float(x) for x in (value["data"] if isinstance(value, dict) else value)]


def _centroid(corners: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    fans = np.cross(corners[1:-1] - corners[0], corners[2:] - corners[0])
    weights = fans @ fans.sum(axis=0)
    middles = (corners[0] + corners[1:-1] + corners[2:]) / 3.0
    centre: np.ndarray[Any, Any] = (weights[:, None] * middles).sum(axis=0) / weights.sum()
    return centre


def _pairs(run: Results) -> Iterator[dict[str, Any]]:
    """Pairs of elements of different stones with a joint between, and the data for their cut; b None: the base."""
    names, start = [_stone(tag) for tag in run.elements.tag], np.asarray(run.elements.position0, dtype=float)
    fixed, joints = np.asarray(run.elements.fixed), run.joints
    a, b, area = joints.element_a, joints.element_b, np.asarray(joints.area, dtype=float)
    centre, normal = np.asarray(joints.centre, dtype=float), np.asarray(joints.normal, dtype=float)
    of_pair: dict[tuple[int, int], list[int]] = {}
    for k in range(len(area)):
        pair = (int(a[k]), int(b[k]))
        if pair[1] >= 0 and (names[pair[0]] == names[pair[1]] or (fixed[pair[0]] and fixed[pair[1]])):
            continue  # pieces of one stone; stones that both stand still
        of_pair.setdefault(pair, []).append(k)
    for (first, second), rows in of_pair.items():
        weight = area[rows] / area[rows].sum()
        largest = rows[int(np.argmax(area[rows]))]
        foot = centre[largest] * [0, 0, 1] + start[first] * [1, 1, 0]
        other = start[second] if second >= 0 else foot
        yield {"blocks": [names[first], names[second] if second >= 0 else None], "point": (weight @ centre[rows]).tolist(),
               "normal": normal[largest].tolist(), "area": float(area[rows].sum()), "middle": (0.5 * (start[first] + other)).tolist()}


def __getattr__(name: str) -> Any:
    if name in ("Solution", "register", "solve"):
        from . import compas_solver
        return getattr(compas_solver, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
