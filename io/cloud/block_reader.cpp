// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/block_reader.h"

#include "io/error.h"
#include "reconstruct/geometry/interruption.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

namespace ridgeline::io {

namespace {

constexpr double kMaxCoordinateM = 1e8;  // beyond any map of the Earth, in metres or feet

/// One block on its way from the file to the cloud; its storage is reused.
struct Block {
  std::vector<CloudPoint> points;
  ReadSummary summary;
  std::exception_ptr error;
};

Eigen::AlignedBox3d extent_of(const std::vector<CloudPoint>& points) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kFar, kFar, kFar};
  std::array<double, 3> high{-kFar, -kFar, -kFar};
  for (const CloudPoint& point : points) {
    if (!std::isfinite(point.x + point.y + point.z)) continue;
    low = {std::min(low[0], point.x), std::min(low[1], point.y), std::min(low[2], point.z)};
    high = {std::max(high[0], point.x), std::max(high[1], point.y), std::max(high[2], point.z)};
  }
  return {Eigen::Vector3d(low[0], low[1], low[2]), Eigen::Vector3d(high[0], high[1], high[2])};
}

CoordinateSteps steps_of(const std::vector<CloudPoint>& points,
                         const LocalFromFile& local_from_file) {
  const auto& [unit_m, origin_m] = local_from_file;
  CoordinateSteps steps(unit_m);
  for (const CloudPoint& p : points) {
    if (!steps.may_have_steps()) break;
    steps.add((Eigen::Vector3d(p.x, p.y, p.z) + origin_m).cwiseQuotient(unit_m));
  }
  return steps;
}

void check_range(const Eigen::AlignedBox3d& extent_in_world, const std::string& path) {
  if (extent_in_world.isEmpty()) return;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double value : {extent_in_world.min()[axis], extent_in_world.max()[axis]}) {
      if (std::abs(value) > kMaxCoordinateM) {
        throw IoError(path,
                      fmt::format("a point has {} = {} m; beyond {} m the file must be damaged",
                                  "xyz"[axis], value, kMaxCoordinateM));
      }
    }
  }
}

/// The number of points of a block if the file's index shows that all of them lie outside the
/// wanted region; otherwise std::nullopt.
std::optional<std::uint64_t> points_outside(const CloudSource& source,
                                            std::size_t index,
                                            const LocalFromFile& local_from_file,
                                            const PointFilter& filter) {
  const std::optional<BlockExtent> extent = source.block_extent(index);
  if (!extent) return std::nullopt;
  const Eigen::AlignedBox3d& box = extent->box_in_file;
  const auto to_local = [&](const Eigen::Vector3d& x_in_file) -> Eigen::Vector3d {
    return local_from_file.unit_m.cwiseProduct(x_in_file) - local_from_file.origin_m;
  };
  if (!filter.excludes({to_local(box.min()), to_local(box.max())})) return std::nullopt;
  return extent->n_points;
}

void decode_and_filter(const CloudSource& source,
                       std::size_t index,
                       const LocalFromFile& local_from_file,
                       const PointFilter& filter,
                       Block& block) {
  block.summary = {};
  if (const auto n_outside = points_outside(source, index, local_from_file, filter)) {
    block.points.clear();
    block.summary.n_read = *n_outside;
    block.summary.drops.outside = *n_outside;
    block.summary.has_whole_extent = false;
    block.summary.steps = CoordinateSteps(local_from_file.unit_m);
    return;
  }
  source.decode_block(index, local_from_file, block.points);
  block.summary.n_read = block.points.size();
  block.summary.extent_in_world = extent_of(block.points);
  if (!block.summary.extent_in_world.isEmpty()) {
    block.summary.extent_in_world.translate(local_from_file.origin_m);
  }
  block.summary.steps = steps_of(block.points, local_from_file);
  check_range(block.summary.extent_in_world, source.info().path);
  block.summary.drops = filter.apply(block.points);
}

void add(const ReadSummary& part, ReadSummary& sum) {
  sum.n_read += part.n_read;
  sum.extent_in_world.extend(part.extent_in_world);
  sum.steps.merge(part.steps);
  sum.has_whole_extent = sum.has_whole_extent && part.has_whole_extent;
  sum.drops.non_finite += part.drops.non_finite;
  sum.drops.withheld += part.drops.withheld;
  sum.drops.classification += part.drops.classification;
  sum.drops.not_last_return += part.drops.not_last_return;
  sum.drops.outside += part.drops.outside;
  sum.drops.share += part.drops.share;
}

/// Calls `visit(block)` for every block in file order until it returns false; some blocks are
/// decoded ahead in parallel. An error in a block is thrown only when its turn comes, so that the
/// first one in the file is reported regardless of timing.
template <typename Visit>
void for_each_block(const CloudSource& source,
                    const LocalFromFile& local_from_file,
                    const PointFilter& filter,
                    const Visit& visit) {
  constexpr std::size_t kMaxBlocksAhead = 16;         // 8 MB with LAS blocks
  constexpr std::size_t kMaxPointsAhead = 2'000'000;  // 64 MB, for LAZ with large chunks
  const std::size_t n_ahead =
      std::clamp(kMaxPointsAhead / std::max<std::size_t>(1, source.max_block_points()),
                 std::size_t{1}, kMaxBlocksAhead);
  std::array<Block, kMaxBlocksAhead> wave;
  for (std::size_t first = 0; first < source.n_blocks(); first += n_ahead) {
    Interruption::check();
    const std::size_t count = std::min(n_ahead, source.n_blocks() - first);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      try {
        decode_and_filter(source, first + i, local_from_file, filter, wave[i]);
      } catch (...) {
        wave[i].error = std::current_exception();
      }
    });
    for (std::size_t i = 0; i < count; ++i) {
      if (wave[i].error) std::rethrow_exception(wave[i].error);
      if (!visit(std::as_const(wave[i]))) return;
    }
    source.release_blocks(first, count);
  }
}

}  // namespace

ReadSummary append_points(const CloudSource& source,
                          const LocalFromFile& local_from_file,
                          const PointFilter& filter,
                          std::vector<CloudPoint>& points,
                          std::uint64_t max_points) {
  ReadSummary sum;
  sum.steps = CoordinateSteps(local_from_file.unit_m);
  for_each_block(source, local_from_file, filter, [&](const Block& block) {
    add(block.summary, sum);
    points.insert(points.end(), block.points.begin(), block.points.end());
    return points.size() <= max_points;
  });
  return sum;
}

std::uint64_t count_kept(const CloudSource& source,
                         const LocalFromFile& local_from_file,
                         const PointFilter& filter) {
  std::uint64_t count = 0;
  for_each_block(source, local_from_file, filter, [&](const Block& block) {
    count += block.points.size();
    return true;
  });
  return count;
}

Eigen::AlignedBox3d kept_extent(const CloudSource& source,
                                const LocalFromFile& local_from_file,
                                const PointFilter& filter) {
  Eigen::AlignedBox3d extent;
  for_each_block(source, local_from_file, filter, [&](const Block& block) {
    extent.extend(extent_of(block.points));
    return true;
  });
  return extent;
}

}  // namespace ridgeline::io
