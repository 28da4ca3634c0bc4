// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/line_evaluation.h"

namespace ridgeline::evaluate {

bool in_range(const Segment3& segment_in_local) {
  static constexpr double kMaxCoordinate_m = 1e7;
  const auto is_near = [](const Eigen::Vector3d& x) {
    return (x.array().abs() <= kMaxCoordinate_m).all();  // false for NaN
  };
  return is_near(segment_in_local.start) && is_near(segment_in_local.end);
}

const char* name(Status status) {
  switch (status) {
    case Status::kEvaluated:
      return "evaluated";
    case Status::kNoLidar:
      return "no_lidar";
    case Status::kNoPlane:
      return "no_plane";
    case Status::kLowCoverage:
      return "low_coverage";
    case Status::kAmbiguous:
      return "ambiguous";
    case Status::kNotReconstructed:
      return "not_reconstructed";
    case Status::kDegenerate:
      return "degenerate";
    case Status::kTooShort:
      return "too_short";
    case Status::kNonFinite:
      return "non_finite";
    case Status::kOutOfRange:
      return "out_of_range";
    case Status::kDuplicateId:
      return "duplicate_id";
    case Status::kUnconfirmed:
      return "unconfirmed";
  }
  return "unknown";
}

const char* name(Kind kind) {
  switch (kind) {
    case Kind::kNone:
      return "";
    case Kind::kStep:
      return "step";
    case Kind::kRidge:
      return "ridge";
  }
  return "unknown";
}

const char* name(JudgingSurface surface) {
  switch (surface) {
    case JudgingSurface::kUpper:
      return "upper";
    case JudgingSurface::kLower:
      return "lower";
    case JudgingSurface::kGround:
      return "ground";
    case JudgingSurface::kRidge:
      return "ridge";
    case JudgingSurface::kObject:
      return "object";
  }
  return "unknown";
}

const char* name(DecidedBy evidence) {
  switch (evidence) {
    case DecidedBy::kPlan:
      return "plan";
    case DecidedBy::kImages:
      return "images";
    case DecidedBy::kPoints:
      return "points";
    case DecidedBy::kPlace:
      return "place";
  }
  return "unknown";
}

}  // namespace ridgeline::evaluate
