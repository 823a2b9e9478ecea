# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Runs commands on a case and collects what they say, each number with the way in which it transforms."""
import dataclasses
import json
import os
import re
import subprocess

import h5py
import numpy

import data
import limits

# peaks: of each axis by itself; sided: with the sign of right or left
SCALAR, SIDED, VECTOR, AXIAL, PEAKS, COUNT = "scalar", "sided", "vector", "axial", "peaks", "count"
# Dimensions: exponents of mass, length, time.
ONE, LENGTH, TIME, MASS, AREA, VOLUME = (0, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 2, 0), (0, 3, 0)
FORCE, MOMENT, ENERGY, SPEED, ACCELERATION, RATE = (1, 1, -2), (1, 2, -2), (1, 2, -2), (0, 1, -1), (0, 1, -2), (0, 0, -1)
INERTIA, STIFFNESS = (1, 2, 0), (1, 0, -2)


@dataclasses.dataclass
class Value:
    """Numbers of one kind: kind says how they turn, dimension how they scale. `element`, `joint`: the axis that counts these.
    floor: differences are relative to no less than this."""
    data: numpy.ndarray
    kind: str = SCALAR
    dimension: tuple = ONE
    element: int = None
    joint: int = None
    floor: float = 0.0
    group: str = ""  # values of one group are measured by the largest of them: a component may be nothing but round-off


class Refused(Exception):
    pass


def call(voussoir, words, seconds=300):
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    try:
        done = subprocess.run([str(voussoir), *map(str, words)], capture_output=True, text=True, timeout=seconds, env=environment)
    except subprocess.TimeoutExpired:
        raise Refused(f"{words[0]}: no answer in {seconds} s")
    return done


def json_of(done):
    if not done.stdout.strip().startswith("{"):
        said = [line for line in done.stderr.strip().splitlines() if "warning" not in line]
        raise Refused(said[-1] if said else f"exit code {done.returncode}")
    return json.loads(done.stdout)


def check(voussoir, case, path, more):
    said = json_of(call(voussoir, ["check", path, "--format", "json", "-j", more.get("threads", 1)]))
    out = {name: Value(numpy.array(said[name]), COUNT) for name in ("elements", "joints", "base_joints")}
    out |= {"volume": Value(numpy.array(said["volume"]), SCALAR, VOLUME), "mass": Value(numpy.array(said["mass"]), SCALAR, MASS)}
    out |= {"step_bound": Value(numpy.array(said["step_bound"]), SCALAR, TIME), "faults": Value(numpy.array(len(said["faults"])), COUNT)}
    return out


def limit(voussoir, case, path, more):
    direction = ",".join(repr(float(x)) for x in case.live)
    done = call(voussoir, ["limit", path, "--format", "json", "--quiet", "--associated", "--kinematic", "--direction=" + direction, "-j", more.get("threads", 1)])
    for answer in ("does not stand under its dead loads alone", "no collapse multiplier in this direction", "beyond what is looked for"):
        if answer in done.stderr:
            return {"verdict: " + answer: Value(numpy.array(1), COUNT)}
    said = json_of(done)
    proof = said["associated"]["proof"]
    known = max(1e-3, (proof["upper"] - proof["lower"]) / limits.PROGRAMME)  # the program may say that last digits are not proven
    return {"multiplier": Value(numpy.array(said["associated"]["multiplier"]), SCALAR, ONE, floor=known),
            "weight": Value(numpy.array(said["weight"]), SCALAR, FORCE), "points": Value(numpy.array(said["points"]), COUNT)} | kinematics(case, said["associated"]["kinematic"])


KINEMATIC = {"weight": FORCE, "participation": ONE, "displacement_factor": ONE, "activation": ACCELERATION, "zero": LENGTH}


def kinematics(case, k):
    """Of a mechanism that goes on in one way alone."""
    if k["freedoms"] != 1 or k["sliding_seams"] or k["not_found"]:
        return {}
    out = {"kinematic: " + name: Value(numpy.array(k[name]), SCALAR, d) for name, d in KINEMATIC.items() if k[name] is not None}
    shares = numpy.linspace(0.0, 1.0, 11)
    curve = numpy.interp(shares * k["zero_control"], k["curve"]["displacement"], k["curve"]["multiplier"])
    if not case.plan:  # of equal pairs of rafters any may be the one that falls
        out["kinematic: control"] = Value(numpy.array(k["control"]) - case.pivot, VECTOR, LENGTH)
    return out | {"kinematic: curve": Value(curve, SCALAR, ONE, floor=1e-3)}


MODE = re.compile(r"^ +(\d+) +([\d.]+) +([\d.]+) +([\d.]+) +([\d.]+)$", re.MULTILINE)


