# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Numbers of the pages that `view` and `report` write, and those that `summary` prints."""
import base64
import json
import re
import zlib

import numpy

import plans
from measure import ACCELERATION, AREA, AXIAL, COUNT, ENERGY, FORCE, LENGTH, ONE, SCALAR, SIDED, SPEED, VECTOR, VOLUME, Refused, Value, call, json_of

ELEMENT = re.compile(r'<script type="[^"]*" id="([a-z0-9-]+)">(.*?)</script>', re.DOTALL)
# What a curve's unit says: how it scales, and how fine the page is.
UNITS = {"m/s²": ACCELERATION, "mm": LENGTH, "%": ONE, "kN": FORCE, "kJ": ENERGY, "J": ENERGY, "m/s": SPEED, "m": LENGTH, "m²": AREA, "m³": VOLUME}


def elements_of(path):
    return dict(ELEMENT.findall(path.read_text(errors="replace")))


def unpacked(text, kind):
    return numpy.frombuffer(zlib.decompress(base64.b64decode(text)), kind)


def places(elements, case):
    """Centroids in the axes of the case. A page has them in single precision, relative to an origin up to 100 m away: off by up to 6 micrometres."""
    origin = numpy.array(json.loads(elements["facts"]).get("origin") or (0.0, 0.0, 0.0))
    centroids = unpacked(elements["centroids"], "<f4").astype(float).reshape(-1, 3) + (origin - case.pivot)
    farthest = float(numpy.abs(unpacked(elements["vertices"], "<f4")).max())
    return Value(centroids, VECTOR, LENGTH, element=0, floor=max(farthest, 3.0))


def view(voussoir, case, path, more):
    page = path.parent / "view.html"
    done = call(voussoir, ["view", path, "-o", page, "--overwrite", "-j", more.get("threads", 1)])
    if done.returncode:
        raise Refused(done.stderr.strip().splitlines()[-1])
    elements = elements_of(page)
    model = json.loads(elements["model"])
    out = {"place": places(elements, case), "faults": Value(numpy.array(len(model["faults"])), COUNT)}
    out["joints by law"] = Value(numpy.array(sorted(law["joints"] for law in model["laws"])), COUNT)
    out["edges"] = Value(numpy.array(len(unpacked(elements["joint-laws"], "u1"))), COUNT)
    out["fixed"] = Value(unpacked(elements["fixed"], "u1"), COUNT, element=0)
    return out


LOADED = "curves: Displacement of loaded places, along the force"


def report(voussoir, case, path, more):
    page = path.parent / "report.html"
    done = call(voussoir, ["report", path.parent / "run", "-o", page, "--overwrite"])
    if done.returncode:
        raise Refused(done.stderr.strip().splitlines()[-1])
    elements = elements_of(page)
    out = {"place": places(elements, case)}
    for plot in json.loads(zlib.decompress(base64.b64decode(elements["curves"]))):
        curves = {plans.side(c["name"]): numpy.array([numpy.nan if y is None else y for y in c["y"]], float) for c in plot["curves"]}
        name, dimension = "curves: " + plot["title"], UNITS.get(plot["unit"])
        if name == LOADED:  # by the numbers of loads, which may be in another order, or two in place of one
            curves = {"largest": numpy.nanmax(numpy.stack(list(curves.values())), axis=0)}
        if {"x", "y"} <= set(curves) <= {"x", "y", "z"}:
            kind = AXIAL if "otation" in name else VECTOR
            out[name] = Value(numpy.stack([curves.get(k, 0.0 * curves["x"]) for k in "xyz"], axis=1), kind, dimension or ONE)
        elif dimension is not None:
            kind = SIDED if plot["title"].startswith("Storey drift") else SCALAR  # to the right, as seen from outside
            out |= {f"{name}, {k}": Value(y, kind, dimension, group=name, floor=1.0 if dimension == ONE else 0.0) for k, y in curves.items()}
    return out


def summary(voussoir, case, path, more):
    said = json_of(call(voussoir, ["summary", path.parent / "run", "--format", "json"]))
    out = {k: Value(numpy.array(said[k]), COUNT) for k in ("collapsed", "settled", "tension", "shear", "compression", "slipped", "damage_grade")}
    numbers = {"peak_base_shear": FORCE, "peak_speed": SPEED, "debris_area": AREA, "initial_free_volume": VOLUME, "free_volume": ONE}
    out |= {k: Value(numpy.array(said[k]), SCALAR, d) for k, d in numbers.items() if said[k] is not None}
    for k in ("peak_drift", "residual_drift", "peak_in_plane_drift", "fallen_mass_fraction"):
        if said[k] is not None:
            out[k] = Value(numpy.array(said[k]), SCALAR, ONE, floor=1.0)
    for wall in said["walls"]:
        for k in ("peak_drift", "peak_in_plane_drift", "crack_extent", "opened_extent"):
            if wall.get(k) is not None:
                out[f"{plans.side(wall['name'])}: {k}"] = Value(numpy.abs(numpy.array(wall[k])), SCALAR, ONE, floor=1.0)
    return out


COMMANDS = {"view": view, "report": report, "summary": summary}
