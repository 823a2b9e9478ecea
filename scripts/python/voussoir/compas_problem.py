# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What a problem of compas_dem says, out of its JSON: blocks, materials, contact law, supports and prescribed displacements, loads."""

import json
import math
import os
import pathlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from .errors import FileError, InputError
from .texts import odd_path, shown

Json = dict[str, Any]

AXES = "xyz"
_STIFFNESSES = {"k_n": "normal_stiffness", "k_t": "shear_stiffness"}
_UNBREAKABLE = 1e13  # Pa: compas_dem has no limit of compression


@dataclass
class Motion:
    """A prescribed motion of a block about its centroid; None: not prescribed."""

    block: str
    translation: list[float | None] = field(default_factory=lambda: [None, None, None])  # m
    rotation: list[float | None] = field(default_factory=lambda: [None, None, None])  # rad, a rotation vector

    @property
    def values(self) -> list[float | None]:
        return self.translation + self.rotation

    def missing(self) -> list[str]:
        """Components that are free, by their names."""
        return [f"{kind} {axis}" for kind, three in (("translation", self.translation), ("rotation", self.rotation))
                for axis, value in zip(AXES, three) if value is None]


class Problem:
    """A problem, model, assembly or list of meshes as `compas.json_dump` wrote it. Names of stones are those that the program gives them."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = pathlib.Path(path)
        try:
            self.root: Any = json.loads(self.path.read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise FileError(f"{shown(self.path)}: {odd_path(self.path) or error}") from error
        self.conditions: Json = next(of_type(self.root, "BoundaryConditions"), {})
        self.material_of_block: dict[str, Json] = {}  # by graph node
        self._names: dict[str, str] = {}
        self._read_blocks()

    def name(self, index: Any) -> str:
        """The stone of a block's index (its node)."""
        return self._names.get(str(index), str(index))

    def names(self) -> list[str]:
        """All stones of the graph."""
        return list(self._names.values())

    def node(self, stone: str) -> int | None:
        """The node of a stone; None: it is not of a graph."""
        return next((int(node) for node, name in self._names.items() if name == stone), None)

    def materials(self) -> list[tuple[Json, list[str]]]:
        """Materials and their stones; no stones: all of them."""
        groups: list[tuple[Json, list[str]]] = []
        for node, material in self.material_of_block.items():
            for known, stones in groups:
                if known == material:
                    stones.append(self.name(node))
                    break
            else:
                groups.append((material, [self.name(node)]))
        if len(groups) > 1:
            return groups
        return [(groups[0][0] if groups else next(of_type(self.root, "Stone"), {}), [])]

    def motions(self) -> list[Motion]:
        """Of blocks with boundary conditions, in the order in which they come."""
        found: dict[str, Motion] = {}
        for entry in self.conditions.get("displacements", []):
            name = self.name(entry["block_index"])
            motion = found.setdefault(name, Motion(name))
            for mine, given in ((motion.translation, entry.get("translation")), (motion.rotation, entry.get("rotation"))):
                for k, value in enumerate(given or []):
                    if value is not None:
                        mine[k] = float(value)
        return list(found.values())

    def friction(self) -> float:
        """Angle of friction, degrees."""
        law = self._law()
        return float(law["phi"]) if law.get("phi") is not None else math.degrees(math.atan(law.get("mu") or 0.6))

    def joint_law(self) -> Json | None:
        """Keys of a joint law, where contacts have cohesion (c, Pa), tension (t_c, Pa) or stiffness (k_n, k_t, Pa/m); None: dry."""
        law = self._law()
        model = next(of_type(self.root, "JointModel"), {})
        given = [name for name in ("kn", "kt") if model.get(name)]
        if given:
            raise InputError(f"{self.path}: joint_model.{given[0]} = {model[given[0]]} N/m is of a whole contact, whatever its area; allowed: k_n and k_t of "
                             "the contact model, in Pa/m")
        stiffness = {ours: float(law[name]) for name, ours in _STIFFNESSES.items() if law.get(name)}
        if len(stiffness) == 1:
            raise InputError(f"{self.path}: contact_model has one of k_n and k_t; allowed: both (Pa/m), or none")
        if not (stiffness or law.get("c") or law.get("t_c")):
            return None
        return {"tension": float(law.get("t_c") or 0.0), "cohesion": float(law.get("c") or 0.0), "friction": self.friction(),
                "compression": _UNBREAKABLE, "cap": 0.0, **stiffness}

    def _law(self) -> Json:
        return next(of_type(self.root, "MohrCoulomb"), {})

    def _read_blocks(self) -> None:
        """As the program names stones: by their own names where all have one and all differ, else by node."""
        model: Json = next(of_type(self.root, "BlockModel"), {})
        elements, materials = model.get("elements") or {}, model.get("materials") or {}
        nodes = (model.get("graph") or {}).get("node") or {}
        names = {}
        for node, attributes in nodes.items():
            element: Json = elements.get(attributes.get("element")) or {}
            data: Json = element.get("data") or {}
            names[node] = data.get("name") or element.get("name") or ""
            material: Json = materials.get(data.get("material")) or {}
            if material.get("data"):
                self.material_of_block[node] = material["data"]
        by_name = all(names.values()) and len(set(names.values())) == len(names)
        self._names = {node: name if by_name else node for node, name in names.items()}


def of_type(root: Any, name: str) -> Iterator[Json]:
    """The data of all objects of a type of COMPAS, in the order of the file."""
    if isinstance(root, dict):
        if str(root.get("dtype", "")).endswith("/" + name):
            yield root.get("data", {})
        for value in root.values():
            yield from of_type(value, name)
    elif isinstance(root, list):
        for value in root:
            yield from of_type(value, name)
