# SPDX-License-Identifier: BSD-3-Clause
"""Point clouds in NumPy."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ridgeline import _core
from ridgeline._arguments import Path, double_of, paths_of, warn


@dataclass(frozen=True, eq=False, repr=False)
class Cloud:
    """Points of a laser scan.

    points: a structured array (n,) with the fields x, y, z (float64, coordinates of the map in its
        units), intensity, classification (ASPRS: 2 ground, 6 building), return_number,
        number_of_returns, flags, source_id. Index it with a mask, `points[mask]`, to get a subset.
    crs: the reference system, as WKT, code or PROJ string; "" if unknown.
    counts: numbers of points read and dropped, by reason.
    """

    points: NDArray[Any]
    crs: str = ""
    counts: Mapping[str, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        points = np.asarray(self.points)
        if points.dtype != _core.point_dtype or points.ndim != 1:
            raise ValueError(f"points: {points.dtype} {points.shape}; must be those of read_cloud() or Cloud.of()")
        object.__setattr__(self, "points", np.ascontiguousarray(points))

    @classmethod
    def of(cls, xyz: ArrayLike, *, classification: ArrayLike = 0, crs: str = "") -> Cloud:
        """A cloud from coordinates (n, 3), each the only return of its pulse; `classification`:
        (n,), or one value for all.
        """
        x = double_of(xyz, "xyz")
        codes = np.asarray(classification)
        if codes.dtype.kind not in "iu" or (codes < 0).any() or (codes > 255).any():
            raise ValueError("classification: must be whole numbers from 0 to 255")
        if x.ndim != 2 or x.shape[1] != 3:
            raise ValueError(f"xyz: the shape is {x.shape}; must be (n, 3)")
        points = np.zeros(len(x), dtype=_core.point_dtype)
        points["x"], points["y"], points["z"] = x.T
        points["classification"] = codes
        points["return_number"] = points["number_of_returns"] = 1
        return cls(points, crs)

    @property
    def xyz(self) -> NDArray[np.float64]:
        """The coordinates (n, 3) as a view of `points`."""
        row = self.points.dtype.itemsize
        return np.ndarray((len(self.points), 3), np.float64, self.points, strides=(row, 8))

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"<ridgeline.Cloud: {len(self)} points>"


#: What evaluate() and edges() take as a cloud.
CloudLike: TypeAlias = Path | Sequence[Path] | Cloud | NDArray[np.float64]


def cloud_source(cloud: CloudLike, *, strict: bool) -> tuple[Any, dict[str, Any]]:
    """The paths or points of a cloud, and its entries for the options."""
    if isinstance(cloud, np.ndarray) and cloud.dtype == _core.point_dtype:
        cloud = Cloud(cloud)
    if isinstance(cloud, Cloud):
        return cloud.points, {"cloud_crs": cloud.crs}
    if isinstance(cloud, np.ndarray):
        return double_of(cloud, "cloud", strict=strict), {}
    return paths_of(cloud, "cloud"), {}


def cloud_options(
    bounds: Sequence[float] | None, classes: Iterable[int] | None, **others: float | bool | str
) -> dict[str, Any]:
    """The options for reading a cloud, for the extension module."""
    return {
        "bounds": None if bounds is None else [float(b) for b in bounds],
        "classes": None if classes is None else [int(c) for c in classes],
        **others,
    }


def read_cloud(
    paths: Path | Sequence[Path],
    *,
    bounds: Sequence[float] | None = None,
    classes: Iterable[int] | None = None,
    include_withheld: bool = False,
    last_returns: bool = False,
    max_resolution_m: float = 0.0,
    max_points: int = 0,
    assume_crs: str = "",
    strict: bool = False,
    salvage: bool = False,
) -> Cloud:
    """Reads LAS, LAZ, COPC, PCD, PLY or text into one cloud.

    paths: a file, or several; patterns such as "tiles/*.laz" are expanded.
    bounds: (x_min, y_min, x_max, y_max) in the coordinates of the files; for COPC, only the nodes
        inside are decoded.
    classes: ASPRS classes to keep; default: all but noise (7, 18).
    include_withheld: keep points flagged as withheld.
    last_returns: keep only the last return of each pulse.
    max_resolution_m: read COPC only down to this point distance; 0: all.
    max_points: largest number of points to keep; 0: no limit.
    assume_crs: reference system of the files, overriding theirs.
    strict: refuse coordinates in steps above 0.025 m (float32, too few digits).
    salvage: read what is left of a truncated file.
    Warns about suspicious inputs. Raises FileNotFoundError, InputFileError and ValueError.
    """
    options = cloud_options(
        bounds,
        classes,
        include_withheld=include_withheld,
        last_returns=last_returns,
        max_resolution_m=max_resolution_m,
        max_points=max_points,
        assume_crs=assume_crs,
        strict=strict,
        salvage=salvage,
    )
    points, crs, messages, counts = _core.read_cloud(paths_of(paths), options)
    warn(messages)
    return Cloud(points, crs, counts)