def modes(voussoir, case, path, more):
    done = call(voussoir, ["modes", path, "--no-impulse", "--closed", "--count", 5, "--quiet", "-j", more.get("threads", 1)])
    rows = MODE.findall(done.stdout.split("Fourier")[0])
    if not rows:
        said = done.stderr.strip().splitlines()
        raise Refused(said[-1] if said else "no modes")
    table = numpy.array([[float(x) for x in row[1:]] for row in rows])
    return {"frequency": Value(table[:, 0], SCALAR, RATE, floor=1e3), "mass in z": Value(table[:, 3], SCALAR, ONE, floor=1e3)}


def run(voussoir, case, path, more):
    folder = path.parent / "run"
    words = ["run", path, "-o", folder, "--overwrite", "--quiet", "-j", more.get("threads", 1), *more.get("run", [])]
    if "stop" in more:
        done = stop_and_resume(voussoir, case, words, folder, more)
    else:
        done = call(voussoir, words)
    said = [line for line in done.stderr.strip().splitlines() if "warning" not in line]
    if not (folder / "run.h5").exists() or done.returncode:
        raise Refused(said[-1] if said else f"exit code {done.returncode}")
    return read(case, folder)


def stop_and_resume(voussoir, case, words, folder, more):
    """A run that ends early, and goes on from its checkpoint to the whole time."""
    early = call(voussoir, words + ["--duration", repr(more["stop"])])
    return early if early.returncode else call(voussoir, ["resume", folder, "--until", repr(case.times["duration"]), "-j", more["resumed by"], "--quiet"])


def read(case, folder):
    """Numbers of run.h5, of summary and of assess."""
    with h5py.File(folder / "run.h5") as f:
        return of_model(case, f) | of_tables(case, f) | of_cracks(f) | of_summary(f)


def of_model(case, f):
    m, origin = f["model/element"], origin_of(f)
    out = {"element position": Value(m["position0"][:] + (origin - case.pivot), VECTOR, LENGTH, element=0, floor=size_of(f))}
    out |= {"element mass": Value(m["mass"][:], SCALAR, MASS, element=0), "element inertia": Value(m["inertia"][:], SCALAR, INERTIA, element=0)}
    out["element segment size"] = Value(m["segment_size"][:], SCALAR, LENGTH, element=0)
    j = f["model/joint"]
    out |= {"joint area": Value(j["area"][:], SCALAR, AREA, joint=0)}
    out["joint centre"] = Value(j["centre"][:] + (origin - case.pivot), VECTOR, LENGTH, joint=0, floor=size_of(f))
    out["joint sides"] = Value(numpy.stack([j["element_a"][:], j["element_b"][:]], axis=1), COUNT, joint=0)
    return out


def origin_of(f):
    return f["model/origin"][:].reshape(3)


def size_of(f):
    return float(numpy.ptp(f["model/vertex"][:], axis=0).max())


# THEORY.md (22a) takes components below 1e-8 out of contact forces, along the axes of the model: DYNAMIC times a hundredth of gravity. What
# this gives in 10 ms is no difference, however small the motion is.
LEAST_SPEED = 0.01 * 9.8 * 0.01  # m/s
LEAST_WAY = 0.5 * LEAST_SPEED * 0.01  # m


def weight_of(f):
    return float(f["model/element/mass"][:][f["model/element/fixed"][:] == 0].sum()) * 9.8


