// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <Eigen/Core>

#include <cstdint>

namespace ridgeline::simulate {

/// The errors of a simulated tool. Each line draws from its own random stream, so that it keeps its
/// errors when others are removed.
struct DegradeOptions {
  std::uint64_t seed = 1;
  double plan_sigma_m = 0.05;    ///< independent error of each endpoint, per plan axis
  double height_sigma_m = 0.05;  ///< height error of the whole line
  double tilt_sigma_m = 0.03;    ///< lowers the start and raises the end
  Eigen::Vector3d bias_m = Eigen::Vector3d::Zero();  ///< shift of all lines
  double missing_share = 0.0;                        ///< share of lines that the tool misses
  double gross_share = 0.0;  ///< share of lines off by 2 to 8 m in height, as after a false match
  /// Ratio of claimed to simulated standard deviations: 1 is honest, below 1 optimistic. Bias and
  /// gross errors are never included in the claim.
  double claimed_sigma_ratio = 1.0;
};

enum class Grade : std::uint8_t {
  kGood,  ///< about 5 cm in each coordinate
  kFair,  ///< about 20 cm
  kPoor,  ///< about 60 cm, with gross errors
};
DegradeOptions options_of(Grade grade, std::uint64_t seed);

/// Returns the lines with errors and the corresponding covariance of (start, end); ids, kinds and
/// other attributes are kept, so that results can be compared with the truth line by line.
/// Throws std::invalid_argument for a negative sigma or a share outside [0, 1].
io::LineSet degrade_lines(const io::LineSet& lines, const DegradeOptions& options);

}  // namespace ridgeline::simulate
