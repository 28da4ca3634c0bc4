// SPDX-License-Identifier: BSD-3-Clause
// How large a scene `simulate` takes.
#include "tests/cli/cli_fixture.h"

namespace ridgeline::cli {
namespace {

using ::testing::HasSubstr;

class SimulateLimits : public Cli {};

TEST_F(SimulateLimits, ImagesBeyondTheLimitAreRefusedWithIt) {
  EXPECT_REFUSED(run({"simulate", "--out", "s", "--extent-m", "60,60", "--focal-length-px",
                      "100000", "--camera-height-m", "100"}),
                 HasSubstr("300 megapixels"));
  for (const char* extent : {"1e308,60", "60,2001", "1e-300,60", "nan,60"}) {
    EXPECT_REFUSED(run({"simulate", "--out", "s", "--extent-m", extent}), HasSubstr("[40, 2000]"));
  }
  EXPECT_FALSE(std::filesystem::exists(path("s")));
}

}  // namespace
}  // namespace ridgeline::cli