def of_tables(case, f):
    weight = weight_of(f)
    # Displacements are measured by the largest at the last frame, loads by the weight.
    x = f["frames/displacement"][:].astype(float)
    moved = max(float(numpy.abs(x).max()), 1e-12)
    # How fine single precision is beside the size of the model; frames have no more digits.
    out = {"frames: settled": Value(x[0], VECTOR, LENGTH, element=0), "frames: last": Value(x[-1], VECTOR, LENGTH, element=0)}
    for v in out.values():
        v.floor = size_of(f)
    out["frames: broken"] = Value(f["frames/broken"][-1], SCALAR, ONE, element=0, floor=1.0)
    for name in case.points:
        h = f["history"][name]
        out[f"history {name}: displacement"] = Value(h["displacement"][:], VECTOR, LENGTH, group="displacement", floor=LEAST_WAY)
        out[f"history {name}: velocity"] = Value(h["velocity"][:], VECTOR, SPEED, group="velocity", floor=LEAST_SPEED)
        out[f"history {name}: rotation"] = Value(h["rotation"][:], AXIAL, ONE, group="rotation", floor=LEAST_WAY / size_of(f))
    energies = [k for k in f["energy"] if k not in ("time", "residual")]
    for k in energies:
        out[f"energy: {k}"] = Value(f["energy"][k][:], SCALAR, ENERGY, group="energy")
    force, moment = f["forces/base_shear"][:], f["forces/base_moment"][:]
    out["base shear"] = Value(force, VECTOR, FORCE, floor=weight)
    out["base moment"] = Value(moment + numpy.cross(numpy.broadcast_to(origin_of(f) - case.pivot, force.shape), force), AXIAL, MOMENT, floor=weight * size_of(f))
    for name, _, _ in case.cuts:
        out[f"cut {name}: force"] = Value(f["cuts"][name]["force"][:], VECTOR, FORCE, floor=weight)
        out[f"cut {name}: moment"] = Value(f["cuts"][name]["moment"][:], AXIAL, MOMENT, floor=weight * size_of(f))
    if "ties" in f:
        out["ties: force"] = Value(f["ties/force"][:], SCALAR, FORCE, floor=weight)
    if "motion" in f and case.samples is not None:
        out["motion: acceleration"] = Value(f["motion/acceleration"][:], VECTOR, ACCELERATION)
        out["motion: displacement"] = Value(f["motion/displacement"][:], VECTOR, LENGTH)
    for name in ("bonded", "slipped", "tension", "shear", "compression"):
        out[f"damage: {name}"] = Value(f["damage"][name][:], COUNT)
    return out


def of_cracks(f):
    c = f["cracks"]
    n = len(c["time"])
    out = {"cracks": Value(numpy.array(n), COUNT), "cracks: area": Value(numpy.array(c["area"][:].sum()), SCALAR, AREA)}
    if n:
        out["cracks: first"] = Value(numpy.array(c["time"][:].min()), SCALAR, TIME, floor=0.01)
        out["cracks: times"] = Value(numpy.sort(c["time"][:]), SCALAR, TIME, floor=0.01)
    return out


SUMMARY = {"fallen_mass_fraction": ONE, "peak_base_shear": FORCE, "peak_speed": SPEED, "debris_area": AREA, "initial_free_volume": VOLUME, "peak_drift": ONE,
           "residual_drift": ONE, "peak_in_plane_drift": ONE, "free_volume": ONE}


def of_summary(f):
    s = f["summary"].attrs
    out = {}
    for name, dimension in SUMMARY.items():
        if name in s and numpy.isfinite(s[name]):
            out[f"summary: {name}"] = Value(numpy.array(float(s[name])), SCALAR, dimension, floor={ONE: 1.0, SPEED: LEAST_SPEED}.get(dimension, 0.0))
    out |= {f"summary: {name}": Value(numpy.array(int(s[name])), COUNT) for name in ("collapsed", "settled", "damage_grade", "deep_pairs", "touching_pairs")}
    hash_ = s["state_hash"]
    out["bits"] = Value(numpy.array([int(hash_ if isinstance(hash_, str) else hash_.decode(), 16)], dtype=object), COUNT)
    return out


LEAST_FACTOR = 1e-3
CAPACITY = {"multiplier": ONE, "peak_shear": FORCE, "first_stiffness": STIFFNESS}  # a peak may be level, so it has no place


DEMAND = "ec8:1:B:0.2g"
PERFORMANCE = {"force": FORCE, "yield": LENGTH, "target": LENGTH}  # by each method, where they have one


def under_demand(voussoir, folder):
    """What a spectrum asks of a pushover, by each method."""
    said = json_of(call(voussoir, ["assess", folder, "--demand", DEMAND, "--format", "json"]))["capacity"].get("performance")
    if not said:
        return {}
    out = {"demand: participation": Value(numpy.array(said["participation"]), SCALAR, ONE), "demand: mass": Value(numpy.array(said["mass"]), SCALAR, MASS)}
    for method in said["points"]:
        out |= {f"demand: {method['name']}, {k}": Value(numpy.array(method[k]), SCALAR, d) for k, d in PERFORMANCE.items() if method[k] is not None}
        out[f"demand: {method['name']}, not proven"] = Value(numpy.array(len(method["not_proven"])), COUNT)
    return out


def at_rest(f):
    """The last state of rest, if all movements of supports are done and nothing fell: where points are, and what the base bears."""
    a = f["capacity"].attrs
    ended = a["ended"] if isinstance(a["ended"], str) else a["ended"].decode()
    if ended not in ("all is on", "history") or numpy.isfinite(a["collapse_movement"]):
        return {}
    force = f["forces/base_shear"][-1]
    out = {"rest: base": Value(force, VECTOR, FORCE, floor=weight_of(f))}
    for name, history in f["history"].items():
        if name != "time":
            out[f"rest: {name}"] = Value(history["displacement"][-1], VECTOR, LENGTH, group="rest: displacement")
            out[f"rest: {name}, rotation"] = Value(history["rotation"][-1], AXIAL, ONE, group="rest: rotation", floor=LEAST_WAY / size_of(f))
    return out


