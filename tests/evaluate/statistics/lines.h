// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"

#include <cmath>
#include <cstdint>
#include <string>

namespace ridgeline::evaluate {

/// An evaluated step edge on the plane `plane_id`, parallel to it at the signed distance.
inline LineEvaluation evaluated_line(std::string id,
                                     double signed_distance_m,
                                     std::uint64_t plane_id,
                                     std::string line_class = "not_aligned") {
  LineEvaluation line;
  line.id = std::move(id);
  line.line_class = std::move(line_class);
  line.status = Status::kEvaluated;
  line.kind = Kind::kStep;
  line.length_m = 5.0;
  line.mean_distance_m = std::abs(signed_distance_m);
  line.max_distance_m = line.mean_distance_m;
  line.signed_mean_m = signed_distance_m;
  line.sigma_plane_m = 0.0;
  JudgingPlane plane;
  plane.id = plane_id;
  plane.coverage = 1.0;
  plane.n_inliers = 40;
  plane.distance = {.start = signed_distance_m,
                    .end = signed_distance_m,
                    .mean_abs = std::abs(signed_distance_m),
                    .mean = signed_distance_m,
                    .rms = std::abs(signed_distance_m),
                    .max_abs = std::abs(signed_distance_m)};
  line.planes.push_back(plane);
  return line;
}

inline LineEvaluation excluded_line(std::string id,
                                    Status status,
                                    std::string line_class = "not_aligned") {
  LineEvaluation line;
  line.id = std::move(id);
  line.line_class = std::move(line_class);
  line.status = status;
  line.reason = "a reason";
  line.length_m = 5.0;
  return line;
}

}  // namespace ridgeline::evaluate
