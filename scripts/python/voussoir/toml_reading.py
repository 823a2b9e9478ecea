# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Reads TOML, also in Python 3.10, whose library cannot: there with tomli, which each pip for it holds. Scripts of studies import this file alone."""

try:
    from tomllib import TOMLDecodeError, loads
except ImportError:
    try:
        from tomli import TOMLDecodeError, loads  # type: ignore[no-redef,import-not-found,unused-ignore]
    except ImportError:
        from pip._vendor.tomli import TOMLDecodeError, loads  # type: ignore[no-redef,import-not-found,unused-ignore]

__all__ = ["TOMLDecodeError", "loads"]
