// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/reference_tracks_file.h"

#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ridgeline::io {
namespace {

using testing::HasSubstr;

class ReadReferenceTracks : public testing::Test {
 protected:
  std::vector<ReferenceTrack> read_back(const std::string& text) {
    const std::string path = folder_.write("tracks.csv", text);
    return read_reference_tracks(path, std::vector<std::string>{"a", "b"});
  }
  std::string fault_of(const std::string& text) {
    try {
      read_back(text);
    } catch (const IoError& error) {
      return error.what();
    }
    return "no error";
  }

 private:
  TempFolder folder_;
};

TEST_F(ReadReferenceTracks, GathersTheRunsOfEachEdge) {
  const auto tracks = read_back(
      "edge,kind,image,x1_px,y1_px,x2_px,y2_px,visible\n7,eave,b,1,2,3,4,0.5\n"
      "3,ridge,a,0,0,9,9,1\n7,eave,a,5,6,7,8,1\n");
  ASSERT_EQ(tracks.size(), 2U);
  EXPECT_EQ(tracks[0].edge, "7");
  EXPECT_EQ(tracks[0].kind, "eave");
  ASSERT_EQ(tracks[0].observations.size(), 2U);
  EXPECT_EQ(tracks[0].observations[0].view, 1U);
  EXPECT_EQ(tracks[0].observations[0].px.end, Eigen::Vector2d(3, 4));
  EXPECT_EQ(tracks[1].observations.size(), 1U);
}

TEST_F(ReadReferenceTracks, NamesTheRowOfAFault) {
  const std::string header = "edge,image,x1_px,y1_px,x2_px,y2_px\n";
  EXPECT_THAT(fault_of(header + "1,c,0,0,1,1\n"),
              HasSubstr("tracks.csv:2: image 'c'; must be one of a, b"));
  EXPECT_THAT(fault_of(header + "1,a,0,0,1,x\n"), HasSubstr("tracks.csv:2"));
  EXPECT_THAT(fault_of("edge,image,x1_px,y1_px,x2_px\n"), HasSubstr("y2_px"));
  EXPECT_THAT(fault_of("left_id,right_id\n1,2\n"),
              HasSubstr("is a table of matches, not a table of reference tracks"));
}

}  // namespace
}  // namespace ridgeline::io
