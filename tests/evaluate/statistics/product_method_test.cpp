// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/product_method.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ridgeline::evaluate {
namespace {

TEST(ProductIndex, IsThatOfTheBestMethod) {
  const auto product = [](const std::vector<std::string>& methods) {
    return methods[product_index(methods)];
  };
  EXPECT_EQ(product({"direct", "joint", "network", "planes", "lines"}), "lines");
  EXPECT_EQ(product({"network", "planes", "joint"}), "network");
  EXPECT_EQ(product({"direct", "joint"}), "joint");
  EXPECT_EQ(product({"planes", "direct"}), "direct");
  EXPECT_EQ(product({"planes"}), "planes");
  EXPECT_EQ(product({"one file", "another file"}), "one file");
  EXPECT_EQ(product_index(std::vector<std::string>{}), 0U);
}

TEST(IsOfPlanes, GoesByTheIdOfMethodsThatHaveSuchLines) {
  EXPECT_TRUE(is_of_planes("lines", "p0"));
  EXPECT_TRUE(is_of_planes("planes", "p12"));
  EXPECT_TRUE(is_of_planes("lines", "25650_270150/p3"));
  EXPECT_FALSE(is_of_planes("lines", "p25_7/3"));
  EXPECT_FALSE(is_of_planes("lines", "pole7"));
  EXPECT_FALSE(is_of_planes("lines", "12"));
  EXPECT_FALSE(is_of_planes("joint", "p0"));  // an id of the user
}

}  // namespace
}  // namespace ridgeline::evaluate
