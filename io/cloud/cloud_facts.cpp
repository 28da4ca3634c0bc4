// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/cloud_facts.h"

#include "io/cloud/cloud_checks.h"
#include "io/cloud/cloud_source.h"
#include "io/cloud/occupied_cells.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace ridgeline::io {

namespace {

/// Counts of a part of the points. Merging is exact and does not depend on the order.
struct Census {
  explicit Census(const Eigen::Vector3d& unit_m) : steps(unit_m) {}

  std::uint64_t n_points = 0;
  std::uint64_t n_non_finite = 0;
  std::uint64_t n_withheld = 0;
  std::array<std::uint64_t, 256> n_by_class{};
  std::array<std::uint64_t, 256> n_by_return{};
  Eigen::AlignedBox3d bounds;
  OccupiedCells cells;
  CoordinateSteps steps;

  void add(const CloudPoint& point, const Eigen::Vector3d& unit_m) {
    constexpr unsigned kWithheldFlag = 0x04;
    ++n_points;
    ++n_by_class[point.classification];
    ++n_by_return[point.return_number];
    if ((point.flags & kWithheldFlag) != 0) ++n_withheld;
    if (!std::isfinite(point.x + point.y + point.z)) {
      ++n_non_finite;
      return;
    }
    bounds.extend(Eigen::Vector3d(point.x, point.y, point.z));
    if (steps.may_have_steps()) steps.add({point.x, point.y, point.z});
    cells.add(point.x * unit_m.x(), point.y * unit_m.y());
  }

  void merge(const Census& other) {
    n_points += other.n_points;
    n_non_finite += other.n_non_finite;
    n_withheld += other.n_withheld;
    for (std::size_t i = 0; i < n_by_class.size(); ++i) {
      n_by_class[i] += other.n_by_class[i];
      n_by_return[i] += other.n_by_return[i];
    }
    bounds.extend(other.bounds);
    cells.merge(other.cells);
    steps.merge(other.steps);
  }
};

Census count_points(const CloudSource& source) {
  const Eigen::Vector3d unit_m = source.info().unit_m;
  const auto add_blocks = [&](const tbb::blocked_range<std::size_t>& range, Census census) {
    std::vector<CloudPoint> points;
    for (std::size_t block = range.begin(); block != range.end(); ++block) {
      source.decode_block(block, {}, points);  // file units
      for (const CloudPoint& point : points) census.add(point, unit_m);
      source.release_blocks(block, 1);
    }
    return census;
  };
  const auto join = [](Census a, const Census& b) {
    a.merge(b);
    return a;
  };
  return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, source.n_blocks(), 16),
                              Census(unit_m), add_blocks, join);
}

std::map<std::uint8_t, std::uint64_t> present(const std::array<std::uint64_t, 256>& counts) {
  std::map<std::uint8_t, std::uint64_t> result;
  for (std::size_t code = 0; code < counts.size(); ++code) {
    if (counts[code] > 0) result[static_cast<std::uint8_t>(code)] = counts[code];
  }
  return result;
}

}  // namespace

CloudFacts cloud_facts(const std::string& path, const OpenCloudOptions& options) {
  const std::unique_ptr<CloudSource> source = open_cloud(path, options);
  const CloudFileInfo& info = source->info();
  const Census census = count_points(*source);
  CloudFacts facts{.path = path,
                   .format = info.format,
                   .n_points = census.n_points,
                   .n_non_finite = census.n_non_finite,
                   .bounds = census.bounds,
                   .density_per_m2 = {},
                   .n_by_class = present(census.n_by_class),
                   .n_by_return = present(census.n_by_return),
                   .n_withheld = census.n_withheld,
                   .crs = describe(info.crs),
                   .plan_scale = {},
                   .unit_m = info.unit_m,
                   .states_unit = info.crs.known() || info.unit_m != Eigen::Vector3d::Ones(),
                   .scale = info.scale,
                   .offset = info.offset,
                   .warnings = info.warnings};
  if (const std::uint64_t n_cells = census.cells.count(); n_cells > 0 && !info.is_geographic) {
    facts.density_per_m2 =
        static_cast<double>(census.n_points - census.n_non_finite) / static_cast<double>(n_cells);
  }
  const SeenPoints seen{{info.unit_m.cwiseProduct(census.bounds.min()),
                         info.unit_m.cwiseProduct(census.bounds.max())},
                        census.steps,
                        census.n_points};
  if (info.is_geographic || census.bounds.isEmpty()) return facts;
  facts.plan_scale = grid_scale(info.crs, census.bounds.center().head<2>());
  if (auto text = coarse_steps(*source, info.unit_m, seen)) facts.warnings.push_back(*text);
  return facts;
}

}  // namespace ridgeline::io
