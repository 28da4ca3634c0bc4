// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/png_writer.h"
#include "tests/cli/cli_fixture.h"

#include <opencv2/core.hpp>

#include <string>
#include <utility>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two cameras 800 m above the ground, 208 m apart; images of `size` px with one grey value.
class FlatPatch : public Cli {
 protected:
  void write_flat(int width, int height) const {
    fs::create_directories(path("flat"));
    for (const char* name : {"flat/left.png", "flat/right.png"}) {
      io::write_png(path(name).string(), cv::Mat(height, width, CV_8UC3, cv::Scalar(90, 90, 90)));
    }
    write(path("flat/patch.yaml"),
          "id: flat\nheight_range: [0, 50]\nimages:\n"
          "  - {id: left, path: left.png, projection_matrix: "
          "[[10000, 0, -100, 80000], [0, -10000, -100, 80000], [0, 0, -1, 800]]}\n"
          "  - {id: right, path: right.png, projection_matrix: "
          "[[10000, 0, -100, -2000000], [0, -10000, -100, 80000], [0, 0, -1, 800]]}\n");
  }
};

TEST_F(FlatPatch, ImagesWithoutTextureGiveNoLinesAndNoError) {
  write_flat(400, 300);
  const ProgramResult result = run({"run", "flat/patch.yaml", "--out", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(read_json(path("out/flat/lines.lines.geojson"))["features"].empty());
  EXPECT_THAT(read(path("out/table2.csv")), HasSubstr("flat,lines,total,0,0,,"));
}

TEST_F(FlatPatch, ImagesWithoutTextureAreNotCheckedAgainstTheirCameras) {
  write_flat(400, 300);
  const ProgramResult result = run({"match", "flat/patch.yaml", "--out", "m.csv"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, AllOf(HasSubstr("only 0 tie points"), HasSubstr("is skipped")));
}

TEST_F(FlatPatch, UnitsThatAreHardlyMetresAreNamed) {
  write_flat(400, 300);
  EXPECT_THAT(run({"run", "flat/patch.yaml", "--out", "metres", "--no-report"}).err,
              Not(HasSubstr("are in metres")));
  std::string text = read(path("flat/patch.yaml"));
  for (const auto& [metres, hundreds] :
       {std::pair("[0, 50]", "[0, 0.5]"), std::pair("-100, 80000]", "-100, 800]"),
        std::pair("-100, 80000]", "-100, 800]"), std::pair("-100, 80000]", "-100, 800]"),
        std::pair("-2000000", "-20000"), std::pair("-1, 800]", "-1, 8]"),
        std::pair("-1, 800]", "-1, 8]")}) {
    text.replace(text.find(metres), std::string(metres).size(), hundreds);
  }
  write(path("flat/patch.yaml"), text);
  const ProgramResult result = run({"run", "flat/patch.yaml", "--out", "out", "--no-report"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("a pixel of image left covers 0.00077 m"),
                                HasSubstr("check that cameras and heights are in metres")));
}

TEST_F(FlatPatch, RunWithoutLinesSaysSoInPlaceOfATable) {
  write_flat(400, 300);
  const ProgramResult result = run({"run", "flat/patch.yaml", "--out", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string sentence =
      "Patch flat: no line was reconstructed: none of 0 segments of the left image has a match.";
  EXPECT_THAT(result.out, AllOf(HasSubstr(sentence), Not(HasSubstr("RMS of the lines"))));
  EXPECT_THAT(read(path("out/report.html")), HasSubstr(sentence));
  EXPECT_TRUE(fs::exists(path("out/table2.md")));
}

TEST_F(FlatPatch, HeightsBehindTheCameraAreRefused) {
  write_flat(40, 30);
  std::string text = read(path("flat/patch.yaml"));
  write(path("flat/patch.yaml"), text.replace(text.find("[0, 50]"), 7, "[700, 900]"));
  EXPECT_REFUSED(run({"run", "flat/patch.yaml", "--out", "out"}),
                 AllOf(HasSubstr("900"), HasSubstr("behind the camera")));
}

TEST_F(FlatPatch, ImageThatDoesNotFitItsCameraIsRefused) {
  write_flat(40, 30);
  write(path("flat/patch.yaml"),
        "id: flat\nheight_range: [0, 50]\nimages:\n"
        "  - {id: left, path: left.png, interior: {focal_length_mm: 120, pixel_size_um: 12, "
        "size_px: [7680, 13824]}, exterior: {position_m: [0, 0, 800], "
        "omega_phi_kappa_deg: [0, 0, 0]}}\n"
        "  - {id: right, path: right.png, interior: {focal_length_mm: 120, pixel_size_um: 12, "
        "size_px: [7680, 13824]}, exterior: {position_m: [208, 0, 800], "
        "omega_phi_kappa_deg: [0, 0, 0]}}\n");
  EXPECT_REFUSED(run({"run", "flat/patch.yaml", "--out", "out"}),
                 AllOf(HasSubstr("left.png: 40 x 30"), HasSubstr("7680 x 13824")));
}

TEST_F(FlatPatch, MatricesThatAreNoCamerasAreRefused) {
  write_flat(40, 30);
  const std::string good = read(path("flat/patch.yaml"));
  const auto with = [&](std::string_view from, std::string_view to) {
    std::string text = good;
    write(path("flat/patch.yaml"), text.replace(text.find(from), from.size(), to));
    return run({"run", "flat/patch.yaml", "--out", "out"});
  };
  EXPECT_REFUSED(with("[0, 0, -1, 800]", "[0, 0, 0, 800]"), HasSubstr("rank"));
  EXPECT_REFUSED(with("[10000, 0, -100, 80000]", "[.nan, 0, -100, 80000]"), HasSubstr("nan"));
  EXPECT_REFUSED(with("-2000000", "80000"), HasSubstr("the same position"));
}

TEST_F(FlatPatch, FileThatIsNoImageIsRefused) {
  write_flat(40, 30);
  write(path("flat/right.png"), "no image");
  EXPECT_REFUSED(run({"run", "flat/patch.yaml", "--out", "out"}), HasSubstr("right.png"));
}

}  // namespace
}  // namespace ridgeline::cli
