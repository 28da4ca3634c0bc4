// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/true_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
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

/// Whether the ground is of different patches on both sides.
bool is_ground_border(const Scene& scene, const Segment3& edge, const Vector3d& x) {
  constexpr double kBeside_m = 0.02;
  const Vector2d along = plan(edge).end - plan(edge).start;
  const Vector2d beside = kBeside_m * Vector2d(-along.y(), along.x()).normalized();
  const Vector2d place = x.head<2>();
  return patch_at(scene, place + beside) != patch_at(scene, place - beside);
}

/// The sample points of an edge that an image shows.
struct Seen {
  int first = -1, last = -1, count = 0;
  void add(int i) {
    if (first < 0) first = i;
    last = i;
    ++count;
  }
};

std::optional<TrueEdge> true_edge(const Scene& scene,
                                  const RayTracer& tracer,
                                  const std::array<AerialCamera, 2>& cameras,
                                  const Edge& edge) {
  constexpr double kStep_m = 0.04;
  const int n = std::max(2, static_cast<int>(length(edge.segment) / kStep_m));
  const auto point = [&](double i) { return point_at(edge.segment, i / n); };
  std::array<Seen, 2> seen;
  for (int i = 0; i < n; ++i) {
    const Vector3d x = point(i + 0.5);
    if (edge.kind == "ground" && !is_ground_border(scene, edge.segment, x)) continue;
    for (std::size_t c = 0; c < 2; ++c) {
      if (sees(cameras[c], tracer, x)) seen[c].add(i);
    }
  }
  if (seen[0].count == 0 || seen[1].count == 0) return std::nullopt;
  const int first = std::min(seen[0].first, seen[1].first);
  const int last = std::max(seen[0].last, seen[1].last);
  TrueEdge result;
  result.edge = {{point(first), point(last + 1)}, edge.kind};
  for (std::size_t c = 0; c < 2; ++c) {
    result.visible[c] = static_cast<double>(seen[c].count) / (last + 1 - first);
    result.visible_px[c] = {cameras[c].pixel(point(seen[c].first)),
                            cameras[c].pixel(point(seen[c].last + 1))};
  }
  return result;
}

}  // namespace

std::vector<TrueEdge> true_edges(const Scene& scene,
                                 const RayTracer& tracer,
                                 const std::array<AerialCamera, 2>& cameras,
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
