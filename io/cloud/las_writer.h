// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/point_cloud.h"
#include "io/crs/crs.h"
#include "reconstruct/geometry/local_frame.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace ridgeline::io {

struct LasWriteOptions {
  /// Resolution of the stored coordinates, which may lie at most 2^31 steps from the origin.
  double scale_m = 0.001;
};

/// What is stored with a point besides its return: a colour and the plane on which it lies.
struct PointLabel {
  std::array<std::uint8_t, 3> rgb{};
  std::uint32_t plane_id = 0;
  float distance_m = 0.0F;  ///< distance from the plane, along its normal
};

/// Writes points of a local frame as LAS 1.4, point format 6, GPS time 0. The frame's origin
/// becomes the header's offset, and the CRS a WKT record. The file is written completely or not at
/// all; the same input gives the same bytes (the creation date is fixed). `labels` has one label
/// per point or is empty. With labels, the point format is 7 with colours (8 bits in the upper half
/// of 16) and the extra bytes `plane_id` and `distance_m`. Throws std::invalid_argument for a
/// coordinate that is not finite or does not fit the scale, a return number above 15 or a CRS that
/// PROJ cannot read; IoError if the file cannot be written.
void write_las(const std::string& path,
               std::span<const CloudPoint> points_in_local,
               const LocalFrame& frame,
               const Crs& crs = {},
               const LasWriteOptions& options = {},
               std::span<const PointLabel> labels = {});

}  // namespace ridgeline::io
