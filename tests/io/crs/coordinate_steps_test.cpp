// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/coordinate_steps.h"

#include "io/cloud/read_cloud.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ridgeline::io {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Points of a sloping roof in UTM.
std::vector<Eigen::Vector3d> roof_points(int n) {
  std::mt19937_64 engine(7);
  const auto share = [&] { return static_cast<double>(engine() >> 11U) * 0x1p-53; };
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < n; ++i) {
    const double x = 513000.0 + 12.0 * share();
    const double y = 5403000.0 + 8.0 * share();
    points.emplace_back(x, y, 250.0 + 0.7 * (y - 5403000.0) + 0.03 * share());
  }
  return points;
}

template <typename Rounding>
Eigen::Vector3d steps_of_rounded(const Rounding& rounded, int n = 300) {
  CoordinateSteps steps;
  for (const Eigen::Vector3d& x : roof_points(n)) steps.add(x.unaryExpr(rounded));
  return steps.steps_m();
}

double to(double value, double step) { return std::round(value / step) * step; }

TEST(CoordinateSteps, FindsThoseOfFloat32AlsoBehindThreePrintedDecimals) {
  const auto as_float = [](double v) { return static_cast<double>(static_cast<float>(v)); };
  EXPECT_EQ(steps_of_rounded(as_float), Eigen::Vector3d(0.03125, 0.5, 0.0));
  EXPECT_EQ(steps_of_rounded([&](double v) { return to(as_float(v), 0.001); }),
            Eigen::Vector3d(0.03125, 0.5, 0.0));
  EXPECT_EQ(steps_of_rounded(as_float, 14), Eigen::Vector3d(0.03125, 0.5, 0.0)) << "seven lines";
}

TEST(CoordinateSteps, FindsThoseOfTooFewDecimals) {
  for (const double step : {0.05, 0.1, 0.5, 1.0}) {
    EXPECT_EQ(steps_of_rounded([&](double v) { return to(v, step); }),
              Eigen::Vector3d::Constant(step))
        << step;
  }
  EXPECT_EQ(steps_of_rounded([](double v) { return v < 1e3 ? v : to(v, 10.0); }, 14),
            Eigen::Vector3d(10.0, 10.0, 0.0));
}

TEST(CoordinateSteps, LeavesFineGridsAndFewValuesAlone) {
  for (const double step : {0.001, 0.01, 0.02}) {
    EXPECT_TRUE(steps_of_rounded([&](double v) { return to(v, step); }, 14).isZero()) << step;
  }
  CoordinateSteps flat;
  for (const double x : {1.234, 7.771, 13.908}) flat.add({x, 2.0 * x, 255.0});
  EXPECT_TRUE(flat.steps_m().isZero()) << "eaves of one height";
  flat.add({2.191, 5.77, 258.0});
  EXPECT_TRUE(flat.steps_m().isZero()) << "and a ridge of another";
}

TEST(CoordinateSteps, AreTheSameHoweverTheValuesAreDivided) {
  const std::vector<Eigen::Vector3d> points = roof_points(100);
  CoordinateSteps whole, first, second;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d x = points[i].unaryExpr([](double v) { return to(v, 0.5); });
    whole.add(x);
    (i < 7 ? first : second).add(x);
  }
  first.merge(second);
  EXPECT_EQ(first.steps_m(), whole.steps_m());
}

std::vector<std::string> warnings_of(const std::string& text) {
  const TempFolder folder;
  return read_cloud({folder.write("cloud.xyz", text)}).warnings;
}

TEST(CloudSteps, AreWarnedOfAndRefusedIfStrict) {
  std::string text;
  for (const Eigen::Vector3d& x : roof_points(300)) {
    text += fmt::format("{:.3f} {:.3f} {:.3f}\n", static_cast<float>(x.x()),
                        static_cast<float>(x.y()), x.z());
  }
  EXPECT_THAT(warnings_of(text),
              Contains(AllOf(HasSubstr("cloud.xyz: coordinates have y in steps of 0.5 m"),
                             HasSubstr("x in steps of 0.0312 m"))));
  const TempFolder folder;
  ReadOptions options;
  options.strict = true;
  EXPECT_THAT(io_error_of([&] { read_cloud({folder.write("cloud.xyz", text)}, options); }),
              HasSubstr("y in steps of 0.5 m"));
}

TEST(CloudSteps, OfARasterInPlanAreRight) {
  std::string raster, scattered;
  for (int i = 0; i < 900; ++i) {
    const int column = i % 30, row = i / 30;
    raster +=
        fmt::format("{}.5 {}.5 {:.3f}\n", 513000 + column, 5403000 + row, 250.0 + 0.01234 * i);
    // the same points, except that a few have the plan position of others
    scattered += fmt::format("{}.5 {}.5 {:.3f}\n", 513000 + std::max(column, 2), 5403000 + row,
                             250.0 + 0.01234 * i);
  }
  EXPECT_THAT(warnings_of(raster), Not(Contains(HasSubstr("in steps of"))));
  EXPECT_THAT(warnings_of(scattered), Contains(HasSubstr("in steps of")));
}

}  // namespace
}  // namespace ridgeline::io
