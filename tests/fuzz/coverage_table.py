# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The table of tests/fuzz/COVERAGE.md from the lines that were reached (LCOV). usage: coverage_table.py READERS.lcov"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
READERS = ("io/input/motion/formats/", "io/input/motion/support_motion.cpp", "io/input/motion/spectra/target_file.cpp", "io/input/stones/", "io/input/case_file/",
           "io/input/document/", "io/input/files/", "io/output/results/checkpoint_file.cpp", "io/output/results/checkpoint_stones.cpp",
           "io/output/results/case_of_run.cpp", "io/output/results/comparison.cpp", "io/output/replay/", "io/output/measures/", "io/output/assess/", "io/output/report/")
# Not readers: they write, make, or are of other programs.
NOT = ("output_path.cpp", "file_kind.cpp", "scratch_folder.cpp", "run_folder.cpp", "whole_file.cpp", "pictures/", "catalogue.cpp", "limit_words.cpp", "embed", "report_modes.cpp",
       "report_model.cpp", "case_keys.cpp", "resolved_case.cpp", "vtu_file.cpp", "settling_warning.cpp", "shown_faults.cpp")
# Functions that only write, in sources that read, too, or read what the program itself has just made (the page of `view`, pictures of the browser): no
# reader of files calls them. Not counted.
WRITERS = {
    "io/output/report/report_data.cpp": "model_html",
    "io/input/files/packed_text.cpp": "from_base64",
    "io/input/files/hdf5_file.cpp": "checked_layout layout_properties Hdf5File::create Hdf5File::flush Hdf5File::make_group Hdf5File::create_dataset Hdf5File::write_dataset "
                                    "Hdf5File::write_rows Hdf5File::create_virtual",
    "io/input/files/hdf5/handle.cpp": "link_properties write_note",
    "io/input/files/hdf5/pieces.cpp": "Hdf5File::name_parts",
    "io/input/files/sealed_file.cpp": "SealedFile::SealedFile SealedFile::~SealedFile SealedFile::seal",
    "io/output/measures/measures_file.cpp": "put write_walls write_series write_ties write_loads figure_units write_measures",
    "io/output/measures/point_accelerations.cpp": "write_accelerations",
    "io/output/measures/capacity/capacity_file.cpp": "write_loops write_capacity",
    "io/output/replay/cells.cpp": "handedness add_hexahedron add_prism add_tetrahedra cells_of",
    "io/output/results/checkpoint_file.cpp": "hdf5_type hex write_facts write_motion write_supports write_stones part_of is_zero write_field write_state room_for write_checkpoint",
    "io/output/results/checkpoint_stones.cpp": "pack_piece packed_stones",
}


def writer_lines(name):
    """Lines of the functions of a source that only write. A function begins at the margin of its closing brace, as clang-format puts it."""
    rows = (ROOT / name).read_text().splitlines()
    lines = set()
    for function in WRITERS.get(name, "").split():
        starts = [n for n, row in enumerate(rows) if re.match(rf"[\w:<>,&*\s\[\]]*(?<![\w:~]){re.escape(function)}\(", row) and not row.startswith(" ")]
        if len(starts) != 1:
            sys.exit(f"coverage_table.py: {name} has {len(starts)} functions {function}")
        end = starts[0]
        while not rows[end].startswith("}") and not (rows[end].endswith("}") and end == starts[0]):
            end += 1
        lines |= set(range(starts[0] + 1, end + 2))
    return lines


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
        for n in writer_lines(name):
            lines.pop(n, None)
        missed = sorted(n for n, count in lines.items() if count == 0)
        total, reached = total + len(lines), reached + len(lines) - len(missed)
        print(f"| `{name.removeprefix('io/')}` | {len(lines)} | {100 * (1 - len(missed) / len(lines)):.0f} % | {ranges(missed)} |")
    print(f"\nAll: {100 * reached / max(1, total):.1f} % of {total} lines.")


if __name__ == "__main__":
    main()
