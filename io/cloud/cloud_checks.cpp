// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/cloud_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
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

/// Coordinate steps caused by the file's storage (the scale of LAS, or float32), metres.
Eigen::Vector3d stored_steps_m(const CloudFileInfo& info,
                               const Eigen::Vector3d& unit_m,
                               const Eigen::AlignedBox3d& extent_in_world) {
  constexpr int kFloatDigits = 24;
  Eigen::Vector3d steps_m = Eigen::Vector3d::Zero();
  if (info.scale) steps_m = info.scale->cwiseAbs().cwiseProduct(unit_m);
  if (!info.has_float_coordinates || extent_in_world.isEmpty()) return steps_m;
  for (int axis = 0; axis < 3; ++axis) {
    const double largest =
        std::max(std::abs(extent_in_world.min()[axis]), std::abs(extent_in_world.max()[axis])) /
        unit_m[axis];
    int exponent = 0;
    (void)std::frexp(largest, &exponent);
    steps_m[axis] = std::ldexp(unit_m[axis], exponent - kFloatDigits);
  }
  return steps_m;
}

/// Whether the points form a raster in plan whose cell size is the coordinate step, with at most
/// one point per cell: no two points of the first block share a cell, and a good part of all cells
/// is filled.
bool is_raster(const CloudSource& source,
               const Eigen::Vector3d& unit_m,
               const Eigen::Vector3d& steps_m,
               const SeenPoints& seen) {
  // Points at the centres of cells may halve the step; a full raster then fills a quarter of the
  // cells.
  constexpr double kMinFill = 0.1;
  if (!(steps_m.x() > 0.0) || steps_m.x() != steps_m.y() || source.n_blocks() == 0) return false;
  const Eigen::Vector3d size_m = seen.extent_in_world.sizes();
  const double n_cells = (size_m.x() / steps_m.x() + 1.0) * (size_m.y() / steps_m.y() + 1.0);
  if (static_cast<double>(seen.n) < kMinFill * n_cells) return false;
  std::vector<CloudPoint> points;
  source.decode_block(0, {.unit_m = unit_m}, points);
  std::vector<std::pair<std::int64_t, std::int64_t>> cells;
  for (const CloudPoint& p : points) {
    if (!std::isfinite(p.x + p.y)) continue;
    cells.emplace_back(std::llround(p.x / steps_m.x()), std::llround(p.y / steps_m.y()));
  }
  std::ranges::sort(cells);
  return std::ranges::adjacent_find(cells) == cells.end();
}

}  // namespace

std::optional<std::string> coarse_steps(const CloudSource& source,
                                        const Eigen::Vector3d& unit_m,
                                        const SeenPoints& points,
                                        double tolerable_m) {
  const CloudFileInfo& info = source.info();
  const Eigen::Vector3d stored_m = stored_steps_m(info, unit_m, points.extent_in_world);
  Eigen::Vector3d steps_m = points.steps.steps_m();
  const bool is_stored_coarsely = stored_m.maxCoeff() > tolerable_m;
  if (!is_stored_coarsely && is_raster(source, unit_m, steps_m, points)) {
    steps_m.head<2>().setZero();
  }
  steps_m = steps_m.cwiseMax(stored_m);
  if (!(steps_m.maxCoeff() > tolerable_m)) return std::nullopt;
  steps_m = (steps_m.array() > tolerable_m).select(steps_m, 0.0);
  const char* cause = "they were written with too few digits or converted to float32";
  if (info.has_float_coordinates && is_stored_coarsely) cause = "they are stored as float32";
  if (info.scale && is_stored_coarsely) cause = "the scale of the file is that coarse";
  return fmt::format(
      "coordinates have {}: {}; steps above {} m degrade plane fits; store doubles, more digits, "
      "or coordinates with an offset subtracted",
      steps_text(steps_m), cause, tolerable_m);
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
  // A run may skip thousands of files, so only some blocks of each are read.
  constexpr std::size_t kChecked = 4;
  const std::size_t n_checked = std::min(kChecked, n_blocks);
  for (std::size_t i = 0; i < n_checked; ++i) {
    const std::size_t block = n_checked == 1 ? 0 : i * (n_blocks - 1) / (n_checked - 1);
    if (!holds_block(box, source, block)) return std::nullopt;
  }
  return box;
}

}  // namespace ridgeline::io
