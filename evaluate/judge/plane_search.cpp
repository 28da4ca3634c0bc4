// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_search.h"

#include "evaluate/judge/quiet_pcl.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/splitmix64.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/msac.h>
#include <pcl/sample_consensus/prosac.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_normal_plane.h>
#include <pcl/sample_consensus/sac_model_plane.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace ridgeline::evaluate {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Model = pcl::SampleConsensusModel<pcl::PointXYZ>;
using PlaneModel = pcl::SampleConsensusModelPlane<pcl::PointXYZ>;
using NormalPlaneModel = pcl::SampleConsensusModelNormalPlane<pcl::PointXYZ, pcl::Normal>;

/// Puts the points into an order that is unrelated to their positions but reproducible: otherwise
/// samples of neighbouring points would be similar.
void scatter(std::vector<ZonePoint>& points) {
  SplitMix64 random(1);
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[random.next() % i]);
  }
}

/// Sorts the points for PROSAC, which tries the first ones first: those nearest to the line are the
/// most likely to be relevant.
void sort_by_distance(std::vector<ZonePoint>& points) {
  std::sort(points.begin(), points.end(), [](const ZonePoint& a, const ZonePoint& b) {
    return std::pair(std::abs(a.t), a.rank) < std::pair(std::abs(b.t), b.rank);
  });
}

/// The points as floats relative to an integer centre, in steps of 2^-14 m (0.06 mm). They are
/// small enough to be exact in float, and have the same bits wherever the scene lies in its map
/// frame.
Cloud::Ptr recentred_cloud(const std::vector<ZonePoint>& points, const Eigen::Vector3d& centre) {
  constexpr double kSteps = 16384.0;
  auto cloud = std::make_shared<Cloud>();
  cloud->reserve(points.size());
  for (const ZonePoint& point : points) {
    const Eigen::Vector3d x = ((point.x - centre) * kSteps).array().round() / kSteps;
    cloud->emplace_back(static_cast<float>(x.x()), static_cast<float>(x.y()),
                        static_cast<float>(x.z()));
  }
  return cloud;
}

pcl::PointCloud<pcl::Normal>::Ptr normals_at(const std::vector<ZonePoint>& points,
                                             const PointNormals& normals) {
  auto cloud = std::make_shared<pcl::PointCloud<pcl::Normal>>();
  cloud->reserve(points.size());
  for (const ZonePoint& point : points) {
    const PointNormals::Normal& n = normals.of_point[point.index];
    cloud->emplace_back(n.x, n.y, n.z, n.curvature);
  }
  return cloud;
}

Model::Ptr plane_model(const std::vector<ZonePoint>& points,
                       const Eigen::Vector3d& centre,
                       const PointNormals& normals) {
  const Cloud::Ptr cloud = recentred_cloud(points, centre);
  if (normals.of_point.empty()) return std::make_shared<PlaneModel>(cloud);
  auto model = std::make_shared<NormalPlaneModel>(cloud);
  model->setInputNormals(normals_at(points, normals));
  model->setNormalDistanceWeight(normals.weight);
  return model;
}

std::unique_ptr<pcl::SampleConsensus<pcl::PointXYZ>> sample_consensus(SampleConsensus method,
                                                                      const Model::Ptr& model,
                                                                      double threshold_m) {
  switch (method) {
    case SampleConsensus::kRansac:
      return std::make_unique<pcl::RandomSampleConsensus<pcl::PointXYZ>>(model, threshold_m);
    case SampleConsensus::kProsac:
      return std::make_unique<pcl::ProgressiveSampleConsensus<pcl::PointXYZ>>(model, threshold_m);
    case SampleConsensus::kMsac:
      break;
  }
  return std::make_unique<pcl::MEstimatorSampleConsensus<pcl::PointXYZ>>(model, threshold_m);
}

/// The plane found by PCL, in the local frame.
std::optional<Plane3> consensus_plane(const std::vector<ZonePoint>& points,
                                      const JudgeOptions& options,
                                      const PointNormals& normals) {
  constexpr double kSure = 0.9999;  // probability that a sample of the best plane was drawn
  std::vector<ZonePoint> order = points;
  if (options.method == SampleConsensus::kProsac) {
    sort_by_distance(order);
  } else {
    scatter(order);
  }
  const Eigen::Vector3d centre = points.front().x.array().round();
  const Model::Ptr model = plane_model(order, centre, normals);
  const auto consensus = sample_consensus(options.method, model, options.inlier_distance_m);
  consensus->setMaxIterations(options.max_iterations);
  consensus->setProbability(kSure);
  if (!consensus->computeModel(0)) return std::nullopt;
  Eigen::VectorXf coefficients;
  consensus->getModelCoefficients(coefficients);
  if (coefficients.size() != 4 || !coefficients.allFinite()) return std::nullopt;
  const Eigen::Vector3d normal = coefficients.head<3>().cast<double>();
  const double scale = normal.norm();
  if (!(scale > 0.0)) return std::nullopt;
  const Eigen::Vector3d unit = normal / scale;
  return Plane3(unit, static_cast<double>(coefficients(3)) / scale - unit.dot(centre));
}

std::vector<Eigen::Vector3d> supporters(const std::vector<ZonePoint>& points,
                                        const Plane3& plane,
                                        double distance_m) {
  std::vector<Eigen::Vector3d> near;
  for (const ZonePoint& point : points) {
    if (plane.absDistance(point.x) <= distance_m) near.push_back(point.x);
  }
  return near;
}

/// Total least squares over the points that support the plane, repeated until these stay the same.
std::optional<PlaneFit> settled_fit(const std::vector<ZonePoint>& points,
                                    const Plane3& start,
                                    const JudgeOptions& options) {
  constexpr int kMaxPasses = 30;  // a few are enough; more only if two sets alternate
  std::optional<PlaneFit> fit;
  Plane3 plane = start;
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    fit = fit_plane(supporters(points, plane, options.inlier_distance_m));
    if (!fit || fit->n < options.min_points) return std::nullopt;
    if (fit->plane.coeffs() == plane.coeffs()) break;
    plane = fit->plane;
  }
  return fit;
}

}  // namespace

std::vector<FoundPlane> search_planes(std::span<const ZonePoint> side,
                                      const JudgeOptions& options,
                                      const PointNormals& normals) {
  const QuietPcl quiet;
  constexpr std::size_t kMaxPlanes = 6;  // two roofs, a dormer, ground and two walls
  const double steepest_rad = options.max_slope_deg * kRadPerDeg;
  std::vector<ZonePoint> rest(side.begin(), side.end());
  std::vector<FoundPlane> planes;
  for (std::size_t trial = 0; trial < kMaxPlanes; ++trial) {
    if (rest.size() < static_cast<std::size_t>(options.min_points)) break;
    const std::optional<Plane3> start = consensus_plane(rest, options, normals);
    if (!start) break;
    const std::optional<PlaneFit> fit = settled_fit(rest, *start, options);
    if (!fit) break;
    const auto others = std::stable_partition(rest.begin(), rest.end(), [&](const ZonePoint& p) {
      return fit->plane.absDistance(p.x) <= options.inlier_distance_m;
    });
    if (slope_rad(fit->plane) <= steepest_rad) {
      planes.push_back({*fit, std::vector<ZonePoint>(rest.begin(), others)});
    }
    if (others == rest.begin()) break;
    rest.erase(rest.begin(), others);
  }
  return planes;
}

}  // namespace ridgeline::evaluate
