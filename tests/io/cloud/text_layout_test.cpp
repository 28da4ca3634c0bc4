// SPDX-License-Identifier: BSD-3-Clause
// Text clouds as other programs write them.

#include "io/cloud/read_cloud.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace ridgeline::io {
namespace {

using testing::AllOf;
using testing::HasSubstr;

PointCloud cloud_of(const std::string& content) {
  const TempFolder folder;
  ReadOptions options;
  options.frame = LocalFrame{};
  return read_cloud({folder.write("cloud.csv", content)}, options);
}

std::string error_of_text(const std::string& content) {
  return io_error_of([&] { (void)cloud_of(content); });
}

/// Expects two points of a roof in UTM, which are the same in every way of writing.
void expect_roof(const std::string& content) {
  const PointCloud cloud = cloud_of(content);
  ASSERT_EQ(cloud.points.size(), 2U) << content;
  EXPECT_EQ(cloud.points[0].x, 512999.314) << content;
  EXPECT_EQ(cloud.points[0].y, 5403002.956) << content;
  EXPECT_EQ(cloud.points[0].z, 250.001) << content;
  EXPECT_EQ(cloud.points[1].x, 513007.827) << content;
  EXPECT_EQ(cloud.points[1].y, 5403004.351) << content;
  EXPECT_EQ(cloud.points[1].z, 257.727) << content;
}

TEST(TextLayout, PassesOverACountOfPointsBeforeThem) {
  expect_roof("2\n512999.314 5403002.956 250.001 1 2 3\n513007.827 5403004.351 257.727 1 2 3\n");
  expect_roof("//X Y Z\n2\n512999.314 5403002.956 250.001\n513007.827 5403004.351 257.727\n");
  expect_roof(
      "\xef\xbb\xbf"
      "2\r\n512999.314\t5403002.956\t250.001\r\n513007.827\t5403004.351\t257.727\r\n");
}

TEST(TextLayout, TakesNamesInQuotesOtherCaseWithUnitsAndInComments) {
  const std::string rows = "\n512999.314,5403002.956,250.001\n513007.827,5403004.351,257.727\n";
  for (const char* names : {"\"X\",\"Y\",\"Z\"", "X [m],Y [m],Z [m]", "x_coord,y_coord,z_coord",
                            "POINT_X,POINT_Y,POINT_Z", "Easting,Northing,Elevation", "E,N,H",
                            "Rechtswert,Hochwert,H\xc3\xb6he", "# x,y,z", "% x, y, z", "; x,y,z",
                            "sep=,\nX,Y,Z", "// X,Y,Z"}) {
    expect_roof(names + rows);
  }
}

TEST(TextLayout, SkipsColumnsThatAreNotNeededWhateverTheyHold) {
  expect_roof(
      "id,x,y,z,note\nP0,512999.314,5403002.956,250.001,\"roof, "
      "old\"\nP1,513007.827,5403004.351,257.727,\n");
  expect_roof(
      "z\ty\tx\tclass\n250.001\t5403002.956\t512999.314\troof\n257.727\t5403004.351\t513007."
      "827\tground\n");
  expect_roof("id x y z\nP0 512999.314 5403002.956 250.001\nP1 513007.827 5403004.351 257.727\n");
  expect_roof("id,,x,y,z\nP0,,512999.314,5403002.956,250.001\n,,513007.827,5403004.351,257.727\n");
}

TEST(TextLayout, ReadsDecimalCommasWhereAnotherMarkSeparates) {
  for (const char mark : {';', '\t', ' '}) {
    for (const std::string& names : {std::string(), std::string("X") + mark + "Y" + mark + "Z\n"}) {
      expect_roof(names + "512999,314" + mark + "5403002,956" + mark + "250,001\n513007,827" +
                  mark + "5403004,351" + mark + "257,727\n");
    }
  }
  expect_roof(
      "x,y,z\n\"512999,314\",\"5403002,956\",\"250,001\"\n\"513007,827\",\"5403004,351\",\"257,"
      "727\"\n");
}

TEST(TextLayout, NamesCommasThatSeparateAndMarkDecimals) {
  const std::string rows = "512999,314,5403002,956,250,001\n513007,827,5403004,351,257,727\n";
  for (const std::string& text : {rows, "X,Y,Z\n" + rows}) {
    EXPECT_THAT(error_of_text(text), HasSubstr("write decimal points where commas separate"))
        << text;
  }
}

TEST(TextLayout, NeverTakesAnotherColumnForHeights) {
  EXPECT_THAT(error_of_text("17 512999.314 5403002.956 250.001\n18 1 2 3\n"),
              AllOf(HasSubstr("line 1"), HasSubstr("column 3 as z is 5403002.956, no height")));
  EXPECT_THAT(error_of_text("1 10.5 20.5 5.0\n2 11.5 21.5 5.1\n3 12.5 20.0 5.2\n"),
              HasSubstr("the first column appears to be a point number"));
  for (const char* const text : {"P1 10.5 20.5 5.0 7\nP2 11.5 21.5 5.1 7\n", "P1 10.5 20.5 5.0\n"})
    EXPECT_THAT(error_of_text(text), HasSubstr("the columns of x, y and z are ambiguous"));
  EXPECT_THAT(error_of_text("x y z\n1 10.5 20.5 5.0\n"),
              AllOf(HasSubstr("has 4 columns but line 1 names 3")));
  EXPECT_THAT(error_of_text("x,y,height,elevation\n1,2,3,4\n"), HasSubstr("2 columns could be z"));
  EXPECT_THAT(error_of_text("1.5,2.5,3.5\n1.5,,2.5,3.5\n"),
              HasSubstr("line 2: \"\" is not a number"));
}

TEST(TextLayout, NamesWhatIsMissingOrAnotherFormat) {
  EXPECT_THAT(error_of_text("lon,lat,height\n8.1,48.2,250\n"),
              AllOf(HasSubstr("line 1"),
                    HasSubstr("\"lon,lat,height\": the columns of x, y and z are ambiguous")));
  EXPECT_THAT(error_of_text("ncols 100\nnrows 100\n"), HasSubstr("ASCII grid"));
  EXPECT_THAT(error_of_text("\xff\xfe"
                            "1\0"),
              HasSubstr("UTF-16"));
  EXPECT_THAT(error_of_text("512,999.314 5,403,002.956 250.001\n"),
              HasSubstr("write numbers without marks other"));
  EXPECT_THAT(error_of_text("x;y;z\n512.999,314;5.403.002,956;250,001\n"),
              HasSubstr("\"512.999,314\" is not a number; write it without thousands"));
}

TEST(TextLayout, LeavesARasterInRowsAlone) {
  EXPECT_EQ(cloud_of("0 5 250.5 9\n1 5 250.6 9\n2 5 250.7 9\n").points.size(), 3U);
}

}  // namespace
}  // namespace ridgeline::io
