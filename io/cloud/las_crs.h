// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_header.h"
#include "io/crs/crs.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The reference system stated by the records of a LAS file.
struct LasCrs {
  Crs crs;
  Eigen::Vector3d unit_m = Eigen::Vector3d::Ones();  ///< metres per coordinate unit, by axis
  bool is_geographic = false;
  std::vector<std::string> warnings;
};

/// Reads WKT (LASF_Projection 2112, or liblas 2112) and GeoTIFF keys (34735). If both are present
/// and disagree, WKT wins if bit 4 of the global encoding is set or the version is 1.5, otherwise
/// the keys win; a warning names both. Records that PROJ cannot read leave the CRS unknown, with a
/// warning. If WKT is not used, unit keys (3076, 4099) that differ from the CRS take precedence,
/// with a warning, as in libgeotiff.
LasCrs read_las_crs(std::span<const std::byte> file, const LasHeader& header);

}  // namespace ridgeline::io
