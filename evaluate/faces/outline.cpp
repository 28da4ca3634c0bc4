// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/outline.h"

#include "evaluate/faces/face_plane.h"
#include "evaluate/faces/limits.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

PlacedPoint placed(const FacePoint& point,
                   const PlaneFit& fit,
                   std::span<const NeighbourFace> neighbours,
                   const JudgeOptions& options) {
  const Eigen::Vector2d x = point.point.x.head<2>();
  const bool on_face = is_on(fit.plane, point, options);
  const double distance_m = fit.plane.absDistance(point.point.x);
  const bool above = fit.plane.signedDistance(point.point.x) > 0.0;
  const PointPlace off_face = above ? PointPlace::kAbove : PointPlace::kElsewhere;
  PlacedPoint result{on_face ? PointPlace::kOnFace : off_face, on_face};
  for (const NeighbourFace& other : neighbours) {
    const double away_m = other.face->plan.distance_m(x);
    if (away_m > kFaceReach_m) continue;
    const bool over_other = away_m == 0.0;
    if (!other.fit) {
      if (over_other && point.beyond_m > 0.0) result.place = PointPlace::kUnknown;
      continue;
    }
    if (!is_on(other.fit->plane, point, options)) continue;
    result.explained = true;
    if (result.place == PointPlace::kAbove) result.place = PointPlace::kElsewhere;
    const bool one_plane = are_nearly_one(fit.plane, other.fit->plane);
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

/// The positions in plan beside an edge that are closer to it than to any other edge, by their
/// distance from it.
class EdgeCell {
 public:
  EdgeCell(const PlanPolygon& plan, std::size_t edge, double reach_m) : step_m_(reach_m / kSteps) {
    for (int i = 0; i < kSteps; ++i) {
      const auto [inside_m, outside_m] = widths_m(plan, edge, (i + 0.5) * step_m_);
      inside_m2_.push_back(inside_m2_.back() + inside_m * step_m_);
      outside_m2_.push_back(outside_m2_.back() + outside_m * step_m_);
    }
  }

  /// The area between the edge and a border beside it.
  [[nodiscard]] double area_m2(double beyond_m) const {
    const std::vector<double>& sums = beyond_m < 0.0 ? inside_m2_ : outside_m2_;
    const double steps = std::min(std::abs(beyond_m) / step_m_, double{kSteps});
    const auto i = std::min(static_cast<std::size_t>(steps), std::size_t{kSteps - 1});
    return sums[i] + (steps - static_cast<double>(i)) * (sums[i + 1] - sums[i]);
  }

 private:
  static constexpr int kSteps = 6;
  static constexpr int kPlaces = 16;  // along the edge

  /// The length of the part of the edge to which positions at this distance belong, inside the
  /// polygon and outside it.
  static std::pair<double, double> widths_m(const PlanPolygon& plan,
                                            std::size_t edge,
                                            double distance_m) {
    const Segment2& segment = plan.edges()[edge];
    const Eigen::Vector2d along = segment.end - segment.start;
    const Eigen::Vector2d across = distance_m * Eigen::Vector2d(-along.y(), along.x()).normalized();
    int n_inside = 0, n_outside = 0;
    for (int i = 0; i < kPlaces; ++i) {
      const Eigen::Vector2d foot = segment.start + (i + 0.5) / kPlaces * along;
      for (const Eigen::Vector2d& x :
           {Eigen::Vector2d(foot + across), Eigen::Vector2d(foot - across)}) {
        if (plan.nearest(x).edge == edge) ++(plan.contains(x) ? n_inside : n_outside);
      }
    }
    const double per_place_m = along.norm() / kPlaces;
    return {n_inside * per_place_m, n_outside * per_place_m};
  }

  double step_m_;
  std::vector<double> inside_m2_{0.0}, outside_m2_{0.0};  // cumulative up to each step
};

/// The evidence of the points beside an edge.
struct Votes {
  std::vector<double> on_m, off_m;  ///< how far beyond the edge they lie
  double points_per_m2 = 0.0;       ///< of the face on its plane
};

/// This many expected points weigh as much as one that lies on the plane. A strip beyond the end of
/// the plane still has a share e of the points that it would have: n points where m are expected
/// support an end with the log-likelihood ratio (1 - e) m - n log(1 / e).
constexpr double kWeightOfOne = 2.56;  // log(1 / e) / (1 - e) with e = 0.1

/// One return below a strip is taken as evidence that this many rays passed through: oblique ones
/// may hit the ground elsewhere.
constexpr double kRaysOfOne = 3.0;

/// The strips between an edge and the votes on one of its sides, starting with the nearest vote.
/// @param sign  -1 for the inner side, 1 for the outer one
template <typename Visitor>
void visit_strips(const Votes& votes, const EdgeCell& cell, double sign, const Visitor& visit) {
  std::vector<std::pair<double, bool>> sorted;
  for (const double m : votes.on_m) sorted.emplace_back(sign * m, true);
  for (const double m : votes.off_m) sorted.emplace_back(sign * m, false);
  std::erase_if(
      sorted, [&](const auto& vote) { return sign > 0.0 ? vote.first <= 0.0 : vote.first < 0.0; });
  std::ranges::sort(sorted);
  int n_on = 0, n_off = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto [distance_m, is_on] = sorted[i];
    ++(is_on ? n_on : n_off);
    if (i + 1 < sorted.size() && sorted[i + 1].first == distance_m)
      continue;  // at the same distance
    const double n_whole = votes.points_per_m2 * cell.area_m2(sign * distance_m);
    visit(distance_m, n_on, std::min(kRaysOfOne * n_off, n_whole));
  }
}

/// The offset of an edge according to the votes beside it.
EdgeOffset best_place(std::size_t edge, const Votes& votes, const EdgeCell& cell) {
  EdgeOffset best{edge};
  const auto consider = [&](double offset_m, double n_contradictions) {
    const int n = static_cast<int>(n_contradictions);
    if (n > best.n_contradictions) best = {edge, offset_m, n};
  };
  visit_strips(votes, cell, -1.0, [&](double distance_m, int n_on, double n_expected) {
    consider(distance_m, n_expected - kWeightOfOne * n_on);
  });
  visit_strips(votes, cell, 1.0, [&](double distance_m, int n_on, double n_expected) {
    consider(-distance_m, std::min<double>(n_on, kWeightOfOne * n_on - n_expected));
  });
  return best;
}

}  // namespace

