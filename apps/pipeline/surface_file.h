// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "reconstruct/geometry/local_frame.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The file in a patch's folder that holds the points of the surface, and the stage that writes it.
inline constexpr const char* kSurfaceFile = "surface.las";
inline constexpr const char* kSurfaceStage = "surface";

/// Most points of a surface that a run keeps. A point takes 8 bytes of the report.
inline constexpr std::size_t kMaxSurfacePoints = 150000;

/// Writes points of points_in_local() as LAS. Throws IoError if the file cannot be written.
void write_surface(const std::string& file,
                   const std::vector<Eigen::Vector3d>& points_in_local,
                   const LocalFrame& frame,
                   const io::Crs& crs);

}  // namespace ridgeline::apps
