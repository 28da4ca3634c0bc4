// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/plan_scale.h"

#include "io/crs/grid_scale.h"
#include "io/error.h"
#include "reconstruct/geometry/check.h"

#include <Eigen/Core>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ridgeline::results {
namespace {

/// The positions of the lines in plan, in the coordinates of their files.
class Places {
 public:
  explicit Places(const std::vector<io::LineSet>& sets) {
    for (const io::LineSet& set : sets) {
      for (const io::Line& line : set.lines) {
        if (!all_finite(line.segment_in_world)) continue;
        const Eigen::Vector3d middle =
            0.5 * (line.segment_in_world.start + line.segment_in_world.end);
        for (const int axis : {0, 1})
          coordinates_[static_cast<std::size_t>(axis)].push_back(middle[axis]);
      }
    }
    for (std::vector<double>& values : coordinates_) std::ranges::sort(values);
  }

  [[nodiscard]] bool empty() const { return coordinates_[0].empty(); }

  /// Quantiles of the coordinates by axis. Those at 0.5 give a centre that is not affected by
  /// outlying lines.
  [[nodiscard]] Eigen::Vector2d quantile(double share_x, double share_y) const {
    return {quantile_of(coordinates_[0], share_x), quantile_of(coordinates_[1], share_y)};
  }

 private:
  static double quantile_of(const std::vector<double>& sorted, double share) {
    const double last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(std::round(share * last))];
  }

  std::array<std::vector<double>, 2> coordinates_;
};

/// The common reference system of lines, cloud and cameras, not all of which need state it.
io::Crs common_crs(const io::CloudFiles& cloud,
                   const std::vector<io::LineSet>& sets,
                   const std::optional<io::Patch>& patch) {
  if (cloud.crs().known()) return cloud.crs();
  if (patch && patch->crs.known()) return patch->crs;
  const auto known =
      std::ranges::find_if(sets, [](const io::LineSet& set) { return set.crs.known(); });
  return known == sets.end() ? io::Crs{} : known->crs;
}

/// Throws IoError unless a single factor per axis is valid for nearly all lines.
void require_constant_scale(const std::string& path,
                            const io::Crs& crs,
                            const Places& places,
                            const io::GridScale& middle) {
  constexpr double kCut = 0.05;  // share ignored at each end, because of outlying lines
  const auto refuse = [&](const std::string& why) {
    throw io::IoError(path, fmt::format("{}; project lines and cloud, for instance to {}", why,
                                        io::utm_zone_text(crs, middle)));
  };
  if (std::abs(middle.skew) > io::kMaxScaleError) {
    refuse("the axes of the plan are not perpendicular on the ground, so no scale can correct it");
  }
  for (const double x : {kCut, 1.0 - kCut}) {
    for (const double y : {kCut, 1.0 - kCut}) {
      const auto scale = io::grid_scale(crs, places.quantile(x, y));
      if (!scale) continue;
      const Eigen::Array2d ratio = scale->scale.array() / middle.scale.array();
      if (((ratio - 1.0).abs() <= io::kMaxScaleError).all()) continue;
      refuse(fmt::format("the lines cover so large an area that the map scale varies by {:.2g} %",
                         100.0 * (ratio - 1.0).abs().maxCoeff()));
    }
  }
}

}  // namespace

void set_plan_scale(const std::vector<io::LineSet>& sets,
                    const std::optional<io::Patch>& patch,
                    bool scale_to_ground,
                    io::CloudFiles& cloud,
                    std::vector<std::string>& warnings) {
  check(!scale_to_ground || !patch,
        "`scale_to_ground`: cameras cannot be scaled; must be without `patch`");
  const io::Crs crs = common_crs(cloud, sets, patch);
  const Places places(sets);
  if (!crs.known() || places.empty()) return;
  const Eigen::Vector2d middle = places.quantile(0.5, 0.5);
  if (!scale_to_ground) {
    const std::string remedy = patch ? "" : ", or give `scale_to_ground`";
    std::string warning = io::require_true_scale(cloud.path(), crs, middle, remedy);
    if (!warning.empty()) warnings.push_back(std::move(warning));
    return;
  }
  const std::optional<io::GridScale> scale = io::grid_scale(crs, middle);
  if (!scale || scale->is_true()) return;
  require_constant_scale(cloud.path(), crs, places, *scale);
  cloud.set_plan_scale(scale->scale);
  warnings.push_back(
      fmt::format("{}: the map scale of \"{}\" is {}; coordinates are divided by it, so that "
                  "figures are metres on the ground",
                  cloud.path(), io::describe(crs).name, io::scale_text(*scale)));
}

void set_plan_scale(bool scale_to_ground,
                    io::CloudFiles& cloud,
                    std::vector<std::string>& warnings) {
  io::LineSet place;
  const Eigen::Vector3d origin = cloud.frame().origin_m.cwiseQuotient(cloud.unit_m());
  place.lines.emplace_back().segment_in_world = {origin, origin};
  set_plan_scale({place}, std::nullopt, scale_to_ground, cloud, warnings);
}

}  // namespace ridgeline::results
