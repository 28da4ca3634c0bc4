// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <cstdint>
#include <tuple>

namespace ridgeline::reconstruct {

enum class Detector : std::uint8_t { kOurs, kEdgeDrawing, kLsd };
const char* name(Detector detector);  ///< "ours" | "edge_drawing" | "lsd"

struct ExtractOptions {
  Detector detector = Detector::kOurs;

  double gradient_sigma_px = 0.8;
  double low_noise_factor = 2.5;
  double high_noise_factor = 5.0;
  double max_lambda_min_px2 = 0.15;
  double max_deviation_px = 1.0;
  double min_length_px = 10.0;

  static constexpr auto fields() {
    using O = ExtractOptions;
    return std::tuple{
        Field{"gradient_sigma_px", &O::gradient_sigma_px, 0.5, 5.0,
              "smoothing of the colour gradient"},
        Field{"low_noise_factor", &O::low_noise_factor, 0.0, 1e3,
              "edge pixels are this many times as strong as the noise"},
        Field{"high_noise_factor", &O::high_noise_factor, 0.0, 1e3,
              "an edge has a pixel this many times as strong as the noise"},
        Field{"max_lambda_min_px2", &O::max_lambda_min_px2, 1e-4, 100.0,
              "straightness: variance of the edge pixels across the line"},
        Field{"max_deviation_px", &O::max_deviation_px, 0.1, 100.0,
              "straightness: largest distance of an edge pixel from the line"},
        Field{"min_length_px", &O::min_length_px, 3.0, 1e5, "shorter segments are dropped"}};
  }
};

}  // namespace ridgeline::reconstruct
