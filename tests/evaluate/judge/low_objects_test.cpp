// SPDX-License-Identifier: BSD-3-Clause
// The edge of a car's roof, 1.4 m above the street, with the bonnet 0.3 m below it.
#include "evaluate/judge/low_objects.h"

#include "evaluate/judge/image_evidence.h"
#include "tests/evaluate/judge/nadir_pair.h"

#include <gmock/gmock.h>

namespace ridgeline::evaluate {
namespace {

constexpr double kSpacing_m = 0.45;
constexpr double kRoof_m = 1.4;
constexpr double kBonnet_m = 1.1;
constexpr double kObjectLength_m = 2.0;

/// A level surface on both sides of the line, which runs along s.
CandidatePlane level(double z, double half_width_m) {
  CandidatePlane plane;
  std::vector<Eigen::Vector3d> x;
  for (double s = 0.0; s < kObjectLength_m; s += kSpacing_m) {
    for (double t = -half_width_m; t <= half_width_m; t += kSpacing_m) {
      plane.inliers.push_back({{-t, s, z}, s, t, 0});
      x.emplace_back(-t, s, z);
    }
  }
  plane.fit = fit_plane(x).value();
  return plane;
}

ImageEvidence seen_at(double z) { return test::seen({{0, 0, z}, {0, kObjectLength_m, z}}); }

std::vector<CandidatePlane> street_roof_and_bonnet() {
  return {level(0.0, 4.0), level(kRoof_m, 0.9), level(kBonnet_m, 0.9)};
}

TEST(MarkLowObjects, TakesACarForNoJudgeWithoutImages) {
  std::vector<CandidatePlane> planes = street_roof_and_bonnet();
  mark_low_objects(planes, kSpacing_m, std::nullopt, {});
  EXPECT_FALSE(planes[0].low_object);
  EXPECT_TRUE(planes[1].low_object);
  EXPECT_TRUE(planes[2].low_object);
}

TEST(MarkLowObjects, KeepsTheRoofOfACarThatTheImagesShowAboveTheStreetThoughNotAboveTheBonnet) {
  std::vector<CandidatePlane> planes = street_roof_and_bonnet();
  const ImageEvidence images = seen_at(kRoof_m);
  ASSERT_LT(image_cost(images, planes[2].fit.plane), kImageMargin);
  ASSERT_GT(image_cost(images, planes[0].fit.plane), kImageMargin);
  mark_low_objects(planes, kSpacing_m, images, {});
  EXPECT_FALSE(planes[1].low_object);
}

TEST(MarkLowObjects, MarksACarBesideALineThatTheImagesShowOnTheStreet) {
  std::vector<CandidatePlane> planes = street_roof_and_bonnet();
  mark_low_objects(planes, kSpacing_m, seen_at(0.0), {});
  EXPECT_TRUE(planes[1].low_object);
  EXPECT_TRUE(planes[2].low_object);
}

TEST(MarkLowObjects, MarksTwoCarsThatHideMuchOfTheStreet) {
  // 14 m2 of cars above 18 m2 of street
  std::vector<CandidatePlane> planes{level(0.0, 4.0), level(kRoof_m, 3.0)};
  mark_low_objects(planes, kSpacing_m, std::nullopt, {});
  EXPECT_TRUE(planes[1].low_object);
}

}  // namespace
}  // namespace ridgeline::evaluate
