# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Which walls are run, where, and how: what the scripts of the validation share."""
import os
import pathlib
import subprocess
import sys
import time

import walls as wall_data

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = os.environ.get("VOUSSOIR", str(ROOT / "build/release/io/voussoir"))


def add_places(parser, folder=""):
    """Adds --runs and --measured."""
    measured = os.environ.get("VOUSSOIR_MEASURED", ROOT.parent / "shared/validation")
    parser.add_argument("--runs", type=pathlib.Path, default=ROOT / "results/validation" / folder)
    parser.add_argument("--measured", type=pathlib.Path, default=pathlib.Path(measured))


def chosen(measured, names):
    """The walls with these names, or all. Ends the program if there are no tables, or no such wall."""
    if not (measured / "dry_walls.csv").exists():
        print(f"no measured walls in {measured}: nothing is run or compared", file=sys.stderr)
        sys.exit(0)
    known = {w.name: w for w in wall_data.all_walls(measured)}
    unknown = sorted(set(names) - set(known))
    if unknown:
        sys.exit(f"no such wall: {', '.join(unknown)}; there are: {', '.join(known)}")
    return [w for name, w in known.items() if not names or name in names]


class RunLost(RuntimeError):
    """The program ended a run with a numerical failure; its words."""


def is_done(folder, text):
    """Whether a run of exactly this case exists that is finished, or lost."""
    case = folder / "case.toml"
    return case.exists() and (folder / "took.txt").exists() and case.read_text() == text


def run(wall, folder, text):
    """Runs the case of the wall in the folder unless done before. Returns the folder. Raises RunLost."""
    if is_done(folder, text):
        if (folder / "lost.txt").exists():
            raise RunLost((folder / "lost.txt").read_text())
        return folder
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("took.txt", "lost.txt"):
        (folder / name).unlink(missing_ok=True)
    (folder / "case.toml").write_text(text)
    start = time.monotonic()
    with open(folder / "log.txt", "w") as log:
        done = subprocess.run([PROGRAM, "run", str(folder / "case.toml"), "-j", "1", "--overwrite", "-o", str(folder / "run")],
                              stdout=log, stderr=subprocess.STDOUT, check=False)
    words = (folder / "log.txt").read_text(errors="replace")
    lost = words.partition("voussoir: numerical failure: ")[2].partition("\n")[0] if done.returncode == 1 else ""
    if lost:
        (folder / "lost.txt").write_text(lost)
    elif done.returncode != 0:
        raise RuntimeError(f"{wall.name}: the run ended with exit code {done.returncode}; see {folder / 'log.txt'}")
    (folder / "took.txt").write_text(f"{time.monotonic() - start:.0f}")
    if lost:
        raise RunLost(lost)
    return folder
