# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A study file and the runs it stands for: one for each combination of case, direction, record, scale or level of intensity, options and
seed.

Whatever is wrong with the file raises StudyError before anything runs; the message names file, key, value and what is allowed.
"""
import collections
import csv
import difflib
import hashlib
import io
import itertools
import json
import math
import os
import pathlib
import re
import subprocess
import sys
from concurrent import futures

import own_files
from own_files import StudyError
from strength import UNITS
from versions import differs, results_of

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "python/voussoir"))  # its module alone: the package needs more
import toml_reading  # noqa: E402

DIRECTIONS = ("LTV", "LVT", "TLV", "TVL", "VLT", "VTL")
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.+]*")
MOST_RUNS = 50_000  # of one study
PLOTS = ("plots/damage_grade.svg", "plots/fallen_mass_fraction.svg", "plots/first_crack_time.svg", "plots/peak_base_shear.svg")
ENVIRONMENT = re.compile(r"\$\{(\w+)\}")


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= sys.float_info.max  # a large integer is no float


def is_positive(value):
    return is_number(value) and value > 0


def is_time(value):
    return is_number(value) and value >= 0


def is_count(value):
    return isinstance(value, int) and not isinstance(value, bool) and value >= 1


def is_text(value):
    """Also a path, or a word on a command line: without the character of number zero, which ends these."""
    return isinstance(value, str) and value != "" and "\0" not in value


def is_override(value):
    return is_text(value) and re.match(r"[^=]+=", value) is not None


def is_scale(value):
    return is_number(value) or (isinstance(value, list) and len(value) == 3 and all(map(is_number, value)))


COMPONENTS = ("each", "geometric mean", "RotD50", "larger")  # of motion.intensity.components
INTENSITY = ('a table [intensity]: measure = "PGA" (m/s2), "PGV" (m/s) or "Sa" (m/s2), of Sa also period = a number > 0 (s), '
             "levels = [numbers > 0], each once; components = " + " | ".join(map(json.dumps, COMPONENTS)) + " (default: the case's)")
MOTION_FILES, MOTION_TEXTS = ("record", "L", "T", "V", "x", "y", "z"), ("unit", "baseline")
MOTION_KEYS = (*MOTION_FILES, *MOTION_TEXTS, "dt", "from", "to", "taper")


def is_record(value):
    """A name or a path, or a table: a name, and keys of [motion] with their values, including files."""
    if not isinstance(value, dict):
        return is_text(value)
    keys = {key: v for key, v in value.items() if key != "name"}
    return (NAME.fullmatch(str(value.get("name", ""))) is not None and any(key in MOTION_FILES for key in keys)
            and all(key in MOTION_KEYS and (is_text(v) if key in (*MOTION_FILES, *MOTION_TEXTS) else is_number(v)
                                            or key == "taper" and isinstance(v, list) and all(map(is_number, v)))
                    for key, v in keys.items()))


def is_seed(value):
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 2**31


# Key: default, test, what is allowed. Lists are tested entry by entry.
VALUES = {
    "title": ("", lambda v: isinstance(v, str), "a string in quotes"),
    "duration": (None, is_positive, "a number > 0: s of shaking"),
    "threads": (1, is_count, "an integer >= 1: threads of a run"),
    "checkpoint_every": (300, is_positive, "a number > 0: s of wall-clock"),
    "memory": (2000, is_count, "an integer >= 1: MB that a run may take on a cluster"),
    "minutes": (1440, is_count, "an integer >= 1: minutes that a cluster gives a run until it must be resumed"),
    "report": (False, lambda v: isinstance(v, bool), "true or false"),
}
LISTS = {
    "cases": (None, is_text, "a name of `voussoir cases`, or the path of a .toml file, from the study file's folder"),
    "directions": ([], lambda v: v in DIRECTIONS, ", ".join(DIRECTIONS)),
    "records": ([], is_record, '"bam-like", "bam-like#N" (N from 1 to 999), or the path of a record, from the study file\'s folder, or a table { name = "...", L = "file", '
                               'T = "file", V = "file" }: a name, and keys of [motion] (files: record, L, T, V, x, y, z; unit, dt, from, to, '
                               'baseline, taper)'),
    "scales": ([], is_scale, "a number, or an array [L, T, V]"),
    "seeds": ([], is_seed, "an integer from 0 to 2147483647"),
    "set": ([], is_override, '"key=value" of the case file, for all runs'),
    "stills": ([], is_time, "a number >= 0: s, the time of a frame to draw"),
}

KEYS = (*VALUES, *LISTS, "options", "intensity")


def fault(path, key, value, allowed):
    return StudyError(f"{path}: {key} = {json.dumps(value, default=str)}; allowed: {allowed}")


def read_list(path, key, value, test, allowed):
    if not isinstance(value, list):
        raise fault(path, key, value, f"an array, each {allowed}")
    for i, entry in enumerate(value):
        if not test(entry):
            raise fault(path, f"{key}[{i}]", entry, allowed)
        if key != "set" and entry in value[:i]:
            raise fault(path, f"{key}[{i}]", entry, "every entry once")
    for i, entry in enumerate(value):
        texts = [entry] if isinstance(entry, str) else [v for v in entry.values() if isinstance(v, str)] if isinstance(entry, dict) else []
        for name in ENVIRONMENT.findall(" ".join(texts)):
            if name not in os.environ:
                raise fault(path, f"{key}[{i}]", entry, f"what the environment has; {name} is not set")
    return value


def from_environment(text):
    """Replaces ${NAME} by the environment's value, since the location of records is no part of a study. Makes existing paths absolute, since runs
    have other working folders."""
    def value(match):
        found = os.environ[match[1]]
        return os.path.abspath(found) if os.path.exists(found) else found
    return ENVIRONMENT.sub(value, text)


def read_options(path, table):
    """Sets of overrides by name; without any, a single set without a name."""
    if not isinstance(table, dict):
        raise fault(path, "options", table, "a table [options] of lines name = [\"key=value\", ...]")
    for name, overrides in table.items():
        if not NAME.fullmatch(name):
            raise fault(path, "options", name, "names of letters, digits, _ . +")
    allowed = '"key=value" of the case file'
    return {name: read_list(path, f"options.{name}", overrides, is_override, allowed) for name, overrides in table.items()} or {"": []}


def read_intensity(path, table):
    """The levels of [intensity]: each with its measure in words, its name and its overrides. Without the table a single level, None."""
    if table is None:
        return [None]
    given = table if isinstance(table, dict) else {}
    measure, period, levels, components = (given.get(key) for key in ("measure", "period", "levels", "components"))
    good_levels = isinstance(levels, list) and all(map(is_positive, levels)) and len(set(levels)) == len(levels) > 0
    good_period = is_positive(period) if measure == "Sa" else period is None
    good = {"measure": measure in list(UNITS), "period": good_period, "levels": good_levels, "components": components in (None, *COMPONENTS)}
    wrong = [key for key in given if key not in good] + [key for key in good if not good[key]]
    if table is not given:
        raise fault(path, "intensity", table, INTENSITY)
    if wrong:
        raise fault(path, f"intensity.{wrong[0]}", given.get(wrong[0]), INTENSITY)
    levels = [float(level) for level in levels]  # 8 and 8.0 are one level
    short, words = (f"Sa{period:g}", f"Sa({period:g} s)") if period else (measure, measure)
    overrides = [f"motion.intensity.measure={json.dumps(measure)}", f"motion.intensity.period={period or ''}"]  # empty: in place of the case's
    overrides += [f"motion.intensity.components={json.dumps(components)}"] if components else []
    return [{"measure": words, "level": level, "name": f"{short}_{level:g}", "set": [*overrides, f"motion.intensity.level={level}"]} for level in levels]


def read_document(path):
    text = own_files.text_of(path, "a study file")
    try:
        return toml_reading.loads(text)
    except ValueError as error:  # of TOML
        raise StudyError(f"{path}: {error}") from error
    except RecursionError as error:
        raise StudyError(f"{path}: arrays or tables within each other, too deep to be read") from error


def read_study(path):
    """All keys of the study file with their defaults."""
    document = read_document(path)
    for key in document:
        if key not in KEYS:
            near = difflib.get_close_matches(key, KEYS, 1)
            raise fault(path, key, document[key], "the keys " + ", ".join(KEYS) + (f"; did you mean {near[0]}?" if near else ""))
    study = {}
    for key, (default, test, allowed) in VALUES.items():
        study[key] = document.get(key, default)
        if key in document and not test(study[key]):
            raise fault(path, key, study[key], allowed)
    for key, (default, test, allowed) in LISTS.items():
        study[key] = read_list(path, key, document.get(key, default or []), test, allowed)
    study["scales"] = [[float(k) for k in scale] if isinstance(scale, list) else float(scale) for scale in study["scales"]]  # 1 and 1.0 are one scale
    study["options"] = read_options(path, document.get("options", {}))
    study["intensity"] = read_intensity(path, document.get("intensity"))
    if study["scales"] and "intensity" in document:
        raise fault(path, "scales", study["scales"], "none beside [intensity], which sets how strong the motion is")

    if not study["cases"]:
        raise fault(path, "cases", study["cases"], "at least one; " + LISTS["cases"][2])
    overrides = [o for one in (study["set"], *study["options"].values()) for o in one]
    if study["seeds"] and not any(re.match(r"\s*scatter\.variation\s*=", o) for o in overrides):
        raise fault(path, "seeds", study["seeds"], 'none, as long as "scatter.variation=..." stands neither in set nor in options')
    return study


def is_built_in(record):
    return record in ("bam-like", "bam-like-1") or record.startswith("bam-like#")


def from_folder(folder, name, on_disk):
    """A path relative to the study file's folder, else the name of something built in."""
    return str((folder / name).resolve()) if on_disk else name


