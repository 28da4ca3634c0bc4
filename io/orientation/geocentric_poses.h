// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/geocentric.h"
#include "io/orientation/orientation.h"

#include <string>
#include <vector>

namespace ridgeline::io {

/// Converts poses from a frame that is fixed to the Earth to a map with heights above the
/// ellipsoid: `map`, or if it is unknown the UTM zone of WGS 84. `geocentric_from_block`: where the
/// frame of the poses lies. Each rotation is turned by the convergence of meridians and the
/// curvature of the Earth at its image. Says so in orientation.decisions, with the scale of the
/// map, which no rotation can take in. Sets orientation.crs. Throws IoError if the system is not
/// projected or the block is nowhere on Earth.
void convert_to_map(const std::string& path,
                    const Eigen::Isometry3d& geocentric_from_block,
                    const Crs& map,
                    Orientation& orientation);

/// The poses of a block in the frame with axes east, north, up at a place amid its images.
struct TopocentricPoses {
  GeodeticPlace place;  ///< height 0
  Eigen::Isometry3d geocentric_from_enu;
  std::vector<ExteriorOrientation> exterior;  ///< one an image
};

/// The poses from which convert_to_map() makes those of `orientation`, which has images. Throws
/// std::invalid_argument if its system is not projected.
TopocentricPoses topocentric_poses(const Orientation& orientation);

/// The frame with axes east, north, up at a place on the ellipsoid of WGS 84.
Eigen::Isometry3d geocentric_from_enu(const GeodeticPlace& place);

}  // namespace ridgeline::io
