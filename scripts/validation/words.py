# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The report of the validation in words, tables and figures."""
import math
import pathlib
import shutil
import textwrap

import numpy as np

import case_file
import measures
import pictures
import tables
import verdicts
import walls as wall_data

NOTES = pathlib.Path(__file__).resolve().parent.parent.parent / "tests/validation/notes.md"  # what no single run shows; quoted at the end
# What has to be reached, share of the measured mean.
PEAK_LIMIT = {"SW": 0.15, "WS": 0.20, "ISP": 0.20, "MI": 0.25}

INTRO = """\
# Validation: measured walls

`scripts/validation/report` writes this page; it is not edited by hand. The walls were tested in
shear and compression: a constant vertical load on a loading beam, then a horizontal force on it.
Each kind of wall is computed once.

- **Fitted**: nothing, to no wall. **Predicted**: all forces, displacements and modes of failure
  below. Values of units, joints and couplets are measured or from the literature; those that are
  assumed say so.
- **Measured curves** are not kept here; the tables come from the EPFL databases of stone and of
  modern masonry walls (Vanin et al. 2017, and the sources named with each wall).
- **Contact points**: `segments.rule = "rim"` for every wall; levers are exact.
- **Loading**: the load of the jack stays vertical and constant. On dry walls (SW, WS*) the actuator
  pushes at the height of zero moment, and the beam is free to turn; on brick walls (MI, ISP) the
  beam is held level. SW is pushed one way. WS*, MI and ISP are pushed to and fro, once at each of
  three drifts: 0.5, 1.25 and 3 % (WS*), 0.1, 0.25 and 0.5 % (MI, ISP).
- **Cases**: `cases/NAME.toml`; `voussoir run tests/validation/cases/SW-100.toml` runs one of them.
- **Symbols**: σ0 vertical stress by the load, without the wall's weight; H0 height of zero moment
  above the base; L, H length and height of the wall; N vertical force on a bed; f_b, f_m
  compressive strength of units and of masonry; f_t tensile strength; c, tan φ cohesion and friction
  of a bed; G_I, G_II fracture energies in tension and in shear; E_pc modulus of the wall in
  compression, E′ = E/(1 − ν²) of its blocks.
- **Scatter**: half the range of the measured peaks over their mean; push and pull count as two
  peaks.
- **Mean error of the curve**: mean of the differences between computed and measured force, without
  their signs, over the mean measured force (WS*: of envelopes).
- **Miss**: the error of the peak (WS*: the mean error of the curve) is larger than the limit. The
  reasons stand below the table.
- **Tables of the walls**: + push, - pull. Drift is the displacement over H0, of brick walls over H.
  The computed stiffness is the secant at 30 % of the peak. "First loss of a fifth" is the drift at
  which the force, as a moving mean, has fallen by 20 % from its largest so far (to and fro: beyond
  the peak). Measured failure of dry walls: F flexure or rocking, R rocking, TC toe crushing, SL
  sliding.
- **Computed failure**: of a dry wall by its slip, the share of the top's displacement by which
  courses slid over each other: above 60 % sliding, below 15 % rocking, else both. Of a brick wall
  by where it broke: shear if more than half of the broken area lies in the middle three fifths of
  the height, else flexure. The bricks of these walls can crack at mid-length.
"""

VERDICTS = """\
- **Failure** of a dry wall by the letters of its tests, flexure as rocking: "no" where the run has
  not what most of the tests have, "partly" where it has what none has. Of a brick wall the mode in
  the table, and that of most of the area broken by then, at the peak and at the end.
- **Loss of force**: as in the tables of the walls, up to 2 % of H0; a run may have one where a test
  has. Brick walls are pushed to 0.5 % and have none to be looked for.
- **Self-centring**: the displacement at which the force is zero after unloading, over the largest,
  at most a fifth on dry walls. Loops of the tests are not in the tables, their envelopes alone.
"""


def wrapped(text, later=""):
    return "\n".join(textwrap.wrap(text, 100, subsequent_indent=later, break_long_words=False, break_on_hyphens=False))


def percent(value, signed=False):
    return "–" if math.isnan(value) else f"{100 * value:{'+' if signed else ''}.1f} %"


def kilo(value, digits=1):
    return "–" if math.isnan(value) else f"{1e-3 * value:.{digits}f}"


def of_share(inner):
    """Shear breaks the middle of a wall that is held level, flexure its foot and head."""
    return f"{verdicts.inner_mode(inner)} ({percent(inner)} of the broken area at mid-height)"


