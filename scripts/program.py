# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Which program the scripts start."""

import os
import pathlib
import shutil

SCRIPTS = pathlib.Path(__file__).resolve().parent
CHECKOUT = SCRIPTS.parent if (SCRIPTS.parent / "CMakeLists.txt").exists() else None  # None where the scripts are installed


def program():
    """VOUSSOIR if it is set, else what `scripts/build` built, else `voussoir` on the PATH; where none is there, the path at which one should be."""
    if os.environ.get("VOUSSOIR"):
        return os.path.abspath(os.environ["VOUSSOIR"])
    built = (CHECKOUT or SCRIPTS) / "build/release/io/voussoir"
    if CHECKOUT and built.exists():
        return str(built)
    return shutil.which("voussoir") or str(built)


def results():
    """Folder in which results lie: of the checkout, or, where there is none, of the working folder."""
    return (CHECKOUT or pathlib.Path.cwd()) / "results"
