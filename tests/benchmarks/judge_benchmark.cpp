// SPDX-License-Identifier: BSD-3-Clause
// Time of judging a line against the size of the cloud, and of the grid against PCL's searches.
#include "evaluate/judge/judge_lines.h"
#include "evaluate/judge/pcl_point_search.h"
#include "tests/support/random.h"
#include "tests/support/sampled_roof.h"

#include <benchmark/benchmark.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kDensity_per_m2 = 5.0;
constexpr double kSigma_m = 0.034;

/// Gabled houses in a square raster with about the given number of points, and the lines of the
/// first ones.
struct Town {
  std::vector<Eigen::Vector3d> points;
  std::vector<JudgedLine> lines;
};

Town make_town(std::size_t n_points) {
  constexpr std::size_t kMaxLines = 200;
  const test::SampledRoof roof;
  const std::vector<Eigen::Vector3d> house = roof.sample(kDensity_per_m2, kSigma_m, 1);
  const Eigen::Vector3d ridge(roof.length_m, 0.0, 0.0);
  const std::size_t n_houses = std::max<std::size_t>(1, n_points / house.size());
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(n_houses)));
  Town town;
  town.points.reserve(n_houses * house.size());
  for (std::size_t h = 0; h < n_houses; ++h) {
    const Eigen::Vector3d place(30.0 * static_cast<double>(h % columns),
                                30.0 * static_cast<double>(h / columns), 0.0);
    for (const Eigen::Vector3d& x : house) town.points.emplace_back(x + place);
    if (town.lines.size() >= kMaxLines) continue;
    for (const Eigen::Vector3d& start :
         {Eigen::Vector3d(0.0, 0.0, roof.ridge_height_m()),
          Eigen::Vector3d(0.0, roof.half_width_m, roof.eave_height_m)}) {
      JudgedLine line;
      line.id = std::to_string(town.lines.size());
      line.segment = {place + start, place + start + ridge};
      town.lines.push_back(line);
    }
  }
  return town;
}

PointGrid grid_of(const std::vector<Eigen::Vector3d>& points) {
  return PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
}

void judge_line_in_cloud_of(benchmark::State& state) {
  const Town town = make_town(static_cast<std::size_t>(state.range(0)));
  const PointGrid grid = grid_of(town.points);
  for (auto _ : state) {
    for (const JudgedLine& line : town.lines) {
      benchmark::DoNotOptimize(judge_line(grid, line, {}));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(town.lines.size()));
  state.counters["points"] = static_cast<double>(town.points.size());
}
BENCHMARK(judge_line_in_cloud_of)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Arg(10'000'000)
    ->Unit(benchmark::kMillisecond);

pcl::PointCloud<pcl::PointXYZ>::Ptr plan_cloud(const std::vector<Eigen::Vector3d>& points) {
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3d& x : points) {
    cloud->emplace_back(static_cast<float>(x.x()), static_cast<float>(x.y()), 0.0F);
  }
  return cloud;
}

void build_grid(benchmark::State& state) {
  const Town town = make_town(1'000'000);
  for (auto _ : state) benchmark::DoNotOptimize(grid_of(town.points));
}
BENCHMARK(build_grid)->Unit(benchmark::kMillisecond);

void build_pcl_kdtree(benchmark::State& state) {
  const auto cloud = plan_cloud(make_town(1'000'000).points);
  for (auto _ : state) {
    pcl::KdTreeFLANN<pcl::PointXYZ> tree;
    tree.setInputCloud(cloud);
    benchmark::DoNotOptimize(tree.getEpsilon());
  }
}
BENCHMARK(build_pcl_kdtree)->Unit(benchmark::kMillisecond);

constexpr int kQueries = 10'000;
constexpr double kRadius_m = 1.0;

Eigen::Vector2d next_place(test::Random& random, const Town& town) {
  return town.points[random.bits() % town.points.size()].head<2>();
}