def scale_name(scale):
    return "x" + "_".join(f"{k:g}" for k in (scale if isinstance(scale, list) else [scale]))


def motion_of(record, folder):
    """Overrides for a record that is a table, as written in the study and with actual paths, replacing the motion of the case."""
    yield from ((f"motion.{key}=", None) for key in (*MOTION_FILES, "unit", "dt", "from", "to") if key not in record)
    for key, value in record.items():
        if key in MOTION_FILES:
            path = from_folder(folder, from_environment(value), not (key == "record" and is_built_in(value)))
            yield f"motion.{key}={json.dumps(value)}", f"motion.{key}={json.dumps(path)}"
        elif key != "name":
            yield f"motion.{key}={json.dumps(value)}", None


def one_run(study, folder, case, direction, record, scale, intensity, options, seed):
    said = study["set"] + study["options"][options]  # overrides, as the study says them
    actual = [from_environment(o) for o in said]

    def add(override, in_fact=None):
        said.append(override)
        actual.append(in_fact or override)

    case = from_environment(case)
    case = from_folder(folder, case, case.endswith(".toml"))
    names = [pathlib.Path(case).stem]
    if study["duration"] is not None:
        add(f"time.duration={study['duration']}")
    if direction:
        names.append(direction)
        add(f"motion.direction={json.dumps(direction)}")
    if isinstance(record, dict):
        names.append(record["name"])
        for override, in_fact in motion_of(record, folder):
            add(override, in_fact)
    elif record:
        path = from_folder(folder, from_environment(record), not is_built_in(record))
        names.append(pathlib.Path(path).stem.replace("#", "_"))  # a name of a folder that a link can hold
        add(f"motion.record={json.dumps(record)}", f"motion.record={json.dumps(path)}")
    if scale is not None:
        names.append(scale_name(scale))
        add(f"motion.scale={json.dumps(scale)}")
    if intensity:
        names.append(intensity["name"])
        for override in intensity["set"]:
            add(override)
    if options:
        names.append(options)
    if seed is not None:
        names.append(f"seed{seed}")
        add(f"scatter.seed={seed}")
    called = record["name"] if isinstance(record, dict) else record
    axes = {"case": names[0], "direction": direction, "record": called, "scale": scale}
    if intensity:
        axes |= {"intensity": intensity["measure"], "level": intensity["level"]}
    return {"name": "-".join(names), "axes": axes | {"options": options, "seed": seed}, "case": case, "set": actual, "identity": identity(case, said)}


