// SPDX-License-Identifier: BSD-3-Clause
// Images that do not fit their cameras.
#include "tests/cli/cli_fixture.h"
#include "tests/support/paths.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The first sample patch with images that a test may spoil, in pair/.
class WrongPair : public Cli {
 protected:
  void SetUp() override {
    fs::create_directories(path("pair"));
    for (const char* name :
         {"patch.yaml", "lidar.las", "matches.csv", "truth.geojson", "left.tif", "right.tif"}) {
      fs::copy_file(fs::path(test::source_dir()) / "sample_data/1" / name, path("pair") / name);
    }
  }

  template <typename Change>
  void change(const std::string& name, const Change& how) const {
    const std::string file = path("pair/" + name).string();
    cv::Mat changed;
    how(cv::imread(file, cv::IMREAD_UNCHANGED), changed);
    ASSERT_TRUE(cv::imwrite(file, changed));
  }

  void turn(const std::string& name, int code) const {
    change(name, [code](const cv::Mat& in, cv::Mat& out) { cv::rotate(in, out, code); });
  }

  void scale(const std::string& name, double factor) const {
    change(name, [factor](const cv::Mat& in, cv::Mat& out) {
      cv::resize(in, out, {}, factor, factor, factor < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    });
  }

  [[nodiscard]] ProgramResult match() const {
    return run({"match", "pair/patch.yaml", "--out", "m.csv"});
  }
};

TEST_F(WrongPair, FittingImagesAreNotComplainedOf) {
  const ProgramResult result = match();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
}

TEST_F(WrongPair, SwappedImagesAreRefused) {
  fs::rename(path("pair/left.tif"), path("pair/other.tif"));
  fs::rename(path("pair/right.tif"), path("pair/left.tif"));
  fs::rename(path("pair/other.tif"), path("pair/right.tif"));
  EXPECT_REFUSED(match(),
                 AllOf(HasSubstr("left.tif"), HasSubstr("right.tif"),
                       HasSubstr("do not fit their cameras"), HasSubstr("at most 3"),
                       HasSubstr("with the images swapped"), HasSubstr("--max-y-parallax-px 0")));
  EXPECT_FALSE(fs::exists(path("m.csv")));
}

TEST_F(WrongPair, ImagesThatAreBothTurnedAreRefused) {
  for (const char* name : {"left.tif", "right.tif"}) turn(name, cv::ROTATE_90_CLOCKWISE);
  EXPECT_REFUSED(match(), HasSubstr("both images rotated by 270 degrees clockwise"));
  for (const char* name : {"left.tif", "right.tif"}) turn(name, cv::ROTATE_90_CLOCKWISE);
  EXPECT_REFUSED(match(), HasSubstr("both images rotated by 180 degrees clockwise"));
}

TEST_F(WrongPair, OneTurnedImageIsRefused) {
  turn("right.tif", cv::ROTATE_180);
  EXPECT_REFUSED(match(), HasSubstr("right.tif rotated by 180 degrees clockwise"));
}

TEST_F(WrongPair, ImagesOfAnotherSizeAreRefused) {
  scale("left.tif", 0.5);
  EXPECT_REFUSED(match(), HasSubstr("left.tif doubled in size"));
  scale("right.tif", 0.5);
  EXPECT_REFUSED(match(), HasSubstr("both images doubled in size"));
}

TEST_F(WrongPair, IsRefusedByEveryCommandThatTakesAPair) {
  turn("left.tif", cv::ROTATE_180);
  EXPECT_REFUSED(run({"reconstruct", "pair/patch.yaml", "--out", "lines.geojson"}),
                 HasSubstr("do not fit their cameras"));
  EXPECT_REFUSED(run({"run", "pair/patch.yaml", "--out", "out", "--no-report"}),
                 HasSubstr("do not fit their cameras"));
  EXPECT_FALSE(fs::exists(path("out/run.json")));
}

TEST_F(WrongPair, IsTakenWhenItsUserSaysSo) {
  turn("left.tif", cv::ROTATE_180);
  const ProgramResult result =
      run({"match", "pair/patch.yaml", "--out", "m.csv", "--max-y-parallax-px", "0"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("fit")));
}

TEST_F(WrongPair, HeightsThatThePointsDoNotHaveAreWarnedOf) {
  std::string text = read(path("pair/patch.yaml"));
  const std::size_t at = text.find("height_range:");
  text.replace(at, text.find('\n', at) - at, "height_range: [400, 420]");
  write(path("pair/patch.yaml"), text);
  const ProgramResult result = match();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("height_range [400, 420]"), HasSubstr("check it")));
}

}  // namespace
}  // namespace ridgeline::cli
