// SPDX-License-Identifier: BSD-3-Clause
// What the judge adds to PCL's plane segmentation: displaced true lines of simulated villages,
// whose distance to their planes is known. Prints the table of docs/pcl.md.
#include "evaluate/judge/footprint.h"
#include "evaluate/judge/line_to_plane_evaluation.h"
#include "evaluate/judge/segment_plane.h"
#include "tests/acceptance/simulated_survey.h"

#include <pcl/ModelCoefficients.h>
#include <pcl/console/print.h>
#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using simulate::LineKind;
using simulate::SceneLine;

// training villages, which the judge's thresholds were not chosen on (docs/calibration.md)
constexpr std::uint64_t kFirstSeed = 21, kLastSeed = 28;
constexpr double kDensityPerM2 = 5.0;
const std::array<Eigen::Vector3d, 2> kMoves_m{Eigen::Vector3d(0.2, -0.15, 0.4),
                                              Eigen::Vector3d(0.2, -0.15, 3.0)};

/// One line of a village, displaced.
struct MovedLine {
  const SceneLine* truth;
  Segment3 segment;
  std::vector<double>
      plane_distances_m;  ///< to each of its planes, as |distance| averaged along it
};

/// Distance of each line; none if refused.
using Distances = std::vector<std::optional<double>>;
using Method = std::function<Distances(const Cloud::Ptr&, const std::vector<MovedLine>&)>;

double height_beside(const Segment3& line, const Eigen::Vector2d& x) {
  const Segment2 p = plan(line);
  const Eigen::Vector2d way = p.end - p.start;
  return point_at(line, (x - p.start).dot(way) / way.squaredNorm()).z();
}

/// The points beside a line, as far above and below it as `height_m`.
pcl::IndicesPtr corridor(const Cloud& cloud, const Segment3& line, double height_m) {
  const evaluate::JudgeOptions options;
  const evaluate::Footprint footprint = evaluate::footprint_of(line);
  auto indices = std::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector2d x(cloud[i].x, cloud[i].y);
    const double s_m = footprint.s(x);
    if (std::abs(footprint.t(x)) <= options.corridor_half_width_m &&
        std::abs(cloud[i].z - height_beside(line, x)) <= height_m &&
        s_m >= -options.corridor_end_m && s_m <= footprint.length_m + options.corridor_end_m) {
      indices->push_back(static_cast<pcl::index_t>(i));
    }
  }
  return indices;
}

/// The largest plane of the corridor, as PCL's tutorials segment one.
std::optional<double> distance_by_segmentation(const Cloud::Ptr& cloud,
                                               const Segment3& line,
                                               double height_m) {
  const evaluate::JudgeOptions options;
  const pcl::IndicesPtr indices = corridor(*cloud, line, height_m);
  if (indices->size() < static_cast<std::size_t>(options.min_points)) return std::nullopt;
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setOptimizeCoefficients(true);
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_MSAC);
  segmentation.setDistanceThreshold(options.inlier_distance_m);
  segmentation.setMaxIterations(options.max_iterations);
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(indices);
  pcl::PointIndices inliers;
  pcl::ModelCoefficients model;
  segmentation.segment(inliers, model);
  if (inliers.indices.size() < static_cast<std::size_t>(options.min_points)) return std::nullopt;
  Eigen::Vector4d plane(model.values[0], model.values[1], model.values[2], model.values[3]);
  plane /= plane.head<3>().norm();
  return orthogonal_distance(line, Plane3(plane.head<3>(), plane.w())).mean_abs;
}

Distances by_segmentation(const Cloud::Ptr& cloud,
                          const std::vector<MovedLine>& lines,
                          double height_m) {
  Distances distances;
  for (const MovedLine& line : lines) {
    distances.push_back(distance_by_segmentation(cloud, line.segment, height_m));
  }
  return distances;
}

Distances by_judge(const Cloud::Ptr& cloud,
                   const std::vector<MovedLine>& lines,
                   const pcl::PointCloud<pcl::Normal>::Ptr& normals) {
  std::vector<evaluate::JudgedLine> judged(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    judged[i].id = std::to_string(i);
    judged[i].segment = lines[i].segment;
  }
  evaluate::LineToPlaneEvaluation<pcl::PointXYZ> evaluation;
  evaluation.setInputCloud(cloud);
  evaluation.setInputLines(std::move(judged));
  evaluation.setInputNormals(normals);
  Distances distances;
  for (const evaluate::LineEvaluation& line : evaluation.compute()) {
    distances.push_back(line.mean_distance_m);
  }
  return distances;
}

pcl::PointCloud<pcl::Normal>::Ptr estimated_normals(const Cloud::Ptr& cloud) {
  constexpr int kNeighbours = 12;
  auto normals = std::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setKSearch(kNeighbours);
  estimation.compute(*normals);
  return normals;
}

/// Errors of one method over the lines of one kind.
struct Tally {
  int n_lines = 0, n_wrong = 0;
  std::vector<double> errors_m;  ///< of the judged ones

  void add(const MovedLine& line, const std::optional<double>& distance_m) {
    constexpr double kWrong_m = 0.1;
    ++n_lines;
    if (!distance_m) return;
    // a ridge has two planes: their mean is right, and so is either of them
    const std::vector<double>& each = line.plane_distances_m;
    double mean_m = 0.0;
    double error_m = HUGE_VAL;
    for (const double d : each) {
      mean_m += d / static_cast<double>(each.size());
      error_m = std::min(error_m, std::abs(*distance_m - d));
    }
    error_m = std::min(error_m, std::abs(*distance_m - mean_m));
    errors_m.push_back(error_m);
    n_wrong += error_m > kWrong_m ? 1 : 0;
  }