def identity(case, overrides):
    """Identity of a run, to recognise its results: its case file as it reads now, and its overrides as written in the study, since the location
    of records may change."""
    is_file = os.path.isfile(case) or (case.endswith(".toml") and os.path.exists(case))  # the program refuses a path where nothing is
    text = own_files.text_of(case, "a case file") if is_file else case
    return hashlib.sha256("\0".join([text, *overrides]).encode()).hexdigest()[:16]


def check_overridden(study, path):
    """Refuses overrides of keys that the study varies or sets for all runs: these would have no effect, and their name in the table would be
    wrong."""
    by_record = {f"motion.{key}" for record in study["records"] if isinstance(record, dict) for key in (*MOTION_FILES, *record)}
    by_study = {key: "records" for key in by_record} | {"motion.record": "records", "motion.direction": "directions", "motion.scale": "scales",
                                                        "scatter.seed": "seeds", "time.duration": "duration",
                                                        "motion.intensity": "intensity"}
    named = {"set": study["set"], **{f"options.{name}": overrides for name, overrides in study["options"].items()}}
    for where, overrides in named.items():
        for override in overrides:
            key = override.split("=")[0].strip()
            axis = by_study.get("motion.intensity" if key.startswith("motion.intensity.") else key)
            if axis and study[axis] not in (None, [], [None]):
                raise StudyError(f"{path}: {where}: \"{override}\" has no effect beside `{axis}`; allowed: one of the two")


