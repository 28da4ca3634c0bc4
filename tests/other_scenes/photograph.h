// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/aerial_cameras.h"
#include "tests/other_scenes/ray_tracer.h"
#include "tests/other_scenes/scene_model.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>

namespace ridgeline::other {

/// What makes one photograph unlike the others of the same scene.
struct Film {
  double gain = 1.0, offset = 0.0;
  double gamma = 0.45;          ///< exponent of the tone curve
  double blur_sigma_px = 0.55;  ///< of the optics
  double read_noise = 0.002;    ///< standard deviation, share of the range
  double photon_noise = 0.005;  ///< standard deviation at full light
  std::uint64_t seed = 0;
  bool bayer = false;    ///< one colour per pixel (red green / green blue), the others interpolated
  int jpeg_quality = 0;  ///< 1 to 100; 0: no compression
};

/// Light (red, green, blue) that reaches the camera, CV_32FC3: by Lambert's law from the sun, with
/// shadows, and from the sky; gloss of car paint, glass and metal. Mean over 3 x 3 rays a pixel.
cv::Mat light(const Scene& scene, const RayTracer& tracer, const AerialCamera& camera);

/// The photograph of that light, CV_8UC3 in the order red, green, blue.
cv::Mat expose(const cv::Mat& light, const Film& film);

}  // namespace ridgeline::other
