# SPDX-License-Identifier: BSD-3-Clause
"""How arguments reach the extension module."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np

Path: TypeAlias = str | os.PathLike[str]
Config: TypeAlias = Path | Mapping[str, Mapping[str, Any]]


def paths_of(value: Path | Sequence[Path]) -> list[str]:
    if isinstance(value, (str, os.PathLike)):
        return [os.fspath(value)]
    return [os.fspath(path) for path in value]


def _plain(value: Any) -> Any:
    """NumPy's numbers as JSON knows them."""
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"{value!r} is no number, text or list")


def text_of(value: Any) -> str:
    """A value as JSON, which is YAML as well."""
    return json.dumps(value, default=_plain)


def config_entries(config: Config | None, judge: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """A config file, or a mapping as `ridgeline config` prints it, and the parameters of its group `judge`."""
    entries: dict[str, Any] = {}
    groups: dict[str, Any] = {}
    if isinstance(config, (str, os.PathLike)):
        entries["config"] = os.fspath(config)
    elif config is not None:
        groups = {name: dict(group) for name, group in config.items()}
    if judge:
        groups["judge"] = {**groups.get("judge", {}), **judge}
    if groups:
        entries["config_text"] = text_of(groups)
    return entries


def new_file(path: Path, overwrite: bool) -> str:
    """Nothing that stands there is lost unless the user says so."""
    if os.path.lexists(path) and not overwrite:
        raise FileExistsError(f"{os.fspath(path)}: stands there and would be written over; overwrite=True allows it")
    return os.fspath(path)


def warn(messages: Iterable[str]) -> None:
    """Of a function that the user calls."""
    for message in messages:
        warnings.warn(message, UserWarning, stacklevel=3)