def of_capacity(f):
    a = f["capacity"].attrs
    if a["fallen_before"] > 0.0 or not a["multiplier"] > LEAST_FACTOR:  # how a heap comes to lie is chance
        return {}
    ended = a["ended"] if isinstance(a["ended"], str) else a["ended"].decode()
    if ended == "largest factor":  # by how much the last step goes beyond it is a matter of the steps
        return {"capacity: first_stiffness": Value(numpy.array(float(a["first_stiffness"])), SCALAR, STIFFNESS)} if numpy.isfinite(a["first_stiffness"]) else {}
    return {f"capacity: {k}": Value(numpy.array(float(a[k])), SCALAR, d) for k, d in CAPACITY.items() if k in a and numpy.isfinite(a[k])}


def assess(voussoir, case, path, more):
    said = json_of(call(voussoir, ["assess", path.parent / "run", "--format", "json"]))
    out = {"weight": Value(numpy.array(said["weight"]), SCALAR, FORCE), "base shear": Value(numpy.array(said["base_shear"]["value"]), SCALAR, FORCE)}
    out["storeys"] = Value(numpy.array(len(said["storeys"])), COUNT)
    if said.get("base_acceleration"):
        out["base acceleration"] = Value(numpy.abs(said["base_acceleration"]), PEAKS, ACCELERATION)
    for point in said["points"]:
        out[f"acceleration {point['name']}"] = Value(numpy.array(point["acceleration"]), PEAKS, ACCELERATION, group="acceleration")
    return out


LOOP_ENERGIES = ("area", "dissipated", "stored", "other_work")


def of_loops(f):
    """A cyclic test that went through all of its cycles: what each loop bore and lost, and where it left the points."""
    a = f["capacity"].attrs
    ended = a["ended"] if isinstance(a["ended"], str) else a["ended"].decode()
    if ended != "history" or a["fallen_before"] > 0.0:
        return {}
    said = f["capacity/loops"].attrs["description"]
    names = (said if isinstance(said, str) else said.decode()).removeprefix("whole cycles: ").split(", ")
    loops = dict(zip(names, f["capacity/loops"][:].T))
    out = {f"cyclic: {k}": Value(loops[k], SCALAR, ONE, group="cyclic: factor", floor=LEAST_FACTOR) for k in ("most_factor", "least_factor")}
    out |= {f"cyclic: {k}": Value(loops[k], SCALAR, LENGTH, group="cyclic: displacement") for k in ("most", "least")}
    out |= {f"cyclic: {k}": Value(loops[k], SCALAR, ENERGY, group="cyclic: energy") for k in LOOP_ENERGIES}
    return out | {"bits": of_summary(f)["bits"]}


def of_kind(kind, f):
    return at_rest(f) if kind in ("rest", "settlement") else of_loops(f) if kind == "cyclic" else of_capacity(f)


def with_growing(case, path):
    """The case of a cyclic test: the same, and the loads that grow."""
    if not case.growing:
        return path
    text = "\n".join(line for load in case.growing for line in data.load_lines(load, grows=True))
    other = path.with_name("capacity.toml")
    other.write_text(path.read_text() + "\n" + text)
    return other


def capacity(voussoir, case, path, more):
    """A pushover, a tilt, a cyclic test or states of rest of the same case, whose keys lie over it."""
    folder = path.parent / "capacity"
    keys = case.capacity | ({"longest": more["stop capacity"]} if "stop capacity" in more else {})
    words = [w for k, v in keys.items() for w in ("--set", f"analysis.{k}={json.dumps(v)}")]
    done = call(voussoir, ["run", with_growing(case, path), "-o", folder, "--overwrite", "--quiet", "-j", more.get("threads", 1), *words])
    if "stop capacity" in more and not done.returncode:
        done = call(voussoir, ["resume", folder, "--until", 300, "-j", more["resumed by"], "--quiet"])
    if done.returncode:
        raise Refused([line for line in done.stderr.strip().splitlines() if "warning" not in line][-1])
    with h5py.File(folder / "run.h5") as f:
        out = of_kind(case.capacity["kind"], f)
    return out | (under_demand(voussoir, folder) if case.capacity["kind"] == "pushover" and len(out) > 1 else {})


COMMANDS = {"check": check, "limit": limit, "modes": modes, "run": run, "assess": assess, "capacity": capacity}
