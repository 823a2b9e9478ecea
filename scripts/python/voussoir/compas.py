# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Problems of COMPAS (compas_dem, or any assembly in its JSON) in, displacements and contact forces out. COMPAS itself is not needed.

    model = voussoir.compas.model_of("problem.json")       # stones, supports, material, friction, loads
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

from .errors import FileError, InputError, ProgramWarning
from .model import Model
from .results import Results, rotation_matrices  # first: says which package is missing

import numpy as np  # isort: skip

_RAMP = [0.0, 0.5]  # s, of loads that COMPAS calls "ramp"
_HALF = 1e-3  # m, of the box about the middle of two stones, by which their contact is told from others


def model_of(path: str | os.PathLike[str], *, unit: str = "m", young: float | None = None, **stones: Any) -> Model:
    """A Model from a problem, a model, an assembly or a list of meshes, as written by `compas.json_dump`.

    Used: stones by the numbers of their nodes (or their names, where all differ), supports, the material (density, Ecm in MPa, poisson), the
    angle of friction, gravity, body forces, point loads and surface loads. Ignored, with a warning: cohesion and stiffnesses of contacts.
    Prescribed displacements other than zero raise InputError. Without gravity and body forces, weight acts all the same, since nothing else would
    hold an assembly together. young: Pa, in place of Ecm. stones: keys of [[stones]], as snap, gap, place.
    """
    path = pathlib.Path(path)
    try:
        root = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise FileError(f"{path}: {error}") from error
    model = Model(path.stem)
    model.material("stone", **_material(path, root, young))
    law = next(_of_type(root, "MohrCoulomb"), {})
    model["contact.friction"] = float(law["phi"]) if law.get("phi") is not None else math.degrees(math.atan(law.get("mu") or 0.6))
    left_out = [key for key in ("c", "t_c", "k_n", "k_t") if law.get(key)]
    if left_out:
        warnings.warn(f"{path}: {', '.join(left_out)} of its contacts play no part: joints are dry, their stiffness comes from the stones (Eq. 3)",
                      ProgramWarning, stacklevel=2)
    conditions = next(_of_type(root, "BoundaryConditions"), {})
    supports = _supports(path, conditions)
    if supports:
        stones.setdefault("supports", supports)
    model.add_stones(path, unit=unit, **stones)
    model["gravity.acceleration"] = _acceleration(path, conditions)
    for load in _loads(conditions):
        model.load(**load)
    model["damping.alpha"] = 2.0
    return model


def follow_contacts(model: Model) -> int:
    """Adds a cut for every two stones in contact (and for stones on the base), which records their contact force over time. Returns the number of
    cuts."""
    probe = Model()
    probe.case = json.loads(json.dumps(model.case))
    probe["gravity.settle"], probe["time.duration"], probe["load"] = False, 0.0, None
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
        row = int(np.argmin(abs(cuts["time"][:] - frame.time)))
        for k, pair in enumerate(_pairs(run)):
            cut = cuts[f"contact-{k}"]
            contacts.append({"blocks": pair["blocks"], "point": pair["point"], "normal": pair["normal"], "area": pair["area"],
                             "force": cut["force"][row].tolist(), "moment": cut["moment"][row].tolist()})
    return {"time": frame.time, "units": {"length": "m", "force": "N", "time": "s"}, "blocks": blocks, "contacts": contacts}


def write(run: Results, path: str | os.PathLike[str], *, time: float | None = None, overwrite: bool = False) -> pathlib.Path:
    """Writes the solution as a file for `compas.json_load`."""
    path = pathlib.Path(path)
    try:
        with open(path, "w" if overwrite else "x", encoding="utf-8") as file:
            json.dump(solution(run, time), file, indent=1)
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from error
    return path


def _stone(tag: str) -> str:
    return tag.split("/")[0]


def _of_type(root: Any, name: str) -> Iterator[dict[str, Any]]:
    """The data of all objects of a type of COMPAS, in the order of the file."""
    if isinstance(root, dict):
        if str(root.get("dtype", "")).endswith("/" + name):
            yield root.get("data", {})
        for value in root.values():
            yield from _of_type(value, name)
    elif isinstance(root, list):
        for value in root:
            yield from _of_type(value, name)


def _material(path: pathlib.Path, root: Any, young: float | None) -> dict[str, float]:
    stone = next(_of_type(root, "Stone"), {})
    if young is None and stone.get("Ecm"):
        young = 1e6 * float(stone["Ecm"])
    if young is None:
        raise InputError(f"{path}: says no modulus (Ecm) of its stones; give young, in Pa")
    return {"density": float(stone.get("density") or 2400.0), "young": float(young), "poisson": float(stone.get("poisson") or 0.2)}


def _supports(path: pathlib.Path, conditions: dict[str, Any]) -> list[str]:
    names = []
    for entry in conditions.get("displacements", []):
        moved = [x for x in (entry.get("translation") or []) + (entry.get("rotation") or []) if x]
        if moved:
            raise InputError(f"{path}: block {entry['block_index']} has a prescribed displacement other than zero, which is not taken over")
        name = str(entry["block_index"])
        if name not in names:
            names.append(name)
    return names


def _acceleration(path: pathlib.Path, conditions: dict[str, Any]) -> list[float]:
    total = np.zeros(3)
    if conditions.get("gravity"):
        total[2] -= float(conditions.get("g") or 9.81)
    for force in conditions.get("body_forces", []):
        total += np.asarray(force, dtype=float)
    if not total.any():
        if conditions:
            warnings.warn(f"{path}: has neither gravity nor body forces; its weight acts, with 9.81 m/s2", ProgramWarning, stacklevel=3)
        total[2] = -9.81
    return [float(x) for x in total]


def _loads(conditions: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for entry in conditions.get("point_loads", []):
        load = {"block": str(entry["block_index"]), "force": entry["force"]}
        for key, value in (("moment", entry.get("moment")), ("at", entry.get("point"))):
            if value is not None:
                load[key] = _point(value)
        yield {**load, "ramp": _RAMP if entry.get("loading_type", "ramp") == "ramp" else [0.0, 0.0]}
    for entry in conditions.get("surface_loads", []):
        polygon = entry["polygon"]
        corners = np.array([_point(p) for p in polygon.get("data", polygon)["points"]])
        area = 0.5 * np.cross(corners - corners[0], np.roll(corners, -1, axis=0) - corners[0]).sum(axis=0)
        way = np.asarray(_point(entry["direction"])) if entry.get("direction") is not None else area / np.linalg.norm(area)
        yield {"block": str(entry["block_index"]), "force": (float(entry["magnitude"]) * np.linalg.norm(area) * way).tolist(),
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
