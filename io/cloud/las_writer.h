// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/point_cloud.h"
#include "io/crs.h"
#include "reconstruct/geometry/local_frame.h"

#include <span>
#include <string>

namespace ridgeline::io {

struct LasWriteOptions {
  double scale_m = 0.001;  ///< resolution of the stored coordinates, at most 2^31 steps from origin
};

/// Writes points of a local frame as LAS 1.4, point format 6, GPS time 0: the frame's origin is the
/// header's offset, the CRS a WKT record. The file appears whole or not at all; the same input
/// gives the same bytes (the creation date is fixed).
/// Throws std::invalid_argument for a coordinate that is not finite or does not fit the scale, a
/// return number above 15 or a CRS that PROJ cannot read; IoError if the file cannot be written.
void write_las(const std::string& path,
               std::span<const CloudPoint> points_in_local,
               const LocalFrame& frame,
               const Crs& crs = {},
               const LasWriteOptions& options = {});

}  // namespace ridgeline::io
