// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/view_pairs.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/plane.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>
#include <tuple>

namespace ridgeline::reconstruct {
namespace {

double middle_height_m(const Scene& scene) {
  return 0.5 * (scene.height_range_in_local_m[0] + scene.height_range_in_local_m[1]);
}

/// Share of a view's pixels, on a regular grid, whose points at the given height are visible in
/// another view.
double shown_share(const View& view, const View& other, double height_m) {
  constexpr int kPerSide = 9;
  const Plane3 level(Eigen::Vector3d::UnitZ(), -height_m);
  int n_shown = 0;
  for (int row = 0; row < kPerSide; ++row) {
    for (int column = 0; column < kPerSide; ++column) {
      const Eigen::Vector2d x((column + 0.5) / kPerSide * view.image.cols,
                              (row + 0.5) / kPerSide * view.image.rows);
      const Eigen::Vector2d y =
          project(other.image_from_local, point_on_plane(view.image_from_local, x, level));
      n_shown +=
          y.x() >= 0.0 && y.y() >= 0.0 && y.x() < other.image.cols && y.y() < other.image.rows;
    }
  }
  return static_cast<double>(n_shown) / (kPerSide * kPerSide);
}

/// The cost of choosing a pair; lower is better.
struct PairCost {
  bool is_makeshift = false;  ///< the views have little in common
  /// Deviation of the base-to-height ratio from the best one; for a makeshift pair, the negative
  /// share that the views have in common.
  double value = 0.0;

  auto operator<=>(const PairCost&) const = default;
};

/// std::nullopt for a pair with too little in common.
std::optional<PairCost> cost_of(const Scene& scene, const ViewPair& pair) {
  constexpr double kBest = 0.3;
  constexpr double kUsualShare = 0.3;
  constexpr double kMinShare = 0.1;
  const auto [share, ratio] = common_place(scene, pair);
  if (share < kMinShare || !(ratio > 0.0)) return std::nullopt;
  if (share < kUsualShare) return PairCost{true, -share};
  return PairCost{false, std::abs(std::log(ratio / kBest))};
}

}  // namespace

CommonPlace common_place(const Scene& scene, const ViewPair& pair) {
  const View& a = scene.views[pair.base];
  const View& b = scene.views[pair.search];
  const double height_m = middle_height_m(scene);
  const Eigen::Vector3d centre_a = projection_centre(a.image_from_local).hnormalized();
  const Eigen::Vector3d centre_b = projection_centre(b.image_from_local).hnormalized();
  // Cameras that look up are below the place that they show.
  const double way_m = std::abs(0.5 * (centre_a.z() + centre_b.z()) - height_m);
  return {std::min(shown_share(a, b, height_m), shown_share(b, a, height_m)),
          (centre_b - centre_a).norm() / way_m};
}

std::vector<ViewPair> choose_pairs(const Scene& scene) {
  const std::size_t n = scene.views.size();
  if (n == 2) return {{0, 1}};
  check(cost_of(scene, {0, 1}).has_value(), "views ", scene.views[0].id, " and ", scene.views[1].id,
        ": the first two views must overlap");
  std::vector<ViewPair> pairs{{0, 1}};
  std::vector<bool> is_connected(n, false);
  is_connected[0] = is_connected[1] = true;
  while (true) {
    std::optional<ViewPair> best;
    const auto key = [&](const ViewPair& p, const PairCost& cost) {
      return std::tuple(cost, scene.views[p.base].id, scene.views[p.search].id);
    };
    std::optional<std::tuple<PairCost, std::string, std::string>> best_key;
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        if (!is_connected[a] || is_connected[b]) continue;
        const auto cost = cost_of(scene, {a, b});
        if (!cost || (best_key && *best_key <= key({a, b}, *cost))) continue;
        best = ViewPair{a, b};
        best_key = key({a, b}, *cost);
      }
    }
    if (!best) break;
    is_connected[best->search] = true;
    pairs.push_back(*best);
  }
  return pairs;
}

}  // namespace ridgeline::reconstruct
