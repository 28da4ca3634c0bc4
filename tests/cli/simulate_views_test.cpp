// SPDX-License-Identifier: BSD-3-Clause
// Scenes with other than two views.
#include "io/project/patch.h"
#include "tests/cli/cli_fixture.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class SimulateViews : public Cli {
 protected:
  [[nodiscard]] ProgramResult simulate(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{
        "simulate", "--out", "s", "--seed", "3", "--extent-m", "45,45", "--samples-per-side", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

TEST_F(SimulateViews, ThreeAndMoreHaveIdsByGroupAndTrueTracks) {
  const ProgramResult made = simulate({"--views", "strip:2,cross:1"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const io::PatchFile patch = io::read_patch(path("s/patch.yaml").string());
  std::vector<std::string> ids;
  for (const io::PatchImage& image : patch.images) {
    ids.push_back(image.id);
    EXPECT_TRUE(std::filesystem::exists(image.path)) << image.path;
  }
  EXPECT_THAT(ids, ElementsAre("strip1", "strip2", "cross1"));
  ASSERT_TRUE(patch.reference_tracks);
  std::istringstream tracks(read(*patch.reference_tracks));
  std::string row;
  std::getline(tracks, row);
  EXPECT_EQ(row, "edge,kind,image,x1_px,y1_px,x2_px,y2_px,visible");
  std::set<std::string> images;
  while (std::getline(tracks, row)) {
    std::istringstream fields(row);
    std::string edge, kind, image;
    std::getline(std::getline(std::getline(fields, edge, ','), kind, ','), image, ',');
    images.insert(image);
  }
  EXPECT_EQ(images, std::set<std::string>(ids.begin(), ids.end()));
  const nlohmann::json truth = read_json(path("s/truth.geojson"));
  int most_images = 0;
  for (const nlohmann::json& line : truth["features"]) {
    most_images = std::max(most_images, line["properties"]["n_images"].get<int>());
  }
  EXPECT_EQ(most_images, 3);
  EXPECT_THAT(read_json(path("s/simulate.json"))["files"].dump(),
              AllOf(HasSubstr("tracks.csv"), HasSubstr("cross1.tif"), Not(HasSubstr("left"))));
}

TEST_F(SimulateViews, TwoOfAnyGroupAreAPairWithoutTracks) {
  ASSERT_EQ(simulate({"--views", "cross:2"}).exit_code, 0);
  EXPECT_THAT(names_in(path("s")),
              AllOf(Contains("left.tif"), Contains("right.tif"), Not(Contains("tracks.csv"))));
  EXPECT_THAT(read(path("s/patch.yaml")), Not(HasSubstr("reference_tracks")));
  EXPECT_THAT(read(path("s/truth.geojson")), Not(HasSubstr("n_images")));
}

TEST_F(SimulateViews, OfTheDefaultAreAStripOfTwo) {
  ASSERT_EQ(simulate({}).exit_code, 0);
  std::filesystem::rename(path("s"), path("s.default"));
  ASSERT_EQ(simulate({"--views", "strip:2"}).exit_code, 0);
  for (const std::string& name : names_in(path("s"))) {
    EXPECT_TRUE(read(path("s") / name) == read(path("s.default") / name)) << name;
  }
}

TEST_F(SimulateViews, TheSunMovesOnByItsStepFromViewToView) {
  ASSERT_EQ(simulate({}).exit_code, 0);
  std::filesystem::rename(path("s"), path("s.default"));
  ASSERT_EQ(simulate({"--sun-step-deg", "30"}).exit_code, 0);
  EXPECT_TRUE(read(path("s/left.tif")) == read(path("s.default/left.tif")));
  EXPECT_FALSE(read(path("s/right.tif")) == read(path("s.default/right.tif")));
}

TEST_F(SimulateViews, ThatAreDegradedAloneChange) {
  ASSERT_EQ(simulate({"--views", "strip:3"}).exit_code, 0);
  std::filesystem::rename(path("s"), path("s.default"));
  const std::vector<std::string> degraded{"--views", "strip:3",        "--blur-px", "2",
                                          "--bayer", "--jpeg-quality", "50"};
  const auto changed = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = degraded;
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(simulate(arguments).exit_code, 0);
    std::vector<std::string> names;
    for (const std::string& name : names_in(path("s"))) {
      const bool is_image = name.ends_with(".tif");
      if (is_image && read(path("s") / name) != read(path("s.default") / name))
        names.push_back(name);
    }
    return names;
  };
  EXPECT_THAT(changed({"--degraded-views", "strip3"}), ElementsAre("strip3.tif"));
  EXPECT_TRUE(read(path("s/truth.geojson")) == read(path("s.default/truth.geojson")));
  EXPECT_THAT(changed({"--degraded-views", "strip1,strip3"}),
              ElementsAre("strip1.tif", "strip3.tif"));
  EXPECT_THAT(changed({}), ElementsAre("strip1.tif", "strip2.tif", "strip3.tif"));
}

TEST_F(SimulateViews, DegradedOnesAreRefusedWithTheOptionTheValueAndTheRule) {
  EXPECT_REFUSED(simulate({"--blur-px", "1", "--degraded-views", "left,middle"}),
                 HasSubstr("--degraded-views = middle, must be one of left, right"));
  EXPECT_REFUSED(simulate({"--degraded-views", "left"}),
                 HasSubstr("must be with --blur-px, --bayer or --jpeg-quality"));
  EXPECT_REFUSED(simulate({"--bayer", "--degraded-views", "left", "--no-images"}),
                 AllOf(HasSubstr("--degraded-views"), HasSubstr("--no-images")));
  EXPECT_REFUSED(simulate({"--blur-px", "-1"}),
                 AllOf(HasSubstr("--blur-px"), HasSubstr("must be in [0, 20]")));
  EXPECT_REFUSED(simulate({"--jpeg-quality", "101"}),
                 AllOf(HasSubstr("--jpeg-quality"), HasSubstr("must be in [0, 100]")));
  EXPECT_REFUSED(simulate({"--jpeg-quality", "50", "--bits", "16"}),
                 HasSubstr("bits = 16, must be 8 with a JPEG quality"));
  EXPECT_REFUSED(simulate({"--bayer", "--bands", "cir"}),
                 HasSubstr("bands = cir, must be rgb with a Bayer pattern"));
  EXPECT_FALSE(std::filesystem::exists(path("s")));
}

TEST_F(SimulateViews, WrongOnesAreRefusedWithTheOptionTheValueAndTheRule) {
  EXPECT_REFUSED(simulate({"--views", "strip"}),
                 AllOf(HasSubstr("--views: 'strip'"), HasSubstr("must be strip:N")));
  EXPECT_REFUSED(simulate({"--views", "strip:2,nadir:3"}), HasSubstr("--views: 'nadir:3'"));
  EXPECT_REFUSED(simulate({"--views", "strip:1"}),
                 HasSubstr("--views: views in all = 1, must be 2 to 30"));
  EXPECT_REFUSED(simulate({"--views", "strip:31"}), HasSubstr("must have 1 to 30 views"));
  EXPECT_REFUSED(simulate({"--views", "strip:3", "--geometry", "chio_wang_2000"}),
                 AllOf(HasSubstr("--views has 3 views"), HasSubstr("--geometry")));
  EXPECT_REFUSED(simulate({"--oblique-tilt-deg", "70"}), HasSubstr("must be in [5, 60]"));
  EXPECT_FALSE(std::filesystem::exists(path("s")));
}

}  // namespace
}  // namespace ridgeline::cli
