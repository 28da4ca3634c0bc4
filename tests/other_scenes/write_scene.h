// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace ridgeline::other {

/// Makes the settlement of a seed and its stereo pair in `folder`, which must be there: patch.yaml
/// (id: the seed), left.tif, right.tif, matches.csv (all straight edges that both show) and
/// truth.geojson (the same as 3D lines). No LIDAR. Throws io::IoError.
void write_scene(const std::string& folder, std::uint64_t seed);

}  // namespace ridgeline::other
