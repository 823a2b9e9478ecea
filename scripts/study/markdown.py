#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The runs of a table.csv that are done, as a table in Markdown on standard output: what a page of results has room for. Columns in which no run
has a value are left out.

usage: markdown.py TABLE.csv [COLUMN ...]      COLUMN: the first words of a column, as run, roof, "opened by"; none: all columns
"""
import csv
import sys

NOTHING = "–"


def time(text):
    return "never" if text.startswith("-") else f"{float(text):.2f}"


def percent(text):
    return NOTHING if text == "" else f"{100 * float(text):.1f}"


def by_mode(row, prefix):
    """Segment sides by mode; a table of an earlier version has no limits reached first."""
    counts = [row.get(prefix + mode, "") for mode in ("tension", "shear", "compression")]
    return NOTHING if "" in counts else " / ".join(f"{int(n):,}" for n in counts)


def first_wall(row):
    """The first wall to lose a quarter of its mass: a wall that loses single bricks may stand to the end."""
    quarter = ": quarter_fallen_time"
    fallen = [(float(row[column]), column.removesuffix(quarter)) for column in row if column.endswith(quarter) and float(row[column] or -1) >= 0]
    return "{1}, {0:.2f}".format(*min(fallen)).replace(" wall", "") if fallen else "none"


def first_crack(row):
    """First crack, with the number of segments opened by weight before the shaking."""
    by_weight = int(row.get("settling_cracks") or 0)
    return time(row["first_crack_time"]) + (f" ({by_weight:,} by weight)" if by_weight else "")


def roof(row):
    fallen = row.get("roof_fallen_mass_fraction", "")
    return NOTHING if fallen == "" else f"{percent(fallen)}" + (f", {time(row['collapse_time'])}" if row["collapsed"] == "1" else "")


# Head, and what stands below it for a row of the table.
COLUMNS = {
    "run": lambda row: row["run"],
    "grade": lambda row: "–" if row["damage_grade"].startswith("-") else f"G{row['damage_grade']}",
    "first crack, s": first_crack,
    "first wall with a quarter fallen, s": first_wall,
    "roof fallen, %; collapse, s": roof,
    "fallen, %": lambda row: percent(row["fallen_mass_fraction"]),
    "peak drift, %": lambda row: percent(row["peak_drift"]),
    "debris, m2; reach, m": lambda row: f"{float(row['debris_area']):.1f}; {float(row['debris_reach']):.1f}",
    "free volume, %": lambda row: percent(row["free_volume"]),
    "reached first: tension / shear / compression": lambda row: by_mode(row, "first_"),
    "opened by: tension / shear / compression": lambda row: by_mode(row, ""),
    "slipped, hold": lambda row: f"{int(row['slipped']):,}",
    "base shear, kN": lambda row: f"{float(row['peak_base_shear']) / 1e3:.0f}",
    "residual": lambda row: f"{float(row['worst_residual']):.1e}",
    "core-hours": lambda row: f"{float(row['core_hours']):.2f}",
}


def chosen(words):
    """Columns whose names begin with these words."""
    if unknown := [word for word in words if not any(head.startswith(word) for head in COLUMNS)]:
        sys.exit(f"{unknown[0]}: no column begins so; allowed: {'; '.join(COLUMNS)}")
    return {head: cell for head, cell in COLUMNS.items() if not words or head.startswith(tuple(words))}


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    columns = chosen(sys.argv[2:])
    with open(sys.argv[1], newline="") as file:
        rows = list(csv.DictReader(file))
    lines = [[cell(row) for cell in columns.values()] for row in rows if row["status"] == "done"]
    shown = [k for k in range(len(columns)) if not lines or any(line[k] != NOTHING for line in lines)]
    head, *body = [" | ".join(line[k] for k in shown) for line in [list(columns), *lines]]
    print(f"| {head} |\n|" + "---|" * len(shown))
    for line in body:
        print(f"| {line} |")


if __name__ == "__main__":
    main()
