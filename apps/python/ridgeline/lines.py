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
    """3D line segments with what is known of them; what is not known is None, "" or NaN.

    Texts are arrays (n,), so that `lines[lines.status == "joint"]` makes Lines of a part.

    segments: (n, 2, 3), start and end, coordinates of the map in its units; (n, 6) is taken as
        well.
    ids: by default "0", "1", ...
    line_class: "aligned" (within 10 degrees of the epipolar line) or "not_aligned"; lines of any
        other class count in the figures of "total" alone.
    status: how a reconstructed line came about; one without geometry has NaN coordinates.
    method, kind, building: as in the files (docs/files.md).
    epipolar_angle_deg: (n,), degrees.
    covariance_m2: (n, 6, 6), of (start, end), square metres.
    left_px, right_px: (n, 2, 2), the segments in both images that a line was made from, pixels.
    crs: the reference system; "" if unknown: that of the cloud.
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
    left_px: NDArray[np.float64] | None = None
    right_px: NDArray[np.float64] | None = None
    crs: str = ""

    def __post_init__(self) -> None:
        self.segments = segments_of(self.segments)
        for name in TEXTS:
            if getattr(self, name) is not None:
                setattr(self, name, _texts(getattr(self, name), name))

    def __len__(self) -> int:
        return len(self.segments)

    def __getitem__(self, index: Any) -> Lines:
        """The lines of a mask, a slice or an array of indices."""
        if isinstance(index, (int, np.integer)):
            raise TypeError("lines[i] makes Lines of a part; one line is lines[[i]]")
        part: dict[str, Any] = {"crs": self.crs}
        for name in (f.name for f in fields(self) if f.name != "crs"):
            values = getattr(self, name)
            part[name] = None if values is None else np.asarray(values)[index]
        return Lines(**part)

    def __repr__(self) -> str:
        return f"<ridgeline.Lines: {len(self)} lines>"

    def _entries(self) -> dict[str, Any]:
        entries = {f.name: getattr(self, f.name) for f in fields(self)}
        for name in TEXTS:
            if entries[name] is not None:
                entries[name] = entries[name].tolist()
        return entries


def _texts(texts: Any, name: str) -> NDArray[np.str_]:
    """An array of texts, one for each line; numbers become texts."""
    if isinstance(texts, (str, bytes)):
        raise TypeError(f"{name}: {texts!r}, must be a list of texts, one for each line")
    given = list(texts)
    if any(text is None or isinstance(text, bytes) for text in given):
        raise TypeError(f"{name}: None or bytes among the texts; must be texts or numbers")
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
    """The Lines of a dict that the extension module returns."""
    return Lines(**{f.name: entries[f.name] for f in fields(Lines)})


def read_lines(path: Path, *, assume_crs: str = "", vertex_pairs: bool = False, lod: str = "") -> Lines:
    """Reads the 3D lines of any tool: GeoJSON, GeoPackage, Shapefile, DXF, WKT, CSV, OBJ, PLY,
    Line3D++, LIMAP, ELSR.

    Polylines become segments. assume_crs: reference system, whatever the file states. vertex_pairs:
    an OBJ's vertices two by two are the lines. Warns of what deserves attention. Raises
    FileNotFoundError and InputFileError.
    """
    entries = _core.read_lines(os.fspath(path), assume_crs, vertex_pairs, lod)
    warn(entries["warnings"])
    return lines_of(entries)


def write_lines(path: Path, lines: Lines | ArrayLike, *, format: str | None = None, overwrite: bool = False) -> int:
    """Writes lines with their attributes. Returns the number of lines left out because they have no
    geometry.

    format: a name that `ridgeline reconstruct --help` lists; by default the ending of the path
    tells it. Raises FileExistsError unless overwrite.
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
