// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/judge_faces.h"

#include "evaluate/faces/judge_face.h"
#include "tests/evaluate/faces/judged_building.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <cstring>

namespace ridgeline::test {
namespace {

using evaluate::FaceEvaluation;
using evaluate::FaceStatus;
using evaluate::JudgeOptions;
using evaluate::RoofBuilding;
using V = Eigen::Vector3d;

std::vector<FaceEvaluation> judged(const RoofBuilding& building,
                                   const evaluate::PointSearch& search,
                                   const JudgeOptions& options = {}) {
  return evaluate::judge_faces(search, std::span(&building, 1), options)[0];
}

RoofBuilding one_face(const std::vector<V>& ring) {
  return {"b", {evaluate::make_roof_face("0", {ring})}};
}

const MadeBuilding& gable() {
  static const MadeBuilding made = make_building({.length_m = 14.0, .width_m = 10.0});
  return made;
}

TEST(JudgeFaces, FindsEveryShapeRight) {
  for (int i = 0; i < kNumRoofShapes; ++i) {
    for (const bool t_junctions : {false, true}) {
      const RoofShape shape = static_cast<RoofShape>(i);
      // without a face of four corners
      const bool no_junctions = shape == RoofShape::kPyramid || shape == RoofShape::kHalfHip;
      if (t_junctions && no_junctions) continue;
      SCOPED_TRACE(i);
      const MadeBuilding made = make_building({.shape = shape,
                                               .length_m = 14.0,
                                               .width_m = 10.0,
                                               .pitch_deg = 38.0,
                                               .azimuth_deg = 20.0,
                                               .t_junctions = t_junctions});
      int n_judged = 0;
      for (const FaceEvaluation& face : judged(roof_of(made), scan_of(made, {}))) {
        if (face.status == FaceStatus::kTooSmall) continue;
        ++n_judged;
        EXPECT_EQ(face.status, FaceStatus::kEvaluated);
        EXPECT_EQ(text(face.verdict), "right");
        EXPECT_GT(face.share_on_plane, 0.98);
        EXPECT_GT(face.covered_share, 0.97);
        EXPECT_LT(face.beyond_m2 + face.missing_m2, 1.5);  // 7 points
        EXPECT_LE(face.n_unexplained, 3);
      }
      EXPECT_GE(n_judged, 1);
    }
  }
}

TEST(JudgeFaces, GivesEveryFaceAStatus) {
  const evaluate::PointGrid grid = scan_of(gable(), {});
  const auto status_of = [&](const std::vector<V>& ring) {
    return judged(one_face(ring), grid)[0].status;
  };
  EXPECT_EQ(status_of({V(0, 0, 0), V(1, 0, 0)}), FaceStatus::kDegenerate);
  EXPECT_EQ(status_of({V(0, 0, 0), V(4, 0, 0), V(4, 0, 3), V(0, 0, 3)}), FaceStatus::kSteep);
  EXPECT_EQ(status_of({V(0, 0, 0), V(9, 0, 0), V(9, 3, 9), V(0, 3, 9)}), FaceStatus::kSteep);
  EXPECT_EQ(status_of({V(0, 0, 8), V(1, 0, 8), V(1, 1, 8), V(0, 1, 8)}), FaceStatus::kTooSmall);
  EXPECT_EQ(status_of({V(-6, -4, 8), V(6, -4, 8), V(6, -3.6, 8), V(-6, -3.6, 8)}),
            FaceStatus::kTooSmall);
  EXPECT_EQ(status_of({V(200, 0, 8), V(210, 0, 8), V(210, 10, 8), V(200, 10, 8)}),
            FaceStatus::kNoLidar);
  EXPECT_EQ(status_of({V(-6, -4, 20), V(6, -4, 20), V(6, 4, 20), V(-6, 4, 20)}),
            FaceStatus::kNoPlane);
  EXPECT_TRUE(judged({"b", {}}, grid).empty());
}

TEST(JudgeFaces, CountsAllPointsOfAFaceWithoutAPlaneAsUnexplained) {
  const FaceEvaluation face = judged(
      one_face({V(-6, -4, 20), V(6, -4, 20), V(6, 4, 20), V(-6, 4, 20)}), scan_of(gable(), {}))[0];
  EXPECT_EQ(face.n_unexplained, face.n_over);
  EXPECT_NEAR(face.n_over, 5.0 * 96.0, 3.0 * std::sqrt(480.0));
}

TEST(JudgeFaces, NeedsAShareOfThePointsOnOnePlane) {
  // a tree's crown over the face, and a few points on it
  const RoofBuilding level = one_face({V(-6, -4, 8), V(6, -4, 8), V(6, 4, 8), V(-6, 4, 8)});
  for (const int n_on_face : {40, 400}) {
    Random random(2);
    std::vector<V> points;
    for (int i = 0; i < 300; ++i) {
      points.emplace_back(random.uniform(-6, 6), random.uniform(-4, 4), random.uniform(6.0, 11.0));
    }
    for (int i = 0; i < n_on_face; ++i) {
      points.emplace_back(random.uniform(-6, 6), random.uniform(-4, 4), 8.0);
    }
    EXPECT_EQ(judged(level, grid_of(points))[0].status,
              n_on_face == 40 ? FaceStatus::kNoPlane : FaceStatus::kEvaluated);
  }
}

TEST(JudgeFaces, TellsTheTiltOfALevelFaceByItsParts) {
  const std::vector<V> ring{V(-6, -5, 6), V(6, -5, 6), V(6, 5, 6), V(-6, 5, 6)};
  const double rise = std::tan(3.0 * kRadPerDeg);
  std::vector<V> points;
  Random random(1);
  for (int i = 0; i < 600; ++i) {
    const double x = random.uniform(-6, 6), y = random.uniform(-5, 5);
    points.emplace_back(x, y, 6.0 + rise * y);
  }
  const FaceEvaluation face = judged(one_face(ring), grid_of(points))[0];
  EXPECT_FALSE(face.difference.pitch_deg);
  EXPECT_FALSE(face.difference.aspect_deg);
  EXPECT_NEAR(face.difference.along_deg.value, -3.0, 1e-9);  // the points rise more towards y
  EXPECT_NEAR(face.difference.across_deg.value, 0.0, 1e-9);
  EXPECT_NEAR(face.difference.angle_deg.value, 3.0, 1e-9);
  EXPECT_EQ(text(face.verdict), "tilt");
}

TEST(JudgeFaces, HasItsSignsFromTheModel) {
  // steeper, turned clockwise, too high
  const evaluate::RoofFace truth = roof_of(gable()).faces[0];
  RoofBuilding building{"b",
                        {with_fault(truth, {.shift_m = 0.5, .pitch_deg = 4.0, .aspect_deg = 6.0})}};
  const evaluate::PlaneDifference d = judged(building, scan_of(gable(), {}))[0].difference;
  EXPECT_NEAR(d.shift_m.value, 0.5, 0.01);
  EXPECT_NEAR(d.pitch_deg->value, 4.0, 0.3);
  EXPECT_NEAR(d.aspect_deg->value, 6.0, 0.5);
  EXPECT_GT(d.height_m.value, d.shift_m.value);
  EXPECT_GT(d.along_deg.value, 3.0);
  // face 0 falls to the south, now to the south-west: it rises to the north-east, to the right of
  // which the points rise more
  EXPECT_GT(building.faces[0].plane.normal().x(), truth.plane.normal().x() - 1.0);
  EXPECT_LT(building.faces[0].plane.normal().x(), 0.0);
}

TEST(JudgeFaces, SeesThatAPlaneGoesOn) {
  // the western half of the southern face is all that the model has
  const std::vector<V>& ring = gable().faces[0].rings[0];
  const V low = 0.5 * (ring[0] + ring[1]), high = 0.5 * (ring[2] + ring[3]);
  RoofBuilding half = one_face({ring[0], low, high, ring[3]});
  const evaluate::PointGrid grid = scan_of(gable(), {.points_per_m2 = 50.0});
  const FaceEvaluation alone = judged(half, grid)[0];
  EXPECT_EQ(text(alone.verdict), "outline");
  EXPECT_NEAR(alone.beyond_m2, 1.5 * 5.0, 1.5);  // points behind the ridge are near its plane, too
  // with the other half it is right
  half.faces.push_back(evaluate::make_roof_face("1", {{low, ring[1], ring[2], high}}));
  const FaceEvaluation beside = judged(half, grid)[0];
  EXPECT_EQ(text(beside.verdict), "right");
  EXPECT_LT(beside.beyond_m2, 1.0);
}

TEST(JudgeFaces, KnowsTheRoofsOfOtherBuildings) {
  const std::vector<MadeBuilding> terrace{make_building({}),
                                          make_building({.position = {12.0, 0.0, 0.0}})};
  const std::vector<RoofBuilding> roofs{roof_of(terrace[0], "a"), roof_of(terrace[1], "b")};
  const evaluate::PointGrid grid = grid_of(scan(terrace, {}));
  for (const std::vector<FaceEvaluation>& faces : evaluate::judge_faces(grid, roofs, {})) {
    for (const FaceEvaluation& face : faces) EXPECT_EQ(text(face.verdict), "right");
  }
  EXPECT_EQ(text(judged(roofs[0], grid)[0].verdict), "outline");
}

TEST(JudgeFaces, TellsTheAreaOfADormerThatTheModelLacks) {
  const BuildingSpec spec{
      .shape = RoofShape::kDormer, .length_m = 14.0, .width_m = 10.0, .pitch_deg = 40.0};
  const MadeBuilding with_dormer = make_building(spec);
  BuildingSpec plain = spec;
  plain.shape = RoofShape::kGable;
  const MadeBuilding without = make_building(plain);
  const FaceEvaluation face = judged(roof_of(without), scan_of(with_dormer, {}))[0];
  const FaceEvaluation known = judged(roof_of(with_dormer), scan_of(with_dormer, {}))[0];
  const double dormer_m2 = face.plan_area_m2 - known.plan_area_m2;
  EXPECT_GT(dormer_m2, 3.0);
  EXPECT_EQ(text(face.verdict), "right");  // its plane and its outline are
  EXPECT_NEAR(face.missing_m2, dormer_m2, 2.0);
  EXPECT_NEAR(known.missing_m2, 0.0, 0.7);
  EXPECT_LT(face.share_on_plane, known.share_on_plane);
  EXPECT_NEAR(face.n_unexplained, 5.0 * dormer_m2, 10.0);
  EXPECT_LT(face.covered_share, known.covered_share);
}

TEST(JudgeFace, IsJudgeFacesOfAFaceThatStandsAlone) {
  const MadeBuilding shed = make_building({.shape = RoofShape::kShed});
  const evaluate::PointGrid grid = scan_of(shed, {});
  const RoofBuilding building = roof_of(shed);
  const FaceEvaluation alone = evaluate::judge_face(grid, building.faces[0], {});
  const FaceEvaluation expected = judged(building, grid)[0];
  EXPECT_EQ(alone.status, FaceStatus::kEvaluated);
  EXPECT_EQ(alone.difference.shift_m.value, expected.difference.shift_m.value);
  EXPECT_EQ(alone.edges.size(), expected.edges.size());
  EXPECT_EQ(alone.beyond_m2, expected.beyond_m2);
}

/// All figures of an evaluation, bit by bit.
std::string bits_of(const std::vector<std::vector<FaceEvaluation>>& buildings) {
  std::string bits;
  const auto add = [&](double value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    bits.append(bytes, sizeof value);
  };
  for (const std::vector<FaceEvaluation>& faces : buildings) {
    for (const FaceEvaluation& f : faces) {
      bits += f.id + name(f.status) + text(f.verdict) + std::to_string(f.n_over) + " " +
              std::to_string(f.n_unexplained) + " " + std::to_string(f.fit.n);
      const evaluate::PlaneDifference& d = f.difference;
      for (const evaluate::Estimate& e : {d.shift_m, d.height_m, d.angle_deg, d.along_deg,
                                          d.across_deg, d.pitch_deg.value_or(evaluate::Estimate{}),
                                          d.aspect_deg.value_or(evaluate::Estimate{})}) {
        add(e.value);
        add(e.half_width);
      }
      for (const double x : {f.area_m2, f.plan_area_m2, f.share_on_plane, f.covered_share,
                             f.beyond_m2, f.missing_m2, f.fit.rms_m, f.fit.plane.offset()}) {
        add(x);
      }
      for (const evaluate::EdgeOffset& edge : f.edges) add(edge.offset_m);
    }
  }
  return bits;
}

std::vector<MadeBuilding> village() {
  std::vector<MadeBuilding> made;
  for (int i = 0; i < 22; ++i) {
    made.push_back(make_building({.shape = static_cast<RoofShape>(i % kNumRoofShapes),
                                  .length_m = 14.0,
                                  .width_m = 10.0,
                                  .pitch_deg = 38.0,
                                  .azimuth_deg = 31.0 * i,
                                  .position = {30.0 * (i % 5), 30.0 * (i / 5), 0.0}}));
  }
  return made;
}

TEST(JudgeFaces, GivesTheSameBitsForAnyNumberOfThreadsAndOrderOfPoints) {
  const std::vector<MadeBuilding> made = village();
  std::vector<RoofBuilding> roofs;
  for (const MadeBuilding& building : made) roofs.push_back(roof_of(building));
  std::vector<V> points = scan(made, {});
  std::string expected;
  for (const std::size_t n_threads : {1U, 2U, 7U}) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, n_threads);
    const std::string bits = bits_of(evaluate::judge_faces(grid_of(points), roofs, {}));
    if (expected.empty()) expected = bits;
    EXPECT_EQ(bits, expected) << n_threads;
    std::ranges::reverse(points);
    const std::vector<V> again(points.begin(), points.begin() + 5000);
    points.insert(points.end(), again.begin(), again.end());  // tiles overlap
  }
}

