#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What motions have of the paper's record: peaks of L, and the order of the spectra of L and T in its Fig. 9.

usage: motions.py MOTION [MOTION ...]     folders of scripts/study/changed_motions, or bam-like#7 (VOUSSOIR names the program)

Writes a table in Markdown: a row for motions of one name without their numbers (pulse50-1 and pulse50-2), with the least and the largest of
each measure. Peak velocity and displacement are those of the acceleration's integrals from rest. The shares are of frequencies, equally
spaced in their logarithm, at 2 % of damping:
  Fig. 9 (a)  over 0 to 3.5 s the displacement spectrum of L lies above T's; of those from 0.2 to 30 Hz
  Fig. 9 (b)  over 0 to 10 s it lies below T's; of those from 0.2 to 5.7 Hz (section 3.7: "less than 6 Hz")
"""
import collections
import csv
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "python/voussoir")]
import program
from outcomes import family

COLUMNS = ("motion", "realisations", "peak acceleration of L, m/s2", "peak velocity, m/s", "peak displacement, m", "as in Fig. 9 (a), %",
           "as in Fig. 9 (b), %")
FIGURE_9A, FIGURE_9B = (3.5, 0.2, 30.0), (10.0, 0.2, 5.7)  # until, s; frequencies, Hz


def share(motions, until, low, high, holds):
    """By motion: share of the frequencies at which a statement on the spectra of L and T is true."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "spectra.csv"
        words = [program.program(), "motion", *motions, "--until", str(until), "--spectra", str(table)]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        with open(table, newline="") as file:
            rows = [row for row in csv.DictReader(file) if low <= float(row["frequency [Hz]"]) <= high]
    spectra = collections.defaultdict(dict)
    for row in rows:
        spectra[row["record"], row["component"]][row["frequency [Hz]"]] = float(row["Sd [m]"])
    return {record: 100 * sum(holds(of_l[f], spectra[record, "T"][f]) for f in of_l) / len(of_l)
            for (record, component), of_l in spectra.items() if component == "L"}


def peaks(motions):
    """By motion: peak acceleration, velocity and displacement of L."""
    said = subprocess.run([program.program(), "motion", *motions], check=True, capture_output=True, text=True).stdout
    head, _, *lines = (line.split() for line in said.splitlines())
    columns = [head.index(name) for name in ("PGA", "PGV", "PGD")]  # the first PGA is in m/s2, the second in g
    return {line[0]: [float(line[k]) for k in columns] for line in lines if line[head.index("component")] == "L"}


def span(values, digits):
    low, high = (f"{f(values):.{digits}f}" for f in (min, max))
    return low if low == high else f"{low} to {high}"


def main():
    motions = sys.argv[1:]
    if not motions or any(word.startswith("-") for word in motions):
        sys.exit(__doc__)
    of_l = peaks(motions)
    above = share(motions, *FIGURE_9A, lambda of_l, of_t: of_l > of_t)
    below = share(motions, *FIGURE_9B, lambda of_l, of_t: of_l < of_t)
    families = collections.defaultdict(list)
    for motion in of_l:
        families[family(motion if "#" in motion else "/" + motion)].append(motion)  # the program names a folder's motion without its path
    print("| " + " | ".join(COLUMNS) + " |\n|" + "---|" * len(COLUMNS))
    for name, members in families.items():
        measured = [span([of_l[m][k] for m in members], 2) for k in range(3)]
        shares = [span([of[m] for m in members], 0) for of in (above, below)]
        print(f"| `{name}` | {len(members)} | " + " | ".join(measured + shares) + " |")


if __name__ == "__main__":
    main()
