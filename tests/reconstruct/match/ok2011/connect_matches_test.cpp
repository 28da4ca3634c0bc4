// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/connect_matches.h"

#include "tests/reconstruct/match/ok2011/stereo_pair.h"
#include "tests/reconstruct/support/owned_pair.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

/// Matched lines as both images show them.
class ConnectMatches : public ::testing::Test {
 protected:
  ConnectMatches() { look_from(test::StereoPair()); }

  void look_from(const test::StereoPair& cameras) {
    pair_ = {{View{"left", cameras.left, {}}, View{"right", cameras.right, {}}}, cameras.heights_m};
  }
  void add(const Segment3& line) {
    for (View& view : pair_.views) {
      view.segments.push_back(test::edge(project(view.image_from_local, line)));
    }
    matches_.push_back({static_cast<int>(matches_.size()), static_cast<int>(matches_.size())});
  }
  [[nodiscard]] std::vector<PairConnection> connect() const {
    return connect_matches(pair_, matches_);
  }

  test::OwnedPair pair_;
  std::vector<Correspondence> matches_;
};

TEST_F(ConnectMatches, JoinsLinesThatMeetInSpace) {
  add({{0, 0, 10}, {3, 3, 10}});
  add({{3, 3, 10}, {6, 0, 10}});
  const auto connections = connect();
  ASSERT_EQ(connections.size(), 1U);
  EXPECT_EQ(connections[0].i, 0);
  EXPECT_EQ(connections[0].k, 1);
}

TEST_F(ConnectMatches, RefusesLinesThatOnlyCrossInOneView) {
  add({{0, 0, 10}, {3, 3, 10}});
  add({{3, 3, 0}, {6, 0, 0}});  // it lies 10 m below: 33 px of parallax between them
  EXPECT_TRUE(connect().empty());
}

TEST_F(ConnectMatches, DoesNotConnectFragmentsThatShareAMate) {
  add({{0, 0, 10}, {3, 3, 10}});
  add({{3, 3, 10}, {6, 0, 10}});
  matches_[1].other = 0;
  EXPECT_TRUE(connect().empty());
  matches_[1] = {0, 1};
  EXPECT_TRUE(connect().empty());
}

TEST_F(ConnectMatches, WidensTheLargestTurnWithTheBase) {
  // an eave along the base and a verge across it, which the base turns by atan(B/H times its slope)
  const auto is_connected = [&](double base_m, double slope) {
    constexpr double kVerge_m = 4.0;
    look_from(test::StereoPair(0.0, base_m));
    matches_.clear();
    add({{0, 0, 10}, {3, 0, 10}});
    add({{3, 0, 10}, {3, kVerge_m, 10 + slope * kVerge_m}});
    return !connect().empty();
  };
  EXPECT_TRUE(is_connected(test::StereoPair::kBase_m, 0.8));       // 12 degrees
  EXPECT_FALSE(is_connected(test::StereoPair::kBase_m, 1.2));      // 17 of 15
  EXPECT_TRUE(is_connected(test::StereoPair::kWideBase_m, 0.8));   // 26 of 35
  EXPECT_FALSE(is_connected(test::StereoPair::kWideBase_m, 1.5));  // 42
}

TEST_F(ConnectMatches, OfNoMatchesAreNone) { EXPECT_TRUE(connect().empty()); }

TEST_F(ConnectMatches, RejectsIndicesOutOfRange) {
  add({{0, 0, 10}, {3, 3, 10}});
  matches_[0].other = 1;
  EXPECT_THROW(connect(), std::invalid_argument);
  matches_[0] = {-1, 0};
  EXPECT_THROW(connect(), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
