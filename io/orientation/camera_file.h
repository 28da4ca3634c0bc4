// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <string>
#include <vector>

namespace ridgeline::io {

struct CameraFile {
  std::vector<Camera> cameras;
  bool is_only_one = false;  ///< whether the file has a single camera, which all images use
};

/// The cameras of a YAML file, by name. Each has either the keys of a patch file (`focal_length_mm,
/// pixel_size_um, size_px`, optionally `principal_point_mm` and `k1, k2, k3, p1, p2`) or those of
/// Orthority and OpenDroneMap (`type, im_size, focal_len`, optionally `sensor_size`, `cx`, `cy` in
/// units of the longer side, and Brown's coefficients). Throws IoError with the line for unknown
/// keys, invalid values, and types other than pinhole and brown, such as fisheye, naming the type.
/// `names`: the cameras that images use. Of several cameras, the others are not read; if `names` is
/// empty, all are.
CameraFile read_cameras(const std::string& path, const std::vector<std::string>& names = {});

/// Distortion coefficients that only some programs have are ignored if they move every pixel of the
/// frame by less than this.
constexpr double kLeftOut_px = 0.05;

/// The largest distance of a pixel of the frame from the principal point, in units of the focal
/// length.
double largest_radius(const InteriorOrientation& interior);

/// Throws IoError if a coefficient that this program does not support, such as k4 or a skew, moves
/// pixels of the frame by more than kLeftOut_px. `effect_px`: the largest shift it causes.
void require_negligible(const std::string& path, const std::string& name, double effect_px);

}  // namespace ridgeline::io
