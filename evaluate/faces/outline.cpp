// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/outline.h"

#include "evaluate/faces/face_plane.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

/// A point's view of one edge.
struct Vote {
  double beyond_m;
  bool on_face;
};

PlacedPoint placed(const FacePoint& point,
                   const PlaneFit& fit,
                   std::span<const NeighbourFace> neighbours,
                   const FaceOptions& options) {
  const Eigen::Vector2d x = point.point.x.head<2>();
  const bool on_face = is_on(fit.plane, point, options);
  const double distance_m = fit.plane.absDistance(point.point.x);
  PlacedPoint result{on_face ? PointPlace::kOnFace : PointPlace::kElsewhere, on_face};
  for (const NeighbourFace& other : neighbours) {
    const double away_m = other.face->plan.distance_m(x);
    if (away_m > options.reach_m) continue;
    const bool over_other = away_m == 0.0;
    if (!other.fit) {
      if (over_other && point.beyond_m > 0.0) result.place = PointPlace::kUnknown;
      continue;
    }
    if (!is_on(other.fit->plane, point, options)) continue;
    result.explained = true;
    const bool one_plane = are_nearly_one(fit.plane, other.fit->plane, options);
    const bool one_above_the_other = !on_face && over_other && point.beyond_m < 0.0;
    if ((on_face && one_plane) || one_above_the_other) {
      result.place = PointPlace::kUnknown;
    } else if (on_face && result.place != PointPlace::kUnknown) {
      const bool nearer = other.fit->plane.absDistance(point.point.x) < distance_m;
      if (nearer) result.place = PointPlace::kOtherOrOnFace;
      if (result.place == PointPlace::kOnFace) result.place = PointPlace::kOnFaceOrOther;
    }
  }
  return result;
}

/// The offset of an edge by the votes of the points beside it, one at least. The edge itself is not set.
EdgeOffset best_place(std::vector<Vote> votes, double reach_m) {
  std::ranges::sort(votes, {}, [](const Vote& v) { return std::pair(v.beyond_m, v.on_face); });
  int n_wrong = 0;  // with a border inwards of all votes
  for (const Vote& vote : votes) n_wrong += vote.on_face ? 1 : 0;
  int n_wrong_now = n_wrong, n_fewest = n_wrong;
  double border_m = std::clamp(0.0, -reach_m, votes.front().beyond_m);
  for (std::size_t i = 0; i < votes.size(); ++i) {
    // the border moves outwards over this vote
    n_wrong += votes[i].on_face ? -1 : 1;
    if (votes[i].beyond_m <= 0.0) n_wrong_now = n_wrong;
    const double next_m = i + 1 < votes.size() ? votes[i + 1].beyond_m : reach_m;
    const double place_m = std::clamp(0.0, votes[i].beyond_m, next_m);
    const bool nearer = std::abs(place_m) < std::abs(border_m);
    if (n_wrong < n_fewest || (n_wrong == n_fewest && nearer)) {
      n_fewest = n_wrong;
      border_m = place_m;
    }
  }
  return {{}, 0.0 - border_m, n_wrong_now - n_fewest};
}

}  // namespace

std::vector<PlacedPoint> placed_points(std::span<const FacePoint> points,
                                       const RoofFace& face,
                                       const PlaneFit& fit,
                                       std::span<const NeighbourFace> neighbours,
                                       const FaceOptions& options) {
  const double reach_m = 2.0 * options.reach_m;  // of the face, then of the point
  std::vector<NeighbourFace> near;
  for (const NeighbourFace& other : neighbours) {
    const bool is_near =
        other.face->plan.box().squaredExteriorDistance(face.plan.box()) <= reach_m * reach_m;
    if (is_near) near.push_back(other);
  }
  std::vector<PlacedPoint> places;
  places.reserve(points.size());
  for (const FacePoint& point : points) places.push_back(placed(point, fit, near, options));
  return places;
}

std::vector<EdgeOffset> edge_offsets(std::span<const FacePoint> points,
                                     std::span<const PlacedPoint> places,
                                     const RoofFace& face,
                                     const FaceOptions& options) {
  std::vector<std::vector<Vote>> votes(face.plan.edges().size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointPlace place = places[i].place;
    const bool near = std::abs(points[i].beyond_m) <= options.reach_m;
    if (place == PointPlace::kUnknown || !near || !points[i].beside) continue;
    const bool on_face = place == PointPlace::kOnFace || place == PointPlace::kOnFaceOrOther;
    votes[points[i].edge].push_back({points[i].beyond_m, on_face});
  }
  std::vector<EdgeOffset> edges;
  for (std::size_t i = 0; i < votes.size(); ++i) {
    if (votes[i].size() < 2 * static_cast<std::size_t>(options.min_contradictions)) continue;
    edges.push_back(best_place(std::move(votes[i]), options.reach_m));
    edges.back().edge = face.plan.edges()[i];
  }
  return edges;
}

bool is_outline_wrong(std::span<const EdgeOffset> edges, const FaceOptions& options) {
  return std::ranges::any_of(edges, [&](const EdgeOffset& edge) {
    return std::abs(edge.offset_m) > options.outline_tolerance_m &&
           edge.n_contradictions >= options.min_contradictions;
  });
}

}  // namespace ridgeline::evaluate
