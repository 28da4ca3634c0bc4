// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/roof_kind.h"

#include "reconstruct/geometry/faces/roof_edge.h"

#include <tuple>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// Distance of the centre of a plane's outline from another plane, positive above it.
double height_above(const PlanesById& planes, std::uint64_t id, const Plane3& other) {
  const auto found = planes.find(id);
  if (found == planes.end() || found->second->outline.empty()) return 0.0;
  const std::vector<Eigen::Vector3d>& outline = found->second->outline;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : outline) middle += corner;
  return other.signedDistance(middle / static_cast<double>(outline.size()));
}

/// Two planes fall away from their edge if the points of each lie below the other.
bool is_convex(const LineEvaluation& line, const PlanesById& planes) {
  const auto& [a, b] = std::tie(line.planes[0], line.planes[1]);
  return height_above(planes, a.id, b.plane) + height_above(planes, b.id, a.plane) < 0.0;
}

}  // namespace

std::string roof_kind(const LineEvaluation& line,
                      const Segment3& segment_in_local,
                      const PlanesById& planes) {
  if (line.planes.empty()) return "";
  if (line.planes.size() == 1) return kind_of_border(line.planes[0].plane, segment_in_local);
  if (!is_convex(line, planes)) return "valley";
  return is_level(segment_in_local) ? "ridge" : "hip";
}

}  // namespace ridgeline::evaluate
