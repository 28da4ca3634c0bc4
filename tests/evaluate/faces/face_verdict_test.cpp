// SPDX-License-Identifier: BSD-3-Clause
// What is told to be wrong with a face that is wrong in one way, by Monte Carlo on gabled houses
// with faces of 20 m2 and more.
#include "tests/evaluate/faces/judged_building.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::test {
namespace {

using evaluate::FaceEvaluation;
using evaluate::RoofFace;

constexpr int kCases = 100;

/// How many of the cases are told so; `change(face, size)` makes the face wrong, with a size from
/// -1 to 1 that is not near 0.
template <typename Change>
int n_told(const std::string& expected, std::uint64_t seed, const Change& change) {
  Random random(seed);
  int n = 0;
  for (int i = 0; i < kCases; ++i) {
    const double area_m2 = std::exp(random.uniform(std::log(20.0), std::log(200.0)));
    const BuildingSpec spec = random_gable(area_m2, random);
    const double size = random.uniform(0.3, 1.0) * (random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0);
    const FaceEvaluation face = judged_after(
        spec, [&](const RoofFace& truth) { return change(truth, size); }, {.seed = random.bits()});
    n += text(face.verdict) == expected && face.status == evaluate::FaceStatus::kEvaluated ? 1 : 0;
  }
  return n;
}

RoofFace with_eave_moved(const RoofFace& face, double outwards_in_plan_m) {
  return with_edge_moved(face, 0, outwards_in_plan_m / face.plane.normal().z());
}

TEST(FaceVerdict, IsRightForARightFace) {
  EXPECT_GE(n_told("right", 1, [](const RoofFace& face, double) { return face; }), 95);
}

TEST(FaceVerdict, TellsAWrongHeight) {
  EXPECT_GE(n_told("height", 2,
                   [](const RoofFace& face, double size) { return with_height(face, size, 0.0); }),
            95);
}

TEST(FaceVerdict, TellsAWrongTiltAboutTheEave) {
  EXPECT_GE(
      n_told("tilt", 3,
             [](const RoofFace& face, double size) { return with_height(face, 0.0, 10.0 * size); }),
      95);
}

TEST(FaceVerdict, TellsAMovedEave) {
  EXPECT_GE(n_told("outline", 4,
                   [](const RoofFace& face, double size) {
                     return with_eave_moved(face, size > 0.0 ? 0.5 : -0.5);
                   }),
            95);
}

TEST(FaceVerdict, TellsSeveralThings) {
  EXPECT_GE(n_told("height+tilt", 5,
                   [](const RoofFace& face, double size) {
                     return with_height(face, size > 0.0 ? 0.7 : -0.7, 5.0 * size);
                   }),
            95);
  EXPECT_GE(n_told("height+outline", 6,
                   [](const RoofFace& face, double size) {
                     return with_eave_moved(with_height(face, size, 0.0), 0.6);
                   }),
            95);
}

}  // namespace
}  // namespace ridgeline::test
