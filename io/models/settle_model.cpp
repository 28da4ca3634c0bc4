// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/settle_model.h"

#include "reconstruct/geometry/faces/face_geometry.h"
#include "reconstruct/geometry/faces/face_kinds.h"
#include "reconstruct/geometry/faces/united_faces.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr LeftOutKind kFlatFace{"face without an area", "faces without an area"};
constexpr LeftOutKind kRepeatedFace{"repeated face", "repeated faces"};

void make_ids_unique(std::vector<Building>& buildings, std::vector<std::string>& warnings) {
  std::map<std::string, int> n_taken;  // how often an id was requested
  std::size_t n_renamed = 0;
  for (Building& building : buildings) {
    const std::string id = building.id;
    int& n = n_taken[id];
    n_renamed += n > 0 ? 1 : 0;
    while (n > 0 && n_taken.contains(building.id)) building.id = fmt::format("{}_{}", id, n++);
    n = std::max(n, 1);
    n_taken.try_emplace(building.id, 1);
  }
  if (n_renamed == 0) return;
  warnings.push_back(
      fmt::format("{} building{} the id of an earlier one and \"_1\", \"_2\", ... appended to it",
                  n_renamed, n_renamed == 1 ? " has" : "s have"));
}

bool has_area(const Ring& ring) {
  constexpr double kMaxCoordinate = 1e12;  // beyond it, millimetres cannot be resolved
  return std::ranges::all_of(ring,
                             [](const Eigen::Vector3d& x) {
                               return x.allFinite() && x.cwiseAbs().maxCoeff() < kMaxCoordinate;
                             }) &&
         plane_of({{ring}, FaceKind::kUnknown, 0, ""});
}

void drop_faces_without_area(BuildingModel& model) {
  model.left_out.add(kFlatFace, std::erase_if(model.faces, [](const Face& face) {
                       return !has_area(face.rings.front());
                     }));
  for (Face& face : model.faces)
    std::erase_if(face.rings, [](const Ring& ring) { return !has_area(ring); });
}

/// Keeps one of the faces of a building with the same outline, such as those of a solid and a
/// multi-surface of one level: the first that states its kind, otherwise the first.
void drop_repeats(BuildingModel& model) {
  std::map<std::pair<std::size_t, Outline>, std::size_t> kept_at;
  std::vector<Face> kept;
  for (Face& face : model.faces) {
    const auto [entry, is_new] =
        kept_at.try_emplace({face.building, outline_of(face.rings.front())}, kept.size());
    if (is_new) {
      kept.push_back(std::move(face));
      continue;
    }
    model.left_out.add(kRepeatedFace);
    Face& first = kept[entry->second];
    if (first.kind == FaceKind::kUnknown) first = std::move(face);
  }
  model.faces = std::move(kept);
}

}  // namespace

void settle(BuildingModel& model) {
  make_ids_unique(model.buildings, model.warnings);
  std::ranges::stable_sort(model.faces, {}, &Face::building);
  drop_faces_without_area(model);
  drop_repeats(model);
  std::vector<Face> settled;
  for_each_building(model, [&](std::size_t, std::span<const Face> stated) {
    std::vector<Face> faces(stated.begin(), stated.end());
    state_kinds(faces);
    std::ranges::move(united_faces(std::move(faces)), std::back_inserter(settled));
  });
  model.faces = std::move(settled);
}

void for_each_building(
    const BuildingModel& model,
    const std::function<void(std::size_t building, std::span<const Face> faces)>& take) {
  const std::span<const Face> faces = model.faces;
  for (std::size_t first = 0; first < faces.size();) {
    const std::size_t building = faces[first].building;
    std::size_t last = first;
    while (last < faces.size() && faces[last].building == building) ++last;
    take(building, faces.subspan(first, last - first));
    first = last;
  }
}

}  // namespace ridgeline::io
