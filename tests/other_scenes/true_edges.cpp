// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/true_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ridgeline::other {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Whether nothing lies before `x`, which is on the border of something itself.
bool sees(const AerialCamera& camera, const RayTracer& tracer, const Vector3d& x) {
  constexpr double kBefore_m = 0.03;
  if (!camera.shows(camera.pixel(x))) return false;
  const Vector3d ray = x - camera.centre;
  return !tracer.is_blocked({camera.centre, ray}, 0.0, 1.0 - kBefore_m / ray.norm());
}

/// The sample points of an edge that an image shows.
struct Seen {
  int first = -1, last = -1, count = 0;
  Segment2 in_px{Vector2d::Zero(), Vector2d::Zero()};
  void add(int i) {
    if (first < 0) first = i;
    last = i;
    ++count;
  }
};

/// From the first to the last one that any image shows.
struct Extent {
  int first = std::numeric_limits<int>::max(), last = -1;
  void add(const Seen& seen) {
    if (seen.count == 0) return;
    first = std::min(first, seen.first);
    last = std::max(last, seen.last);
  }
  [[nodiscard]] double share(const Seen& seen) const {
    return static_cast<double>(seen.count) / (last + 1 - first);
  }
};

int n_samples(const Edge& edge) {
  constexpr double kStep_m = 0.04;
  return std::max(2, static_cast<int>(length(edge.segment) / kStep_m));
}

std::vector<Seen> seen_of(const Scene& scene,
                          const RayTracer& tracer,
                          const std::vector<AerialCamera>& cameras,
                          const Edge& edge) {
  const int n = n_samples(edge);
  const auto point = [&](double i) { return point_at(edge.segment, i / n); };
  std::vector<Seen> seen(cameras.size());
  for (int i = 0; i < n; ++i) {
    const Vector3d x = point(i + 0.5);
    if (edge.kind == "ground" && !is_ground_border(scene, edge.segment, x)) continue;
    for (std::size_t c = 0; c < cameras.size(); ++c) {
      if (sees(cameras[c], tracer, x)) seen[c].add(i);
    }
  }
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    if (seen[c].count == 0) continue;
    seen[c].in_px = {cameras[c].pixel(point(seen[c].first)),
                     cameras[c].pixel(point(seen[c].last + 1))};
  }
  return seen;
}

/// Whether both images show enough of an edge to tell where it is. What other images show of it
/// does not count: the rule is the same for each pair.
bool do_show(const Seen& a, const Seen& b) {
  constexpr double kMinLength_px = 6.0, kMinShare = 0.25;
  if (length(a.in_px) < kMinLength_px || length(b.in_px) < kMinLength_px) return false;
  Extent extent;
  extent.add(a);
  extent.add(b);
  return extent.share(a) >= kMinShare && extent.share(b) >= kMinShare;
}

std::vector<std::size_t> views_in_pairs(const std::vector<Seen>& seen) {
  std::vector<std::size_t> views;
  for (std::size_t c = 0; c < seen.size(); ++c) {
    for (std::size_t other = 0; other < seen.size(); ++other) {
      if (other == c || !do_show(seen[c], seen[other])) continue;
      views.push_back(c);
      break;
    }
  }
  return views;
}

std::optional<TrueEdge> true_edge(const Scene& scene,
                                  const RayTracer& tracer,
                                  const std::vector<AerialCamera>& cameras,
                                  const Edge& edge) {
  const std::vector<Seen> seen = seen_of(scene, tracer, cameras, edge);
  TrueEdge result;
  result.views = views_in_pairs(seen);
  if (result.views.empty()) return std::nullopt;
  Extent extent;
  for (const std::size_t view : result.views) extent.add(seen[view]);
  for (const std::size_t view : result.views) result.visible.push_back(extent.share(seen[view]));
  const double n = n_samples(edge);
  result.edge = {
      {point_at(edge.segment, extent.first / n), point_at(edge.segment, (extent.last + 1) / n)},
      edge.kind};
  if (do_show(seen[0], seen[1])) result.base_px = {seen[0].in_px, seen[1].in_px};
  return result;
}

}  // namespace

bool is_ground_border(const Scene& scene, const Segment3& edge, const Vector3d& x) {
  constexpr double kBeside_m = 0.02;
  const Vector2d along = plan(edge).end - plan(edge).start;
  const Vector2d beside = kBeside_m * Vector2d(-along.y(), along.x()).normalized();
  const Vector2d place = x.head<2>();
  return patch_at(scene, place + beside) != patch_at(scene, place - beside);
}

std::vector<TrueEdge> true_edges(const Scene& scene,
                                 const RayTracer& tracer,
                                 const std::vector<AerialCamera>& cameras,
                                 const std::vector<Edge>& edges) {
  std::vector<std::optional<TrueEdge>> found(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(),
                    [&](std::size_t i) { found[i] = true_edge(scene, tracer, cameras, edges[i]); });
  std::vector<TrueEdge> result;
  for (const auto& edge : found) {
    if (edge) result.push_back(*edge);
  }
  return result;
}

}  // namespace ridgeline::other
