// SPDX-License-Identifier: BSD-3-Clause
// A patch whose cameras come from a table of orientations, in every command that takes patches.
#include "io/images/image.h"
#include "io/project/patch.h"
#include "tests/cli/cli_fixture.h"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Camera and pose of a projection matrix without skew.
struct DecomposedCamera {
  Eigen::Vector3d position_m;
  Eigen::Vector3d omega_phi_kappa_deg;
  double focal_length_px = 0.0;
  Eigen::Vector2d principal_point_px;
};

DecomposedCamera decomposed(const ProjectionMatrix& image_from_world) {
  Eigen::Matrix3d m = image_from_world.leftCols<3>() / image_from_world.row(2).head<3>().norm();
  if (m.determinant() < 0.0) m = -m;
  DecomposedCamera camera;
  camera.position_m = projection_centre(image_from_world).hnormalized();
  camera.principal_point_px = m.topRows<2>() * m.row(2).transpose();
  Eigen::Matrix3d axes_from_world;  // of the camera: x right, y down, z forwards
  axes_from_world << m.topRows<2>() - camera.principal_point_px * m.row(2), m.row(2);
  camera.focal_length_px = axes_from_world.row(0).norm();
  axes_from_world.topRows<2>() /= camera.focal_length_px;
  const Eigen::Matrix3d R =
      axes_from_world.transpose() * Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  camera.omega_phi_kappa_deg = Eigen::Vector3d(std::atan2(-R(1, 2), R(2, 2)), std::asin(R(0, 2)),
                                               std::atan2(-R(0, 1), R(0, 0))) *
                               (180.0 / std::numbers::pi);
  return camera;
}

std::string camera_entry(const std::string& name,
                         const DecomposedCamera& camera,
                         const io::ImageFacts& image) {
  const Eigen::Vector2d middle(0.5 * (image.width_px - 1), 0.5 * (image.height_px - 1));
  const Eigen::Vector2d offset = camera.principal_point_px - middle;
  return fmt::format(
      "{}: {{focal_length_mm: {}, pixel_size_um: 1000, size_px: [{}, {}], "
      "principal_point_mm: [{}, {}]}}\n",
      name, camera.focal_length_px, image.width_px, image.height_px, offset.x(), -offset.y());
}

/// The small patch and, beside it, oriented.yaml: the same with a table of orientations and a file of cameras.
class OrientedPatch : public SmallPatch {
 protected:
  OrientedPatch() { write_orientation("omega_deg,phi_deg,kappa_deg", 0.0); }

  void write_orientation(const std::string& angles, double raised_m) const {
    const io::PatchFile patch = io::read_patch(path("patch/patch.yaml").string());
    std::string table = "name,x,y,z," + angles + ",camera\n";
    std::string cameras;
    std::string images;
    for (const io::PatchImage& image : patch.images) {
      const DecomposedCamera camera = decomposed(image.image_from_world);
      const Eigen::Vector3d& x = camera.position_m;
      const Eigen::Vector3d& a = camera.omega_phi_kappa_deg;
      table += fmt::format("{},{},{},{},{},{},{},of_{}\n", image.id, x.x(), x.y(), x.z() + raised_m,
                           a.x(), a.y(), a.z(), image.id);
      cameras += camera_entry("of_" + image.id, camera, io::image_facts(image.path));
      images +=
          fmt::format("  - path: {}\n", std::filesystem::path(image.path).filename().string());
    }
    write(path("patch/opk.csv"), table);
    write(path("patch/cameras.yaml"), cameras);
    write(path("patch/oriented.yaml"),
          fmt::format("id: '1'\ncrs: '{}'\nheight_range: [{}, {}]\nlidar: lidar.las\n"
                      "orientation: opk.csv\ncameras: cameras.yaml\nimages:\n{}",
                      patch.crs.definition, patch.height_range_m[0], patch.height_range_m[1],
                      images));
  }