std::vector<PlacedPoint> placed_points(std::span<const FacePoint> points,
                                       const RoofFace& face,
                                       const PlaneFit& fit,
                                       std::span<const NeighbourFace> neighbours,
                                       const JudgeOptions& options) {
  const double reach_m = 2.0 * kFaceReach_m;  // once from the face, once from the point
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
                                     double points_per_m2) {
  std::vector<Votes> votes(face.plan.edges().size(), {{}, {}, points_per_m2});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointPlace place = places[i].place;
    const bool near = std::abs(points[i].beyond_m) <= kFaceReach_m;
    const bool speaks = place != PointPlace::kUnknown && place != PointPlace::kAbove;
    if (!speaks || !near || !points[i].beside) continue;
    const bool on_face = place == PointPlace::kOnFace || place == PointPlace::kOnFaceOrOther;
    Votes& of_edge = votes[points[i].edge];
    (on_face ? of_edge.on_m : of_edge.off_m).push_back(points[i].beyond_m);
  }
  std::vector<EdgeOffset> edges;
  for (std::size_t i = 0; i < votes.size(); ++i) {
    const std::size_t n = votes[i].on_m.size() + votes[i].off_m.size();
    if (n < 2 * static_cast<std::size_t>(kMinContradictions)) continue;
    edges.push_back(best_place(i, votes[i], EdgeCell(face.plan, i, kFaceReach_m)));
  }
  return edges;
}

bool is_off(const EdgeOffset& edge) {
  return std::abs(edge.offset_m) > kOutlineTolerance_m &&
         edge.n_contradictions >= kMinContradictions;
}

bool is_outline_wrong(std::span<const EdgeOffset> edges) {
  return std::ranges::any_of(edges, [&](const EdgeOffset& edge) { return is_off(edge); });
}

}  // namespace ridgeline::evaluate
