// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/geocentric.h"
#include "io/orientation/orientation.h"

#include <string>
#include <vector>

namespace ridgeline::io {

/// Converts poses from an Earth-fixed frame to a map with heights above the ellipsoid: `map`, or
/// the WGS 84 UTM zone if `map` is unknown. `geocentric_from_block`: the position and orientation
/// of the poses' frame. The rotations are corrected for meridian convergence and the curvature of
/// the Earth at each image. Records this in orientation.decisions, together with the map scale,
/// which rotations cannot account for. Sets orientation.crs. Throws IoError if the system is not
/// projected or the block is not on Earth.
void convert_to_map(const std::string& path,
                    const Eigen::Isometry3d& geocentric_from_block,
                    const Crs& map,
                    Orientation& orientation);

/// The poses of a block in a frame with axes east, north, up at the centre of its images.
struct TopocentricPoses {
  GeodeticPlace place;  ///< height 0
  Eigen::Isometry3d geocentric_from_enu;
  std::vector<ExteriorOrientation> exterior;  ///< one per image
};

/// The inverse of convert_to_map(), for an orientation that has images. Throws
/// std::invalid_argument if its system is not projected.
TopocentricPoses topocentric_poses(const Orientation& orientation);

/// The frame with axes east, north, up at a place on the WGS 84 ellipsoid.
Eigen::Isometry3d geocentric_from_enu(const GeodeticPlace& place);

}  // namespace ridgeline::io
