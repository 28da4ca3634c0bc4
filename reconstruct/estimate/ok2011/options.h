// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/field.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include <array>
#include <cstdint>
#include <tuple>

namespace ridgeline::reconstruct {

/// kDirect and kJoint are the methods of Ok et al. 2011, section 3. The others are ours: kNetwork,
/// kPlanes (lines without a visible edge) and kLines (the lines of kNetwork, plus those of kPlanes
/// where no edge gives a line).
enum class Method : std::uint8_t { kPlanes, kDirect, kJoint, kNetwork, kLines };
inline constexpr std::array kMethods{Method::kLines, Method::kNetwork, Method::kJoint,
                                     Method::kDirect, Method::kPlanes};
const char* name(Method method);  ///< "planes" | "direct" | "joint" | "network" | "lines"
/// Whether the method gives lines without a visible edge, which requires surfaces (plane_lines()).
constexpr bool has_lines_of_planes(Method method) {
  return method == Method::kPlanes || method == Method::kLines;
}

/// The estimation of Ok et al. 2011, section 3.
struct ReconstructOptions {
  Method method = Method::kJoint;
  /// `direct` and `joint` share it, so that both treat a not_aligned line identically.
  LineCovariance line_covariance = LineCovariance::kEq1;

  double max_aligned_angle_deg = kMaxAlignedAngle_deg;  ///< largest angle of an `aligned` line

  static constexpr auto fields() {
    using O = ReconstructOptions;
    return std::tuple{Field{"max_aligned_angle_deg", &O::max_aligned_angle_deg, 0.0, 90.0,
                            "maximum angle of class aligned to the epipolar line"}};
  }
};

}  // namespace ridgeline::reconstruct
