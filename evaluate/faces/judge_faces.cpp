// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/judge_faces.h"

#include "evaluate/faces/face_index.h"
#include "evaluate/faces/judge_face.h"
#include "reconstruct/geometry/field.h"
#include "reconstruct/geometry/interruption.h"

#include <tbb/parallel_for.h>

#include <cstddef>

namespace ridgeline::evaluate {
namespace {

std::vector<const RoofFace*> all_faces(std::span<const RoofBuilding> buildings) {
  std::vector<const RoofFace*> faces;
  for (const RoofBuilding& building : buildings) {
    for (const RoofFace& face : building.faces) faces.push_back(&face);
  }
  return faces;
}

FaceIndex index_of(const std::vector<const RoofFace*>& faces) {
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const RoofFace* face : faces) boxes.push_back(face->plan.box());
  return FaceIndex(boxes);
}

/// The faces within reach of the k-th one, with the planes of their points.
std::vector<NeighbourFace> neighbours_of(std::size_t k,
                                         const std::vector<const RoofFace*>& faces,
                                         const std::vector<FaceEvaluation>& evaluations,
                                         const FaceIndex& index,
                                         double reach_m) {
  std::vector<NeighbourFace> neighbours;
  for (const std::size_t other : index.near(faces[k]->plan.box(), 2.0 * reach_m)) {
    if (other == k || evaluations[other].status == FaceStatus::kSteep) continue;
    const bool has_plane = evaluations[other].status == FaceStatus::kEvaluated;
    neighbours.push_back({faces[other], has_plane ? &evaluations[other].fit : nullptr});
  }
  return neighbours;
}

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
                                                     const FaceOptions& options) {
  ridgeline::validate(options);
  ridgeline::validate(options.judge);
  const std::vector<const RoofFace*> faces = all_faces(buildings);
  std::vector<FaceEvaluation> evaluations(faces.size());
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t k) {
    Interruption::check();
    evaluations[k] = judge_plane(search, *faces[k], options);
  });
  const FaceIndex index = index_of(faces);
  // planes are only read here, outlines only written
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t k) {
    Interruption::check();
    const std::vector<NeighbourFace> neighbours =
        neighbours_of(k, faces, evaluations, index, options.reach_m);
    judge_outline(search, *faces[k], neighbours, options, evaluations[k]);
  });
  return by_building(buildings, std::move(evaluations));
}

}  // namespace ridgeline::evaluate
