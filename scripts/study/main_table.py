# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The main columns of a study's table as a table of their own. usage: main_table.py TABLE MAIN   (in the study's folder)

What varied in the study, then how each run came out: 20 columns at most, of the same names, rows and texts as in TABLE. A column that is empty in
all rows is left out.
"""
import csv
import io
import sys

import own_files

AXES = ("case", "direction", "record", "scale", "intensity", "level", "options", "seed")  # with `run` at most eight: no scale beside a level
OUTCOME = ("status", "damage_grade", "collapsed", "collapse_time", "fallen_mass_fraction", "peak_drift", "residual_drift", "free_volume",
           "peak_base_shear", "capacity: multiplier", "capacity: peak_shear", "capacity: peak_displacement")


def columns_of(rows):
    """Names of the main columns: of a study of one case, that case if nothing varies."""
    varied = [name for name in AXES if len({row.get(name) or "" for row in rows}) > 1]
    if "level" in varied and "intensity" not in varied:
        varied.insert(varied.index("level"), "intensity")  # which measure the levels are of
    return ["run", *(varied or ["case"]), *(name for name in OUTCOME if name == "status" or any(row.get(name) for row in rows))]


def main():
    text = own_files.bytes_of(sys.argv[1], "a table.csv of a study", own_files.LARGEST_TABLE).decode()
    rows = list(csv.DictReader(io.StringIO(text, newline="")))
    with own_files.replacing(sys.argv[2]) as file:
        writer = csv.DictWriter(file, columns_of(rows), extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    try:
        main()
    except own_files.StudyError as error:
        sys.exit(str(error))