  [[nodiscard]] ProgramResult run_oriented(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run",    "patch/oriented.yaml", "--out", "out", "--methods",
                                   "direct", "--no-report"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  /// How many inputs of a run's record have this role.
  [[nodiscard]] long n_inputs(const std::string& folder, const std::string& role) const {
    const nlohmann::json inputs = read_json(path(folder + "/run.json"))["inputs"];
    return std::count_if(inputs.begin(), inputs.end(),
                         [&](const auto& input) { return input["role"] == role; });
  }
};

std::size_t n_found(std::string_view text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

TEST_F(OrientedPatch, GivesTheLinesOfThePatchWithMatrices) {
  ASSERT_EQ(run_oriented().exit_code, 0);
  const ProgramResult typed =
      run({"run", "patch/patch.yaml", "--out", "typed", "--methods", "direct", "--no-report"});
  ASSERT_EQ(typed.exit_code, 0) << typed.err;
  const auto n_lines = [&](const char* folder) {
    return read_json(path(std::string(folder) + "/1/lines.direct.geojson"))["features"].size();
  };
  EXPECT_GT(n_lines("out"), 5U);
  EXPECT_EQ(n_lines("out"), n_lines("typed"));
  EXPECT_EQ(n_inputs("out", "orientation"), 2);
  EXPECT_EQ(n_inputs("typed", "orientation"), 0);
  const ProgramResult compared = run({"compare", "out", "typed"});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
}

TEST_F(OrientedPatch, IsMatchedAnewIfThePosesHaveChanged) {
  ASSERT_EQ(run_oriented().exit_code, 0);
  EXPECT_THAT(run_oriented({"--resume"}).err, HasSubstr("7 finished stages skipped"));
  write_orientation("omega_deg,phi_deg,kappa_deg", 0.25);
  const ProgramResult raised = run_oriented({"--resume"});
  EXPECT_EQ(raised.exit_code, 0) << raised.err;
  EXPECT_THAT(raised.err, HasSubstr("2 finished stages skipped"));  // the segments of two images
}

TEST_F(OrientedPatch, IsNotReportedOnIfTheTableHasChanged) {
  ASSERT_EQ(run_oriented().exit_code, 0);
  EXPECT_THAT(run({"report", "out"}).err, Not(HasSubstr("opk.csv")));
  write(path("patch/opk.csv"), read(path("patch/opk.csv")) + "further,1,2,3,0,0,0,of_left\n");
  EXPECT_THAT(run({"report", "out"}).err, HasSubstr("opk.csv: has changed since the run"));
}

TEST_F(OrientedPatch, ServesEveryCommandThatTakesPatches) {
  const ProgramResult info = run({"info", "patch/oriented.yaml"});
  EXPECT_THAT(info.out, AllOf(HasSubstr("orientation patch/opk.csv patch/cameras.yaml"),
                              HasSubstr("image       left: patch/left.tif")));
  EXPECT_EQ(run({"match", "patch/oriented.yaml", "--out", "matches.csv"}).exit_code, 0);
  EXPECT_EQ(run({"reconstruct", "patch/oriented.yaml", "--matches", "matches.csv", "--method",
                 "direct", "--out", "lines.geojson"})
                .exit_code,
            0);
  EXPECT_EQ(run({"extract", "patch/left.tif", "--patch", "patch/oriented.yaml", "--out", "e.csv"})
                .exit_code,
            0);
  const ProgramResult judged = run({"evaluate", "--lines", "lines.geojson", "--patch",
                                    "patch/oriented.yaml", "--out", "judged", "--no-report"});
  EXPECT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_EQ(n_inputs("judged", "orientation"), 2);
  EXPECT_REFUSED(run({"match", "patch/oriented.yaml", "--out", "patch/opk.csv", "--quiet"}),
                 HasSubstr("patch/opk.csv"));
}

TEST_F(OrientedPatch, SaysOnceWhatItsImagesDecide) {
  write_orientation("omega,phi,kappa", 0.0);
  const ProgramResult info = run({"info", "patch/oriented.yaml"});
  EXPECT_THAT(info.out, HasSubstr("decided     patch/opk.csv: The file does not state"));
  const ProgramResult result = run_oriented();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("info: patch/opk.csv: "));
  EXPECT_EQ(n_found(result.err, "Decided: "), 1U) << result.err;
  EXPECT_EQ(n_found(read(path("out/run.json")), "Decided: "), 1U);
}

TEST_F(OrientedPatch, NamesTheTableThatIsDamaged) {
  write(path("patch/opk.csv"), "name,x,y,z,omega_deg,phi_deg,kappa_deg\nleft,1,2\n");
  EXPECT_REFUSED(run_oriented(), HasSubstr("patch/opk.csv:2: "));
  write(path("patch/opk.csv"),
        "name,x,y,z,omega_deg,phi_deg,kappa_deg,camera\nleft,1,2,3,0,0,0,of_left\n");
  EXPECT_REFUSED(run_oriented(),
                 AllOf(HasSubstr("patch/oriented.yaml: line "),
                       HasSubstr("patch/opk.csv has no image right.tif; the nearest")));
}

}  // namespace
}  // namespace ridgeline::cli
