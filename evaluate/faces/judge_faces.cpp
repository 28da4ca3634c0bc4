// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/judge_faces.h"

#include "evaluate/faces/judge_face.h"
#include "evaluate/faces/limits.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/field.h"
#include "reconstruct/geometry/interruption.h"

#include <tbb/parallel_for.h>

#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace ridgeline::evaluate {
namespace {

std::vector<const RoofFace*> all_faces(std::span<const RoofBuilding> buildings) {
  std::vector<const RoofFace*> faces;
  for (const RoofBuilding& building : buildings) {
    for (const RoofFace& face : building.faces) faces.push_back(&face);
  }
  return faces;
}

BoxIndex2 index_of(const std::vector<const RoofFace*>& faces) {
  std::vector<Eigen::AlignedBox2d> boxes;
  boxes.reserve(faces.size());
  for (const RoofFace* face : faces) boxes.push_back(face->plan.box());
  return BoxIndex2(std::move(boxes));
}

/// The faces within reach of each face, with the planes found for them.
class Neighbours {
 public:
  Neighbours(const std::vector<const RoofFace*>& faces,
             const std::vector<FaceEvaluation>& found,
             double reach_m)
      : faces_(faces), index_(index_of(faces)), reach_m_(reach_m) {
    for (const FaceEvaluation& evaluation : found) {
      const bool has_plane = evaluation.status == FaceStatus::kEvaluated;
      fits_.push_back(has_plane ? std::optional(evaluation.fit) : std::nullopt);
    }
  }

  [[nodiscard]] std::vector<NeighbourFace> of(std::size_t k) const {
    std::vector<NeighbourFace> neighbours;
    for (const std::size_t other : index_.near(faces_[k]->plan.box(), 2.0 * reach_m_)) {
      if (other == k) continue;
      neighbours.push_back({faces_[other], fits_[other] ? &*fits_[other] : nullptr});
    }
    return neighbours;
  }

 private:
  const std::vector<const RoofFace*>& faces_;
  BoxIndex2 index_;
  double reach_m_;
  std::vector<std::optional<PlaneFit>> fits_;
};

std::vector<std::vector<FaceEvaluation>> by_building(std::span<const RoofBuilding> buildings,
                                                     std::vector<FaceEvaluation> evaluations) {
  std::vector<std::vector<FaceEvaluation>> results;
  auto next = std::make_move_iterator(evaluations.begin());
  for (const RoofBuilding& building : buildings) {
    const auto end = next + static_cast<std::ptrdiff_t>(building.faces.size());
    results.emplace_back(next, end);
    next = end;
  }
  return results;
}

}  // namespace

std::vector<std::vector<FaceEvaluation>> judge_faces(const PointSearch& search,
                                                     std::span<const RoofBuilding> buildings,
                                                     const JudgeOptions& options) {
  ridgeline::validate(options);
  const std::vector<const RoofFace*> faces = all_faces(buildings);
  std::vector<FaceEvaluation> evaluations(faces.size());
  const auto for_all = [&](const auto& judge) {
    tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t k) {
      Interruption::check();
      judge(k);
    });
  };
  for_all([&](std::size_t k) { evaluations[k] = find_plane(search, *faces[k], options); });
  const Neighbours found(faces, evaluations, kFaceReach_m);
  for_all([&](std::size_t k) {
    refine_plane(search, *faces[k], found.of(k), options, evaluations[k]);
  });
  const Neighbours refined(faces, evaluations, kFaceReach_m);
  for_all([&](std::size_t k) {
    judge_outline(search, *faces[k], refined.of(k), options, evaluations[k]);
  });
  return by_building(buildings, std::move(evaluations));
}

}  // namespace ridgeline::evaluate