  /// Refused, wrong and RMS error as cells of the table.
  void print() const {
    const auto n = static_cast<double>(errors_m.size());
    std::printf(" %.1f %% |", 100.0 * (n_lines - n) / n_lines);
    if (errors_m.empty()) {
      std::printf(" - | - |");
      return;
    }
    double squares = 0.0;
    for (const double e : errors_m) squares += e * e;
    std::printf(" %.1f %% | %.3f m |", 100.0 * n_wrong / n, std::sqrt(squares / n));
  }
};

/// A row group of the table.
struct Group {
  const char* name;
  std::function<bool(LineKind)> holds;
};

const std::vector<Group>& groups() {
  static const std::vector<Group> all{
      {"ridges, hips, valleys",
       [](LineKind k) {
         return k == LineKind::kRidge || k == LineKind::kHip || k == LineKind::kValley;
       }},
      {"eaves, verges", [](LineKind k) { return k == LineKind::kEave || k == LineKind::kVerge; }},
      {"streets, markings", [](LineKind k) { return k == LineKind::kGround; }}};
  return all;
}

std::vector<MovedLine> moved_lines(const test::SimulatedSurvey& survey,
                                   const Eigen::Vector3d& move_m) {
  std::vector<MovedLine> lines;
  for (std::size_t i = 0; i < survey.scene.lines.size(); ++i) {
    if (!test::has_lidar(survey.truth[i])) continue;
    const SceneLine& truth = survey.scene.lines[i];
    MovedLine line{&truth, {truth.segment.start + move_m, truth.segment.end + move_m}, {}};
    for (const int id : truth.plane_ids) {
      const Plane3& plane = survey.scene.planes[static_cast<std::size_t>(id)].plane;
      line.plane_distances_m.push_back(orthogonal_distance(line.segment, plane).mean_abs);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

struct NamedMethod {
  const char* name;
  Method distances;
};

std::vector<NamedMethod> methods() {
  constexpr double kNearLine_m = 1.5;
  return {{"`SACSegmentation`, all heights",
           [](const auto& cloud, const auto& lines) {
             return by_segmentation(cloud, lines, HUGE_VAL);
           }},
          {"`SACSegmentation`, 1.5 m of height",
           [](const auto& cloud, const auto& lines) {
             return by_segmentation(cloud, lines, kNearLine_m);
           }},
          {"judge",
           [](const auto& cloud, const auto& lines) { return by_judge(cloud, lines, nullptr); }},
          {"judge with normals", [](const auto& cloud, const auto& lines) {
             return by_judge(cloud, lines, estimated_normals(cloud));
           }}};
}

Cloud::Ptr cloud_of(const test::SimulatedSurvey& survey) {
  auto cloud = std::make_shared<Cloud>();
  for (const Eigen::Vector3d& x : survey.points) {
    const Eigen::Vector3f p = x.cast<float>();
    cloud->emplace_back(p.x(), p.y(), p.z());
  }
  return cloud;
}

/// By method and group.
using Tallies = std::vector<std::vector<Tally>>;

Tallies tallies_of(const std::vector<test::SimulatedSurvey>& surveys,
                   const Eigen::Vector3d& move_m) {
  const std::vector<NamedMethod> all = methods();
  Tallies tallies(all.size(), std::vector<Tally>(groups().size()));
  for (const test::SimulatedSurvey& survey : surveys) {
    const std::vector<MovedLine> lines = moved_lines(survey, move_m);
    const Cloud::Ptr cloud = cloud_of(survey);
    for (std::size_t m = 0; m < all.size(); ++m) {
      const Distances distances = all[m].distances(cloud, lines);
      for (std::size_t g = 0; g < groups().size(); ++g) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
          if (groups()[g].holds(lines[i].truth->kind)) tallies[m][g].add(lines[i], distances[i]);
        }
      }
    }
  }
  return tallies;
}

void print_table(const std::vector<test::SimulatedSurvey>& surveys) {
  std::vector<Tallies> of_move;
  of_move.reserve(kMoves_m.size());
  for (const Eigen::Vector3d& move_m : kMoves_m) of_move.push_back(tallies_of(surveys, move_m));
  std::printf("| lines | by |");
  for (const Eigen::Vector3d& move_m : kMoves_m) {
    std::printf(" %.1f m up: refused | wrong | RMS |", move_m.z());
  }
  std::puts("\n|---|---|---|---|---|---|---|---|");
  for (std::size_t g = 0; g < groups().size(); ++g) {
    for (std::size_t m = 0; m < methods().size(); ++m) {
      const std::string lines =
          m == 0 ? std::to_string(of_move[0][m][g].n_lines) + " " + groups()[g].name : "";
      std::printf("| %s | %s |", lines.c_str(), methods()[m].name);
      for (const Tallies& tallies : of_move) tallies[m][g].print();
      std::puts("");
    }
  }
}

}  // namespace
}  // namespace ridgeline

int main() {
  using namespace ridgeline;
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  std::vector<test::SimulatedSurvey> surveys;
  for (std::uint64_t seed = kFirstSeed; seed <= kLastSeed; ++seed) {
    surveys.push_back(test::simulated_survey(seed, kDensityPerM2));
  }
  print_table(surveys);
}