void query_grid(benchmark::State& state) {
  const Town town = make_town(1'000'000);
  const PointGrid grid = grid_of(town.points);
  for (auto _ : state) {
    test::Random random(7);
    for (int i = 0; i < kQueries; ++i) {
      benchmark::DoNotOptimize(grid.count_within(next_place(random, town), kRadius_m));
    }
  }
}
BENCHMARK(query_grid)->Unit(benchmark::kMillisecond);

void query_pcl_kdtree(benchmark::State& state) {
  const Town town = make_town(1'000'000);
  pcl::KdTreeFLANN<pcl::PointXYZ> tree(false);
  tree.setInputCloud(plan_cloud(town.points));
  pcl::Indices indices;
  std::vector<float> squared;
  for (auto _ : state) {
    test::Random random(7);
    for (int i = 0; i < kQueries; ++i) {
      const Eigen::Vector2d x = next_place(random, town);
      const pcl::PointXYZ place(static_cast<float>(x.x()), static_cast<float>(x.y()), 0.0F);
      benchmark::DoNotOptimize(tree.radiusSearch(place, kRadius_m, indices, squared));
    }
  }
}
BENCHMARK(query_pcl_kdtree)->Unit(benchmark::kMillisecond);

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr cloud_of(const Town& town) {
  auto cloud = std::make_shared<Cloud>();
  for (const Eigen::Vector3d& x : town.points) {
    const Eigen::Vector3f p = x.cast<float>();
    cloud->emplace_back(p.x(), p.y(), p.z());
  }
  return cloud;
}

std::unique_ptr<PointSearch> own_grid(const Cloud::Ptr& cloud) {
  return std::make_unique<PointGrid>(PointGrid::build(cloud->size(), [&](std::size_t i) {
    return Eigen::Vector3d((*cloud)[i].getVector3fMap().cast<double>());
  }));
}

std::unique_ptr<PointSearch> by_pcl(const pcl::search::Search<pcl::PointXYZ>::Ptr& search,
                                    const Cloud::Ptr& cloud) {
  auto indices = std::make_shared<pcl::Indices>(cloud->size());
  std::iota(indices->begin(), indices->end(), 0);
  return std::make_unique<PclPointSearch<pcl::PointXYZ>>(search, cloud, indices);
}

std::unique_ptr<PointSearch> pcl_kdtree(const Cloud::Ptr& cloud) {
  constexpr bool kSorted = false;
  return by_pcl(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(kSorted), cloud);
}

std::unique_ptr<PointSearch> pcl_octree(const Cloud::Ptr& cloud) {
  constexpr double kResolution_m = 2.0;
  return by_pcl(std::make_shared<pcl::search::Octree<pcl::PointXYZ>>(kResolution_m), cloud);
}

using MakeSearch = std::unique_ptr<PointSearch> (*)(const Cloud::Ptr&);

void build_search(benchmark::State& state, MakeSearch make) {
  const Cloud::Ptr cloud = cloud_of(make_town(static_cast<std::size_t>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(make(cloud));
}

void judge_by_search(benchmark::State& state, MakeSearch make) {
  const Town town = make_town(static_cast<std::size_t>(state.range(0)));
  const std::unique_ptr<PointSearch> search = make(cloud_of(town));
  for (auto _ : state) {
    for (const JudgedLine& line : town.lines) {
      benchmark::DoNotOptimize(judge_line(*search, line, {}));
    }
  }
  state.counters["lines"] = static_cast<double>(town.lines.size());
}

void two_sizes(benchmark::internal::Benchmark* b) {
  b->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(build_search, grid, own_grid)->Apply(two_sizes);
BENCHMARK_CAPTURE(build_search, kdtree, pcl_kdtree)->Apply(two_sizes);
BENCHMARK_CAPTURE(build_search, octree, pcl_octree)->Apply(two_sizes);
BENCHMARK_CAPTURE(judge_by_search, grid, own_grid)->Apply(two_sizes);
BENCHMARK_CAPTURE(judge_by_search, kdtree, pcl_kdtree)->Apply(two_sizes);
BENCHMARK_CAPTURE(judge_by_search, octree, pcl_octree)->Apply(two_sizes);

}  // namespace
}  // namespace ridgeline::evaluate

BENCHMARK_MAIN();
