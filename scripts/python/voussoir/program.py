# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Which program is started. Imports nothing of this package, so that scripts can use it without NumPy and h5py."""

import os
import pathlib
import shutil

_UP = pathlib.Path(__file__).resolve().parents[3]
CHECKOUT = _UP if (_UP / "CMakeLists.txt").exists() else None  # None where the package is installed


def program() -> str:
    """VOUSSOIR if it is set, else what `scripts/build` built in the checkout that holds this package, else `voussoir` on the PATH.

    If none exists: the path where one is expected.
    """
    if os.environ.get("VOUSSOIR"):
        return os.path.abspath(os.environ["VOUSSOIR"])
    built = CHECKOUT / "build/release/io/voussoir" if CHECKOUT else None
    if built and built.exists():
        return str(built)
    return shutil.which("voussoir") or str(built or "voussoir")


def results() -> pathlib.Path:
    """The folder for results: of the checkout, or, without one, of the working folder."""
    return (CHECKOUT or pathlib.Path.cwd()) / "results"
