# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""A study as one HTML page that needs no other file: the table, stills, plots; links to the runs' own pages where they are there.

usage: page.py PLAN TABLE PAGE [SVG ...]   (in the study's folder)
"""
import base64
import csv
import html
import json
import pathlib
import sys

import own_files

STYLE = """body { font: 14px/1.4 sans-serif; margin: 2em; color: #222 } table { border-collapse: collapse }
th, td { padding: .25em .6em; border-bottom: 1px solid #ddd; text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums }
th { position: sticky; top: 0; background: #fff } td:first-child, th:first-child { text-align: left }
tr.collapsed td { background: #fbe9e7 } tr.open td { color: #999 } img { vertical-align: middle; margin: .3em } .still { height: 8em; max-width: 16em }"""


# Of the table, what a page has room for; the rest is in table.csv.
SHOWN = ("run", "case", "direction", "record", "scale", "intensity", "level", "motion_factor", "options", "seed", "status", "damage_grade", "settling_damage_grade", "collapsed", "collapse_time",
         "first_crack_time", "settling_cracks", "shaking_cracks", "first_fallen_time", "first_fallen_wall", "fallen_mass_fraction", "peak_drift", "residual_drift", "free_volume", "debris_area",
         "debris_reach", "peak_base_shear", "state_hash", "core_hours")
NEVER = ("collapse_time", "first_crack_time", "first_fallen_time")  # a time below 0


def shown(name, text):
    """Text of a cell."""
    if name in ("damage_grade", "settling_damage_grade") and text:
        return "–" if text.startswith("-") else "G" + text
    return "never" if name in NEVER and text.startswith("-") else short(text)


def short(text):
    """Numbers with five digits; other values unchanged."""
    try:
        number = float(text)
    except ValueError:
        return text
    return text if text.lstrip("-").isdigit() else f"{number:.5g}"


def picture(path, kind, css):
    return f'<img class="{css}" alt="{html.escape(path.stem)}" src="data:image/{kind};base64,{base64.b64encode(path.read_bytes()).decode()}">'


def links(folder):
    """Links to the run's own page and pictures, if they exist."""
    still, report = folder / "stills.png", folder / "report.html"
    cells = [f'<a href="{html.escape(str(report))}">report</a>'] if report.exists() else []
    if still.exists():
        cells.append(f'<a href="{html.escape(str(still))}">{picture(still, "png", "still")}</a>')
    return " ".join(cells)


def table_row(row, columns):
    kind = "collapsed" if row.get("collapsed") == "1" else "" if row["status"] == "done" else "open"
    cells = "".join(f"<td>{html.escape(shown(name, row[name]))}</td>" for name in columns)
    return f'<tr class="{kind}">{cells}<td>{links(pathlib.Path("runs") / row["run"])}</td></tr>'


def facts(rows):
    done = sum(row["status"] == "done" for row in rows)
    failed = sum(row["status"] not in ("done", "to be done") for row in rows)
    hours = sum(float(row["core_hours"]) for row in rows)
    collapsed = sum(row.get("collapsed") == "1" for row in rows)
    failures = f", {failed} stopped by a numerical failure" if failed else ""
    return f"{done} of {len(rows)} runs done{failures}, {collapsed} collapsed, {hours:.3g} core-hours."


def main():
    plan = json.loads(pathlib.Path(sys.argv[1]).read_text())
    with open(sys.argv[2], newline="") as file:
        rows = list(csv.DictReader(file))
    title = html.escape(plan["title"] or "A study")
    columns = [name for name in SHOWN if any(row.get(name) for row in rows)]
    head = "".join(f"<th>{html.escape(name.replace('_', ' '))}</th>" for name in columns)
    lines = ["<!DOCTYPE html>", f'<html lang="en"><head><meta charset="utf-8">{own_files.GENERATOR}<title>{title}</title><style>{STYLE}</style></head><body>',
             f"<h1>{title}</h1>", f"<p>{facts(rows)} Damage grades of EMS-98, drift out of plane over the height of the wall, free volume and fallen mass as fractions; times in s, lengths in m, forces in N, levels of PGA and Sa in m/s², of PGV in m/s. Main columns: main.csv; all measures: table.csv.</p>",
             f"<table><thead><tr>{head}<th></th></tr></thead><tbody>", *(table_row(row, columns) for row in rows), "</tbody></table>",
             *(picture(pathlib.Path(path), "svg+xml", "plot") for path in sys.argv[4:]), "</body></html>"]
    with own_files.replacing(sys.argv[3]) as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    try:
        main()
    except own_files.StudyError as error:
        sys.exit(str(error))