def expand(study, path):
    check_overridden(study, path)
    axes = [study[key] or [None] for key in ("cases", "directions", "records", "scales")]
    count = math.prod(map(len, [*axes, study["intensity"], study["options"], study["seeds"] or [None]]))
    if count > MOST_RUNS:
        raise StudyError(f"{path}: stands for {count} runs, the product of all its lists; allowed: at most {MOST_RUNS}")
    runs = [one_run(study, path.parent, *values)
            for values in itertools.product(*axes, study["intensity"], study["options"], study["seeds"] or [None])]
    for name, times in collections.Counter(run["name"] for run in runs).items():
        if times > 1:
            raise StudyError(f"{path}: two runs have the name {name}; allowed: cases and records whose files have names of "
                             "their own, and scales and levels that differ in their first six digits")
    return runs


def call(words):
    """Runs the program in another folder, as for a run of the study."""
    try:
        return subprocess.run(words, capture_output=True, text=True, check=False, cwd="/")
    except OSError as error:
        raise StudyError(f"{words[0]}: {error.strerror}; build it, or name the program by VOUSSOIR=...") from error


def number_of_strength(axes):
    """Level or scale of a run; -inf if the case sets it, or the scale differs between components."""
    value = axes.get("level", axes["scale"])
    return value if is_number(value) else -math.inf


def first_of_each(runs):
    """Runs that cover each case with each set of options, in each direction and with the strongest motion, and each record, at least once."""
    seen, strongest = set(), max(number_of_strength(run["axes"]) for run in runs)
    for run in runs:
        axes = run["axes"]
        new = {(run["case"], "options", axes["options"]), (run["case"], "direction", axes["direction"]), axes["record"]}
        new = (new | ({(run["case"], "strongest")} if number_of_strength(axes) == strongest else set())) - seen
        if new:
            seen |= new
            yield run


