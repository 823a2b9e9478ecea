# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Runs `voussoir limit` on a model and compares what it says with the reference."""
import csv
import dataclasses
import json
import resource
import signal
import subprocess

import numpy

import case_file
from reference import FALLS, MARGINAL, STANDS, UNBOUNDED, UNSURE, Programme, solve, taken

PLANE, SPACE = 1e-6, 1e-4  # relative differences that are allowed
CLOSES, POWER = 1e-8, 1e-5  # of mechanisms, whose velocities are written with twelve digits
SMALL = 1e-3  # differences of multipliers below it are relative to it
AGREES, DISAGREES, OPEN = "agrees", "disagrees", "open"
NO_LIMIT = ("no collapse multiplier in this direction", "beyond what is looked for")
DOES_NOT_STAND = "does not stand under its dead loads alone"


@dataclasses.dataclass
class Outcome:
    kind: str
    verdict: str
    what: str  # in words
    difference: float = 0.0
    refused: bool = False


def run(voussoir, case, *more, seconds=120):
    """`seconds`: of processor time, so that a busy machine makes no answer late."""
    command = [str(voussoir), "limit", str(case), "--format", "json", "--quiet", "-j", "1", *more]
    most = lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=most)
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return subprocess.CompletedProcess(command, -1, "", f"no answer in {seconds} s of processor time")
    return done


def apart(one, other):
    return abs(one - other) / max(abs(other), SMALL)


def bound_of_mechanism(model, result, table):
    """The multiplier at which the power of dead and live forces vanishes for the velocities that the program writes, and the greatest closing
    velocity of a contact relative to the fastest point. The first is an upper bound of the multiplier, if the second is zero."""
    p = Programme(model, plane=result["plane"])
    rows = {row["tag"]: row for row in csv.DictReader(table.read_text().splitlines()) if row["flow"] == "associated"}
    velocities = []
    for i in p.free:
        row = rows[model.blocks[i].name]
        turn = numpy.array([float(row[k]) for k in ("wx", "wy", "wz")]) * p.radii[i]
        velocities += [float(row[k]) for k in ("vx", "vy", "vz")] + list(turn)
    velocities = numpy.array(velocities)
    if p.keep is not None:
        velocities = p.keep @ velocities
    fastest = max(numpy.abs(velocities).max(), 1e-300)
    power = float(p.live @ velocities)
    return ((taken(p, velocities) - float(p.dead @ velocities)) / power if power else numpy.inf), -min(0.0, float((p.matrix.T @ velocities).min())) / fastest


def compare(voussoir, model, case, coulomb=False):
    """Writes the case, runs the program and compares; `coulomb`: also its multiplier of Coulomb friction."""
    case_file.write(model, case)
    answer = solve(model)
    table = case.with_suffix(".csv")
    more = case_file.options(model) + ["--mechanism", str(table), "--overwrite"] + ([] if coulomb else ["--associated"])
    done = run(voussoir, case, *more)
    outcome = judge(model, answer, done, table, coulomb)
    outcome.kind = model.kind
    return outcome, " ".join(done.args)


def judge(model, answer, done, table, coulomb):
    said = done.stderr.strip().splitlines()[-1].split(": ", 2)[-1] if done.stderr.strip() else f"exit code {done.returncode}"
    if answer.verdict in (MARGINAL, UNSURE):
        return Outcome("", OPEN, f"reference: {answer.verdict}")
    if DOES_NOT_STAND in done.stderr:
        if answer.verdict == FALLS:
            return Outcome("", AGREES, "does not stand")
        return Outcome("", DISAGREES, f"does not stand; reference: {answer.verdict}, {answer.multiplier}", numpy.inf)
    if not done.stdout.strip().startswith("{"):
        if answer.verdict == UNBOUNDED and any(words in done.stderr for words in NO_LIMIT):
            return Outcome("", AGREES, "no limit")
        if answer.verdict == UNBOUNDED:
            return Outcome("", OPEN, f"reference: no limit; {said}")
        return Outcome("", DISAGREES, f"refused: {said}; reference: {answer.verdict}, {answer.multiplier}", refused=True)
    result = json.loads(done.stdout)
    multiplier = result["associated"]["multiplier"]
    if answer.verdict != STANDS:
        return Outcome("", DISAGREES, f"multiplier {multiplier}; reference: {answer.verdict}", numpy.inf)
    return judge_numbers(model, answer, result, table, coulomb)


def judge_numbers(model, answer, result, table, coulomb):
    multiplier, allowed = result["associated"]["multiplier"], PLANE if result["plane"] else SPACE
    difference = apart(multiplier, answer.multiplier)
    faults = []
    if difference > allowed:
        faults.append(f"multiplier {multiplier!r}; reference {answer.multiplier!r}, apart by {difference:.1e}")
    bound, closing = (multiplier, 0.0) if model.outlines else bound_of_mechanism(model, result, table)  # the program has cut those otherwise
    if apart(bound, multiplier) > POWER or closing > CLOSES:
        faults.append(f"multiplier {multiplier!r}; its mechanism has {bound!r} and closes contacts by {closing:.1e}")
    if coulomb:
        found = result["coulomb"]["multiplier"]
        if not -1e-9 <= found <= multiplier * (1.0 + 1e-6) + 1e-9:
            faults.append(f"Coulomb's multiplier {found!r}, associated {multiplier!r}, converged: {result['converged']}")
    note = "" if result["plane"] or not model.plane else ", not taken for a plane one"
    return Outcome("", DISAGREES if faults else AGREES, "; ".join(faults) or f"{multiplier:.6f}{note}", difference)
