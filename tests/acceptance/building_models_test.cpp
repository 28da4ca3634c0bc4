// SPDX-License-Identifier: BSD-3-Clause
// What is told of the exact models of villages, and of models with one wrong face, against scans at
// usual angles.
#include "apps/simulate/als.h"
#include "apps/simulate/village.h"
#include "evaluate/faces/building_table.h"
#include "evaluate/faces/judge_faces.h"
#include "reconstruct/geometry/degrees.h"
#include "tests/acceptance/judge_cloud.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace ridgeline::test {
namespace {

using evaluate::BuildingRow;
using evaluate::BuildingVerdict;
using evaluate::FaceEvaluation;
using evaluate::FaceStatus;
using evaluate::RoofBuilding;
using evaluate::RoofFace;
using Rings = std::vector<std::vector<Eigen::Vector3d>>;

// 101 to 110: nothing was calibrated on them
constexpr std::uint64_t kFirstSeed = 101;
constexpr int kSeeds = 10;

struct ModelSurvey {
  std::vector<RoofBuilding> buildings;
  io::PointCloud cloud;
};

struct ScanCase {
  double half_scan_angle_deg;
  bool trees;
  double density_per_m2;
};

ModelSurvey survey_of(std::uint64_t seed, const ScanCase& scan) {
  simulate::VillageOptions village;
  village.seed = seed;
  if (!scan.trees) village.trees_per_lot = 0.0;
  const simulate::SyntheticScene scene = simulate::make_village(village);
  simulate::AlsOptions als;
  als.seed = 1000 + seed;
  als.half_scan_angle_deg = scan.half_scan_angle_deg;
  als.density_per_m2 = scan.density_per_m2;
  ModelSurvey survey{std::vector<RoofBuilding>(scene.buildings.size()),
                     simulate::scan_als(scene, als)};
  std::erase_if(survey.cloud.points, [](const auto& p) { return p.classification == 7; });
  for (const Face& face : scene.faces) {
    RoofBuilding& building = survey.buildings[face.building];
    const bool is_roof = face.kind == FaceKind::kRoof;
    (is_roof ? building.faces : building.others)
        .push_back(evaluate::make_roof_face("", face.rings));
  }
  return survey;
}

std::vector<BuildingRow> rows_of(const ModelSurvey& survey) {
  const evaluate::PointGrid grid = grid_of(survey.cloud);
  const auto faces = evaluate::judge_faces(grid, survey.buildings, {});
  std::vector<std::uint8_t> classes;
  for (const io::CloudPoint& p : survey.cloud.points) classes.push_back(p.classification);
  const auto points = point_distances(grid, survey.buildings, classes);
  return building_table(survey.buildings, faces, points, {});
}

class ExactModels : public testing::TestWithParam<double> {};

TEST_P(ExactModels, AreRight) {
  constexpr double kMinRightShare = 0.98;
  constexpr double kMaxP90_m = 0.15;  // noise of the scan and some points of chimneys
  int n = 0, n_right = 0;
  for (int i = 0; i < kSeeds; ++i) {
    const ScanCase scan{GetParam(), i % 2 == 0, i % 4 < 2 ? 5.0 : 10.0};
    for (const BuildingRow& row :
         rows_of(survey_of(kFirstSeed + static_cast<std::uint64_t>(i), scan))) {
      ++n;
      n_right += row.verdict == BuildingVerdict::kRight ? 1 : 0;
      EXPECT_LT(row.points_p90_m.value_or(0.0), kMaxP90_m) << row.id;
    }
  }
  EXPECT_GE(n_right, kMinRightShare * n) << n;
}

INSTANTIATE_TEST_SUITE_P(HalfScanAngles, ExactModels, testing::Values(2.0, 20.0, 30.0));

/// The longest edge of the outer ring that is level and the lowest of an inclined face.
std::optional<std::size_t> eave_of(const RoofFace& face) {
  if (face.degenerate || slope_rad(face.plane) < 5.0 * kRadPerDeg) return std::nullopt;
  const auto& ring = face.rings[0];
  const auto lowest = std::ranges::min_element(ring, {}, [](const auto& x) { return x.z(); });
  std::optional<std::size_t> eave;
  double longest_m = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector3d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (std::max(a.z(), b.z()) > lowest->z() + 1e-6 || (b - a).norm() <= longest_m) continue;
    longest_m = (b - a).norm();
    eave = i;
  }
  return eave;
}

