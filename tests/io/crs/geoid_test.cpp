// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/geoid.h"

#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

#include <bit>
#include <cstdint>
#include <string>

namespace ridgeline::io {
namespace {

using testing::HasSubstr;

const Eigen::Vector2d kStuttgart(513200.0, 5403000.0);  // of UTM zone 32: 9.18 E, 48.78 N
/// Height of EGM96 there by its grid of 15 minutes, whose cells differ by 0.3 m.
constexpr double kStuttgart_m = 48.5;
constexpr double kCell_m = 0.3;

void append_big_endian(std::uint64_t bits, int n_bytes, std::string& bytes) {
  for (int shift = 8 * (n_bytes - 1); shift >= 0; shift -= 8)
    bytes += static_cast<char>((bits >> static_cast<unsigned>(shift)) & 0xffU);
}

/// A GTX grid of 2 x 2 values around 9.5 E, 48.5 N, one degree apart, all equal.
std::string level_grid(float height_m) {
  std::string bytes;
  for (const double value : {48.0, 9.0, 1.0, 1.0})
    append_big_endian(std::bit_cast<std::uint64_t>(value), 8, bytes);
  for (int i = 0; i < 2; ++i) append_big_endian(2, 4, bytes);
  for (int i = 0; i < 4; ++i) append_big_endian(std::bit_cast<std::uint32_t>(height_m), 4, bytes);
  return bytes;
}

TEST(GeoidAt, TakesEgm96IfNothingIsStated) {
  const GeoidAnswer answer = geoid_at({"EPSG:25832"}, kStuttgart, "");
  ASSERT_TRUE(answer.height);
  EXPECT_NEAR(answer.height->height_m, kStuttgart_m, kCell_m);
  EXPECT_EQ(answer.height->grid, "egm96_15.gtx");
  EXPECT_TRUE(answer.missing.empty());
}

TEST(GeoidAt, TakesTheGridOfTheVerticalPart) {
  const GeoidAnswer answer = geoid_at({"EPSG:32632+5773"}, kStuttgart, "");
  ASSERT_TRUE(answer.height);
  EXPECT_NEAR(answer.height->height_m, kStuttgart_m, kCell_m);
  EXPECT_LT(answer.height->accuracy_m, 1.0);
}

TEST(GeoidAt, NamesAGridThatIsNotThere) {
  const GeoidAnswer answer = geoid_at({"EPSG:25832+7837"}, kStuttgart, "");
  EXPECT_THAT(answer.missing, testing::Contains(HasSubstr("GCG2016")));
  ASSERT_TRUE(answer.height) << "EGM96 in its place";
  EXPECT_EQ(answer.height->grid, "egm96_15.gtx");
}

TEST(GeoidAt, TakesTheGridOfTheUser) {
  const TempFolder folder;
  const std::string path = folder.write("my grid.gtx", level_grid(12.5F));
  const GeoidAnswer answer = geoid_at({"EPSG:25832"}, kStuttgart, path);
  ASSERT_TRUE(answer.height);
  EXPECT_NEAR(answer.height->height_m, 12.5, 1e-6);  // of 32 bits
  EXPECT_EQ(answer.height->grid, "my grid.gtx");
  const GeoidAnswer elsewhere = geoid_at({"EPSG:25832"}, {513200.0, 5600000.0}, path);
  ASSERT_TRUE(elsewhere.height);
  EXPECT_EQ(elsewhere.height->grid, "egm96_15.gtx");
  EXPECT_THAT(elsewhere.missing, testing::Contains("my grid.gtx at this place"));
}

TEST(GeoidAt, IsNothingWithoutAPlace) { EXPECT_FALSE(geoid_at({}, kStuttgart, "").height); }

TEST(RequireGeoidGrid, NamesTheFileThatIsNone) {
  const TempFolder folder;
  const std::string path = folder.write("text.gtx", "no grid");
  EXPECT_THAT(io_error_of([&] { require_geoid_grid(path); }),
              HasSubstr("is not a grid that PROJ can read"));
  EXPECT_THAT(io_error_of([&] { require_geoid_grid(folder.file("none.gtx")); }),
              HasSubstr("is not a file"));
  require_geoid_grid(folder.write("grid.gtx", level_grid(1.0F)));
}

}  // namespace
}  // namespace ridgeline::io
