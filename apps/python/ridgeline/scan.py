# SPDX-License-Identifier: BSD-3-Clause
"""The roof edges of a point cloud."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ridgeline import _core
from ridgeline._arguments import warn
from ridgeline.cloud import CloudLike, cloud_options, cloud_source
from ridgeline.lines import Lines, lines_of


def edges(
    cloud: CloudLike,
    *,
    min_length_m: float = 1.0,
    only_roofs: bool = False,
    bounds: Sequence[float] | None = None,
    classes: Iterable[int] | None = None,
    include_withheld: bool = False,
    last_returns: bool = False,
    max_resolution_m: float = 0.0,
    max_points: int = 0,
    assume_crs: str = "",
    scale_to_ground: bool = False,
    strict: bool = False,
    salvage: bool = False,
    cloud_memory_mib: int = 512,
) -> Lines:
    """Finds the roof edges of a point cloud, like `ridgeline edges`.

    The kind of a line is "ridge", "hip", "valley", "eave", "verge" or "step"; plane_ids are the
    planes that it bounds; support is the share of its length with points next to it; moved_out_m is
    by how much an eave, verge or step was moved out beyond the outermost points. docs/edges.md
    describes what is found and what is not.

    cloud: files or patterns (see read_cloud()), a Cloud, or an array (n, 3). Coordinates are map
        coordinates.
    min_length_m: shortest edge.
    only_roofs: the points are those of roofs alone, as with classes=[6]: a roof then ends where the
        points end.
    bounds ... salvage: options for reading the cloud, as for read_cloud().
    scale_to_ground: divide plan coordinates by the local map scale, as needed for Web Mercator; by
        default, data that are not true to scale are refused.
    cloud_memory_mib: memory for points; larger clouds are read and processed part by part.
    Arrays must not change during the call. Warns about suspicious inputs. Raises
    FileNotFoundError, InputFileError, and ValueError or TypeError for an invalid value.
    """
    options = {
        **cloud_options(
            bounds,
            classes,
            include_withheld=include_withheld,
            last_returns=last_returns,
            max_resolution_m=max_resolution_m,
            max_points=max_points,
            assume_crs=assume_crs,
            strict=strict,
            salvage=salvage,
        ),
        "cloud_memory_mib": cloud_memory_mib,
        "min_length_m": float(min_length_m),
        "only_roofs": only_roofs,
        "scale_to_ground": scale_to_ground,
    }
    points, of_points = cloud_source(cloud, strict=strict)
    entries = _core.edges(points, options | of_points)
    warn(entries["warnings"])
    return lines_of(entries)
