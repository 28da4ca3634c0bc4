// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "io/gdal/attribute_table.h"
#include "io/models/building_model.h"
#include "io/text/kind_counts.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The segment that an image shows of a line.
struct LineObservation {
  std::string image;  ///< id of the image in its patch
  Segment2 px;        ///< ideal pixels
};

/// One 3D segment of a line file with what the file says of it. Attributes that the file does not
/// have stay empty.
struct Line {
  std::string id;         ///< the file's own `id` property or column, else source_fid
  std::string parent_id;  ///< id of the polyline or track it is a part of; empty if it is whole
  Segment3 segment_in_world{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  ///< file's CRS, m
  std::string line_class;  ///< `class`: aligned | not_aligned, or the file's own
  std::string
      class_base;        ///< `class` by the base pair alone; only of lines of three images and more
  std::string method;    ///< direct | joint | ...
  std::string kind;      ///< ridge | hip | valley | eave | verge | ground (true lines)
  std::string building;  ///< building id: the cluster of the bootstrap
  std::string status;
  /// Ids of its segments in the first two images of the patch, the base and the other one; in files
  /// `left_id`, `right_id`.
  std::string base_id, other_id;
  /// Ends of these segments from which the line was made, ideal pixels; in files `left_px`,
  /// `right_px`. Segments of the other image in our own files may have been moved across their
  /// direction (compare_profiles()).
  std::optional<Segment2> base_px, other_px;
  /// All image segments of a line that was made from three images or more, in files `observations`,
  /// [["IMAGE", x1, y1, x2, y2], ...].
  std::vector<LineObservation> observations;
  std::optional<double> epipolar_angle_deg;
  /// Share of the length of a true line that the base and the other image show, 0..1; in files
  /// `visible_left`, `visible_right`.
  std::optional<double> visible_base, visible_other;
  std::optional<int> n_points;  ///< artificial points used
  std::optional<int> n_images;  ///< supporting images (Line3D++, LIMAP)
  /// Covariance of (start, end) in world axes, m^2.
  std::optional<Eigen::Matrix<double, 6, 6>> covariance_m2;
  std::vector<int> plane_ids;  ///< ids of the planes that a true line bounds
  /// Id of its feature in the file: GDAL's feature id, an integer `id` of GeoJSON, else its place
  /// from 0.
  std::int64_t source_fid = 0;
  int part = 0;         ///< place in its feature, from 0
  int layer = 0;        ///< place in LineSet::layers
  std::size_t row = 0;  ///< row of its feature in LineSet::features
};

struct LineSet {
  std::string path;    ///< where it was read from
  std::string format;  ///< "GeoJSON", "Line3D++", ...
  Crs crs;
  std::vector<Line> lines;
  /// All that the file states of its features; formats without attributes have no columns.
  AttributeTable features;
  /// Names of the layers with lines; none in formats without layers.
  std::vector<std::string> layers;
  KindCounts left_out;                  ///< what the file holds that is no 3D line
  std::size_t n_straight_vertices = 0;  ///< vertices on a straight line, which do not divide it
  std::vector<std::string> warnings;
  /// The model whose edges the lines are; its faces are judged, too.
  std::shared_ptr<const BuildingModel> model = nullptr;
  /// Metres per coordinate unit by axis, where the CRS does not say.
  std::optional<Eigen::Vector3d> unit_m = std::nullopt;
  /// Coordinates of the plan are divided by these to be metres on the ground, as those of the
  /// cloud.
  Eigen::Vector2d plan_scale = Eigen::Vector2d::Ones();
  /// A unit that the file names beside its coordinates, "millimetres"; no more than a hint, as most
  /// programs write the one of their template ($INSUNITS of DXF).
  std::string stated_unit;
  /// Memory for lines that a reader may still add; see lines_for_file().
  std::size_t memory_left_bytes = std::numeric_limits<std::size_t>::max();
};

}  // namespace ridgeline::io
