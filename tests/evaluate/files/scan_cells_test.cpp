// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/scan_cells.h"

#include "evaluate/files/scan_lines.h"
#include "io/cloud/las_writer.h"
#include "reconstruct/geometry/transformed.h"
#include "tests/support/cut_cloud.h"
#include "tests/support/made_points.h"
#include "tests/support/random.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <algorithm>

namespace ridgeline::results {
namespace {

using test::Random;

/// A few houses around a corner of four cells of the map, and a hall over a cell and its
/// neighbours.
std::vector<Eigen::Vector3d> town() {
  std::vector<test::MadeBuilding> houses;
  const auto build = [&](double x, double y, double length_m, double width_m, double azimuth_deg) {
    houses.push_back(test::make_building({.shape = test::RoofShape::kGable,
                                          .length_m = length_m,
                                          .width_m = width_m,
                                          .azimuth_deg = azimuth_deg,
                                          .position = {x, y, 0.0}}));
  };
  for (const double x : {-45.0, -21.0, 2.0, 31.0}) {
    for (const double y : {-21.0, 3.0, 27.0}) build(x, y, 14.0, 10.0, 20.0);
  }
  build(5.0, -60.0, 150.0, 20.0, 0.0);
  return test::scan(houses, {.points_per_m2 = 4.0});
}

constexpr double kScale_m = 0.001;
const LocalFrame kFrame{{513000.0, 5403000.0, 200.0}};

class EdgesOfCloudFiles : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    points_ = transformed(town(), [](const Eigen::Vector3d& x) {
      return io::single_return((x / kScale_m).array().round() * kScale_m);
    });
  }

  [[nodiscard]] std::string write(const std::string& name,
                                  const std::vector<io::CloudPoint>& points) const {
    io::write_las(folder_.file(name), points, kFrame, {"EPSG:25832"});
    return folder_.file(name);
  }

  /// The lines and planes as text, in coordinates of the map.
  [[nodiscard]] static std::string found_in(const std::vector<std::string>& paths,
                                            std::uint64_t max_memory_bytes = 1U << 30U,
                                            const std::optional<Eigen::AlignedBox2d>& area = {},
                                            const io::ReadOptions& options = {}) {
    io::CloudFiles cloud(paths, options);
    const EdgesOfCloud found = edges_of_cloud(cloud, area, max_memory_bytes);
    n_batches_ = found.readings.n_batches;
    std::string text;
    for (const io::Line& line : lines_of_scan(found.edges, cloud).lines) {
      text += fmt::format("{} {} {} {} {}\n", line.id, line.kind, fmt::join(line.plane_ids, ","),
                          text_of(line.segment_in_world.start), text_of(line.segment_in_world.end));
    }
    for (const evaluate::ScanPlane& plane : found.edges.planes) {
      text += fmt::format("{} {}", plane.fit.n, plane.area_m2);
      for (const auto& ring : plane.rings) {
        for (const Eigen::Vector3d& x : ring) text += text_of(cloud.frame().world_from_local(x));
      }
      text += "\n";
    }
    return text;
  }

  static std::string text_of(const Eigen::Vector3d& x) {
    return fmt::format(" {} {} {}", x.x(), x.y(), x.z());
  }

  [[nodiscard]] std::vector<std::string> tiles_of(const std::string& file, double tile_m) const {
    const std::string folder = folder_.file(fmt::format("tiles{}", tile_m));
    test::cut_cloud(file, folder, tile_m);
    return {folder + "/*.las"};
  }

  static inline std::vector<io::CloudPoint> points_;
  static inline std::size_t n_batches_ = 0;
  io::TempFolder folder_;
};

TEST_F(EdgesOfCloudFiles, AreTheSameForTilesOfAnySize) {
  const std::string file = write("whole.las", points_);
  const std::string whole = found_in({file});
  EXPECT_GT(std::ranges::count(whole, '\n'), 20);
  EXPECT_EQ(found_in(tiles_of(file, 50.0)), whole);
  EXPECT_EQ(found_in(tiles_of(file, 200.0)), whole);
}

TEST_F(EdgesOfCloudFiles, AreTheSameForAnyOrderAndRepeatedPoints) {
  const std::string whole = found_in({write("whole.las", points_)});
  std::vector<io::CloudPoint> shuffled = points_;
  Random random(3);
  for (std::size_t i = shuffled.size(); i > 1; --i) {
    std::swap(shuffled[i - 1], shuffled[random.bits() % i]);
  }
  shuffled.insert(shuffled.end(), points_.begin(), points_.begin() + 1000);
  EXPECT_EQ(found_in({write("shuffled.las", shuffled)}), whole);
}

TEST_F(EdgesOfCloudFiles, AreTheSameForAnyMemoryNumberOfThreadsAndFrame) {
  const std::string file = write("whole.las", points_);
  const std::string whole = found_in({file});
  EXPECT_EQ(n_batches_, 1U);
  EXPECT_EQ(found_in({file}, 1U << 20U), whole);
  EXPECT_GT(n_batches_, 1U);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  io::ReadOptions options;
  options.frame = LocalFrame{{512345.0, 5402345.0, 17.0}};
  EXPECT_EQ(found_in({file}, 1U << 30U, {}, options), whole);
}

TEST_F(EdgesOfCloudFiles, OfAreasAreTogetherThoseOfTheWhole) {
  const std::string file = write("whole.las", points_);
  const auto segments = [&](const std::optional<Eigen::AlignedBox2d>& area) {
    io::CloudFiles cloud({file}, {});
    std::vector<std::string> texts;
    for (const io::Line& line :
         lines_of_scan(edges_of_cloud(cloud, area, 1U << 30U).edges, cloud).lines) {
      texts.push_back(text_of(line.segment_in_world.start) + text_of(line.segment_in_world.end));
    }
    return texts;
  };
  std::vector<std::string> parts;
  for (const auto& [low, high] : {std::pair{512000.0, 513003.0}, {513003.0, 514000.0}}) {
    const auto part = segments(
        Eigen::AlignedBox2d(Eigen::Vector2d(low, 5402000.0), Eigen::Vector2d(high, 5404000.0)));
    EXPECT_FALSE(part.empty());
    parts.insert(parts.end(), part.begin(), part.end());
  }
  std::vector<std::string> whole = segments({});
  std::ranges::sort(parts);
  std::ranges::sort(whole);
  EXPECT_EQ(parts, whole);
}

TEST_F(EdgesOfCloudFiles, ReportProgressUpToTheNumberOfCells) {
  io::CloudFiles cloud({write("whole.las", points_)}, {});
  std::size_t last = 0;
  std::size_t total = 0;
  (void)edges_of_cloud(cloud, {}, 1U << 30U, [&](std::size_t n_done, std::size_t n_total) {
    EXPECT_EQ(n_done, last + 1);
    last = n_done;
    total = n_total;
  });
  EXPECT_EQ(last, total);
  EXPECT_EQ(total, 4U);
}

TEST_F(EdgesOfCloudFiles, NeedPoints) {
  io::ReadOptions nowhere;
  nowhere.bounds_in_file = io::plan_bounds(std::vector<double>{0.0, 0.0, 1.0, 1.0});
  io::CloudFiles cloud({write("whole.las", points_)}, nowhere);
  const EdgesOfCloud found = edges_of_cloud(cloud, {}, 1U << 30U);
  EXPECT_THAT(io::io_error_of([&] { require_points(found.readings, cloud); }),
              testing::HasSubstr("no point lies within `bounds`"));
}

}  // namespace
}  // namespace ridgeline::results
