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

/// The segment of a line in one image.
struct LineObservation {
  std::string image;  ///< id of the image in its patch
  Segment2 px;        ///< ideal pixels
};

/// One 3D segment of a line file, with its attributes. Attributes that the file does not have stay
/// empty.
struct Line {
  std::string id;         ///< the file's own `id` property or column, else source_fid
  std::string parent_id;  ///< id of the polyline or track that contains it; empty if none
  Segment3 segment_in_world{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  ///< file's CRS, m
  std::string line_class;  ///< `class`: aligned | not_aligned, or the file's own
  std::string
      class_base;  ///< `class` from the base pair only; set only for lines of three or more images
  std::string method;    ///< direct | joint | ...
  std::string kind;      ///< ridge | hip | valley | eave | verge | ground (true lines)
  std::string building;  ///< building id: the cluster of the bootstrap
  std::string status;
  /// Ids of its segments in the first two images of the patch, the base and the other one; in files
  /// `left_id`, `right_id`.
  std::string base_id, other_id;
  /// End points of these segments, from which the line was made, ideal pixels; in files `left_px`,
  /// `right_px`. In our own files, segments of the other image may have been shifted at right
  /// angles to their direction (compare_profiles()).
  std::optional<Segment2> base_px, other_px;
  /// All image segments of a line that was made from three or more images; in files `observations`,
  /// [["IMAGE", x1, y1, x2, y2], ...].
  std::vector<LineObservation> observations;
  std::optional<double> epipolar_angle_deg;
  /// Shares of the length of a true line that are visible in the base and in the other image, 0..1;
  /// in files `visible_left`, `visible_right`.
  std::optional<double> visible_base, visible_other;
  std::optional<int> n_points;  ///< artificial points used
  std::optional<int> n_images;  ///< supporting images (Line3D++, LIMAP)
  /// Covariance of (start, end) in world axes, m^2.
  std::optional<Eigen::Matrix<double, 6, 6>> covariance_m2;
  std::vector<int> plane_ids;  ///< ids of the planes that it bounds: true lines, edges of a scan
  /// Of an edge of a scan: the share of its length that has points next to it, 0..1, and by how
  /// much it was moved out beyond the outermost points, m.
  std::optional<double> support, moved_out_m;
  /// Id of its feature in the file: GDAL's feature id, an integer `id` of GeoJSON, otherwise its
  /// index from 0.
  std::int64_t source_fid = 0;
  int part = 0;         ///< index within its feature, from 0
  int layer = 0;        ///< index into LineSet::layers
  std::size_t row = 0;  ///< row of its feature in LineSet::features
};

struct LineSet {
  std::string path;    ///< path from which it was read
  std::string format;  ///< "GeoJSON", "Line3D++", ...
  Crs crs;
  std::vector<Line> lines;
  /// All attributes of the features in the file; formats without attributes have no columns.
  AttributeTable features;
  /// Names of the layers with lines; empty for formats without layers.
  std::vector<std::string> layers;
  KindCounts left_out;                  ///< contents of the file that are not 3D lines
  std::size_t n_straight_vertices = 0;  ///< vertices on a straight line, which do not divide it
  std::vector<std::string> warnings;
  /// The model whose edges the lines are; its faces are judged, too.
  std::shared_ptr<const BuildingModel> model = nullptr;
  /// Metres per coordinate unit by axis, if the CRS does not state them.
  std::optional<Eigen::Vector3d> unit_m = std::nullopt;
  /// Plan coordinates are divided by these to obtain metres on the ground, like those of the cloud.
  Eigen::Vector2d plan_scale = Eigen::Vector2d::Ones();
  /// A unit that the file states separately from its coordinates, "millimetres"; only a hint,
  /// because most programs write the unit of their template ($INSUNITS of DXF).
  std::string stated_unit;
  /// Memory for lines that a reader may still add; see lines_for_file().
  std::size_t memory_left_bytes = std::numeric_limits<std::size_t>::max();
};

}  // namespace ridgeline::io