class Compared:
    """A wall, its tests and its run."""

    def __init__(self, wall, folder, measured):
        self.wall = wall
        self.rows = wall_data.measured_rows(measured, wall)
        self.curves = {test: wall_data.read_curve(path) for test, path in wall_data.curve_files(measured, wall).items()}
        self.run = measures.RunOfWall(folder / "run", wall)
        if not self.run.finished:
            raise RuntimeError(f"{wall.name}: the run in {folder} was stopped before its end; remove the folder")
        self.seconds = int((folder / "took.txt").read_text())
        self.ways = measures.both_ways(self.run.displacement, self.run.force)
        if wall.cyclic:
            self.ways = measures.both_ways(*measures.envelope(self.run.displacement, self.run.force))
            self.first = measures.first_rise(self.run.displacement, self.run.force)
        else:
            self.ways = self.ways[:1]
            self.first = self.ways[0]

    @property
    def measured_peak(self):
        return float(np.mean([row["force"] for row in self.rows]))

    @property
    def scatter(self):
        """Half of the range of the tests over their mean."""
        forces = [row["force"] for row in self.rows]
        return 0.5 * (max(forces) - min(forces)) / self.measured_peak

    @property
    def peak(self):
        return float(np.mean([way.peak for way in self.ways]))

    @property
    def error(self):
        return self.peak / self.measured_peak - 1.0

    @property
    def envelope_error(self):
        """Mean error over the tests and both directions; NaN without measured curves."""
        found = []
        for u, f in self.curves.values():
            measured = measures.both_ways(u, f)
            found += [measures.mean_error(m, c) for m, c in zip(measured, self.ways) if len(m.displacement) > 2]
        return float(np.mean(found)) if found else math.nan

    @property
    def residual_share(self):
        """Largest displacement at which the force changes sign, over the largest displacement: 0 is self-centring."""
        f, u = self.run.force, self.run.displacement
        crossing = np.flatnonzero((f[1:] * f[:-1] <= 0.0) & (np.abs(np.diff(f)) > 0.0))
        crossing = crossing[crossing > np.argmax(np.abs(u) > 0.5 * np.abs(u).max())]
        return float(np.abs(u[crossing]).max() / np.abs(u).max()) if len(crossing) else math.nan

    @property
    def slip(self):
        """Share of slip at the largest displacement of the frames."""
        frames = self.run.rows_of("frames")
        x0 = self.run.file["model/element/position0"][:]
        beam = int(np.argmax(x0[:, 2]))
        tops = np.abs(measures.results.displacement_of(self.run.file, slice(frames))[:, beam, 0])
        self.frame = int(np.argmax(tops))
        return self.run.slip_share(self.frame)

    @property
    def mode(self):
        slip = self.slip
        if self.wall.bond:
            to_peak, to_end = self.run.inner_share(self.run.time_of_peak()), self.run.inner_share()
            cuts = f"{percent(self.run.unit_share())} of the area of bricks' mid-length joints broken"
            if math.isnan(to_peak) or (to_peak > 0.5) == (to_end > 0.5):
                return f"{of_share(to_end)}; {cuts}"
            return f"{of_share(to_peak)} up to the peak, then {of_share(to_end)}; {cuts}"
        name = verdicts.in_words(verdicts.modes_of_slip(slip))
        return f"{name} (slip {percent(slip)} of the displacement)"

    def first_drop(self, way):
        """First drop of an envelope of loops beyond its peak; before the peak it includes loops after slip."""
        if not self.wall.cyclic:
            return way.first_drop
        beyond = way.displacement >= way.at_peak
        return measures.Curve(way.displacement[beyond], way.force[beyond]).first_drop

    @staticmethod
    def sign(row):
        return -1.0 if row["test"].endswith(" -") else 1.0

    @property
    def limit(self):
        return PEAK_LIMIT[self.wall.kind]

    @property
    def verdict(self):
        worst = abs(self.error) if not self.wall.cyclic or self.wall.level else self.envelope_error
        return "" if worst <= self.limit else "**miss**"


def summary(found):
    lines = ["| wall | tests | peak, measured [kN] | scatter of the tests | peak, computed [kN] | error | limit | mean error of the curve | |",
             "|---|---|---|---|---|---|---|---|---|"]
    for c in found:
        lines.append(f"| {c.wall.name} | {len(c.wall.tests)} | {kilo(c.measured_peak)} | ± {percent(c.scatter)} | {kilo(c.peak)} | "
                     f"{percent(c.error, True)} | {percent(c.limit)} | {percent(c.envelope_error)} | {c.verdict} |")
    return lines


def file_name(wall):
    return wall.name.replace("*", "x").replace(".", "-")


