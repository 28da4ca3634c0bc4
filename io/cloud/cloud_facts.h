// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/crs/crs.h"
#include "io/crs/grid_scale.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The contents of a cloud file, counted over all of its points without any filter.
struct CloudFacts {
  std::string path;
  std::string format;  ///< "LAZ 1.4, point format 6", "PCD, binary", ...
  std::uint64_t n_points = 0;
  std::uint64_t n_non_finite = 0;
  Eigen::AlignedBox3d bounds;  ///< box of the points, file units; empty without points
  /// Points per square metre of the 1 m cells that contain points; unset for coordinates in
  /// degrees.
  std::optional<double> density_per_m2;
  std::map<std::uint8_t, std::uint64_t> n_by_class;
  std::map<std::uint8_t, std::uint64_t> n_by_return;  ///< by return number
  std::uint64_t n_withheld = 0;
  CrsFacts crs;
  /// Plan scale at the centre of the points; unset unless the CRS is projected.
  std::optional<GridScale> plan_scale;
  /// Metres per coordinate unit by axis, from the CRS or the file's own unit keys.
  Eigen::Vector3d unit_m = Eigen::Vector3d::Ones();
  /// Whether the CRS or unit keys state the unit; otherwise metres are assumed.
  bool states_unit = false;
  /// LAS and LAZ: resolution and offset of the stored coordinates, file units.
  std::optional<Eigen::Vector3d> scale;
  std::optional<Eigen::Vector3d> offset;
  std::vector<std::string> warnings;  ///< without the path
};

/// Reads the whole file, block by block. Unlike read_cloud(), it also describes files that cannot
/// be evaluated: those in degrees or with coordinates beyond any map.
/// Throws IoError if the file cannot be read.
CloudFacts cloud_facts(const std::string& path, const OpenCloudOptions& options = {});

}  // namespace ridgeline::io
