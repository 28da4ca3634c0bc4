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
from ridgeline._arguments import Path, double_of, new_file, warn


TEXTS = ("ids", "line_class", "status", "method", "kind", "building")


@dataclass(eq=False, repr=False)
class Lines:
    """3D line segments with their attributes; unknown ones are None, "" or NaN.

    Text attributes are arrays (n,); `lines[lines.status == "joint"]` is a subset.

    segments: (n, 2, 3), start and end in map coordinates; also accepts (n, 6).
    ids: by default "0", "1", ...
    line_class: "aligned" (within 10 degrees of the epipolar line) or "not_aligned"; lines of any
        other class only count in the figures of "total".
    status: how a line was determined; lines without geometry have NaN coordinates.
    method, kind, building: as in the files (docs/files.md).
    epipolar_angle_deg: (n,), degrees.
    covariance_m2: (n, 6, 6), of (start, end), square metres.
    plane_ids: (n,), a list for each line, the planes that it bounds; only for edges() and true
        lines.
    support, moved_out_m: (n,), see edges().
    left_px, right_px: (n, 2, 2), the segments of a line in both images, pixels.
    crs: the reference system; if "" (unknown), that of the cloud is assumed.
    """

    segments: NDArray[np.float64]
    ids: Sequence[str] | NDArray[np.str_] | None = None
    line_class: Sequence[str] | NDArray[np.str_] | None = None
    status: Sequence[str] | NDArray[np.str_] | None = None
    method: Sequence[str] | NDArray[np.str_] | None = None
    kind: Sequence[str] | NDArray[np.str_] | None = None
    building: Sequence[str] | NDArray[np.str_] | None = None
    epipolar_angle_deg: NDArray[np.float64] | None = None
    covariance_m2: NDArray[np.float64] | None = None
    plane_ids: Sequence[Sequence[int]] | NDArray[np.object_] | None = None
    support: NDArray[np.float64] | None = None
    moved_out_m: NDArray[np.float64] | None = None
    left_px: NDArray[np.float64] | None = None
    right_px: NDArray[np.float64] | None = None
    crs: str = ""

    def __post_init__(self) -> None:
        self.segments = segments_of(self.segments)
        for name in TEXTS:
            if getattr(self, name) is not None:
                setattr(self, name, _texts(getattr(self, name), name))
        if self.plane_ids is not None:
            lists = np.empty(len(self.plane_ids), dtype=object)
            for i, ids in enumerate(self.plane_ids):
                lists[i] = list(ids)
            self.plane_ids = lists

    def __len__(self) -> int:
        return len(self.segments)

    def __getitem__(self, index: Any) -> Lines:
        """The lines selected by a mask, a slice or an array of indices."""
        if isinstance(index, (int, np.integer)):
            raise TypeError("lines[i] must be a mask, slice or list; a single line is lines[[i]]")
        part: dict[str, Any] = {"crs": self.crs}
        for name in (f.name for f in fields(self) if f.name != "crs"):
            values = getattr(self, name)
            part[name] = None if values is None else np.asarray(values)[index]
        return Lines(**part)

    def __repr__(self) -> str:
        return f"<ridgeline.Lines: {len(self)} lines>"

    def _entries(self) -> dict[str, Any]:
        entries = {f.name: getattr(self, f.name) for f in fields(self)}
        for name in (*TEXTS, "plane_ids"):
            if entries[name] is not None:
                entries[name] = entries[name].tolist()
        return entries


def _texts(texts: Any, name: str) -> NDArray[np.str_]:
    """An array of strings, one per line; numbers are converted."""
    if isinstance(texts, (str, bytes)):
        raise TypeError(f"{name}: {texts!r}, must be a list of strings, one per line")
    given = list(texts)
    if any(text is None or isinstance(text, bytes) for text in given):
        raise TypeError(f"{name}: contains None or bytes; must be strings or numbers")
    return np.array([str(text) for text in given], dtype=np.str_)


def segments_of(array: ArrayLike) -> NDArray[np.float64]:
    """Segments (n, 2, 3) from an array (n, 2, 3) or (n, 6)."""
    segments = double_of(array, "lines")
    if segments.size == 0:
        return segments.reshape(0, 2, 3)
    if segments.ndim == 2 and segments.shape[1] == 6:
        return segments.reshape(-1, 2, 3)
    if segments.ndim != 3 or segments.shape[1:] != (2, 3):
        raise ValueError(f"lines: the shape is {segments.shape}; must be (n, 2, 3) or (n, 6)")
    return segments


def lines_of(entries: dict[str, Any]) -> Lines:
    """The Lines from a dict returned by the extension module."""
    return Lines(**{f.name: entries[f.name] for f in fields(Lines)})


def read_lines(path: Path, *, assume_crs: str = "", vertex_pairs: bool = False, lod: str = "") -> Lines:
    """Reads the 3D lines of any tool: GeoJSON, GeoPackage, Shapefile, DXF, WKT, CSV, OBJ, PLY,
    Line3D++, LIMAP, ELSR.

    Polylines become segments.

    assume_crs: reference system, overriding that of the file.
    vertex_pairs: read every two consecutive vertices of an OBJ as a line.
    Warns about suspicious inputs. Raises FileNotFoundError and InputFileError.
    """
    entries = _core.read_lines(os.fspath(path), assume_crs, vertex_pairs, lod)
    warn(entries["warnings"])
    return lines_of(entries)


def write_lines(path: Path, lines: Lines | ArrayLike, *, format: str | None = None, overwrite: bool = False) -> int:
    """Writes lines with their attributes. Returns the number of lines skipped because they have no
    geometry.

    format: a name listed by `ridgeline reconstruct --help`; default: by the extension of the path.
    Raises FileExistsError if the file exists, unless overwrite.
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
    raise ValueError(f"{path}: unknown extension; must be one of {known}")
