// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/nearest_name.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ridgeline::io {
namespace {

TEST(NearestName, CountsLettersPutInLeftOutReplacedAndSwapped) {
  const std::vector<std::string_view> known{"class", "metric", "method"};
  EXPECT_EQ(nearest_name("metrc", known), "metric");
  EXPECT_EQ(nearest_name("metthod", known), "method");
  EXPECT_EQ(nearest_name("klass", known), "class");
  EXPECT_EQ(nearest_name("metric", known), "metric");
}

TEST(NearestName, CountsASwapOnce) {
  EXPECT_EQ(nearest_name("amx", {"a", "max"}), "max") << "one swap against two letters too many";
}

TEST(NearestName, TakesTheFirstOfSeveral) {
  EXPECT_EQ(nearest_name("", {"max", "min"}), "max");
  EXPECT_EQ(nearest_name("mix", {"max", "min"}), "max");
}

TEST(NearestName, RefusesNoKnownName) {
  EXPECT_THROW(nearest_name("max", {}), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::io
