// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/ray_scene.h"

#include <Eigen/Geometry>
#include <embree3/rtcore.h>

#include <cmath>
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

/// Distance to the triangle's plane in double: Embree's own is float, good to 0.1 mm at best.
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

RTCRay ray_of(const Eigen::Vector3d& origin,
              const Eigen::Vector3d& direction,
              double min_distance_m,
              double max_distance_m) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin.x());
  ray.org_y = static_cast<float>(origin.y());
  ray.org_z = static_cast<float>(origin.z());
  ray.dir_x = static_cast<float>(direction.x());
  ray.dir_y = static_cast<float>(direction.y());
  ray.dir_z = static_cast<float>(direction.z());
  ray.tnear = static_cast<float>(min_distance_m);
  ray.tfar = static_cast<float>(max_distance_m);
  ray.mask = ~0U;
  return ray;
}

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

std::optional<RayScene::Hit> RayScene::first_hit(const Eigen::Vector3d& origin,
                                                 const Eigen::Vector3d& direction,
                                                 double min_distance_m) const {
  RTCRayHit query{};
  query.ray = ray_of(origin, direction, min_distance_m, std::numeric_limits<double>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Triangle& triangle = mesh_->triangles[query.hit.primID];
  return Hit{.distance_m = distance_to_plane(*mesh_, triangle, origin, direction),
             .triangle = static_cast<int>(query.hit.primID)};
}

bool RayScene::occluded(const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction,
                        double min_distance_m,
                        double max_distance_m) const {
  RTCRay ray = ray_of(origin, direction, min_distance_m, max_distance_m);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar < 0.0F;  // Embree's sign of a hit
}

}  // namespace ridgeline::simulate
