// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/faces/united_faces.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/disjoint_sets.h"
#include "reconstruct/geometry/faces/face_geometry.h"
#include "reconstruct/geometry/faces/face_seams.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace ridgeline {
namespace {

using Corner = std::array<double, 3>;

Corner corner_of(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

/// The closed rings formed by segments that share their ends exactly; std::nullopt unless every
/// corner has exactly two segments.
std::optional<std::vector<Ring>> rings_of(const std::vector<Segment3>& border) {
  std::map<Corner, std::vector<std::size_t>> at_corner;
  for (std::size_t i = 0; i < border.size(); ++i) {
    at_corner[corner_of(border[i].start)].push_back(i);
    at_corner[corner_of(border[i].end)].push_back(i);
  }
  if (!std::ranges::all_of(at_corner, [](const auto& c) { return c.second.size() == 2; }))
    return std::nullopt;
  std::vector<Ring> rings;
  std::vector<bool> is_used(border.size(), false);
  for (std::size_t first = 0; first < border.size(); ++first) {
    if (is_used[first]) continue;
    Ring& ring = rings.emplace_back();
    Eigen::Vector3d x = border[first].start;
    for (std::size_t i = first; !is_used[i];) {
      is_used[i] = true;
      ring.push_back(x);
      x = corner_of(border[i].start) == corner_of(x) ? border[i].end : border[i].start;
      const std::vector<std::size_t>& both = at_corner[corner_of(x)];
      i = both[0] == i ? both[1] : both[0];
    }
  }
  return rings;
}

/// Unites the pieces into one face; std::nullopt if their outline touches itself.
std::optional<Face> united(const std::vector<Face>& pieces) {
  std::vector<Segment3> border;
  for (const FaceSeam& seam : seams_of(pieces))
    if (seam.faces.size() == 1) border.push_back(seam.segment);
  std::optional<std::vector<Ring>> rings = rings_of(border);
  if (!rings || rings->empty()) return std::nullopt;
  const auto size_of = [](const Ring& ring) { return area_vector(ring).norm(); };
  std::swap(rings->front(), *std::ranges::max_element(*rings, {}, size_of));
  const Eigen::Vector3d normal = area_vector(pieces.front().rings.front());
  for (std::size_t i = 0; i < rings->size(); ++i) {
    const bool runs_on = area_vector((*rings)[i]).dot(normal) > 0.0;
    if (runs_on != (i == 0)) std::ranges::reverse((*rings)[i]);
  }
  Face face = pieces.front();
  face.rings = std::move(*rings);
  return face;
}

/// For each face, the number of the first face of its connected coplanar region. The first faces of
/// regions are compared, so that the strips of a vault are not merged into one face, strip by
/// strip.
std::vector<std::size_t> regions_of(const std::vector<Face>& faces) {
  constexpr double kFlat_rad = 0.5 * kRadPerDeg;  // rounding to mm tilts a face of 0.2 m by this
  const auto normals = transformed(
      faces, [](const Face& face) { return Eigen::Vector3d(upward(*plane_of(face)).normal()); });
  DisjointSets regions(faces.size());
  for (const FaceSeam& seam : seams_of(faces)) {
    if (seam.faces.size() != 2) continue;
    const std::size_t a = regions.name_of(seam.faces[0]), b = regions.name_of(seam.faces[1]);
    const bool is_one =
        faces[a].kind == faces[b].kind && acute_angle_rad(normals[a], normals[b]) < kFlat_rad;
    if (is_one) regions.join(a, b);
  }
  std::vector<std::size_t> names;
  for (std::size_t i = 0; i < faces.size(); ++i) names.push_back(regions.name_of(i));
  return names;
}

}  // namespace

std::vector<Face> united_faces(std::vector<Face> faces) {
  std::map<std::size_t, std::vector<std::size_t>> members;
  const std::vector<std::size_t> regions = regions_of(faces);
  for (std::size_t i = 0; i < faces.size(); ++i) members[regions[i]].push_back(i);
  std::vector<Face> result;
  for (const auto& [name, numbers] : members) {
    std::vector<Face> pieces;
    for (const std::size_t i : numbers) pieces.push_back(std::move(faces[i]));
    std::optional<Face> whole = pieces.size() > 1 ? united(pieces) : std::nullopt;
    if (whole)
      result.push_back(std::move(*whole));
    else
      std::ranges::move(pieces, std::back_inserter(result));
  }
  return result;
}

}  // namespace ridgeline
