// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/surface_lines.h"

#include "tests/other_scenes/true_edges.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace ridgeline::other {
namespace {

using Eigen::Vector3d;

bool lies_on(const Face& face, const Vector3d& x) {
  constexpr double kOn_m = 1e-6;
  constexpr double kBeyondBorder_m = 1e-3;  // edges are borders of faces
  const Vector3d normal = normal_of(face);
  if (std::abs(normal.dot(x - face.corners[0])) > kOn_m) return false;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Vector3d& a = face.corners[i];
    const Vector3d& b = face.corners[(i + 1) % face.corners.size()];
    if (normal.cross(b - a).normalized().dot(x - a) < -kBeyondBorder_m) return false;
  }
  return true;
}

bool lies_on(const Face& face, const Segment3& segment) {
  constexpr std::array kPlaces{0.1, 0.5, 0.9};
  return std::all_of(kPlaces.begin(), kPlaces.end(),
                     [&](double t) { return lies_on(face, point_at(segment, t)); });
}

bool is_wall(const Face& face) {
  constexpr double kUpright = 0.1;  // vertical component of the unit normal
  return std::abs(normal_of(face).z()) < kUpright;
}

bool rises_from(const Face& wall, const Segment3& segment) {
  constexpr double kMinRise_m = 0.1;
  double top_m = -std::numeric_limits<double>::infinity();
  for (const Vector3d& corner : wall.corners) top_m = std::max(top_m, corner.z());
  return top_m > std::max(segment.start.z(), segment.end.z()) + kMinRise_m;
}

/// Distance between the longer sides of a rectangle.
double width_m(const Face& face) {
  return std::min((face.corners[1] - face.corners[0]).norm(),
                  (face.corners[2] - face.corners[1]).norm());
}

/// `face`: one that the edge lies on.
std::string kind_on(const Face& face, bool is_foot, const std::string& kind) {
  constexpr double kMinWidth_m = 0.15;  // narrower tops are those of fences
  if (is_foot) return "foot";
  if (kind == "car" || kind == "chimney") return "object";
  if (kind == "fence") return width_m(face) >= kMinWidth_m ? "wall_top" : "object";
  return kind;
}

/// Whether something above sees a point of an edge.
bool is_seen(const RayTracer& tracer, const Vector3d& x) {
  constexpr double kOff_m = 0.01, kFar_m = 100.0;
  constexpr double kTilt_rad = 35.0 * M_PI / 180.0;
  constexpr int kSides = 8;
  if (!tracer.is_blocked({x, Vector3d::UnitZ()}, kOff_m, kFar_m)) return true;
  for (int i = 0; i < kSides; ++i) {
    const double azimuth = 2.0 * M_PI * i / kSides;
    const Vector3d to_eye(std::sin(kTilt_rad) * std::cos(azimuth),
                          std::sin(kTilt_rad) * std::sin(azimuth), std::cos(kTilt_rad));
    if (!tracer.is_blocked({x, to_eye}, kOff_m, kFar_m)) return true;
  }
  return false;
}

/// The longest stretch of an edge that is seen; start = end if none is.
Segment3 seen_stretch(const Scene& scene, const RayTracer& tracer, const Edge& edge) {
  constexpr double kStep_m = 0.05;
  const int n = std::max(2, static_cast<int>(length(edge.segment) / kStep_m));
  int first = 0, best_first = 0, best_end = 0;
  for (int i = 0; i < n; ++i) {
    const Vector3d x = point_at(edge.segment, (i + 0.5) / n);
    const bool is_border = edge.kind != "ground" || is_ground_border(scene, edge.segment, x);
    if (!is_border || !is_seen(tracer, x)) first = i + 1;
    if (i + 1 - first > best_end - best_first) {
      best_first = first;
      best_end = i + 1;
    }
  }
  return {point_at(edge.segment, static_cast<double>(best_first) / n),
          point_at(edge.segment, static_cast<double>(best_end) / n)};
}

bool is_in_patch(const Scene& scene, const Segment3& segment) {
  return point_at(segment, 0.5).head<2>().cwiseAbs().maxCoeff() <= scene.half_extent_m;
}

}  // namespace

std::optional<SurfaceLine> with_surfaces(const Scene& scene, const Edge& edge) {
  SurfaceLine line{edge.segment, edge.kind, {}};
  bool is_foot = false;
  for (std::size_t i = 0; i < scene.faces.size(); ++i) {
    const Face& face = scene.faces[i];
    if (!lies_on(face, edge.segment)) continue;
    if (is_wall(face)) {
      is_foot = is_foot || rises_from(face, edge.segment);
    } else {
      line.faces.push_back(static_cast<int>(i));
    }
  }
  if (line.faces.empty()) return std::nullopt;
  const Face& face = scene.faces[static_cast<std::size_t>(line.faces.front())];
  line.kind = kind_on(face, is_foot, edge.kind);
  if (line.kind == "object") line.faces.clear();
  return line;
}

std::vector<SurfaceLine> surface_lines(const Scene& scene, const RayTracer& tracer) {
  constexpr double kMinStretchLength_m = 0.5;
  std::vector<std::optional<SurfaceLine>> found(scene.edges.size());
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    const Edge& edge = scene.edges[i];
    const Segment3 stretch = seen_stretch(scene, tracer, edge);
    if (length(stretch) < kMinStretchLength_m || !is_in_patch(scene, stretch)) return;
    found[i] = with_surfaces(scene, {stretch, edge.kind});
  });
  std::vector<SurfaceLine> lines;
  for (std::optional<SurfaceLine>& line : found) {
    if (line) lines.push_back(std::move(*line));
  }
  return lines;
}

}  // namespace ridgeline::other
