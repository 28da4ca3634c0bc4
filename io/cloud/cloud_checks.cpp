// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/cloud_checks.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace ridgeline::io {

namespace {

constexpr double kTolerance = 0.01;  // file units: writers round bounds to the scale

bool holds_block(const Eigen::AlignedBox3d& box, const CloudSource& source, std::size_t block) {
  std::vector<CloudPoint> points;
  source.decode_block(block, {}, points);
  return std::ranges::all_of(points, [&](const CloudPoint& p) {
    return !std::isfinite(p.x + p.y + p.z) || box.contains(Eigen::Vector3d(p.x, p.y, p.z));
  });
}

}  // namespace

std::optional<std::string> float_damage(const CloudFileInfo& info,
                                        const Eigen::AlignedBox3d& extent_in_world,
                                        const ReadOptions& options) {
  constexpr double kFloatEpsilon = 0x1p-23;
  if (!info.has_float_coordinates || extent_in_world.isEmpty()) return std::nullopt;
  const double largest_m =
      extent_in_world.min().cwiseAbs().cwiseMax(extent_in_world.max().cwiseAbs()).maxCoeff();
  const double step_m = largest_m * kFloatEpsilon;
  if (step_m <= options.max_coordinate_step_m) return std::nullopt;
  return fmt::format(
      "coordinates up to {:.0f} m are stored as float32, in steps of up to {:.3g} m; steps above "
      "{} m spoil plane fits, store doubles or subtract an offset first",
      largest_m, step_m, options.max_coordinate_step_m);
}

std::optional<std::string> wrong_bounds(const CloudFileInfo& info,
                                        const Eigen::Vector3d& unit_m,
                                        const Eigen::AlignedBox3d& extent_in_world) {
  if (!info.stated_bounds || extent_in_world.isEmpty()) return std::nullopt;
  const Eigen::Vector3d low = extent_in_world.min().cwiseQuotient(unit_m);
  const Eigen::Vector3d high = extent_in_world.max().cwiseQuotient(unit_m);
  const bool agree = ((low - info.stated_bounds->min()).cwiseAbs().maxCoeff() <= kTolerance) &&
                     ((high - info.stated_bounds->max()).cwiseAbs().maxCoeff() <= kTolerance);
  if (agree) return std::nullopt;
  return fmt::format(
      "header bounds are wrong: x {} to {}, y {} to {}, z {} to {}; the points span x {} to {}, y "
      "{} to {}, z {} to {}",
      info.stated_bounds->min().x(), info.stated_bounds->max().x(), info.stated_bounds->min().y(),
      info.stated_bounds->max().y(), info.stated_bounds->min().z(), info.stated_bounds->max().z(),
      low.x(), high.x(), low.y(), high.y(), low.z(), high.z());
}

std::optional<Eigen::AlignedBox3d> confirmed_bounds(const CloudSource& source) {
  const std::size_t n_blocks = source.n_blocks();
  const auto& stated = source.info().stated_bounds;
  if (!stated || n_blocks == 0 || !source.is_light() || source.block_extent(0)) return std::nullopt;
  const Eigen::Vector3d size = stated->max() - stated->min();
  if (!size.allFinite() || !(size.head<2>().minCoeff() > 0.0)) return std::nullopt;
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kTolerance);
  const Eigen::AlignedBox3d box(stated->min() - margin, stated->max() + margin);
  if (!holds_block(box, source, 0) || !holds_block(box, source, n_blocks - 1)) return std::nullopt;
  return box;
}

}  // namespace ridgeline::io
