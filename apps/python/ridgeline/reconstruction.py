# SPDX-License-Identifier: BSD-3-Clause
"""3D lines from oriented images."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ridgeline import _core
from ridgeline._arguments import Config, Path, config_entries, double_of, warn
from ridgeline.lines import Lines, lines_of


@dataclass(eq=False, repr=False)
class View:
    """An oriented image without distortion.

    image: (height, width) or (height, width, bands), uint8 or uint16, 1 to 4 bands.
    matrix: (3, 4), projects homogeneous map coordinates (x, y, z, 1) to homogeneous pixels (column,
        row, 1). The centre of the top-left pixel is (0, 0).
    id: name of the view in messages.
    """

    image: NDArray[Any]
    matrix: NDArray[np.float64]
    id: str = "image"

    def __repr__(self) -> str:
        return f"<ridgeline.View {self.id}: {np.shape(self.image)}>"


def view_entries(views: Sequence[View], height_range_m: Sequence[float] | None) -> dict[str, Any]:
    """The cameras and heights for the extension module."""
    if height_range_m is None:
        raise ValueError("height_range_m: is required with views")
    given = list(views)
    if not all(isinstance(view, View) for view in given):
        raise TypeError("views: must be View objects, View(image, matrix)")
    return {
        "height_range_m": [float(height) for height in height_range_m],
        "views": [(str(view.id), double_of(view.matrix, f"matrix of {view.id}")) for view in given],
    }


def reconstruct(
    views: Path | Sequence[View],
    height_range_m: Sequence[float] | None = None,
    *,
    method: str | None = None,
    preset: str = "default",
    matcher: str = "pairwise",
    config: Config | None = None,
    crs: str = "",
) -> Lines:
    """Reconstructs the 3D lines of two oriented images, like `ridgeline reconstruct`.

    views: two views, the first of which is the base image; or a patch file, which includes heights and
        reference system.
    height_range_m: lowest and highest height of objects, in metres of the map.
    method: "lines" (the default, except with "published"): the lines of "network" plus the ridges,
        hips and valleys without a visible edge ("planes"); "direct" and "joint" (the default with
        "published"): the methods of the papers.
    preset: "default" (best-performing settings) or "published" (the papers' method).
    matcher: "pairwise" or "chio".
    config: a config file (see `ridgeline config`), or a mapping {"match": {...}, ...}.
    crs: reference system of the matrices, and thus of the lines.
    Returns lines with class, status, covariance and image segments, and with NaN coordinates where
    the images do not determine the depth. Warns if there are too few tie points to check the
    cameras. Raises an error if images and cameras do not match, ValueError for an invalid value,
    and FileNotFoundError and InputFileError for files.
    """
    options: dict[str, Any] = {
        "matcher": matcher,
        "preset": preset,
        **config_entries(config),
    }
    if method is not None:
        options["method"] = method
    if isinstance(views, (str, os.PathLike)):
        if height_range_m is not None or crs:
            raise ValueError("height_range_m, crs: are defined by the patch file; do not give them")
        found = _core.reconstruct_patch(os.fspath(views), options)
    else:
        options |= view_entries(views, height_range_m)
        options |= {"crs": crs, "images": [np.ascontiguousarray(view.image) for view in views]}
        found = _core.reconstruct_views(options)
    warn(found["warnings"])
    return lines_of(found)
