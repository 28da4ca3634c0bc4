// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/true_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ridgeline::other {
namespace {

using Eigen::Vector3d;

constexpr double kShadowReach_m = 60.0;
constexpr double kMinLength_m = 0.6;

bool throws_shadow(const Edge& edge) {
  return edge.kind != "ground" && edge.kind != "joint" && edge.kind != "valley" &&
         length(edge.segment) >= kMinLength_m;
}

/// Faces that the shadow of the edge may fall on: those that rays which pass it closely meet.
std::set<int> receivers(const Scene& scene, const RayTracer& tracer, const Segment3& edge) {
  constexpr double kStep_m = 0.25, kBeside_m = 0.05;
  const Vector3d direction = (edge.end - edge.start).normalized();
  const Vector3d beside = kBeside_m * direction.cross(scene.to_sun).normalized();
  const int n = std::max(2, static_cast<int>(length(edge) / kStep_m));
  std::set<int> faces;
  for (int i = 0; i < n; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const Vector3d x = point_at(edge, (i + 0.5) / n) + side * beside;
      const auto hit = tracer.first_hit({x, -scene.to_sun}, 0.02, kShadowReach_m);
      if (hit && hit->face >= 0) faces.insert(hit->face);
    }
  }
  return faces;
}

/// Whether a face has light on one side of `x` and shadow on the other one.
bool is_border(const Scene& scene,
               const RayTracer& tracer,
               const Vector3d& x,
               const Vector3d& beside,
               const Vector3d& normal) {
  const auto in_shadow = [&](double side) {
    return tracer.is_blocked({x + side * beside + 2e-3 * normal, scene.to_sun}, 0.0,
                             kShadowReach_m);
  };
  return in_shadow(-1.0) != in_shadow(1.0);
}

/// Whether the sun sees `x` on the face itself, but for the edge that throws the shadow: the face
/// reaches as far as `x`.
bool is_on_face(const RayTracer& tracer, int face, const Vector3d& x, const Vector3d& normal) {
  constexpr double kAbove_m = 0.01;
  const auto hit = tracer.first_hit({x + kAbove_m * normal, -normal}, 0.0, 2.0 * kAbove_m);
  return hit && hit->face == face;
}

void add_borders(const Scene& scene,
                 const RayTracer& tracer,
                 const Segment3& edge,
                 int face,
                 std::vector<Edge>& borders) {
  constexpr double kStep_m = 0.05, kBeside_m = 0.05, kMaxGap_m = 0.3;
  Vector3d normal = normal_of(scene.faces[face]);
  const double cosine = normal.dot(scene.to_sun);
  if (std::abs(cosine) < 0.05) return;
  if (cosine < 0.0) normal = -normal;
  const Vector3d& on_plane = scene.faces[face].corners[0];
  const auto shadow_of = [&](const Vector3d& x) -> Vector3d {
    return x - normal.dot(x - on_plane) / std::abs(cosine) * scene.to_sun;
  };
  const Segment3 shadow{shadow_of(edge.start), shadow_of(edge.end)};
  if (length(shadow) < kMinLength_m || normal.dot(edge.start - on_plane) < -0.01) return;
  const Vector3d beside = kBeside_m * normal.cross(shadow.end - shadow.start).normalized();
  const int n = static_cast<int>(length(shadow) / kStep_m);
  double from = -1.0;
  double to = -1.0;
  const auto end_run = [&] {
    const Segment3 run{point_at(shadow, from), point_at(shadow, to)};
    if (from >= 0.0 && length(run) >= kMinLength_m) borders.push_back({run, "shadow"});
    from = to = -1.0;
  };
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) / n;
    const Vector3d x = point_at(shadow, t);
    if (from >= 0.0 && (t - to) * length(shadow) > kMaxGap_m) end_run();
    if (!is_on_face(tracer, face, x, normal)) continue;
    if (!is_border(scene, tracer, x, beside, normal)) continue;
    if (from < 0.0) from = t;
    to = t;
  }
  end_run();
}

}  // namespace

std::vector<Edge> shadow_edges(const Scene& scene, const RayTracer& tracer) {
  std::vector<std::vector<Edge>> borders(scene.edges.size());
  tbb::parallel_for(std::size_t{0}, scene.edges.size(), [&](std::size_t i) {
    const Edge& edge = scene.edges[i];
    if (!throws_shadow(edge)) return;
    if (midpoint(edge.segment).head<2>().cwiseAbs().maxCoeff() > scene.half_extent_m + 15.0) return;
    for (const int face : receivers(scene, tracer, edge.segment)) {
      add_borders(scene, tracer, edge.segment, face, borders[i]);
    }
  });
  std::vector<Edge> all;
  for (const auto& of_edge : borders) all.insert(all.end(), of_edge.begin(), of_edge.end());
  return all;
}

}  // namespace ridgeline::other
