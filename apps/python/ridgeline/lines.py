# SPDX-License-Identifier: BSD-3-Clause
"""3D line segments in NumPy."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, fields
from pathlib import PurePath
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ridgeline import _core
from ridgeline._arguments import Path, new_file, warn


@dataclass(eq=False)
class Lines:
    """3D line segments with what is known of them; None and NaN where there is nothing.

    segments: (n, 2, 3), start and end, coordinates of the map in its units; (n, 6) is taken as well.
    ids: by default "0", "1", ...
    line_class: "aligned" (within 10 degrees of the epipolar line), "not_aligned" or the file's own.
    status: how a reconstructed line came about; one without geometry has NaN coordinates.
    method, kind, building: as in the files (docs/patch-file.md).
    epipolar_angle_deg: (n,), degrees.
    covariance_m2: (n, 6, 6), of (start, end), square metres.
    left_px, right_px: (n, 2, 2), the segments in both images that a line was made from, pixels.
    crs: the reference system; "" if unknown: that of the cloud.
    """

    segments: NDArray[np.float64]
    ids: Sequence[str] | None = None
    line_class: Sequence[str] | None = None
    status: Sequence[str] | None = None
    method: Sequence[str] | None = None
    kind: Sequence[str] | None = None
    building: Sequence[str] | None = None
    epipolar_angle_deg: NDArray[np.float64] | None = None
    covariance_m2: NDArray[np.float64] | None = None
    left_px: NDArray[np.float64] | None = None
    right_px: NDArray[np.float64] | None = None
    crs: str = ""

    def __post_init__(self) -> None:
        self.segments = segments_of(self.segments)

    def __len__(self) -> int:
        return len(self.segments)

    def _entries(self) -> dict[str, Any]:
        texts = ("ids", "line_class", "status", "method", "kind", "building")
        entries = {f.name: getattr(self, f.name) for f in fields(self)}
        for name in texts:
            if entries[name] is not None:
                entries[name] = [str(text) for text in entries[name]]
        return entries


def segments_of(array: ArrayLike) -> NDArray[np.float64]:
    """(n, 2, 3) of (n, 2, 3) or (n, 6)."""
    segments = np.ascontiguousarray(array, dtype=np.float64)
    if segments.ndim == 2 and segments.shape[1] == 6:
        return segments.reshape(-1, 2, 3)
    if segments.ndim != 3 or segments.shape[1:] != (2, 3):
        raise ValueError(f"lines: the shape is {segments.shape}; must be (n, 2, 3) or (n, 6)")
    return segments


def lines_of(entries: dict[str, Any]) -> Lines:
    """Of what the extension module returns."""
    return Lines(**{f.name: entries[f.name] for f in fields(Lines)})


def read_lines(path: Path, *, assume_crs: str = "", vertex_pairs: bool = False) -> Lines:
    """Reads the 3D lines of any tool: GeoJSON, GeoPackage, Shapefile, DXF, WKT, CSV, OBJ, PLY, Line3D++, LIMAP, ELSR.

    Polylines become segments. assume_crs: reference system, whatever the file states. vertex_pairs: an OBJ's vertices
    two by two are the lines. Warns of what deserves attention. Raises FileNotFoundError and InputFileError.
    """
    entries = _core.read_lines(os.fspath(path), assume_crs, vertex_pairs)
    warn(entries["warnings"])
    return lines_of(entries)


def write_lines(path: Path, lines: Lines | ArrayLike, *, format: str | None = None, overwrite: bool = False) -> int:
    """Writes lines with their attributes; returns how many the format has no place for, as they have no geometry.

    format: by its name in `ridgeline reconstruct --help`; by default by the ending of the path.
    Raises FileExistsError unless overwrite.
    """
    given = lines if isinstance(lines, Lines) else Lines(segments_of(lines))
    name = format or _format_of(os.fspath(path))
    return _core.write_lines(new_file(path, overwrite), given._entries(), name)


def _format_of(path: str) -> str:
    ending = PurePath(path).suffix.lower()
    for name, extension in _core.line_formats:
        if extension == ending and name != "wkt_csv":
            return name
    known = ", ".join(extension for _, extension in _core.line_formats)
    raise ValueError(f"{path}: lines are not written to this ending; must be one of {known}")
