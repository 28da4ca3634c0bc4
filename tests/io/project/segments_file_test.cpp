// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/segments_file.h"

#include "tests/support/random.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::io {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Eigen::Vector2d point(test::Random& random) {
  const double x = random.uniform(-50.0, 2e4);
  return {x, random.uniform(-50.0, 2e4)};
}

EdgeSegment random_segment(test::Random& random) {
  EdgeSegment s;
  s.line.segment = {point(random), point(random)};
  s.line.centroid_px = midpoint(s.line.segment);
  s.line.sigma_q_px = random.uniform(1e-3, 1.0);
  s.line.sigma_phi_rad = random.uniform(1e-6, 0.1);
  s.line.sigma_e_px = random.uniform(0.5, 2.0);
  s.in_image = {point(random), point(random)};
  s.n_edge_pixels = static_cast<int>(random.uniform(3, 5000));
  s.rms_px = random.uniform(0.0, 1.0);
  s.contrast = random.uniform(0.0, 1.0);
  s.scale_px = std::floor(random.uniform(1.0, 8.0));
  for (Flank* flank : {&s.left, &s.right}) {
    for (float& band : flank->colour) band = static_cast<float>(random.uniform(0.0, 1.0));
    flank->grey = static_cast<float>(random.uniform(0.0, 1.0));
  }
  return s;
}

std::vector<EdgeSegment> three_segments() {
  test::Random random(5);
  return {random_segment(random), random_segment(random), random_segment(random)};
}

void replace(std::string& text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  ASSERT_NE(at, std::string::npos) << what;
  text.replace(at, what.size(), by);
}

TEST(SegmentsFile, ReadsBackWhatWasWrittenToTheLastBit) {
  const TempFolder folder;
  const std::vector<EdgeSegment> written = three_segments();
  write_segments(folder.file("segments.left.csv"), written);
  const std::vector<EdgeSegment> read = read_segments(folder.file("segments.left.csv"));
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].line.segment.start, written[i].line.segment.start);
    EXPECT_EQ(read[i].line.segment.end, written[i].line.segment.end);
    EXPECT_EQ(read[i].line.centroid_px, written[i].line.centroid_px);
    EXPECT_EQ(read[i].line.sigma_q_px, written[i].line.sigma_q_px);
    EXPECT_EQ(read[i].line.sigma_phi_rad, written[i].line.sigma_phi_rad);
    EXPECT_EQ(read[i].line.sigma_e_px, written[i].line.sigma_e_px);
    EXPECT_EQ(read[i].in_image.start, written[i].in_image.start);
    EXPECT_EQ(read[i].in_image.end, written[i].in_image.end);
    EXPECT_EQ(read[i].n_edge_pixels, written[i].n_edge_pixels);
    EXPECT_EQ(read[i].rms_px, written[i].rms_px);
    EXPECT_EQ(read[i].contrast, written[i].contrast);
    EXPECT_EQ(read[i].scale_px, written[i].scale_px);
    EXPECT_EQ(read[i].left.colour, written[i].left.colour);
    EXPECT_EQ(read[i].right.grey, written[i].right.grey);
  }
}

TEST(SegmentsFile, OfNoSegmentsIsAHeader) {
  const TempFolder folder;
  write_segments(folder.file("none.csv"), {});
  EXPECT_THAT(folder.read("none.csv"), testing::StartsWith("id,x1_px,y1_px,x2_px,y2_px,"));
  EXPECT_THAT(read_segments(folder.file("none.csv")), IsEmpty());
}

TEST(SegmentsFile, StatesTheCovarianceOfTheEnds) {
  const TempFolder folder;
  EdgeSegment s = three_segments()[0];
  // along x, ends 10 px from the centroid: across 0.3^2 + (10 * 0.02)^2, of both ends
  // 0.3^2 - (10 * 0.02)^2; along 1.5^2
  s.line = {.segment = {{0, 0}, {20, 0}},
            .centroid_px = {10, 0},
            .sigma_q_px = 0.3,
            .sigma_phi_rad = 0.02,
            .sigma_e_px = 1.5};
  write_segments(folder.file("one.csv"), {s});
  EXPECT_THAT(folder.read("one.csv"), HasSubstr(",2.25,0,0,0,0.13,0,0.05,2.25,0,0.13,"));
}

TEST(SegmentsFile, FaultsNameTheLine) {
  const TempFolder folder;
  write_segments(folder.file("good.csv"), three_segments());
  const auto error_after = [&](const std::string& what, const std::string& by) {
    std::string text = folder.read("good.csv");
    replace(text, what, by);
    const std::string path = folder.write("bad.csv", text);
    return io_error_of([&] { read_segments(path); });
  };
  EXPECT_THAT(error_after("sigma_q_px", "sigma_Q"), HasSubstr("no column sigma_q_px"));
  EXPECT_THAT(error_after("\n1,", "\n7,"), HasSubstr("bad.csv:3: id = 7, must be 1"));
  EXPECT_THAT(error_after("\n1,", "\n1,nan,"), HasSubstr("fields"));
  EXPECT_THAT(error_after("\n2,", "\nx,"), HasSubstr("bad.csv:4: id = 'x'"));
  EXPECT_THAT(io_error_of([&] { read_segments(folder.file("missing.csv")); }),
              HasSubstr("missing.csv"));
  EXPECT_THAT(io_error_of([&] { read_segments(folder.write("empty.csv", "")); }),
              HasSubstr("is empty"));
}