TEST(JudgeFaces, TakesFacesOfAnyRings) {
  const evaluate::PointGrid grid = scan_of(gable(), {});
  Random random(8);
  RoofBuilding building{"b", {}};
  for (int i = 0; i < 500; ++i) {
    Rings rings(1 + random.bits() % 3);
    for (std::vector<V>& ring : rings) {
      ring.resize(random.bits() % 8);  // crossing itself, as a rule
      for (V& x : ring) x = random.vector(-8.0, 8.0);
      if (ring.size() > 3 && i % 3 == 0) ring[1] = ring[3];
      if (i % 5 == 0) {
        for (V& x : ring) x.z() = 6.0;
      }
    }
    building.faces.push_back(evaluate::make_roof_face(std::to_string(i), rings));
  }
  for (const FaceEvaluation& face : judged(building, grid)) {
    EXPECT_GE(face.share_on_plane, 0.0);
    EXPECT_LE(face.share_on_plane, 1.0);
    EXPECT_LE(face.n_unexplained, face.n_over);
    EXPECT_TRUE(std::isfinite(face.beyond_m2 + face.missing_m2 + face.covered_share));
    EXPECT_TRUE(std::isfinite(face.difference.shift_m.value));
    EXPECT_TRUE(std::isfinite(face.difference.shift_m.half_width));
  }
}

TEST(JudgeFaces, RefusesOptionsOutOfRange) {
  const evaluate::PointGrid grid = scan_of(gable(), {});
  JudgeOptions options;
  options.min_points = 0;
  EXPECT_THROW(evaluate::judge_faces(grid, {}, options), std::invalid_argument);
}

TEST(FaceVerdictText, NamesWhatIsWrong) {
  EXPECT_EQ(text(evaluate::FaceVerdict{}), "right");
  EXPECT_EQ(text(evaluate::FaceVerdict{true, false, true}), "height+outline");
  EXPECT_EQ(text(evaluate::FaceVerdict{false, true, false}), "tilt");
}

}  // namespace
}  // namespace ridgeline::test
