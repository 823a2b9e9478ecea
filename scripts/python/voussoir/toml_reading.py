# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Reads TOML. Python 3.10 has no reader in its library; there it is tomli, which pip brings with it.

Scripts of studies import this file alone, without the rest of the package."""

try:
    from tomllib import TOMLDecodeError, loads
except ImportError:
    try:
        from tomli import TOMLDecodeError, loads  # type: ignore[no-redef,import-not-found,unused-ignore]
    except ImportError:
        from pip._vendor.tomli import TOMLDecodeError, loads  # type: ignore[no-redef,import-not-found,unused-ignore]

__all__ = ["TOMLDecodeError", "loads"]
