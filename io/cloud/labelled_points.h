// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_writer.h"
#include "io/crs/crs.h"
#include "reconstruct/geometry/local_frame.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace ridgeline::io {

/// Points with their planes, local metres.
struct LabelledPoints {
  LocalFrame frame;
  Crs crs;
  Eigen::Vector3d unit_m = Eigen::Vector3d::Ones();  ///< metres per unit of the CRS
  std::vector<Eigen::Vector3d> x_in_local;
  std::vector<PointLabel> labels;  ///< one for each point
};

/// Throws std::invalid_argument unless the path ends in .las, .pcd or .ply.
void require_point_format(const std::string& path);

/// Writes the points in the format given by the extension of the path, with fields rgb, plane_id
/// and distance_m:
///   .las  LAS 1.4 in the units of the CRS, which the file states
///   .ply  binary, double coordinates in the units of the CRS, which a comment states
///   .pcd  binary, coordinates in metres relative to an origin that a comment states, because
///         PCL stores 32 bits; rgb as PCL packs it
/// The same points give the same bytes. The file is written completely or not at all. Throws
/// IoError if it cannot be written.
void write_labelled_points(const std::string& path, const LabelledPoints& points);

}  // namespace ridgeline::io
