# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Small tables that scripts of the validation make and the report quotes: tests/validation/tables/NAME.txt.

The first line says which program made the table, when and by what; the rest is Markdown.
"""
import datetime
import pathlib
import subprocess
import textwrap

import run_walls

FOLDER = run_walls.ROOT / "tests/validation/tables"


def version():
    done = subprocess.run([run_walls.PROGRAM, "--version"], capture_output=True, text=True, check=False)
    return done.stdout.strip().splitlines()[0] if done.stdout else "unknown"


class Table:
    """Prints rows as they are added; save() keeps them for the report."""

    def __init__(self, *columns):
        self.lines = []
        self.row(*columns)
        self.put("|" + "---|" * len(columns))

    def put(self, line):
        self.lines.append(line)
        print(line, flush=True)

    def row(self, *cells):
        self.put("| " + " | ".join(str(c) for c in cells) + " |")

    def save(self, name, command, runs=True):
        """Stores the table. runs: it is derived from runs of the program."""
        FOLDER.mkdir(parents=True, exist_ok=True)
        made = f"`{command}`, {datetime.date.today()}" + (f", {version()}" if runs else "")
        (FOLDER / f"{name}.txt").write_text("\n".join([made, *self.lines]) + "\n", encoding="utf-8")


def quoted(text, folder=None):
    """Replaces lines {table NAME} of a text by the tables, with their origin below."""
    out = []
    for line in text.splitlines():
        if not line.startswith("{table "):
            out.append(line)
            continue
        path = pathlib.Path(folder or FOLDER) / f"{line[7:-1]}.txt"
        if not path.exists():
            raise FileNotFoundError(f"{path}: no such table; the script that makes it has not been run")
        made, *rows = path.read_text(encoding="utf-8").splitlines()
        out += rows + ["", *textwrap.wrap(f"({made})", 100, break_long_words=False, break_on_hyphens=False)]
    return "\n".join(out)
