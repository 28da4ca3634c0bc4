# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of arguments for the extension module."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Path: TypeAlias = str | os.PathLike[str]
#: Coarsest tolerable step of coordinates: a quarter of the tolerance of planes.
LARGEST_STEP_M = 0.025
Config: TypeAlias = Path | Mapping[str, Mapping[str, Any]]


def paths_of(value: Path | Sequence[Path], name: str = "paths") -> list[str]:
    if isinstance(value, (str, os.PathLike)):
        return [os.fspath(value)]
    try:
        return [os.fspath(path) for path in value]
    except TypeError:
        raise TypeError(f"{name}: {type(value).__name__}, must be the path of a file or a list of paths") from None


def double_of(array: ArrayLike, name: str, *, strict: bool = False) -> NDArray[np.float64]:
    """Contiguous doubles; masked entries become NaN. If float32 has lost digits of coordinates,
    warns, or raises if `strict`.
    """
    given: Any = np.asarray(array)
    if isinstance(array, np.ma.MaskedArray):
        given = np.where(array.mask, np.nan, given)
    if given.dtype in (np.float16, np.float32):
        largest = np.max(np.abs(given[np.isfinite(given)]), initial=0.0)
        step = float(np.spacing(given.dtype.type(largest)))
        if step > LARGEST_STEP_M:
            message = f"{name}: {given.dtype} holds these numbers in steps of {step:g} and loses digits; use float64"
            if strict:
                raise ValueError(message)
            warnings.warn(message, UserWarning, stacklevel=4)
    return np.ascontiguousarray(given, dtype=np.float64)


def _plain(value: Any) -> Any:
    """Converts NumPy numbers to Python numbers for JSON."""
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"{value!r} is not a number, string or list")


def text_of(value: Any) -> str:
    """A value as JSON, which is YAML as well."""
    return json.dumps(value, default=_plain)


def _group(name: str, group: Any) -> dict[str, Any]:
    if not isinstance(group, Mapping):
        raise TypeError(f"config: {name} = {group!r}, must be a mapping of parameters")
    return dict(group)


def config_entries(config: Config | None, judge: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Entries for a config file, or for a mapping with the structure printed by `ridgeline config`,
    and further parameters of its group `judge`.
    """
    entries: dict[str, Any] = {}
    groups: dict[str, Any] = {}
    if isinstance(config, (str, os.PathLike)):
        entries["config"] = os.fspath(config)
    elif config is not None:
        groups = {name: _group(name, group) for name, group in config.items()}
    if judge:
        groups["judge"] = {**groups.get("judge", {}), **judge}
    if groups:
        entries["config_text"] = text_of(groups)
    return entries


def new_file(path: Path, overwrite: bool) -> str:
    """The path as text. Raises FileExistsError if the path exists, unless `overwrite`."""
    if os.path.lexists(path) and not overwrite:
        raise FileExistsError(f"{os.fspath(path)}: already exists; overwrite=True replaces it")
    return os.fspath(path)


def warn(messages: Iterable[str]) -> None:
    """Warns at the line that calls the package; removes backticks around options, as in errors."""
    for message in messages:
        warnings.warn(message.replace("`", ""), UserWarning, stacklevel=3)
