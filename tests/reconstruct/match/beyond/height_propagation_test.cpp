// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/height_propagation.h"

#include "reconstruct/match/beyond/extensions.h"
#include "tests/reconstruct/match/ok2011/painted_pair.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

using test::PaintedPair;

/// A flat roof at 6 m; its east and west eaves run across the epipolar lines. A line meets a corner
/// of it.
class PropagateHeights : public testing::Test {
 protected:
  static constexpr PaintedPair::Roof kRoof{-6.0, -5.0, 6.0, 5.0, 6.0};

  PropagateHeights() : pair_({kRoof}) {
    pair_.add_outline(kRoof);
    pair_.add_line({{6.0, 5.0, 6.0}, {9.0, 11.0, 6.0}});
    inclined_ = static_cast<int>(pair_.views[0].segments.size()) - 1;
  }

  [[nodiscard]] std::vector<Correspondence> from(const std::vector<Correspondence>& given,
                                                 double min_similarity = 0.0) const {
    MatchExtensionOptions options;
    options.propagate_min_similarity = min_similarity;
    return propagate_heights(pair_.pair(), given, {}, {}, chio_extensions({}, {}), options);
  }

  PaintedPair pair_;
  int inclined_ = 0;
};

TEST_F(PropagateHeights, FindsNothingBesideNothing) { EXPECT_TRUE(from({}).empty()); }

TEST_F(PropagateHeights, FindsTheLineThatMeetsAMatchedOne) {
  const std::vector<Correspondence> all = from({{1, 1, 1.0, 1.0}, {3, 3, 1.0, 1.0}});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].base, inclined_);
  EXPECT_EQ(all[0].other, inclined_);
}

TEST_F(PropagateHeights, LeavesLinesThatDoNotLookAlike) {
  EXPECT_TRUE(from({{1, 1, 1.0, 1.0}, {3, 3, 1.0, 1.0}}, 1.0).empty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
