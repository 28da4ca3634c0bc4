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


def is_path(value: object) -> bool:
    return isinstance(value, (str, os.PathLike))


def paths_of(value: Path | Sequence[Path]) -> list[str]:
    if is_path(value):
        return [os.fspath(value)]  # type: ignore[arg-type]
    return [os.fspath(path) for path in value]  # type: ignore[union-attr]


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
    if is_path(config):
        entries["config"] = os.fspath(config)  # type: ignore[arg-type]
    elif config is not None:
        groups = {name: dict(group) for name, group in config.items()}  # type: ignore[union-attr]
    if judge:
        groups["judge"] = {**groups.get("judge", {}), **judge}
    if groups:
        entries["config_text"] = text_of(groups)
    return entries


def warn(messages: Iterable[str]) -> None:
    """Of a function that the user calls."""
    for message in messages:
        warnings.warn(message, UserWarning, stacklevel=3)