def check_cases(path, runs, voussoir):
    """Asks the program whether it can build each case with each set of options and in each direction, and read each record. Reports the first fault
    in the order of the study, and each warning for the first run that has it."""
    def check(run):
        return call([voussoir, "check", run["case"]] + [word for o in run["set"] for word in ("--set", o)])

    tried = list(first_of_each(runs))
    with futures.ThreadPoolExecutor(4) as pool:
        answers = pool.map(check, tried)
        warned = set()
        for run, done in zip(tried, answers):
            said = done.stderr.splitlines()
            warnings = [line for line in said if line.startswith(("voussoir: note: ", "voussoir: warning: "))]
            if done.returncode != 0:
                pool.shutdown(wait=False, cancel_futures=True)
                faults = [line for line in said if line not in warnings and not line.startswith('voussoir: damping.frequency = "auto": ')]
                raise StudyError(f"{path}: run {run['name']}: " + ("\n".join(faults) or done.stdout.strip()))
            for line in warnings:
                if line not in warned:
                    print(f"{path}: run {run['name']}: {line.removeprefix('voussoir: ')}", file=sys.stderr)
            warned.update(warnings)


def check_folder(folder, runs, version):
    """Checks that existing results are those of the study as it is now, and of this program: one table, one physics."""
    def said(path):
        return own_files.text_of(path, "what a study wrote of its run").strip() if path.exists() else None

    for run in runs:
        made_by = folder / "runs" / run["name"] / "version"
        if said(made_by) not in (None, version):
            raise StudyError(f"{made_by.parent}: is a run of version {said(made_by)}, and this is {version}: their results may differ. "
                             "Name the program that began the study by VOUSSOIR=..., or give the study another folder")
        there = folder / "runs" / run["name"] / "identity"
        if said(there) not in (None, run["identity"]):
            raise StudyError(f"{there.parent}: holds a run of the same name with another case file or other overrides; "
                             "remove it to run it anew, or give the study another folder")


def version_of(voussoir):
    """The version as in the program's results: "0.1.0 (physics 8)"."""
    return call([voussoir, "--version"]).stdout.strip().removeprefix("voussoir ")


def finished_rows(table):
    """By identity: rows of a study's table for finished runs."""
    data = own_files.bytes_of(table, "a table.csv of a study", own_files.LARGEST_TABLE)
    try:
        rows = list(csv.DictReader(io.StringIO(data.decode(), newline="")))
    except (ValueError, csv.Error) as error:  # of UTF-8; of CSV
        raise StudyError(f"{table}: {error}; wanted a table.csv of a study") from error
    for column in ("run", "identity", "status"):
        if rows and column not in rows[0]:
            raise StudyError(f"{table}: no column {column}; wanted a table.csv of a study")
    return {row["identity"]: row for row in rows if row["status"] != "to be done"}


def same_results(run, row, version):
    """Whether this version of the program would give the same results as a row of an earlier table."""
    made_by = row.get("version", "")
    return made_by == version or (results_of(made_by) == results_of(version) and not differs(run["case"], run["set"]))


def known_rows(tables, runs, folder, voussoir):
    """Rows of earlier tables, by run: of finished runs with equal case and overrides that are not in the folder. The table may be another study's,
    with another name for the run. All must have the results of this program, as rows of another physics are not comparable."""
    known = {}
    for table in tables:
        there = finished_rows(table)
        found = {run["name"]: there[run["identity"]] for run in runs
                 if run["identity"] in there and not (folder / "runs" / run["name"]).exists()}
        now = version_of(voussoir)
        others = sorted({found[run["name"]].get("version", "") for run in runs if run["name"] in found and not same_results(run, found[run["name"]], now)})
        if others:
            raise StudyError(f"{table}: holds runs of version {' and '.join(others)}, and this is {now}: their results may differ. "
                             "Leave out --known, or name the program of the table by VOUSSOIR=...")
        known = found | known
    return known