TEST(SegmentsFile, RejectsASegmentWithoutLengthUncertaintyOrScale) {
  const TempFolder folder;
  std::vector<EdgeSegment> segments = three_segments();
  segments[1].line.sigma_q_px = 0.0;
  write_segments(folder.file("sigma.csv"), segments);
  EXPECT_THAT(io_error_of([&] { read_segments(folder.file("sigma.csv")); }),
              HasSubstr("sigma_q_px = 0, must be positive"));
  segments = three_segments();
  segments[2].scale_px = 0.5;
  write_segments(folder.file("scale.csv"), segments);
  EXPECT_THAT(io_error_of([&] { read_segments(folder.file("scale.csv")); }),
              HasSubstr("scale_px = 0.5, must be a whole number from 1 to 8"));
  segments = three_segments();
  segments[0].line.segment.end = segments[0].line.segment.start;
  write_segments(folder.file("length.csv"), segments);
  EXPECT_THAT(io_error_of([&] { read_segments(folder.file("length.csv")); }),
              HasSubstr("start and end are identical"));
}

constexpr double kOwnSigma_px = 0.4;
const Eigen::Vector2i kImage_px(1000, 800);

std::vector<EdgeSegment> own_segments(const std::string& content) {
  const TempFolder folder;
  return read_own_segments(folder.write("lsd.csv", content), kOwnSigma_px, kImage_px);
}

TEST(OwnSegmentsFile, NeedsNothingButIdsAndEnds) {
  const auto segments =
      own_segments("y1_px,x1_px,x2_px,y2_px,id,score\n20,10,110,20,0,0.9\n5,4,3,2,1,0.8\n");
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[0].in_image.start, Eigen::Vector2d(10, 20));
  EXPECT_EQ(segments[0].in_image.end, Eigen::Vector2d(110, 20));
  EXPECT_EQ(segments[1].in_image.start, Eigen::Vector2d(4, 5));
  EXPECT_EQ(segments[0].line.sigma_q_px, line_of_ends(segments[0].in_image, 0.4).sigma_q_px);
  EXPECT_EQ(segments[0].scale_px, 1.0);
}

TEST(OwnSegmentsFile, MayStateSigmaAndScaleOfEachSegment) {
  const auto segments = own_segments(
      "id,x1_px,y1_px,x2_px,y2_px,sigma_px,scale_px\n0,10,20,110,20,0.4,1\n1,10,20,110,20,0.8,2\n");
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[1].line.sigma_q_px, 2.0 * segments[0].line.sigma_q_px);
  EXPECT_EQ(segments[1].line.sigma_phi_rad, 2.0 * segments[0].line.sigma_phi_rad);
  EXPECT_EQ(segments[1].scale_px, 2.0);
}

TEST(OwnSegmentsFile, OfExtractHasItsEndsInTheImageAndItsSigmas) {
  const TempFolder folder;
  const std::vector<EdgeSegment> written = three_segments();
  write_segments(folder.file("edges.csv"), written);
  const auto read = read_own_segments(folder.file("edges.csv"), kOwnSigma_px);
  ASSERT_EQ(read.size(), written.size());
  EXPECT_EQ(read[1].in_image.end, written[1].in_image.end);
  EXPECT_EQ(read[1].line.sigma_q_px, written[1].line.sigma_q_px);
  EXPECT_EQ(read[1].line.sigma_phi_rad, written[1].line.sigma_phi_rad);
  EXPECT_EQ(read[1].line.sigma_e_px, written[1].line.sigma_e_px);
  EXPECT_EQ(read[1].scale_px, written[1].scale_px);
}

TEST(OwnSegmentsFile, MayEndJustOutsideOfTheImage) {
  EXPECT_EQ(own_segments("id,x1_px,y1_px,x2_px,y2_px\n0,-4.6,3,1004,804\n").size(), 1U);
}

TEST(OwnSegmentsFile, FaultsNameLineValueAndRule) {
  const auto error_of = [](const std::string& rows) {
    return io_error_of([&] { (void)own_segments("id,x1_px,y1_px,x2_px,y2_px\n" + rows); });
  };
  const std::string good = "0,1,2,30,40\n";
  EXPECT_THAT(error_of(good + "0,1,2,30,40\n"), HasSubstr("lsd.csv:3: id = 0, must be 1"));
  EXPECT_THAT(error_of(good + "1,1,two,30,40\n"), HasSubstr("lsd.csv:3: y1_px = 'two', must be"));
  EXPECT_THAT(error_of(good + "1,1,inf,30,40\n"), HasSubstr("lsd.csv:3: y1_px = 'inf', must be"));
  EXPECT_THAT(error_of(good + "1,1,2,1,2\n"), HasSubstr("lsd.csv:3: start and end are identical"));
  EXPECT_THAT(error_of(good + "1,1,2,30\n"), HasSubstr("lsd.csv:3: 4 fields, the header has 5"));
  EXPECT_THAT(
      error_of("0,1,2,1004.5,4\n"),
      HasSubstr("lsd.csv:2: x2_px = 1004.5, must be in [-5, 1004]: the image has 1000 x 800"));
  EXPECT_THAT(error_of("0,1,-5.5,7,4\n"), HasSubstr("y1_px = -5.5, must be in [-5, 804]"));
  EXPECT_THAT(io_error_of([] { (void)own_segments("id,x1,y1,x2,y2\n0,1,2,3,4\n"); }),
              HasSubstr("no column x1_px"));
  EXPECT_THAT(
      io_error_of([] { (void)own_segments("id,x1_px,y1_px,x2_px,y2_px,sigma_px\n0,1,2,3,4,0\n"); }),
      HasSubstr("lsd.csv:2: sigma_px = 0, must be positive"));
}

}  // namespace
}  // namespace ridgeline::io
