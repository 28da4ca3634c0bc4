// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/shared_warnings.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using testing::ElementsAre;

TEST(SharedWarnings, AreSaidOnceWithTheirFirstFileAndTheNumberOfTheOthers) {
  EXPECT_THAT(shared_warnings({"a.las: is odd", "a.las: is cut: here", "b.las: is odd",
                               "c.las: is odd", "c.las: is odd", "d.las: is cut: here"}),
              ElementsAre("a.las and 2 more files: is odd", "a.las and 1 more file: is cut: here"));
}

TEST(SharedWarnings, OfOneFileStayAsTheyAre) {
  EXPECT_THAT(shared_warnings({"a.las: is odd", "without a path", "a.las: is odd"}),
              ElementsAre("a.las: is odd", "without a path"));
}

}  // namespace
}  // namespace ridgeline::io
