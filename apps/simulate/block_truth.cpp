// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/block_truth.h"

#include "apps/simulate/visible_runs.h"
#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace ridgeline::simulate {
namespace {

/// Whether the image of a line may lie in a view. Avoids the visibility test for most views of a
/// block.
bool may_show(const AerialView& view, const Segment3& line) {
  const Eigen::AlignedBox2d frame_px(Eigen::Vector2d::Constant(-0.5),
                                     view.size_px.cast<double>() - Eigen::Vector2d::Constant(0.5));
  Eigen::AlignedBox2d line_px;
  for (const Eigen::Vector3d& x : {line.start, line.end}) {
    line_px.extend(project(view.image_from_local, x));
  }
  return frame_px.intersects(line_px);
}

/// Adds to a true line what the views show of it. `shares`: the visible share of its length in each
/// view.
void set_seen(std::span<const AerialView> views, std::vector<double> shares, io::Line& line) {
  constexpr double kHalf = 0.5;
  std::vector<ProjectionMatrix> cameras;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (shares[i] >= kHalf) cameras.push_back(views[i].image_from_world);
  }
  if (cameras.size() >= 2) set_class(cameras, line);
  std::ranges::partial_sort(shares, shares.begin() + 2, std::greater());
  line.n_images = static_cast<int>(cameras.size());
  line.visible_base = shares[0];
  line.visible_other = shares[1];
}

}  // namespace

io::LineSet seen_in_block(const SyntheticScene& scene,
                          std::span<const AerialView> views,
                          io::LineSet truth) {
  check(truth.lines.size() == scene.lines.size(), "seen_in_block: ", truth.lines.size(),
        " lines, must be those of the scene, ", scene.lines.size());
  check(views.size() >= 2, "seen_in_block: ", views.size(), " views, must be 2 or more");
  const SurfaceOracle oracle(scene, {views.begin(), views.end()});
  tbb::parallel_for(std::size_t{0}, truth.lines.size(), [&](std::size_t i) {
    const Segment3& segment = scene.lines[i].segment;
    std::vector<double> shares(views.size(), 0.0);
    for (std::size_t view = 0; view < views.size(); ++view) {
      if (!may_show(views[view], segment)) continue;
      shares[view] = total_length(visible_runs(oracle, view, segment));
    }
    set_seen(views, std::move(shares), truth.lines[i]);
  });
  return truth;
}

}  // namespace ridgeline::simulate
