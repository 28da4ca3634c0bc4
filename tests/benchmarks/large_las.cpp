// SPDX-License-Identifier: BSD-3-Clause
// Writes a large LAS and lines to judge against it, to measure time and memory of the program:
//   large_las FOLDER [MILLIONS_OF_POINTS [LINES]]
// gives FOLDER/town.las (30 bytes a point; 70 million points are 2.1 GB) and FOLDER/lines.csv:
// gabled houses in a square raster with 5 points/m2, and ridges and eaves of some spread over it.
#include "io/cloud/las_writer.h"
#include "tests/support/sampled_roof.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace ridgeline;

const LocalFrame kFrame{.origin_m = {513000.0, 5403000.0, 300.0}};
constexpr double kDensity_per_m2 = 5.0;
constexpr double kSigma_m = 0.034;
constexpr double kSpacing_m = 30.0;

/// Houses row by row; `place` is the start of a ridge.
struct Town {
  std::size_t columns, n_houses;

  [[nodiscard]] Eigen::Vector3d place(std::size_t house) const {
    return {kSpacing_m * static_cast<double>(house % columns),
            kSpacing_m * static_cast<double>(house / columns), 0.0};
  }
};

std::vector<io::CloudPoint> points_of(const Town& town) {
  const test::SampledRoof roof;
  const std::vector<Eigen::Vector3d> house = roof.sample(kDensity_per_m2, kSigma_m, 1);
  std::vector<io::CloudPoint> points;
  points.reserve(town.n_houses * house.size());
  for (std::size_t h = 0; h < town.n_houses; ++h) {
    const Eigen::Vector3d place = town.place(h);
    for (const Eigen::Vector3d& x : house) {
      points.push_back({.x = place.x() + x.x(),
                        .y = place.y() + x.y(),
                        .z = place.z() + x.z(),
                        .intensity = 100,
                        .classification = 6,
                        .return_number = 1,
                        .number_of_returns = 1,
                        .flags = 0,
                        .source_id = 1});
    }
  }
  return points;
}

/// A ridge and an eave of every k-th house.
void write_lines(const std::string& path, const Town& town, std::size_t n_lines) {
  const test::SampledRoof roof;
  std::ofstream file(path);
  file << "id,x1,y1,z1,x2,y2,z2\n" << std::fixed;
  const std::size_t step =
      std::max<std::size_t>(1, 2 * town.n_houses / std::max<std::size_t>(1, n_lines));
  const Eigen::Vector3d ridge(0.0, 0.0, roof.ridge_height_m());
  const Eigen::Vector3d eave(0.0, roof.half_width_m, roof.eave_height_m);
  for (std::size_t i = 0; i < n_lines && i / 2 * step < town.n_houses; ++i) {
    const Eigen::Vector3d start =
        kFrame.world_from_local(town.place(i / 2 * step) + (i % 2 == 0 ? ridge : eave));
    const Eigen::Vector3d end = start + Eigen::Vector3d(roof.length_m, 0.0, 0.0);
    file << i << ',' << start.x() << ',' << start.y() << ',' << start.z() << ',' << end.x() << ','
         << end.y() << ',' << end.z() << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: large_las FOLDER [MILLIONS_OF_POINTS [LINES]]\n", stderr);
    return 1;
  }
  const std::string folder = argv[1];
  const std::size_t n_points = 1'000'000 * (argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 70);
  const std::size_t n_lines = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1000;
  const std::size_t per_house = test::SampledRoof().sample(kDensity_per_m2, kSigma_m, 1).size();
  const std::size_t n_houses = std::max<std::size_t>(1, n_points / per_house);
  const Town town{static_cast<std::size_t>(std::ceil(std::sqrt(n_houses))), n_houses};
  io::write_las(folder + "/town.las", points_of(town), kFrame, {"EPSG:25832"});
  write_lines(folder + "/lines.csv", town, n_lines);
  return 0;
}
