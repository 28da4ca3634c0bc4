// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/tracks_file.h"

#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

#include <fstream>

namespace ridgeline::io {
namespace {

using ::testing::EndsWith;

const std::vector<std::string> kTrackImages{"west", "middle", "east"};

class TracksFile : public testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return folder_.file("tracks.csv"); }
  [[nodiscard]] std::string refusal_of(const std::string& text) const {
    std::ofstream(path()) << text;
    return io_error_of([&] { (void)read_tracks(path(), kTrackImages); });
  }
  TempFolder folder_;
};

TEST_F(TracksFile, HoldsTheObservationsInTheirOrder) {
  const std::vector<Track> tracks{{{{1, 7}, {0, 3}, {2, 0}, {0, 4}}}, {{{2, 5}, {1, 8}}}};
  write_tracks(path(), tracks, kTrackImages);
  const std::vector<Track> read = read_tracks(path(), kTrackImages);
  ASSERT_EQ(read.size(), tracks.size());
  for (std::size_t t = 0; t < tracks.size(); ++t)
    EXPECT_EQ(read[t].observations, tracks[t].observations);
}

TEST_F(TracksFile, IsRefusedWithRowAndRule) {
  const std::string header = "track,image,segment\n";
  EXPECT_THAT(refusal_of(header + "0,west,1\n0,north,2\n"),
              EndsWith("tracks.csv:3: image 'north'; must be one of west, middle, east"));
  EXPECT_THAT(refusal_of(header + "0,west,1\n0,west,2\n"),
              EndsWith("track 0 must begin with segments of two images"));
  EXPECT_THAT(refusal_of(header + "1,west,1\n1,east,2\n"),
              EndsWith("track 0 must begin with segments of two images"));
  EXPECT_THAT(refusal_of(header + "900000000,west,1\n"),
              EndsWith("tracks.csv:2: track 900000000, must be below the number of rows"));
  EXPECT_THAT(refusal_of(header + "0,west,-1\n0,east,2\n"), testing::HasSubstr("tracks.csv:2"));
  EXPECT_THAT(refusal_of("track,image\n0,west\n"), testing::HasSubstr("segment"));
}

}  // namespace
}  // namespace ridgeline::io
