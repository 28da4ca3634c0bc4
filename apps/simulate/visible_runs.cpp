// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/visible_runs.h"

#include <oneapi/tbb/parallel_for.h>

namespace ridgeline::simulate {
namespace {

constexpr double kSightStep_m = 0.1;  ///< spacing of the lines of sight along an edge
constexpr double kMaxGap_m = 0.5;     ///< shorter interruptions are closed
constexpr double kFlank_px = 1.0;     ///< distance from an edge at which its sides are sampled

/// Whether a view sees a point of an edge: nothing hides it and its two sides show different
/// surfaces.
bool is_seen(const SurfaceOracle& oracle,
             std::size_t view,
             const Eigen::Vector3d& x,
             const Eigen::Vector2d& side_px) {
  if (!oracle.visible(view, x)) return false;
  const Eigen::Vector2d x_px = oracle.pixel_of(view, x);
  const auto a = oracle.seen_at(view, x_px + side_px);
  const auto b = oracle.seen_at(view, x_px - side_px);
  return a && b && !oracle.same_surface(*a, *b);
}

/// Merges intervals separated by gaps shorter than `longest_gap`.
std::vector<PlanInterval> closed(const std::vector<PlanInterval>& intervals, double longest_gap) {
  std::vector<PlanInterval> result;
  for (const PlanInterval& interval : intervals) {
    if (!result.empty() && interval.begin - result.back().end < longest_gap) {
      result.back().end = interval.end;
    } else {
      result.push_back(interval);
    }
  }
  return result;
}

}  // namespace

Segment2 image_of(const SurfaceOracle& oracle,
                  std::size_t view,
                  const Segment3& edge,
                  const PlanInterval& part) {
  return {oracle.pixel_of(view, point_at(edge, part.begin)),
          oracle.pixel_of(view, point_at(edge, part.end))};
}

std::vector<PlanInterval> visible_runs(const SurfaceOracle& oracle,
                                       std::size_t view,
                                       const Segment3& edge) {
  const Segment2 image = image_of(oracle, view, edge, {});
  if (length(image) < kMinShownLength_px) return {};
  const Eigen::Vector2d side_px = kFlank_px * normal(image);
  const int samples = 1 + static_cast<int>(length(edge) / kSightStep_m);
  std::vector<PlanInterval> runs;
  for (int i = 0; i < samples; ++i) {
    const PlanInterval step{static_cast<double>(i) / samples, static_cast<double>(i + 1) / samples};
    const Eigen::Vector3d middle = point_at(edge, 0.5 * (step.begin + step.end));
    if (!is_seen(oracle, view, middle, side_px)) continue;
    if (!runs.empty() && runs.back().end == step.begin) {
      runs.back().end = step.end;
    } else {
      runs.push_back(step);
    }
  }
  return closed(runs, kMaxGap_m / length(edge));
}

double total_length(const std::vector<PlanInterval>& runs) {
  double sum = 0.0;
  for (const PlanInterval& run : runs) sum += run.end - run.begin;
  return sum;
}

std::vector<std::vector<double>> visible_shares(const SyntheticScene& scene,
                                                const SurfaceOracle& oracle) {
  std::vector<std::vector<double>> shares(scene.lines.size());
  tbb::parallel_for(std::size_t{0}, shares.size(), [&](std::size_t i) {
    for (std::size_t view = 0; view < oracle.num_views(); ++view) {
      shares[i].push_back(total_length(visible_runs(oracle, view, scene.lines[i].segment)));
    }
  });
  return shares;
}

}  // namespace ridgeline::simulate
