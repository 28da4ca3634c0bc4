// SPDX-License-Identifier: BSD-3-Clause
// Four real images that are tilted in four directions, with the distortion of their lens, and a
// surface model of their survey.
#include "tests/cli/cli_fixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace ridgeline::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The interior orientation in the words of a patch file, of a camera as OpenSfM states it: in
/// units of the longer side, the principal point from the middle of the image.
std::string interior_of(const nlohmann::json& camera) {
  const double width = camera["width"];
  const auto px = [&](const char* key) { return width * camera[key].get<double>(); };
  std::string text = fmt::format(
      "{{focal_length_mm: {}, pixel_size_um: 1000, size_px: [{}, {}], principal_point_mm: [{}, {}]",
      px("focal_x"), width, camera["height"].get<double>(), px("c_x"), -px("c_y"));
  for (const char* key : {"k1", "k2", "k3", "p1", "p2"})
    text += fmt::format(", {}: {}", key, camera[key].get<double>());
  return text + "}";
}

/// A patch file of all images of the table of orientations: name, x, y, z, omega, phi, kappa.
std::string patch_of(const std::filesystem::path& folder) {
  const nlohmann::json cameras = read_json(folder / "reconstruction.json")[0]["cameras"];
  std::string text =
      fmt::format("id: drone\ncrs: EPSG:32651\nheight_range: [85, 112]\nlidar: {}\nimages:\n",
                  (folder / "dsm.las").string());
  std::istringstream rows(read(folder / "odm_xyz_opk.csv"));
  std::string row;
  std::getline(rows, row);  // the header
  while (std::getline(rows, row)) {
    std::istringstream words(row);
    std::string name;
    std::array<double, 6> v{};
    words >> name;
    for (double& value : v) words >> value;
    name = name.substr(1, name.size() - 2);
    text += fmt::format(
        "  - {{id: '{}', path: {}, interior: {}, exterior: {{position_m: [{}, {}, {}], "
        "omega_phi_kappa_deg: [{}, {}, {}]}}}}\n",
        name, (folder / (name + ".tif")).string(), interior_of(*cameras.begin()), v[0], v[1], v[2],
        v[3], v[4], v[5]);
  }
  return text;
}

class DroneImages : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    if (test::kIsSanitized) GTEST_SKIP() << "takes minutes there; three_images_test.cpp is short";
  }
};

TEST_F(DroneImages, AreAllUsedAndThoseOfThreeLieOnTheSurface) {
  const std::filesystem::path folder = shared_data("drone_odm");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  write(path("patch.yaml"), patch_of(folder));
  const ProgramResult result =
      run({"run", "patch.yaml", "--out", "out", "--methods", "direct", "--no-report"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("is not matched")));
  const std::string tracks = read(path("out/drone/tracks.csv"));
  for (const char* image : {"0018", "0136", "0140", "0142"})
    EXPECT_THAT(tracks, HasSubstr(fmt::format(",100_0005_{},", image)));

  const nlohmann::json strata =
      read_json(path("out/drone/evaluation.direct.json"))["strata"]["n_images"];
  ASSERT_GE(strata.size(), 2U);
  const nlohmann::json& two = strata[0];
  const nlohmann::json& three = strata[1];
  ASSERT_EQ(two["stratum"], "2");
  ASSERT_EQ(three["stratum"], "3");
  EXPECT_GT(three["n_lines"], 150);
  EXPECT_GT(three["n_evaluated"], 90);
  EXPECT_LT(three["median_m"], 0.12);  // of pixels of 0.12 m
  EXPECT_LT(three["rms_m"], 0.25);
  EXPECT_EQ(three["gross_share"], 0.0);
  EXPECT_GT(two["n_lines"], 350);
  EXPECT_LT(three["median_m"].get<double>(), two["median_m"].get<double>());
}

/// The same patch, of which the table itself is the orientation.
std::string oriented_patch_of(const std::filesystem::path& folder) {
  std::string text = fmt::format(
      "id: drone\ncrs: EPSG:32651\nheight_range: [85, 112]\norientation: {}\ncameras: "
      "cameras.yaml\nangles: deg\nimages:\n",
      (folder / "odm_xyz_opk.csv").string());
  for (const char* name : {"0142", "0018", "0136", "0140"})
    text += fmt::format("  - path: {}/100_0005_{}.tif\n", folder.string(), name);
  return text;
}

TEST_F(DroneImages, AreMatchedAlikeByTheirTableOfOrientations) {
  const std::filesystem::path folder = shared_data("drone_odm");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const nlohmann::json cameras = read_json(folder / "reconstruction.json")[0]["cameras"];
  write(path("cameras.yaml"), "FC6310R: " + interior_of(*cameras.begin()) + "\n");
  write(path("typed.yaml"), patch_of(folder));
  write(path("oriented.yaml"), oriented_patch_of(folder));
  for (const char* name : {"typed", "oriented"}) {
    const ProgramResult result =
        run({"match", std::string(name) + ".yaml", "--out", std::string(name) + "/matches.csv"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  const std::string matches = read(path("oriented/matches.csv"));
  EXPECT_GT(std::ranges::count(matches, '\n'), 10);
  EXPECT_EQ(std::ranges::count(matches, '\n'),
            std::ranges::count(read(path("typed/matches.csv")), '\n'));
}

}  // namespace
}  // namespace ridgeline::cli
