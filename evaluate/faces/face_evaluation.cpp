// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/face_evaluation.h"

namespace ridgeline::evaluate {

const char* name(FaceStatus status) {
  switch (status) {
    case FaceStatus::kEvaluated:
      return "evaluated";
    case FaceStatus::kNoLidar:
      return "no_lidar";
    case FaceStatus::kNoPlane:
      return "no_plane";
    case FaceStatus::kTooSmall:
      return "too_small";
    case FaceStatus::kSteep:
      return "steep";
    case FaceStatus::kDegenerate:
      break;
  }
  return "degenerate";
}

std::string text(const FaceVerdict& verdict) {
  if (verdict.right()) return "right";
  std::string text;
  const auto add = [&](bool is_wrong, const char* what) {
    if (is_wrong) text += (text.empty() ? "" : "+") + std::string(what);
  };
  add(verdict.height, "height");
  add(verdict.tilt, "tilt");
  add(verdict.outline, "outline");
  return text;
}

}  // namespace ridgeline::evaluate
