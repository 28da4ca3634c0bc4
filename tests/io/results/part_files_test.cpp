// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/part_files.h"

#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::results {
namespace {

using evaluate::JudgedLine;
using evaluate::JudgedResult;
using evaluate::JudgingPlane;
using evaluate::LineEvaluation;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A NaN whose bits no arithmetic gives, with a sign.
const double kOddNan = std::bit_cast<double>(std::uint64_t{0xfff8000000001234});

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

JudgingPlane odd_plane() {
  JudgingPlane plane;
  plane.plane.coeffs() << 0.1, -0.2, 1.0 / 3.0, 1e300;
  plane.n_inliers = 41;
  plane.rms_m = kOddNan;
  plane.coverage = -0.0;
  plane.extrapolation_m = kInfinity;
  plane.sigma_m = -kInfinity;
  plane.sigma_random_m = std::numeric_limits<double>::denorm_min();
  plane.distance = {1.1, 2.2, 3.3, 4.4, 5.5, 6.6};
  plane.id = 0xffffffffffffffff;
  return plane;
}

LineEvaluation odd_evaluation() {
  LineEvaluation line;
  line.id = std::string("a\0b\xff", 4);
  line.line_class = "aligned";
  line.building = "7";
  line.status = evaluate::Status::kUnconfirmed;
  line.reason = "why";
  line.kind = evaluate::Kind::kRidge;
  line.flags = {"merged", ""};
  line.planes = {odd_plane(), JudgingPlane{}};
  line.length_m = 12.5;
  line.epipolar_angle_deg = 33.3;
  line.n_images = -3;
  line.class_base = "not_aligned";
  line.segment = Segment3{{1.0, 2.0, 3.0}, {4.0, 5.0, kOddNan}};
  line.mean_distance_m = 0.1;
  line.max_distance_m = 0.2;
  line.signed_mean_m = -0.3;
  line.sigma_plane_m = 0.4;
  line.sigma_line_m = 0.5;
  line.z = -0.6;
  line.intersection_distance_m = 0.7;
  line.intersection_angle_deg = 0.8;
  line.displacement = evaluate::RidgeDisplacement{0.9, -1.0, Eigen::Matrix2d{{1, 2}, {3, 4}}};
  line.height_if_vertical_m = 1.1;
  return line;
}

JudgedBatches odd_part() {
  JudgedResult result{odd_evaluation(),
                      {{1, 2}, {}},
                      {{10, 11, 12, 0xffffffffffffffff}, {12, 11, 0, 10, 12}},
                      {{{1.0, 2.0, kOddNan}}, {}},
                      {{{1.5, -0.0}, {kInfinity, 3.0}}, {}}};
  JudgedBatches part;
  part.results = {{result, JudgedResult{}}, {}, {result}};
  part.readings.n_batches = 3;
  part.readings.n_kept = 1ULL << 40U;
  part.readings.read_places = {0, 5};
  io::PointCloud& cloud = part.readings.cloud;
  cloud.frame.origin_m = {1.0, 2.0, 3.0};
  cloud.crs.definition = "EPSG:25832";
  cloud.warnings = {"a.las: one", "two"};
  cloud.horizontal_unit_m = 0.3048;
  cloud.vertical_unit_m = 0.5;
  cloud.n_read = 1;
  cloud.n_dropped_class = 2;
  cloud.n_dropped_withheld = 3;
  cloud.n_dropped_return = 4;
  cloud.n_dropped_bounds = 5;
  cloud.n_dropped_non_finite = 6;
  cloud.n_dropped_share = 7;
  return part;
}

LinesPart odd_lines() {
  JudgedLine line;
  line.id = "x";
  line.segment = {{kOddNan, kInfinity, -0.0}, {1.0, 2.0, 3.0}};
  line.line_class = "all";
  line.class_base = "b";
  line.building = "c";
  line.epipolar_angle_deg = 1.5;
  line.covariance_m2 = Eigen::Matrix<double, 6, 6>::Random();
  line.images = evaluate::ImageEvidence{{{{ProjectionMatrix::Random(), {{1, 2}, {3, 4}}},
                                          {ProjectionMatrix::Random(), {{5, 6}, {7, 8}}}}},
                                        {9.0, 10.0}};
  line.reconstructed = false;
  line.confirmed = false;
  line.n_images = 4;
  return {.frame = {{513000.0, 5403000.0, 200.0}},
          .plan_scale = {1.5, 1.25},
          .lines = {{line}, {}, {JudgedLine{}, line}}};
}

void expect_same(const JudgingPlane& actual, const JudgingPlane& expected) {
  EXPECT_EQ(actual.plane.coeffs(), expected.plane.coeffs());
  EXPECT_EQ(actual.n_inliers, expected.n_inliers);
  EXPECT_EQ(bits(actual.rms_m), bits(expected.rms_m));
  EXPECT_EQ(bits(actual.coverage), bits(expected.coverage));
  EXPECT_EQ(actual.extrapolation_m, expected.extrapolation_m);
  EXPECT_EQ(actual.sigma_m, expected.sigma_m);
  EXPECT_EQ(actual.sigma_random_m, expected.sigma_random_m);
  EXPECT_EQ(actual.distance.start, expected.distance.start);
  EXPECT_EQ(actual.distance.end, expected.distance.end);
  EXPECT_EQ(actual.distance.mean_abs, expected.distance.mean_abs);
  EXPECT_EQ(actual.distance.mean, expected.distance.mean);
  EXPECT_EQ(actual.distance.rms, expected.distance.rms);
  EXPECT_EQ(actual.distance.max_abs, expected.distance.max_abs);
  EXPECT_EQ(actual.id, expected.id);
}

void expect_same(const LineEvaluation& actual, const LineEvaluation& expected) {
  EXPECT_EQ(actual.id, expected.id);
  EXPECT_EQ(actual.line_class, expected.line_class);
  EXPECT_EQ(actual.building, expected.building);
  EXPECT_EQ(actual.status, expected.status);
  EXPECT_EQ(actual.reason, expected.reason);
  EXPECT_EQ(actual.kind, expected.kind);
  EXPECT_EQ(actual.flags, expected.flags);
  ASSERT_EQ(actual.planes.size(), expected.planes.size());
  expect_same(actual.planes[0], expected.planes[0]);
  EXPECT_EQ(actual.length_m, expected.length_m);
  EXPECT_EQ(actual.epipolar_angle_deg, expected.epipolar_angle_deg);
  EXPECT_EQ(actual.n_images, expected.n_images);
  EXPECT_EQ(actual.class_base, expected.class_base);
  EXPECT_EQ(actual.segment->start, expected.segment->start);
  EXPECT_EQ(bits(actual.segment->end.z()), bits(expected.segment->end.z()));
  EXPECT_EQ(actual.mean_distance_m, expected.mean_distance_m);
  EXPECT_EQ(actual.max_distance_m, expected.max_distance_m);
  EXPECT_EQ(actual.signed_mean_m, expected.signed_mean_m);
  EXPECT_EQ(actual.sigma_plane_m, expected.sigma_plane_m);
  EXPECT_EQ(actual.sigma_line_m, expected.sigma_line_m);
  EXPECT_EQ(actual.z, expected.z);
  EXPECT_EQ(actual.intersection_distance_m, expected.intersection_distance_m);
  EXPECT_EQ(actual.intersection_angle_deg, expected.intersection_angle_deg);
  EXPECT_EQ(actual.displacement->horizontal_m, expected.displacement->horizontal_m);
  EXPECT_EQ(actual.displacement->vertical_m, expected.displacement->vertical_m);
  EXPECT_EQ(actual.displacement->covariance_m2, expected.displacement->covariance_m2);
  EXPECT_EQ(actual.height_if_vertical_m, expected.height_if_vertical_m);
}

TEST(JudgedPart, ComesBackBitByBit) {
  const JudgedBatches part = odd_part();
  const JudgedBatches back = judged_part_of(to_bytes(part));
  ASSERT_EQ(back.results.size(), 3U);
  ASSERT_EQ(back.results[0].size(), 2U);
  EXPECT_TRUE(back.results[1].empty());
  const JudgedResult& expected = part.results[2][0];
  const JudgedResult& actual = back.results[2][0];
  EXPECT_EQ(actual.inliers, expected.inliers);
  EXPECT_EQ(actual.inlier_keys, expected.inlier_keys);
  EXPECT_EQ(bits(actual.inlier_points[0][0].z()), bits(kOddNan));
  EXPECT_EQ(actual.hulls, expected.hulls);
  EXPECT_EQ(bits(actual.hulls[0][0].y()), bits(-0.0));
  expect_same(actual.evaluation, expected.evaluation);
  EXPECT_EQ(back.readings.cloud.warnings, part.readings.cloud.warnings);
  const io::PointCloud& cloud = back.readings.cloud;
  EXPECT_EQ(cloud.frame.origin_m, part.readings.cloud.frame.origin_m);
  EXPECT_EQ(cloud.crs.definition, "EPSG:25832");
  EXPECT_EQ(cloud.horizontal_unit_m, 0.3048);
  EXPECT_EQ(cloud.vertical_unit_m, 0.5);
  EXPECT_THAT((std::array{cloud.n_read, cloud.n_dropped_class, cloud.n_dropped_withheld,
                          cloud.n_dropped_return, cloud.n_dropped_bounds,
                          cloud.n_dropped_non_finite, cloud.n_dropped_share}),
              testing::ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_EQ(back.readings.n_batches, 3U);
  EXPECT_EQ(back.readings.n_kept, 1ULL << 40U);
  EXPECT_EQ(back.readings.read_places, part.readings.read_places);
  EXPECT_EQ(to_bytes(back), to_bytes(part));
}

TEST(JudgedPart, KeepsFieldsWithoutAValueEmpty) {
  const JudgedBatches back = judged_part_of(to_bytes(odd_part()));
  const LineEvaluation& line = back.results[0][1].evaluation;
  EXPECT_FALSE(line.epipolar_angle_deg || line.n_images || line.segment || line.sigma_line_m ||
               line.z || line.displacement || line.height_if_vertical_m);
}

TEST(JudgedPart, TakesFewBytesForKeysThatPlanesShare) {
  constexpr std::size_t kKeys = 1000;
  JudgedBatches part;
  std::vector<std::uint64_t> keys(kKeys);
  for (std::size_t i = 0; i < kKeys; ++i) keys[i] = 0x9e3779b97f4a7c15 * (i + 1);
  part.results = {{JudgedResult{
      .evaluation = {}, .inliers = {}, .inlier_keys = {keys}, .inlier_points = {}, .hulls = {}}}};
  const std::size_t once = to_bytes(part).size();
  part.results[0][0].inlier_keys.push_back(keys);
  EXPECT_LT(to_bytes(part).size() - once, 1100U);
  EXPECT_EQ(judged_part_of(to_bytes(part)).results[0][0].inlier_keys[1], keys);
}

TEST(LinesPart, ComesBackBitByBit) {
  const LinesPart part = odd_lines();
  const LinesPart back = lines_part_of(to_bytes(part));
  EXPECT_EQ(to_bytes(back), to_bytes(part));
  EXPECT_EQ(back.frame.origin_m, part.frame.origin_m);
  EXPECT_EQ(back.plan_scale, part.plan_scale);
  ASSERT_EQ(back.lines[2].size(), 2U);
  const JudgedLine& line = back.lines[2][1];
  EXPECT_EQ(bits(line.segment.start.x()), bits(kOddNan));
  EXPECT_EQ(*line.covariance_m2, *part.lines[0][0].covariance_m2);
  EXPECT_EQ(line.images->base().image_from_local, part.lines[0][0].images->base().image_from_local);
  EXPECT_EQ(line.images->other().px.end, Eigen::Vector2d(7, 8));
  EXPECT_EQ(line.images->height_range_m[1], 10.0);
  EXPECT_EQ(line.id + line.line_class + line.class_base + line.building, "xallbc");
  EXPECT_EQ(line.epipolar_angle_deg, 1.5);
  EXPECT_EQ(line.n_images, 4);
  EXPECT_FALSE(line.reconstructed || line.confirmed);
  EXPECT_TRUE(back.lines[2][0].reconstructed && back.lines[2][0].confirmed);
}

TEST(JudgedPart, RefusesBytesThatEndEarlyOrLate) {
  const std::string bytes = to_bytes(odd_part());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    EXPECT_THROW(judged_part_of(bytes.substr(0, n)), std::invalid_argument) << n;
  }
  EXPECT_THROW(judged_part_of(bytes + "x"), std::invalid_argument);
}

TEST(ReadPart, GivesNothingUnlessTheFileIsWholeAndOfTheKey) {
  const io::TempFolder folder;
  const std::string path = folder.file("tasks/0001.judged");
  const JudgedBatches part = odd_part();
  EXPECT_FALSE(read_judged_part(path, "key"));
  write_part(path, "key", part);
  ASSERT_TRUE(read_judged_part(path, "key"));
  EXPECT_EQ(to_bytes(*read_judged_part(path, "key")), to_bytes(part));
  EXPECT_TRUE(is_part(path, "key"));
  EXPECT_FALSE(read_judged_part(path, "kez"));
  const std::string content = folder.read("tasks/0001.judged");
  for (const std::size_t n :
       {std::size_t{0}, std::size_t{10}, content.size() / 2, content.size() - 1}) {
    (void)folder.write("tasks/0001.judged", content.substr(0, n));
    EXPECT_FALSE(is_part(path, "key")) << n;
  }
  for (std::size_t i = 0; i < content.size(); i += 97) {
    std::string damaged = content;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    (void)folder.write("tasks/0001.judged", damaged);
    EXPECT_FALSE(read_judged_part(path, "key")) << i;
  }
}

}  // namespace
}  // namespace ridgeline::results
