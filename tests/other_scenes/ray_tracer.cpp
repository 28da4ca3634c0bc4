// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/ray_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ridgeline::other {
namespace {

constexpr double kNever = 1e30;  ///< farther than any shape

/// Moller and Trumbore 1997; kNever if the ray misses.
double to_triangle(const Eigen::Vector3d& a,
                   const Eigen::Vector3d& ab,
                   const Eigen::Vector3d& ac,
                   const Ray& ray) {
  const Eigen::Vector3d p = ray.direction.cross(ac);
  const double determinant = ab.dot(p);
  if (std::abs(determinant) < 1e-15) return kNever;
  const Eigen::Vector3d offset = ray.origin - a;
  const double u = offset.dot(p) / determinant;
  if (u < 0.0 || u > 1.0) return kNever;
  const Eigen::Vector3d q = offset.cross(ab);
  const double v = ray.direction.dot(q) / determinant;
  if (v < 0.0 || u + v > 1.0) return kNever;
  return ac.dot(q) / determinant;
}

double to_ellipsoid(const Eigen::Vector3d& centre,
                    const Eigen::Vector3d& inverse_radii,
                    const Ray& ray,
                    double from) {
  const Eigen::Vector3d o = (ray.origin - centre).cwiseProduct(inverse_radii);
  const Eigen::Vector3d d = ray.direction.cwiseProduct(inverse_radii);
  const double dd = d.squaredNorm();
  const double half = -o.dot(d) / dd;
  const double radicand = (1.0 - (o + half * d).squaredNorm()) / dd;
  if (radicand < 0.0) return kNever;
  const double root = std::sqrt(radicand);
  return half - root >= from ? half - root : half + root;
}

}  // namespace

struct RayTracer::Boxed {
  Shape shape;
  Eigen::Vector3d low, high;
};

RayTracer::RayTracer(const Scene& scene)
    : ground_point_(scene.faces.front().corners[0]),
      ground_normal_(normal_of(scene.faces.front())) {
  std::vector<Boxed> boxed;
  add_triangles(scene, boxed);
  for (std::size_t i = 0; i < scene.ellipsoids.size(); ++i) {
    const Ellipsoid& e = scene.ellipsoids[i];
    boxed.push_back({{e.centre, e.radii.cwiseInverse(), e.radii, -1, static_cast<int>(i)},
                     e.centre - e.radii,
                     e.centre + e.radii});
  }
  nodes_.reserve(2 * boxed.size());
  nodes_.emplace_back();
  build(0, boxed, 0, static_cast<int>(boxed.size()));
  for (const Boxed& b : boxed) shapes_.push_back(b.shape);
}

void RayTracer::add_triangles(const Scene& scene, std::vector<Boxed>& boxed) {
  for (std::size_t f = 1; f < scene.faces.size(); ++f) {
    const auto& corners = scene.faces[f].corners;
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Eigen::Vector3d& a = corners[0];
      const Eigen::Vector3d& b = corners[i - 1];
      const Eigen::Vector3d& c = corners[i];
      boxed.push_back({{a, b - a, c - a, static_cast<int>(f), -1},
                       a.cwiseMin(b).cwiseMin(c),
                       a.cwiseMax(b).cwiseMax(c)});
    }
  }
}

void RayTracer::build(int node, std::vector<Boxed>& boxed, int from, int to) {
  constexpr int kLeaf = 3;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(kNever);
  Eigen::Vector3d high = -low;
  for (int i = from; i < to; ++i) {
    low = low.cwiseMin(boxed[i].low);
    high = high.cwiseMax(boxed[i].high);
  }
  nodes_[node] = {low, high, from, to - from};
  if (to - from <= kLeaf) return;
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int middle = (from + to) / 2;
  std::nth_element(boxed.begin() + from, boxed.begin() + middle, boxed.begin() + to,
                   [axis](const Boxed& a, const Boxed& b) {
                     return a.low[axis] + a.high[axis] < b.low[axis] + b.high[axis];
                   });
  const int child = static_cast<int>(nodes_.size());
  nodes_[node].first = child;
  nodes_[node].count = 0;
  nodes_.resize(nodes_.size() + 2);
  build(child, boxed, from, middle);
  build(child + 1, boxed, middle, to);
}

double RayTracer::distance(const Shape& shape, const Ray& ray, double from, double to) {
  const double t = shape.face >= 0 ? to_triangle(shape.a, shape.ab, shape.ac, ray)
                                   : to_ellipsoid(shape.a, shape.ab, ray, from);
  return t >= from && t <= to ? t : kNever;
}

double RayTracer::entry(const Node& node, const Inverse& ray, double from, double to) {
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (node.low[axis] - ray.origin[axis]) * ray.inverse[axis];
    const double b = (node.high[axis] - ray.origin[axis]) * ray.inverse[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to ? from : kNever;
}

template <bool kAny>
std::optional<Hit> RayTracer::trace(const Ray& ray, double from, double to) const {
  std::optional<Hit> hit;
  const double to_ground =
      ground_normal_.dot(ground_point_ - ray.origin) / ground_normal_.dot(ray.direction);
  if (to_ground >= from && to_ground <= to) {
    hit = Hit{to_ground, 0, -1};
    if (kAny) return hit;
    to = to_ground;
  }
  const Inverse inverse{ray.origin, ray.direction.cwiseInverse()};
  std::array<int, 64> stack{};
  int size = 0;
  if (entry(nodes_[0], inverse, from, to) < kNever) stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    for (int i = node.first; i < node.first + node.count; ++i) {
      const double t = distance(shapes_[i], ray, from, to);
      if (t == kNever) continue;
      hit = Hit{t, shapes_[i].face, shapes_[i].ellipsoid};
      if (kAny) return hit;
      to = t;
    }
    if (node.count > 0) continue;
    const double left = entry(nodes_[node.first], inverse, from, to);
    const double right = entry(nodes_[node.first + 1], inverse, from, to);
    const int nearer = left <= right ? node.first : node.first + 1;
    if (std::max(left, right) < kNever) stack[size++] = 2 * node.first + 1 - nearer;
    if (std::min(left, right) < kNever) stack[size++] = nearer;
  }
  return hit;
}

std::optional<Hit> RayTracer::first_hit(const Ray& ray, double from, double to) const {
  return trace<false>(ray, from, to);
}

bool RayTracer::is_blocked(const Ray& ray, double from, double to) const {
  return trace<true>(ray, from, to).has_value();
}

}  // namespace ridgeline::other
