# SPDX-License-Identifier: BSD-3-Clause
"""Lines judged against a point cloud."""

from __future__ import annotations

import csv
import io
import json
import os
import re
from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ridgeline import _core
from ridgeline._arguments import Config, Path, config_entries, new_file, warn
from ridgeline.cloud import CloudLike, cloud_options, cloud_source
from ridgeline.lines import Lines, segments_of
from ridgeline.reconstruction import View, view_entries

#: Columns of the tables that are always read as text.
TEXTS = ("patch", "method", "class", "kind", "reference")

#: What evaluate() takes as lines.
LinesLike = Path | Lines | ArrayLike


class Result:
    """The result of evaluate(). print() shows the accuracy table."""

    def __init__(self, judged: _core.Judged) -> None:
        self._judged = judged

    @cached_property
    def lines(self) -> dict[str, Any]:
        """All lines in input order: arrays (n,) by name, ready for pandas.DataFrame().

        id, line_class, kind: "step", "ridge" or "". status: "evaluated", or why the line was
            not, with details in reason.
        surface: the most probable surface bounded by the line: "upper", "lower", "ground", "ridge",
            "object", with surface_probability; surface_other: the second most probable one;
            decided_by: the evidence that decided, "plan", "images", "points", "place". "" and NaN
            if unknown.
        flags, plane_ids: a list for each line.
        length_m, epipolar_angle_deg.
        n_images: number of images that support the line, NaN if unknown; class_base: with three or
            more images, the class in the base pair only, else "".
        mean_distance_m: the mean orthogonal distance from the adjacent planes;
            max_distance_m, signed_mean_m.
        sigma_plane_m, sigma_line_m: standard deviations of planes and line; z: the signed distance
            divided by both.
        horizontal_m, vertical_m: the error of a ridge, across it in plan, and in height.
        Distances are metres, and NaN for a line that was not evaluated.
        """
        columns = dict(self._judged.lines())
        texts = ("id", "line_class", "class_base", "kind", "status", "reason", "surface", "surface_other", "decided_by")
        for name in texts:
            columns[name] = np.array(columns[name], dtype=np.str_)
        for name in ("flags", "plane_ids"):
            column = np.empty(len(columns[name]), dtype=object)
            column[:] = columns[name]
            columns[name] = column
        return columns

    @cached_property
    def segments(self) -> NDArray[np.float64]:
        """The judged lines (n, 2, 3): as given, or moved by apply_shift."""
        segments: NDArray[np.float64] = self._judged.segments()["segments"]
        return segments

    @cached_property
    def planes(self) -> list[dict[str, Any]]:
        """The LIDAR planes used for judging, one dict per plane.

        id; normal (3,), upwards, and offset_m: normal . x + offset_m = 0 in map coordinates,
        metres; n_points and rms_m of its points; n_lines, the number of lines judged against it;
        outline (k, 3), the hull of its points.
        """
        return self._judged.planes()

    @cached_property
    def classes(self) -> dict[str, dict[str, Any]]:
        """The figures of each class, including "total": n_lines, n_evaluated, rms_m, ci95_m,
        median_m, q95_m, ...

        n_half_of_squares: number of the worst lines that contribute half of the sum of squares;
            rms_without_half_m: the RMS of the others.
        decided_by: the same figures for lines whose surface was chosen by plan and images
            ("plan_images", the headline) and by points or place ("points_place").
        """
        figures: dict[str, dict[str, Any]] = self.to_dict()["summary"]
        return figures

    @cached_property
    def shift(self) -> dict[str, Any] | None:
        """The common shift between lines and LIDAR planes; None if no line was judged.

        axes: "x", "y" and "z" with shift_m and ci95_m, or None for an axis that the planes do not
        determine. significant, likely_cause, applied, ... as in the file evaluation.METHOD.json
        (docs/outputs.md).
        """
        shift: dict[str, Any] | None = self.to_dict()["shift"]
        return shift

    @cached_property
    def decoys(self) -> list[dict[str, Any]]:
        """How many lines moved on purpose would pass as correct, one dict per kind and distance;
        empty for decoys=0.

        kind: "height", "across" or "match"; distance_m; n_lines, n_decoys; share: the share of
        decoys that pass within 0.2 m, with ci95; withheld_share: the share that was not evaluated.
        It does not show how many lines are wrong (docs/method.md).
        """
        decoys: list[dict[str, Any]] = self.to_dict()["decoys"]
        return decoys

    @cached_property
    def completeness(self) -> dict[str, Any] | None:
        """Which roof edges of the cloud the lines show; None without completeness=True.

        rows: one dict per kind ("ridge", "hip", "valley", "eave", "verge", "step", "all") and length
        ("2-4", "4-8", "8+" metres, "all"): n, n_found, recall with ci95, length_m, covered_m,
        recall_length. edges: one dict per edge: kind, start_m and end_m in map coordinates, metres,
        length_m, covered_share; it is found if that is at least 0.5. n_lines_without_edge: number of
        the n_lines that follow no edge of the cloud; they may be right. area_from, area_m2: where the
        edges were looked for (docs/outputs.md).
        """
        completeness: dict[str, Any] | None = self.to_dict().get("completeness")
        return completeness

    @cached_property
    def buildings(self) -> list[dict[str, Any]]:
        """The buildings of a model, one dict per building; empty for other line files.

        id, verdict, n_lines, n_judged_lines, rms_m, worst_line, worst_distance_m, n_faces, area_m2,
        ridge_height_m, ... as in the file buildings.csv (docs/models.md). The faces are in
        tables["faces"].
        """
        return self.tables.get("buildings", [])

    @cached_property
    def tables(self) -> dict[str, list[dict[str, Any]]]:
        """The tables by name, each row a dict: table2 and parts; tolerances; decoys; completeness; with
        reference lines, reference_errors, reference_completeness and wireframe; for models,
        buildings, faces, kinds and, with completeness, missing_roofs. Columns as in the files of the same name (docs/outputs.md)."""
        return {name: [_typed(row) for row in csv.DictReader(io.StringIO(text))] for name, text in self._judged.tables()}

    @cached_property
    def warnings(self) -> list[str]:
        """Warnings about the inputs."""
        return self._judged.warnings()

    def to_dict(self) -> dict[str, Any]:
        """Everything, as in the file evaluation.METHOD.json."""
        everything: dict[str, Any] = json.loads(self._judged.json())
        return everything

    def to_geopackage(self, path: Path, *, schema: str = "plain", overwrite: bool = False) -> None:
        """Writes the map: the lines, coloured by distance, their planes and error vectors, with
        styles for QGIS.

        schema: "plain" or "fkb". Raises FileExistsError if the file exists, unless overwrite. An
        input file of evaluate() is never overwritten.
        """
        self._judged.write_map(new_file(path, overwrite), schema)

    def write(self, folder: Path, *, schema: str = "plain", overwrite: bool = False) -> None:
        """Writes the files of `ridgeline evaluate --no-report` into a folder, for gates and
        `ridgeline report`.

        Raises FileExistsError for a folder that is not empty, unless overwrite.
        """
        if not overwrite and os.path.isdir(folder) and os.listdir(folder):
            raise FileExistsError(f"{os.fspath(folder)}: is not empty; overwrite=True replaces the files that ridgeline wrote there")
        self._judged.write(os.fspath(folder), schema)

    def __str__(self) -> str:
        return self._judged.text()

    def __repr__(self) -> str:
        total = self.classes["total"]
        headline = total["decided_by"]["plan_images"]
        rms = "none" if headline["rms_m"] is None else f"{headline['rms_m']:.3f} m"
        return (f"<ridgeline.Result: {total['n_evaluated']} of {total['n_lines']} lines judged, "
                f"RMS {rms} of {headline['n_evaluated']} by plan and images>")


