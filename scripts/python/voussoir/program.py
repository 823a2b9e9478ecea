# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Which program is started. Imports nothing of this package, so that scripts can use it without NumPy and h5py."""

import os
import pathlib
import shutil
import sys
import sysconfig

_HOME = pathlib.Path(__file__).resolve().parents[1]
_UP = pathlib.Path(__file__).resolve().parents[3]
CHECKOUT = _UP if (_UP / "CMakeLists.txt").exists() else None  # None where the package is installed


def program() -> str:
    """VOUSSOIR if it is set, else the program that came with this package: what `scripts/build` built in the checkout that holds it, or what
    a wheel has put beside Python; else `voussoir` on the PATH.

    If none exists: the path where one is expected.
    """
    if os.environ.get("VOUSSOIR"):
        return os.path.abspath(os.environ["VOUSSOIR"])
    built = CHECKOUT / "build/release/io/voussoir" if CHECKOUT else None
    if built and built.exists():
        return str(built)
    for folder in () if CHECKOUT else _folders():
        found = shutil.which("voussoir", path=folder)
        if found:
            return found
    return shutil.which("voussoir") or str(built or "voussoir")


def _folders() -> list[str]:
    """Where pip puts programs: of this environment, of the user, of `pip install --target`."""
    user = sysconfig.get_path("scripts", f"{os.name}_user")
    return [os.path.dirname(sys.executable), sysconfig.get_path("scripts"), user, str(_HOME / "bin")]


def results() -> pathlib.Path:
    """The folder for results: of the checkout, or, without one, of the working folder."""
    return (CHECKOUT or pathlib.Path.cwd()) / "results"
