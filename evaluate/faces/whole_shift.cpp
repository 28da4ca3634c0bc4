// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/whole_shift.h"

#include "evaluate/faces/limits.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

// Standard deviations of faces and edges of models, in addition to those of the points.
constexpr double kFaceSigma_m = 0.03;
constexpr double kEdgeSigma_m = 0.1;

/// Unit vector in plan pointing out of a face across one of its edges.
Eigen::Vector2d outwards(const RoofFace& face, std::size_t edge) {
  constexpr double kStep_m = 1e-3;
  const Segment2& segment = face.plan.edges()[edge];
  const Eigen::Vector2d along = (segment.end - segment.start).normalized();
  const Eigen::Vector2d left(-along.y(), along.x());
  const Eigen::Vector2d beside = 0.5 * (segment.start + segment.end) + kStep_m * left;
  return face.plan.contains(beside) ? Eigen::Vector2d(-left) : left;
}

Eigen::Vector3d across(const RoofFace& face, const EdgeOffset& edge) {
  Eigen::Vector3d way;
  way << outwards(face, edge.edge), 0.0;
  return way;
}

/// Observations way' t = value of a shift t.
class Adjustment {
 public:
  void add(const Eigen::Vector3d& way, double value_m, double sigma_m) {
    const double weight = 1.0 / (sigma_m * sigma_m);
    normal_ += weight * way * way.transpose();
    right_ += weight * value_m * way;
  }

  [[nodiscard]] std::optional<Eigen::Vector3d> solution() const {
    constexpr double kMaxSigma_m = 0.2;  // of a component
    const Eigen::LDLT<Eigen::Matrix3d> factors(normal_);
    if (factors.info() != Eigen::Success || !(factors.rcond() > 1e-12)) return std::nullopt;
    const Eigen::Matrix3d covariance = factors.solve(Eigen::Matrix3d::Identity());
    if (covariance.diagonal().maxCoeff() > kMaxSigma_m * kMaxSigma_m) return std::nullopt;
    return factors.solve(right_);
  }

 private:
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

/// Whether the border lies within the distance in which it was sought.
bool is_within_reach(const EdgeOffset& edge) {
  return std::abs(edge.offset_m) < kFaceReach_m - 2.0 * kEdgeSigma_m;
}

bool is_right_without(const Eigen::Vector3d& shift_m,
                      const RoofFace& face,
                      const FaceEvaluation& evaluation) {
  const Estimate& shift = evaluation.difference.shift_m;
  const double rest_m = shift.value - face.plane.normal().dot(shift_m);
  if (evaluation.verdict.tilt) return false;
  if (std::abs(rest_m) > kHeightTolerance_m + shift.half_width) return false;
  return std::ranges::all_of(evaluation.edges, [&](const EdgeOffset& edge) {
    return is_within_reach(edge) &&
           std::abs(edge.offset_m - across(face, edge).dot(shift_m)) <= 2.0 * kEdgeSigma_m;
  });
}

}  // namespace

std::optional<Eigen::Vector3d> whole_shift_m(std::span<const RoofFace> faces,
                                             std::span<const FaceEvaluation> evaluations) {
  Adjustment adjustment;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (evaluations[i].status != FaceStatus::kEvaluated) continue;
    const Estimate& shift = evaluations[i].difference.shift_m;
    adjustment.add(faces[i].plane.normal(), shift.value,
                   std::hypot(kFaceSigma_m, 0.5 * shift.half_width));
    for (const EdgeOffset& edge : evaluations[i].edges) {
      if (is_within_reach(edge))
        adjustment.add(across(faces[i], edge), edge.offset_m, kEdgeSigma_m);
    }
  }
  std::optional<Eigen::Vector3d> shift_m = adjustment.solution();
  if (!shift_m) return std::nullopt;
  double right_m2 = 0.0, judged_m2 = 0.0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (evaluations[i].status != FaceStatus::kEvaluated) continue;
    judged_m2 += faces[i].area_m2;
    if (is_right_without(*shift_m, faces[i], evaluations[i])) right_m2 += faces[i].area_m2;
  }
  if (right_m2 < (1.0 - kMaxWrongShare) * judged_m2) return std::nullopt;
  return shift_m;
}

}  // namespace ridgeline::evaluate
