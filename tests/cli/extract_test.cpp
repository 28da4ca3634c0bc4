// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image.h"
#include "io/project/segments_file.h"
#include "tests/cli/cli_fixture.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sys/stat.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

namespace ridgeline::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ExtractCommand : public Cli {
 protected:
  /// Writes a white square on grey.
  void write_square(std::string_view name) const {
    cv::Mat image(200, 200, CV_8UC3, cv::Scalar::all(90));
    image(cv::Rect(60, 60, 80, 80)).setTo(cv::Scalar::all(180));
    cv::GaussianBlur(image, image, {7, 7}, 0.8);
    ASSERT_TRUE(cv::imwrite(path(name).string(), image));
  }
};

TEST_F(ExtractCommand, WritesTheFourSidesOfASquare) {
  write_square("square.png");
  const auto result =
      run({"extract", "square.png", "--out", "segments.csv", "--overlay", "overlay.png"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("200 x 200 px, 3 bands: 4 segments"));
  const std::string csv = read(path("segments.csv"));
  EXPECT_THAT(csv, StartsWith("id,x1_px,y1_px,x2_px,y2_px,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_EQ(cv::imread(path("overlay.png").string()).size(), cv::Size(400, 400));
}

TEST_F(ExtractCommand, TheFileDoesNotDependOnTheNumberOfThreads) {
  write_square("square.png");
  ASSERT_EQ(run({"extract", "square.png", "--out", "one.csv", "--jobs", "1"}).exit_code, 0);
  ASSERT_EQ(run({"extract", "square.png", "--out", "two.csv", "--jobs", "2"}).exit_code, 0);
  EXPECT_EQ(read(path("one.csv")), read(path("two.csv")));
}

TEST_F(ExtractCommand, AnImageWithoutTextureHasNoSegments) {
  ASSERT_TRUE(cv::imwrite(path("flat.png").string(), cv::Mat(50, 50, CV_8UC1, cv::Scalar(70))));
  const auto result = run({"extract", "flat.png", "--out", "segments.csv"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr(": 0 segments"));
}

/// A square on a turned frame, with black or transparent pixels around the frame.
cv::Mat turned_frame(bool is_transparent) {
  cv::Mat frame(300, 300, CV_8UC4, cv::Scalar(0, 0, 0, is_transparent ? 0 : 255));
  const auto fill = [&](float half_px, int grey) {
    const cv::RotatedRect turned({150.0F, 150.0F}, cv::Size2f(2 * half_px, 2 * half_px), 20.0F);
    std::array<cv::Point2f, 4> corners;
    turned.points(corners.data());
    const std::vector<cv::Point> outline(corners.begin(), corners.end());
    cv::fillConvexPoly(frame, outline, cv::Scalar(grey, grey, grey, 255));
  };
  fill(100.0F, 90);
  fill(30.0F, 180);
  if (is_transparent) return frame;
  cv::cvtColor(frame, frame, cv::COLOR_BGRA2BGR);
  return frame;
}

TEST_F(ExtractCommand, TransparentBorderGivesNoSegments) {
  ASSERT_TRUE(cv::imwrite(path("frame.png").string(), turned_frame(true)));
  const auto result = run({"extract", "frame.png", "--out", "segments.csv"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("3 bands: 4 segments"));
  EXPECT_EQ(result.err, "");
}

TEST_F(ExtractCommand, BlackBorderIsNamed) {
  ASSERT_TRUE(cv::imwrite(path("frame.png").string(), turned_frame(false)));
  const auto result = run({"extract", "frame.png", "--out", "segments.csv"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("3 bands: 8 segments"));
  EXPECT_THAT(result.err, HasSubstr("frame.png: 55 % is black and connected to the border"));
}

TEST_F(ExtractCommand, ReportedFramesHaveNoSegmentsAtTheirBorder) {
  const std::filesystem::path folder = shared_data("reported_2/40-transparent-border");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  for (const char* const name : {"rgba.tif", "nodata.tif"}) {
    SCOPED_TRACE(name);
    const std::string image = (folder / name).string();
    const auto result = run({"extract", image, "--out", "segments.csv", "--overwrite"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("3 bands"));
    cv::Mat is_inside;
    cv::erode(io::read_picture(image).is_valid, is_inside, cv::Mat::ones(9, 9, CV_8UC1));
    const auto segments = io::read_segments(path("segments.csv").string());
    EXPECT_GT(segments.size(), 5U);
    for (const EdgeSegment& segment : segments) {
      for (const Eigen::Vector2d& end : {segment.in_image.start, segment.in_image.end}) {
        const cv::Point pixel(static_cast<int>(std::lround(end.x())),
                              static_cast<int>(std::lround(end.y())));
        EXPECT_NE(is_inside.at<std::uint8_t>(pixel), 0) << end.transpose();
      }
    }
  }
  EXPECT_THAT(run({"extract", (folder / "black.tif").string(), "--out", "s.csv"}).err,
              HasSubstr("is black and connected to the border of the image"));
  EXPECT_EQ(run({"extract", (folder / "plain.tif").string(), "--out", "p.csv"}).err, "");
}

TEST_F(ExtractCommand, RefusesWrongInput) {
  write_square("square.png");
  EXPECT_REFUSED(run({"extract", "missing.png", "--out", "a.csv"}), HasSubstr("does not exist"));
  write(path("p.yaml"), "extract: {min_length_px: -4}\n");
  EXPECT_REFUSED(run({"extract", "square.png", "--out", "a.csv", "--config", "p.yaml"}),
                 HasSubstr("p.yaml: line 1: min_length_px = -4, must be in [3, 100000]"));
  EXPECT_REFUSED(run({"extract", "square.png", "--out", "square.png"}),
                 HasSubstr("would be overwritten"));
  EXPECT_REFUSED(run({"extract", "square.png", "--out", "a.csv", "--image-id", "left"}),
                 HasSubstr("requires --patch"));
  EXPECT_REFUSED(run({"extract", "square.png", "--out", "a.csv", "--overlay", "a.csv"}),
                 HasSubstr("would be overwritten"));
  EXPECT_REFUSED(run({"extract", "square.png", "--out", "a.csv", "--overlay", "a.jpg"}),
                 HasSubstr("--overlay = a.jpg, must end in .png"));
  ASSERT_TRUE(cv::imwrite(path("pixel.png").string(), cv::Mat(1, 1, CV_8UC1, cv::Scalar(70))));
  EXPECT_REFUSED(run({"extract", "pixel.png", "--out", "a.csv"}),
                 HasSubstr("pixel.png: 1 x 1 pixels; must be at least 2 x 2"));
  EXPECT_FALSE(std::filesystem::exists(path("a.csv")));
}

TEST_F(ExtractCommand, WritesIntoAPipeAndInThePlaceOfALink) {
  write_square("square.png");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] {
    std::ifstream pipe(path("pipe"));
    received.assign(std::istreambuf_iterator<char>(pipe), {});
  });
  EXPECT_EQ(run({"extract", "square.png", "--out", "pipe"}).exit_code, 0);
  reader.join();
  EXPECT_TRUE(std::filesystem::is_fifo(path("pipe")));

  write(path("real.csv"), "mine");
  std::filesystem::create_symlink("real.csv", path("link.csv"));
  EXPECT_EQ(run({"extract", "square.png", "--out", "link.csv", "--overwrite"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::is_symlink(path("link.csv")));
  EXPECT_EQ(read(path("link.csv")), received);
  EXPECT_EQ(read(path("real.csv")), "mine");
}

}  // namespace
}  // namespace ridgeline::cli
