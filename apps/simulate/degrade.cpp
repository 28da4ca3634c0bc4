// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/degrade.h"

#include "apps/simulate/random.h"
#include "reconstruct/geometry/check.h"

namespace ridgeline::simulate {
namespace {

void check_options(const DegradeOptions& o) {
  const auto not_negative = [](const char* name, double value) {
    check(value >= 0.0, name, " = ", value, ", must be >= 0");
  };
  const auto share = [](const char* name, double value) {
    check(value >= 0.0 && value <= 1.0, name, " = ", value, ", must be in [0, 1]");
  };
  not_negative("plan_sigma_m", o.plan_sigma_m);
  not_negative("height_sigma_m", o.height_sigma_m);
  not_negative("tilt_sigma_m", o.tilt_sigma_m);
  not_negative("claimed_sigma_ratio", o.claimed_sigma_ratio);
  share("missing_share", o.missing_share);
  share("gross_share", o.gross_share);
}

/// Covariance of (start, end). The plan coordinates are independent. The heights have the errors h
/// - t and h + t with independent offset h and tilt t, hence variance h^2 + t^2 and covariance h^2
/// - t^2.
Eigen::Matrix<double, 6, 6> claimed_covariance_m2(const DegradeOptions& o) {
  const double plan = o.plan_sigma_m * o.plan_sigma_m;
  const double offset = o.height_sigma_m * o.height_sigma_m;
  const double tilt = o.tilt_sigma_m * o.tilt_sigma_m;
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  covariance.diagonal() << plan, plan, offset + tilt, plan, plan, offset + tilt;
  covariance(2, 5) = covariance(5, 2) = offset - tilt;
  return o.claimed_sigma_ratio * o.claimed_sigma_ratio * covariance;
}

Segment3 moved(const Segment3& segment, const DegradeOptions& o, Random& random) {
  constexpr double kMinGrossErrorM = 2.0;
  constexpr double kMaxGrossErrorM = 8.0;
  const auto plan_error = [&] {
    const double x = o.plan_sigma_m * random.normal();
    return Eigen::Vector3d(x, o.plan_sigma_m * random.normal(), 0.0);
  };
  const Eigen::Vector3d start_error = plan_error();
  const Eigen::Vector3d end_error = plan_error();
  double offset_m = o.height_sigma_m * random.normal();
  const double tilt_m = o.tilt_sigma_m * random.normal();
  if (random.chance(o.gross_share)) {
    const double size_m = random.uniform(kMinGrossErrorM, kMaxGrossErrorM);
    offset_m += random.chance(0.5) ? size_m : -size_m;
  }
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  return {segment.start + start_error + o.bias_m + (offset_m - tilt_m) * up,
          segment.end + end_error + o.bias_m + (offset_m + tilt_m) * up};
}

}  // namespace

DegradeOptions options_of(Grade grade, std::uint64_t seed) {
  switch (grade) {
    case Grade::kGood:
      return {.seed = seed, .missing_share = 0.05};
    case Grade::kFair:
      return {.seed = seed,
              .plan_sigma_m = 0.2,
              .height_sigma_m = 0.18,
              .tilt_sigma_m = 0.1,
              .missing_share = 0.15};
    case Grade::kPoor:
      break;
  }
  return {.seed = seed,
          .plan_sigma_m = 0.6,
          .height_sigma_m = 0.52,
          .tilt_sigma_m = 0.3,
          .missing_share = 0.3,
          .gross_share = 0.08};
}

io::LineSet degrade_lines(const io::LineSet& lines, const DegradeOptions& options) {
  check_options(options);
  io::LineSet result = lines;
  result.lines.clear();
  const Eigen::Matrix<double, 6, 6> covariance_m2 = claimed_covariance_m2(options);
  for (std::size_t i = 0; i < lines.lines.size(); ++i) {
    Random random({options.seed, i});
    if (random.chance(options.missing_share)) continue;
    io::Line line = lines.lines[i];
    line.segment_in_world = moved(line.segment_in_world, options, random);
    line.covariance_m2 = covariance_m2;
    result.lines.push_back(std::move(line));
  }
  return result;
}

}  // namespace ridgeline::simulate