def evaluate(
    lines: LinesLike,
    cloud: CloudLike,
    *,
    patch: Path | None = None,
    views: Sequence[View] | None = None,
    height_range_m: Sequence[float] | None = None,
    reference_lines: LinesLike | None = None,
    config: Config | None = None,
    bounds: Sequence[float] | None = None,
    classes: Iterable[int] | None = None,
    include_withheld: bool = False,
    last_returns: bool = False,
    max_resolution_m: float = 0.0,
    max_points: int = 0,
    assume_crs: str = "",
    scale_to_ground: bool = False,
    apply_shift: bool = False,
    geoid: Path | None = None,
    decoys: int | None = None,
    completeness: bool = False,
    strict: bool = False,
    salvage: bool = False,
    vertex_pairs: bool = False,
    lod: str = "",
    cloud_memory_mib: int = 512,
    name: str | None = None,
    max_aligned_angle_deg: float | None = None,
    gross_m: float = 1.0,
    sigma_sys_m: float = 0.0,
    bootstrap_replicates: int = 2000,
    bootstrap_seed: int = 1,
    bca: bool = False,
    **judge: float | str,
) -> Result:
    """Judges 3D lines by their orthogonal distances from adjacent LIDAR planes, like `ridgeline
    evaluate`.

    lines: a line file of any tool (see read_lines()), Lines, or an array (n, 2, 3) or (n, 6) of start
        and end.
    cloud: files or patterns (see read_cloud()), a Cloud, or an array (n, 3). Coordinates are map
        coordinates.
    patch: a patch file, whose cameras classify lines as aligned or not_aligned and locate their
        edges in the images.
    views, height_range_m: views in memory instead of a patch file, as for reconstruct().
    reference_lines: true lines, given as `lines` are; they add true errors, precision and
        completeness.
    config: a config file (see `ridgeline config`), or a mapping {"judge": {...}}.
    bounds ... salvage: options for reading the cloud, as for read_cloud().
    vertex_pairs, lod: as for read_lines().
    scale_to_ground: divide plan coordinates by the local map scale, as needed for Web Mercator; by
        default, data that are not true to scale are refused.
    apply_shift: remove a significant common shift between lines and LIDAR planes before judging
        (Result.shift).
    geoid: a geoid grid (.gtx, .tif) for explaining a height shift; default: grids of PROJ.
    decoys: number of lines to move on purpose and judge again (Result.decoys); default: half the
        number of lines, at least 200 and at most 2,000; 0: none, and no check that the lines fit
        better in place than elsewhere.
    completeness: find the roof edges in the cloud and report which of them the lines show
        (Result.completeness); takes several seconds per million points.
    cloud_memory_mib: memory for points; larger clouds are processed in batches of neighbouring
        lines.
    name: name of the patch in the tables; default: that of the patch file or the cloud.
    max_aligned_angle_deg: largest angle to the epipolar line of aligned lines; default: that of
        config, or 10.
    gross_m: distance above which a line is a gross error.
    sigma_sys_m: systematic part of the accuracy of the cloud.
    bootstrap_replicates, bootstrap_seed, bca: bootstrap of the 95 % intervals.
    judge: parameters of the judge by their names in `ridgeline config`: lidar_sigma_m (range noise
        of the cloud), corridor_half_width_m, inlier_distance_m, min_points, seed, ...
    Arrays must not change during the call. Warns about suspicious inputs. Raises
    FileNotFoundError, InputFileError, and ValueError or TypeError for an invalid value.
    """
    for option in judge:
        if option not in _core.judge_options:
            known = ", ".join(_core.judge_options)
            raise TypeError(f"evaluate() has no argument {option!r}; parameters of the judge are {known}")
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
        "apply_shift": apply_shift,
        "bca": bca,
        "bootstrap_replicates": bootstrap_replicates,
        "bootstrap_seed": bootstrap_seed,
        "cloud_memory_mib": cloud_memory_mib,
        "completeness": completeness,
        "decoys": decoys,
        "geoid": None if geoid is None else os.fspath(geoid),
        "gross_m": gross_m,
        "scale_to_ground": scale_to_ground,
        "max_aligned_angle_deg": max_aligned_angle_deg,
        "name": name,
        "patch": None if patch is None else os.fspath(patch),
        "sigma_sys_m": sigma_sys_m,
        "vertex_pairs": vertex_pairs,
        "lod": lod,
        **config_entries(config, judge),
    }
    if views is not None:
        if patch is not None:
            raise ValueError("patch, views: both are given; give only one")
        options |= view_entries(views, height_range_m)
    points, of_points = cloud_source(cloud, strict=strict)
    options |= of_points
    references = None if reference_lines is None else _source(reference_lines)
    result = Result(_core.evaluate(_source(lines), points, references, options))
    warn(result.warnings)
    return result


def _source(lines: LinesLike) -> str | dict[str, Any]:
    if isinstance(lines, (str, os.PathLike)):
        return os.fspath(lines)
    given = lines if isinstance(lines, Lines) else Lines(segments_of(lines))
    return given._entries()


def _typed(row: dict[str, str]) -> dict[str, Any]:
    return {name: text if name in TEXTS else _number(text) for name, text in row.items()}


def _number(text: str) -> int | float | str | None:
    if text == "":
        return None
    if re.fullmatch(r"-?\d+", text):
        return int(text)
    return float(text) if re.fullmatch(r"-?\d+\.\d*(e[+-]?\d+)?", text) else text
