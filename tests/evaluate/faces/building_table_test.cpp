// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/building_table.h"

#include "evaluate/faces/face_table.h"
#include "tests/evaluate/faces/judged_building.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::test {
namespace {

using evaluate::BuildingRow;
using evaluate::BuildingVerdict;
using evaluate::FaceEvaluation;
using evaluate::FaceStatus;
using evaluate::LineEvaluation;
using evaluate::RoofBuilding;
using evaluate::RoofFace;
using V = Eigen::Vector3d;

BuildingSpec spec_of(RoofShape shape) {
  return {
      .shape = shape, .length_m = 14.0, .width_m = 10.0, .pitch_deg = 38.0, .azimuth_deg = 20.0};
}

/// The row of a building without lines.
BuildingRow row_of(const RoofBuilding& building, const evaluate::PointGrid& search) {
  const auto evaluations = evaluate::judge_faces(search, std::span(&building, 1), {});
  const auto points = evaluate::point_distances(search, std::span(&building, 1), {});
  return evaluate::building_table(std::span(&building, 1), evaluations, points, {})[0];
}

/// The row of a building whose faces are changed, against the scan of the one as it was made.
template <typename Change>
BuildingRow row_after(RoofShape shape, const Change& change) {
  const MadeBuilding made = make_building(spec_of(shape));
  RoofBuilding building = roof_of(made);
  for (RoofFace& face : building.faces) face = change(face);
  return row_of(building, scan_of(made, {}));
}

RoofFace moved(const RoofFace& face, const V& by) {
  return transformed(face, Eigen::Isometry3d(Eigen::Translation3d(by)));
}

LineEvaluation line_of(const std::string& building, const std::string& id, double distance_m) {
  LineEvaluation line;
  line.id = id;
  line.building = building;
  line.status = distance_m < 0.0 ? evaluate::Status::kNoPlane : evaluate::Status::kEvaluated;
  line.mean_distance_m = distance_m;
  return line;
}

TEST(BuildingTable, FindsRightBuildingsRight) {
  for (int i = 0; i < kNumRoofShapes; ++i) {
    const BuildingRow row =
        row_after(static_cast<RoofShape>(i), [](const RoofFace& face) { return face; });
    EXPECT_EQ(row.verdict, BuildingVerdict::kRight) << i;
    EXPECT_LT(*row.unexplained, 0.02) << i;
    if (row.heights.ridge_m) {
      EXPECT_NEAR(*row.heights.ridge_m, 0.0, 0.04) << i;
    }
    EXPECT_NEAR(*row.heights.eave_m, 0.0, 0.04) << i;
  }
}

TEST(BuildingTable, TellsABuildingThatIsTooHighOrTooLowAsAWhole) {
  const BuildingRow row = row_after(RoofShape::kHip, [](const RoofFace& face) {
    return moved(face, {0, 0, 0.6});
  });
  EXPECT_EQ(row.verdict, BuildingVerdict::kTooHigh);
  ASSERT_TRUE(row.shift_m);
  EXPECT_NEAR(row.shift_m->z(), 0.6, 0.03);
  EXPECT_NEAR(*row.heights.ridge_m, 0.6, 0.03);
  EXPECT_NEAR(*row.heights.eave_m, 0.6, 0.03);
  EXPECT_NEAR(row.wrong_height, 1.0, 1e-9);
  const BuildingRow low = row_after(RoofShape::kGable, [](const RoofFace& face) {
    return moved(face, {0, 0, -0.4});
  });
  EXPECT_EQ(low.verdict, BuildingVerdict::kTooLow);
  ASSERT_TRUE(low.shift_m);
  EXPECT_NEAR(low.shift_m->z(), -0.4, 0.03);
}

TEST(BuildingTable, TellsABuildingThatIsMetresTooHighOrTooLow) {
  for (const RoofShape shape : {RoofShape::kGable, RoofShape::kHip, RoofShape::kFlat}) {
    for (const double by_m : {-6.0, -2.5, 2.5, 3.0, 6.0}) {
      const BuildingRow row = row_after(shape, [&](const RoofFace& face) {
        return moved(face, {0, 0, by_m});
      });
      EXPECT_EQ(row.verdict, by_m > 0 ? BuildingVerdict::kTooHigh : BuildingVerdict::kTooLow)
          << static_cast<int>(shape) << " " << by_m;
      ASSERT_TRUE(row.shift_m);
      EXPECT_NEAR(row.shift_m->z(), by_m, 0.05);
    }
  }
}

TEST(BuildingTable, KeepsABuildingThatChangedWhereItsOtherPointsAgree) {
  // a seventh of the points on dormers, as many in a pit
  const MadeBuilding made = make_building(spec_of(RoofShape::kGable));
  const evaluate::PointGrid scan = scan_of(made, {});
  const RoofBuilding building = roof_of(made);
  std::vector<FaceEvaluation> faces = evaluate::judge_faces(scan, std::span(&building, 1), {})[0];
  for (FaceEvaluation& face : faces) face.n_unexplained = face.n_over * 3 / 10;
  evaluate::PointDistances points;
  points.parallel_below_m = 0.02;
  const std::vector<std::vector<FaceEvaluation>> evaluations{faces};
  EXPECT_EQ(
      evaluate::building_table(std::span(&building, 1), evaluations, std::span(&points, 1), {})[0]
          .verdict,
      BuildingVerdict::kChanged);
}

TEST(BuildingTable, FindsABuildingOnASlopeGone) {
  const MadeBuilding made = make_building(spec_of(RoofShape::kGable));
  std::vector<V> ground;
  Random random(2);
  const double slope = std::tan(10.0 * kRadPerDeg);
  for (int i = 0; i < 4500; ++i) {
    const double x = random.uniform(-15, 15);
    ground.emplace_back(x, random.uniform(-15, 15), slope * x + random.normal(0.03));
  }
  EXPECT_EQ(row_of(roof_of(made), grid_of(ground)).verdict, BuildingVerdict::kGone);
}

TEST(BuildingTable, DoesNotJudgeABuildingWhoseLinesContradictItsFaces) {
  const MadeBuilding made = make_building(spec_of(RoofShape::kGable));
  const RoofBuilding building = roof_of(made);
  const evaluate::PointGrid search = scan_of(made, {});
  const auto evaluations = evaluate::judge_faces(search, std::span(&building, 1), {});
  const auto points = evaluate::point_distances(search, std::span(&building, 1), {});
  const auto verdict_with = [&](double distance_m) {
    const LineEvaluation line = line_of(building.id, "1", distance_m);
    return evaluate::building_table(std::span(&building, 1), evaluations, points,
                                    std::span(&line, 1))[0]
        .verdict;
  };
  EXPECT_EQ(verdict_with(0.1), BuildingVerdict::kRight);
  EXPECT_EQ(verdict_with(1.24), BuildingVerdict::kNotJudged);
}

TEST(BuildingTable, TellsAWrongHeightOfOneFace) {
  int n = 0;
  const BuildingRow row = row_after(RoofShape::kGable, [&](const RoofFace& face) {
    return n++ == 0 ? moved(face, {0, 0, 0.6}) : face;
  });
  EXPECT_EQ(row.verdict, BuildingVerdict::kWrongHeight);
  EXPECT_FALSE(row.shift_m);
}

TEST(BuildingTable, TellsABuildingThatIsShiftedInPlan) {
  for (const RoofShape shape :
       {RoofShape::kGable, RoofShape::kHip, RoofShape::kShed, RoofShape::kLShape}) {
    const BuildingRow row = row_after(shape, [](const RoofFace& face) {
      return moved(face, {0.7, -0.4, 0});
    });
    EXPECT_EQ(row.verdict, BuildingVerdict::kShifted) << static_cast<int>(shape);
    ASSERT_TRUE(row.shift_m);
    EXPECT_LT((*row.shift_m - V(0.7, -0.4, 0.0)).norm(), 0.25) << static_cast<int>(shape);
  }
}

TEST(BuildingTable, TellsABuildingThatIsGone) {
  const MadeBuilding made = make_building(spec_of(RoofShape::kGable));
  std::vector<V> ground;
  Random random(1);
  for (int i = 0; i < 4500; ++i) {
    ground.emplace_back(random.uniform(-15, 15), random.uniform(-15, 15), random.normal(0.03));
  }
  EXPECT_EQ(row_of(roof_of(made), grid_of(ground)).verdict, BuildingVerdict::kGone);
}

TEST(BuildingTable, TellsAWrongTilt) {
  const BuildingRow row = row_after(
      RoofShape::kGable, [](const RoofFace& face) { return with_height(face, 0.0, 5.0); });
  EXPECT_EQ(row.verdict, BuildingVerdict::kWrongTilt);
  const double higher_m = 5.0 * (std::tan(43.0 * kRadPerDeg) - std::tan(38.0 * kRadPerDeg));
  EXPECT_NEAR(*row.heights.ridge_m, higher_m, 0.03);
  EXPECT_NEAR(*row.heights.eave_m, 0.0, 0.03);
}

TEST(BuildingTable, TellsAWrongOutline) {
  const BuildingRow row = row_after(
      RoofShape::kGable, [](const RoofFace& face) { return with_edge_moved(face, 0, 0.7); });
  EXPECT_EQ(row.verdict, BuildingVerdict::kWrongOutline);
  EXPECT_NEAR(*row.heights.ridge_m, 0.0, 0.03);
}

TEST(BuildingTable, DoesNotTakeAMovedRidgeForAWrongHeight) {
  const V across(-std::sin(20.0 * kRadPerDeg), std::cos(20.0 * kRadPerDeg), 0.0);
  const BuildingRow row =
      row_after(RoofShape::kGable, [&](const RoofFace& face) { return moved(face, 0.5 * across); });
  EXPECT_NEAR(*row.heights.ridge_m, 0.0, 0.03);
}

TEST(BuildingTable, TellsAnotherShape) {
  // a flat box in place of a gable 3.9 m higher
  const BuildingRow row = row_after(RoofShape::kGable, [](const RoofFace& face) {
    Rings rings = face.rings;
    for (V& x : rings[0]) x.z() = 5.0;
    return evaluate::make_roof_face(face.id, rings);
  });
  EXPECT_EQ(row.verdict, BuildingVerdict::kChanged);
  EXPECT_GT(*row.unexplained, 0.9);
}

TEST(BuildingTable, DoesNotJudgeABuildingOutsideTheCloud) {
  const BuildingRow row = row_after(RoofShape::kGable, [](const RoofFace& face) {
    return moved(face, {500.0, 0, 0});
  });
  EXPECT_EQ(row.verdict, BuildingVerdict::kNotJudged);
  EXPECT_FALSE(row.unexplained);
  EXPECT_FALSE(row.heights.ridge_m);
  EXPECT_EQ(row.n_faces, 2);
  EXPECT_EQ(row.n_judged_faces, 0);
}

TEST(BuildingTable, WeighsVerdictsByArea) {
  const std::vector<RoofBuilding> buildings{{"a", std::vector<RoofFace>(4)}};
  const std::vector<evaluate::PointDistances> points(1);
  std::vector<std::vector<FaceEvaluation>> evaluations(1);
  const auto face = [](double area_m2, bool height, bool outline, FaceStatus status) {
    FaceEvaluation evaluation;
    evaluation.status = status;
    evaluation.area_m2 = area_m2;
    evaluation.n_over = 10;
    evaluation.verdict = {height, false, outline};
    return evaluation;
  };
  evaluations[0] = {face(30.0, true, false, FaceStatus::kEvaluated),
                    face(40.0, false, true, FaceStatus::kEvaluated),
                    face(30.0, false, false, FaceStatus::kEvaluated),
                    face(500.0, false, false, FaceStatus::kSteep)};
  const BuildingRow row = evaluate::building_table(buildings, evaluations, points, {})[0];
  EXPECT_EQ(row.verdict, BuildingVerdict::kWrongOutline);
  EXPECT_NEAR(row.wrong_height, 0.3, 1e-12);
  EXPECT_NEAR(row.wrong_outline, 0.4, 1e-12);
  EXPECT_NEAR(row.area_m2, 100.0, 1e-12);
  evaluations[0][2].status = FaceStatus::kNoLidar;
  evaluations[0][2].area_m2 = 80.0;
  EXPECT_EQ(evaluate::building_table(buildings, evaluations, points, {})[0].verdict,
            BuildingVerdict::kNotJudged);
  evaluations[0].pop_back();
  EXPECT_THROW(evaluate::building_table(buildings, evaluations, points, {}), std::invalid_argument);
}

TEST(BuildingTable, SumsUpTheLinesOfEachBuilding) {
  const std::vector<RoofBuilding> buildings{{"a", {}}, {"b", {}}, {"c", {}}};
  const std::vector<std::vector<FaceEvaluation>> evaluations(3);
  const std::vector<evaluate::PointDistances> points(3);
  const std::vector<LineEvaluation> lines{line_of("a", "1", 0.3), line_of("b", "2", 0.1),
                                          line_of("a", "3", 0.4), line_of("a", "4", -1.0),
                                          line_of("x", "5", 9.0), line_of("a", "6", 0.4)};
  const std::vector<BuildingRow> rows =
      evaluate::building_table(buildings, evaluations, points, lines);
  EXPECT_EQ(rows[0].n_lines, 4);
  EXPECT_EQ(rows[0].n_judged_lines, 3);
  EXPECT_NEAR(*rows[0].rms_m, std::sqrt((0.09 + 0.16 + 0.16) / 3.0), 1e-12);
  EXPECT_EQ(rows[0].worst_line, "3");
  EXPECT_NEAR(*rows[0].worst_distance_m, 0.4, 1e-12);
  EXPECT_EQ(rows[1].n_lines, 1);
  EXPECT_EQ(rows[2].n_lines, 0);
  EXPECT_FALSE(rows[2].rms_m);
}

TEST(ToBuildingsCsv, HasOneRowABuilding) {
  BuildingRow row;
  row.id = "a,b";
  row.verdict = BuildingVerdict::kWrongTilt;
  row.n_lines = 3;
  row.n_judged_lines = 2;
  row.rms_m = 0.12345;
  row.worst_line = "7";
  row.worst_distance_m = 0.2;
  row.n_faces = 4;
  row.n_judged_faces = 3;
  row.area_m2 = 120.04;
  row.judged_area_m2 = 100.0;
  row.wrong_tilt = 0.5;
  row.heights.ridge_m = -0.25;
  row.unexplained = 0.01;
  row.shift_m = V(0.5, -0.25, 0.125);
  row.n_points = 700;
  row.points_rms_m = 0.05;
  row.points_p90_m = 0.08;
  row.covered = 0.9;
  const std::string csv = evaluate::buildings_csv_header(false) +
                          evaluate::buildings_csv_rows("m", std::vector{row, BuildingRow{}});
  EXPECT_EQ(
      csv,
      "method,id,verdict,n_lines,n_judged_lines,rms_m,worst_line,worst_distance_m,n_faces,"
      "n_judged_faces,area_m2,judged_area_m2,wrong_height_share,wrong_tilt_share,"
      "wrong_outline_share,ridge_height_m,eave_height_m,unexplained_share,shift_x_m,shift_y_m,"
      "shift_z_m,"
      "n_points,points_rms_m,points_p90_m,roof_points_rms_m,covered_share\n"
      "m,\"a,b\",wrong tilt,3,2,0.1235,7,0.2000,4,3,120.0,100.0,0.0000,0.5000,0.0000,-0.2500,,"
      "0.0100,0.5000,-0.2500,0.1250,700,0.0500,0.0800,,0.9000\n"
      "m,,not judged,0,0,,,,0,0,0.0,0.0,0.0000,0.0000,0.0000,,,,,,,0,,,,0.0000\n");
}

TEST(ToFacesCsv, HasOneRowAFace) {
  const MadeBuilding made = make_building({.shape = RoofShape::kShed, .pitch_deg = 30.0});
  RoofBuilding building = roof_of(made, "a");
  building.faces.push_back(evaluate::make_roof_face("x,y", {}));
  FaceEvaluation face;
  face.status = FaceStatus::kEvaluated;
  face.verdict.tilt = true;
  face.area_m2 = 110.8;
  face.n_over = 480;
  face.fit.n = 470;
  face.fit.rms_m = 0.034;
  face.difference.shift_m = {0.01, 0.002};
  face.difference.height_m = {0.0115, 0.0023};
  face.difference.angle_deg = {1.5, 0.1};
  face.difference.pitch_deg = evaluate::Estimate{-1.5, 0.1};
  face.share_on_plane = 0.98;
  face.covered_share = 1.0;
  face.beyond_m2 = 0.4;
  face.missing_m2 = 1.2;
  face.edges = {{0, 0.2, 3}, {1, -0.3, 4}, {2, 0.1, 0}};
  const std::vector<std::vector<FaceEvaluation>> evaluations{{face, FaceEvaluation{}}};
  EXPECT_EQ(
      evaluate::faces_csv_header() +
          evaluate::faces_csv_rows("m", std::span(&building, 1), evaluations),
      "method,building,face,status,verdict,area_m2,slope_deg,flatness_m,n_over,n_on_plane,rms_m,"
      "shift_m,shift_95_m,height_m,height_95_m,angle_deg,angle_95_deg,pitch_deg,pitch_95_deg,"
      "aspect_deg,aspect_95_deg,share_on_plane,covered_share,beyond_m2,missing_m2,"
      "largest_offset_m\n"
      "m,a,0,evaluated,tilt,110.8,30.0000,0.0000,480,470,0.0340,0.0100,0.0020,0.0115,0.0023,"
      "1.5000,0.1000,-1.5000,0.1000,,,0.9800,1.0000,0.4,1.2,-0.3000\n"
      "m,a,\"x,y\",degenerate,,0.0,,,0,,,,,,,,,,,,,,,,,\n");
  EXPECT_THROW(evaluate::faces_csv_rows("m", {}, evaluations), std::invalid_argument);
}

TEST(EdgeHeights, AreThoseOfThePlanesWhereTheyMeet) {
  // a gable whose points lie 0.3 m higher on one side and 0.1 m on the other
  const RoofBuilding building = roof_of(make_building({.pitch_deg = 45.0}));
  std::vector<FaceEvaluation> evaluations(2);
  for (std::size_t i = 0; i < 2; ++i) {
    const Plane3& plane = building.faces[i].plane;
    evaluations[i].status = FaceStatus::kEvaluated;
    const double raised_m = i == 0 ? 0.3 : 0.1;
    evaluations[i].fit.plane =
        Plane3(plane.normal(), plane.offset() - raised_m * plane.normal().z());
  }
  const evaluate::EdgeHeights heights = edge_heights(building.faces, evaluations);
  EXPECT_NEAR(*heights.ridge_m, -0.2, 1e-9);
  EXPECT_NEAR(*heights.eave_m, -0.2, 1e-9);
  evaluations[0].status = FaceStatus::kNoPlane;
  const evaluate::EdgeHeights of_one = edge_heights(building.faces, evaluations);
  EXPECT_NEAR(*of_one.ridge_m, -0.1, 1e-9);
  EXPECT_NEAR(*of_one.eave_m, -0.1, 1e-9);
}

TEST(EdgeHeights, TakeTheRidgeOfTheScanWhereverItIs) {
  // slopes of 1 and 1/2 that meet in a level ridge at z = 0; the points of the first lie 0.3 m
  // higher: their ridge is at y = 0.2, z = 0.1
  const std::vector<RoofFace> faces{
      evaluate::make_roof_face("0", {{V(9, 0, 0), V(9, 4, -4), V(0, 4, -4), V(0, 0, 0)}}),
      evaluate::make_roof_face("1", {{V(0, 0, 0), V(0, -4, -2), V(9, -4, -2), V(9, 0, 0)}})};
  std::vector<FaceEvaluation> evaluations(2);
  for (std::size_t i = 0; i < 2; ++i) {
    evaluations[i].status = FaceStatus::kEvaluated;
    evaluations[i].fit.plane = faces[i].plane;
  }
  const V raised(0, 0, 0.3);
  evaluations[0].fit.plane = Plane3(faces[0].plane.normal(), raised);
  EXPECT_NEAR(*edge_heights(faces, evaluations).ridge_m, -0.1, 1e-9);
}

TEST(EdgeHeights, LeaveOutTheKinkOfAMansard) {
  const RoofBuilding building = roof_of(make_building(spec_of(RoofShape::kMansard)));
  std::vector<FaceEvaluation> evaluations(building.faces.size());
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    const Plane3& plane = building.faces[i].plane;
    evaluations[i].status = FaceStatus::kEvaluated;
    // the lower faces' points lie 1 m higher
    const double raised_m = i < 4 ? 1.0 : 0.0;
    evaluations[i].fit.plane =
        Plane3(plane.normal(), plane.offset() - raised_m * plane.normal().z());
  }
  const evaluate::EdgeHeights heights = edge_heights(building.faces, evaluations);
  EXPECT_NEAR(*heights.ridge_m, 0.0, 1e-9);
  EXPECT_NEAR(*heights.eave_m, -1.0, 1e-9);
}

}  // namespace
}  // namespace ridgeline::test
