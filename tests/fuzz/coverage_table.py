# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The table of tests/fuzz/COVERAGE.md from the lines that were reached (LCOV). usage: coverage_table.py READERS.lcov"""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
READERS = ("io/input/motion/formats/", "io/input/motion/support_motion.cpp", "io/input/motion/spectra/target_file.cpp", "io/input/stones/", "io/input/case_file/",
           "io/input/document/", "io/input/files/", "io/output/results/checkpoint_file.cpp", "io/output/results/checkpoint_stones.cpp",
           "io/output/results/case_of_run.cpp", "io/output/results/comparison.cpp", "io/output/replay/", "io/output/measures/", "io/output/assess/", "io/output/report/")
# Not readers: they write, make, or are of other programs.
NOT = ("output_path.cpp", "file_kind.cpp", "scratch_folder.cpp", "run_folder.cpp", "whole_file.cpp", "pictures/", "catalogue.cpp", "limit_words.cpp", "embed", "report_modes.cpp",
       "report_model.cpp", "vtu_file.cpp", "settling_warning.cpp", "shown_faults.cpp")


def lines_of(path):
    """By file: lines reached and not."""
    files, name = {}, None
    for row in pathlib.Path(path).read_text().splitlines():
        if row.startswith("SF:"):
            name = row[3:].removeprefix(str(ROOT) + "/")
            files.setdefault(name, {})
        elif row.startswith("DA:"):
            line, count = row[3:].split(",")[:2]
            files[name][int(line)] = max(files[name].get(int(line), 0), int(count))
    return files


def ranges(lines):
    """12, 15-17"""
    out = []
    for n in lines:
        if out and n == out[-1][1] + 1:
            out[-1][1] = n
        else:
            out.append([n, n])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in out)


def main():
    print("| reader | lines | reached | not |\n|---|---|---|---|")
    total = reached = 0
    for name, lines in sorted(lines_of(sys.argv[1]).items()):
        if not name.startswith(READERS) or any(n in name for n in NOT) or not name.endswith(".cpp"):
            continue
        missed = sorted(n for n, count in lines.items() if count == 0)
        total, reached = total + len(lines), reached + len(lines) - len(missed)
        print(f"| `{name.removeprefix('io/')}` | {len(lines)} | {100 * (1 - len(missed) / len(lines)):.0f} % | {ranges(missed)} |")
    print(f"\nAll: {100 * reached / max(1, total):.1f} % of {total} lines.")


if __name__ == "__main__":
    main()