def of_wall(c, output):
    """The section of the report for one wall."""
    w = c.wall
    name = file_name(w)
    levels = {"rigid wall turning about its toe": w.rocking_bound, "friction on a bed": w.sliding_bound}
    points = [] if c.curves else [(c.sign(row) * row["drift"] * w.lever_height, c.sign(row) * row["force"]) for row in c.rows]
    pictures.curves(output / "figures" / f"{name}.svg", w, c.curves, (c.run.displacement, c.run.force),
                    {k: v for k, v in levels.items() if v < 1.8 * max(c.peak, c.measured_peak)}, points)
    slip = c.slip
    pictures.wall_as_it_stands(output / "figures" / f"{name}-wall.png", c.run, c.frame, magnified(w, c))
    lines = [f"## {w.name}", "", f"![Curves of {w.name}](figures/{name}.svg)", "",
             f"![{w.name} at its largest displacement](figures/{name}-wall.png)", "",
             "| | peak [kN] | drift at the peak | stiffness [kN/mm] | first loss of a fifth | failure |", "|---|---|---|---|---|---|"]
    for row in c.rows:
        lines.append(f"| measured, {row['test']} | {kilo(row['force'])} | {percent(row['drift'])} | {kilo(row['stiffness'] * 1e-3)} | "
                     f"{measured_drop(c, row['test'])} | {row['failure']} |")
    for way, sign in zip(c.ways, "+-"):
        lines.append(f"| computed{'' if len(c.ways) == 1 else ' ' + sign} | {kilo(way.peak)} | {percent(way.at_peak / w.lever_height)} | "
                     f"{kilo(c.first.stiffness * 1e-3) if sign == '+' else '–'} | {percent(c.first_drop(way) / w.lever_height)} | {c.mode} |")
    lines += ["", wrapped(facts(c, slip)), ""]
    return lines


def magnified(wall, compared):
    """Magnification of displacements in figures: the top moves by a tenth of the height, with a factor of at most 20."""
    return max(1.0, min(20.0, round(0.1 * wall.height / float(np.abs(compared.run.displacement).max()))))


def measured_drop(c, test):
    curve = c.curves.get(test.split(" ")[0])
    if curve is None:
        return "–"
    way = measures.both_ways(*curve)[1 if test.endswith("-") else 0]
    return percent(way.first_drop / c.wall.lever_height)


def facts(c, _slip):
    w, attributes = c.wall, c.run.attributes
    drive = case_file.drive_of(w)
    normal, shear = case_file.joint_stiffness(w, drive.get("modulus") or w.unit_modulus)
    text = (f"A rigid wall that turns about its toe bears {kilo(w.rocking_bound)} kN, friction on a bed {kilo(w.sliding_bound)} kN. "
            f"Joints: {normal:.3g} Pa/m normal, {shear:.3g} Pa/m in shear; segments of {1e3 * w.segment:.0f} mm. "
            f"Energy ledger: residual at most {c.run.peak_residual:.1e}. "
            f"Pace {float(attributes['pace']):.3g} s, first frequency {float(attributes['frequency']):.3g} Hz; {c.seconds} s of wall-clock time on one thread.")
    if c.measured_peak > w.rocking_bound:
        text += (f" **The tests bore {percent(c.measured_peak / w.rocking_bound - 1.0)} more than a rigid wall can under a constant load with "
                 "this height of zero moment**, so the load or the height in the table is not that at the peak; no model with them reaches it.")
    if w.bond:
        areas = c.run.first_modes()
        text += (f" Area of broken bonds by the limit that they reached first: tension {areas['tension']:.3f} m², shear {areas['shear']:.3f} m², "
                 f"crushing {areas['compression']:.3f} m².")
    if w.cyclic:
        text += f" After unloading at most {percent(c.residual_share)} of the largest displacement remains."
    return text


def parameters(found):
    lines = ["## Parameters and their sources", "", "| walls | what | source |", "|---|---|---|"]
    kinds = set(c.wall.kind for c in found)
    for kind in wall_data.SOURCES:
        for what, source in wall_data.SOURCES[kind].items() if kinds & set(kind.split(", ")) else ():
            lines.append(f"| {kind} | {what} | {source} |")
    for what, source in wall_data.COMMON_SOURCES.items():
        lines.append(f"| all | {what} | {source} |")
    return lines + [""]


def report(walls, folders, measured, output):
    output.mkdir(parents=True, exist_ok=True)
    found = [Compared(w, f, measured) for w, f in zip(walls, folders)]
    lines = [INTRO, f"Program: {tables.version()}.", "", "## Peaks", ""] + summary(found) + [""]
    reasons = [wrapped(f"- {c.wall.name}: {wall_data.REASONS[c.wall.name]}", "  ") for c in found if c.verdict and c.wall.name in wall_data.REASONS]
    lines += reasons + ([""] if reasons else []) + verdicts.table(found) + ["", VERDICTS] + parameters(found)
    (output / "cases").mkdir(exist_ok=True)
    for c, folder in zip(found, folders):
        lines += of_wall(c, output)
        shutil.copyfile(folder / "case.toml", output / "cases" / f"{file_name(c.wall)}.toml")
    notes = tables.quoted(NOTES.read_text(encoding="utf-8")).splitlines()
    return "\n".join(lines + notes).rstrip() + "\n"
