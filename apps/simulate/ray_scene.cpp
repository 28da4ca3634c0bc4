// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/ray_scene.h"

#include "reconstruct/geometry/transformed.h"

#include <Eigen/Geometry>
#include <embree3/rtcore.h>

#include <cstddef>
#include <limits>
#include <stdexcept>

namespace ridgeline::simulate {
namespace {

constexpr std::size_t kBytesPerCorner = 3 * sizeof(float);
constexpr std::size_t kBytesPerTriangle = 3 * sizeof(unsigned);

void fill_vertices(const Mesh& mesh, RTCGeometry geometry) {
  auto* out = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                          RTC_FORMAT_FLOAT3, kBytesPerCorner,
                                                          mesh.vertices.size()));
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) *out++ = static_cast<float>(vertex[axis]);
  }
}

void fill_triangles(const Mesh& mesh, RTCGeometry geometry) {
  auto* out = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                                             RTC_FORMAT_UINT3, kBytesPerTriangle,
                                                             mesh.triangles.size()));
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::int32_t vertex : triangle.vertices) *out++ = static_cast<unsigned>(vertex);
  }
}

/// Distance to the triangle's plane in double precision: Embree's own result is a float, accurate
/// to 0.1 mm at best.
double distance_to_plane(const Mesh& mesh,
                         const Triangle& triangle,
                         const Eigen::Vector3d& origin,
                         const Eigen::Vector3d& direction) {
  const auto corner = [&](std::size_t i) -> const Eigen::Vector3d& {
    return mesh.vertices[static_cast<std::size_t>(triangle.vertices[i])];
  };
  const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  return normal.dot(corner(0) - origin) / normal.dot(direction);
}

RTCRay embree_ray(const RayScene::Ray& ray, double max_distance_m) {
  RTCRay out{};
  out.org_x = static_cast<float>(ray.origin.x());
  out.org_y = static_cast<float>(ray.origin.y());
  out.org_z = static_cast<float>(ray.origin.z());
  out.dir_x = static_cast<float>(ray.direction.x());
  out.dir_y = static_cast<float>(ray.direction.y());
  out.dir_z = static_cast<float>(ray.direction.z());
  out.tnear = static_cast<float>(ray.min_distance_m);
  out.tfar = static_cast<float>(max_distance_m);
  out.mask = ~0U;
  return out;
}

RTCIntersectContext context_of(RTCIntersectContextFlags flags) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  return context;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

RTCRayHit embree_query(const RayScene::Ray& ray) {
  RTCRayHit query{};
  query.ray = embree_ray(ray, kInfinity);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return query;
}

bool was_hit(const RTCRay& ray) { return ray.tfar < 0.0F; }  // how rtcOccluded marks a hit

}  // namespace

struct RayScene::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Embree() = default;
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  Embree(Embree&&) = delete;
  Embree& operator=(Embree&&) = delete;
  ~Embree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RayScene::RayScene(const Mesh& mesh) : mesh_(&mesh), embree_(std::make_unique<Embree>()) {
  embree_->device = rtcNewDevice(nullptr);
  if (embree_->device == nullptr) throw std::runtime_error("Embree: no device");
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);  // without it rays leak through edges
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  fill_vertices(mesh, geometry);
  fill_triangles(mesh, geometry);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(embree_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(embree_->scene);
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

std::optional<RayScene::Hit> RayScene::hit_of(const Ray& ray,
                                              unsigned geometry,
                                              unsigned triangle) const {
  if (geometry == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Hit{.distance_m =
                 distance_to_plane(*mesh_, mesh_->triangles[triangle], ray.origin, ray.direction),
             .triangle = static_cast<int>(triangle)};
}

std::optional<RayScene::Hit> RayScene::first_hit(const Eigen::Vector3d& origin,
                                                 const Eigen::Vector3d& direction,
                                                 double min_distance_m) const {
  const Ray ray{origin, direction, min_distance_m};
  RTCRayHit query = embree_query(ray);
  RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  rtcIntersect1(embree_->scene, &context, &query);
  return hit_of(ray, query.hit.geomID, query.hit.primID);
}

bool RayScene::occluded(const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction,
                        double min_distance_m,
                        double max_distance_m) const {
  RTCRay ray = embree_ray({origin, direction, min_distance_m}, max_distance_m);
  RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  rtcOccluded1(embree_->scene, &context, &ray);
  return was_hit(ray);
}

std::vector<std::optional<RayScene::Hit>> RayScene::first_hits(std::span<const Ray> rays) const {
  std::vector<RTCRayHit> queries;
  queries.reserve(rays.size());
  for (const Ray& ray : rays) queries.push_back(embree_query(ray));
  RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  rtcIntersect1M(embree_->scene, &context, queries.data(), static_cast<unsigned>(queries.size()),
                 sizeof(RTCRayHit));
  std::vector<std::optional<Hit>> hits;
  hits.reserve(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits.push_back(hit_of(rays[i], queries[i].hit.geomID, queries[i].hit.primID));
  }
  return hits;
}

std::vector<char> RayScene::occluded(std::span<const Ray> rays) const {
  std::vector<RTCRay> queries;
  queries.reserve(rays.size());
  for (const Ray& ray : rays) queries.push_back(embree_ray(ray, kInfinity));
  RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  rtcOccluded1M(embree_->scene, &context, queries.data(), static_cast<unsigned>(queries.size()),
                sizeof(RTCRay));
  return transformed(queries,
                     [&](const RTCRay& query) { return static_cast<char>(was_hit(query)); });
}

}  // namespace ridgeline::simulate