RoofFace with_points_moved(const RoofFace& face,
                           const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& moved) {
  Rings rings = face.rings;
  for (auto& ring : rings)
    for (Eigen::Vector3d& x : ring) x = moved(x);
  return evaluate::make_roof_face(face.id, rings);
}

Eigen::Vector3d up(double height_m) { return {0.0, 0.0, height_m}; }

RoofFace raised(const RoofFace& face, double height_m) {
  return with_points_moved(face, [&](const auto& x) { return Eigen::Vector3d(x + up(height_m)); });
}

RoofFace pitched_about_eave(const RoofFace& face, std::size_t eave, double pitch_deg) {
  const double slope_rad = ridgeline::slope_rad(face.plane);
  const double steeper = std::tan(slope_rad + pitch_deg * kRadPerDeg) / std::tan(slope_rad);
  const double eave_z = face.rings[0][eave].z();
  return with_points_moved(face, [&](const auto& x) {
    return Eigen::Vector3d(x.x(), x.y(), eave_z + steeper * (x.z() - eave_z));
  });
}

RoofFace with_eave_moved(const RoofFace& face, std::size_t eave, double outwards_m) {
  const Eigen::Vector3d n = face.plane.normal();
  Eigen::Vector3d fall(n.x(), n.y(), 0.0);
  fall.normalize();
  fall.z() = -fall.head<2>().dot(n.head<2>()) / n.z();
  Rings rings = face.rings;
  rings[0][eave] += outwards_m * fall;
  rings[0][(eave + 1) % rings[0].size()] += outwards_m * fall;
  return evaluate::make_roof_face(face.id, rings);
}

using Change = std::function<RoofFace(const RoofFace&, std::size_t eave, double sign)>;

struct WrongFace {
  const char* name;
  const char* word;
  Change change;
};

class OneWrongFace : public testing::TestWithParam<WrongFace> {};

TEST_P(OneWrongFace, IsFoundAndTheOthersAreRight) {
  constexpr double kMinArea_m2 = 20.0, kMinFoundShare = 0.95, kMaxOthersWrongShare = 0.02;
  constexpr ScanCase kScan{20.0, true, 5.0};
  int n = 0, n_found = 0, n_others = 0, n_others_wrong = 0;
  for (int i = 0; i < kSeeds; ++i) {
    ModelSurvey survey = survey_of(kFirstSeed + static_cast<std::uint64_t>(i), kScan);
    std::vector<std::optional<std::size_t>> changed(survey.buildings.size());
    for (std::size_t b = 0; b < survey.buildings.size(); ++b) {
      std::vector<RoofFace>& faces = survey.buildings[b].faces;
      for (std::size_t f = 0; f < faces.size() && !changed[b]; ++f) {
        const auto eave = eave_of(faces[f]);
        if (!eave || faces[f].area_m2 < kMinArea_m2) continue;
        faces[f] = GetParam().change(faces[f], *eave, (b + f) % 2 == 0 ? 1.0 : -1.0);
        changed[b] = f;
      }
    }
    const auto evaluations = evaluate::judge_faces(grid_of(survey.cloud), survey.buildings, {});
    for (std::size_t b = 0; b < changed.size(); ++b) {
      if (!changed[b]) continue;
      for (std::size_t f = 0; f < evaluations[b].size(); ++f) {
        const FaceEvaluation& face = evaluations[b][f];
        const std::string word = face.status == FaceStatus::kEvaluated ? text(face.verdict) : "";
        ++(f == *changed[b] ? n : n_others);
        if (f == *changed[b]) n_found += word == GetParam().word ? 1 : 0;
        if (f != *changed[b]) n_others_wrong += !word.empty() && word != "right" ? 1 : 0;
      }
    }
  }
  EXPECT_GE(n_found, kMinFoundShare * n) << n;
  EXPECT_LE(n_others_wrong, kMaxOthersWrongShare * n_others) << n_others;
  RecordProperty("found", std::to_string(n_found) + "/" + std::to_string(n));
}

INSTANTIATE_TEST_SUITE_P(
    Changes,
    OneWrongFace,
    testing::Values(WrongFace{"Height", "height",
                              [](const RoofFace& face, std::size_t, double sign) {
                                return raised(face, 0.2 * sign);
                              }},
                    WrongFace{"Pitch", "tilt",
                              [](const RoofFace& face, std::size_t eave, double sign) {
                                return pitched_about_eave(face, eave, 3.0 * sign);
                              }},
                    WrongFace{"Eave", "outline",
                              [](const RoofFace& face, std::size_t eave, double sign) {
                                return with_eave_moved(face, eave, 0.5 * sign);
                              }}),
    [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace ridgeline::test
