// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_records.h"

#include "tests/io/cloud/las_bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <string>

namespace ridgeline::io {
namespace {

// Fields from byte 12 on. Formats 0-5: intensity, return byte, class byte, angle, user, source.
const std::string kOldFields("\x34\x12\x1a\xe6\x05\x00\x21\x43", 8);
// Formats 6-10: intensity, returns, flags, class, user, angle, source.
const std::string kNewFields("\x34\x12\x52\x0c\xc8\x00\x05\x05\x21\x43", 10);

CloudPoint decode_one(const LasBytes& las, const LocalFromFile& local_from_file = {}) {
  const std::string text = las.bytes();
  const auto bytes = std::as_bytes(std::span(text));
  const LasHeader header = parse_las_header(bytes, "tile.las");
  CloudPoint point{};
  decode_las_records(bytes.subspan(header.point_offset), header, local_from_file, {&point, 1});
  return point;
}

TEST(DecodeLasRecords, ReadsFormats0To5) {
  for (std::uint8_t format = 0; format <= 5; ++format) {
    const CloudPoint point = decode_one(LasBytes(3, format, 3).add_point({1, -2, 300}, kOldFields));
    EXPECT_DOUBLE_EQ(point.x, 1000.01);
    EXPECT_DOUBLE_EQ(point.y, 1999.98);
    EXPECT_DOUBLE_EQ(point.z, 3.0);
    EXPECT_EQ(point.intensity, 0x1234);
    EXPECT_EQ(point.return_number, 2);  // 0x1a = 0b00'011'010
    EXPECT_EQ(point.number_of_returns, 3);
    EXPECT_EQ(point.classification, 6);  // 0xe6 = three flags over class 6
    EXPECT_EQ(point.flags, 7);
    EXPECT_EQ(point.source_id, 0x4321);
  }
}

TEST(DecodeLasRecords, ReadsFormats6To10) {
  for (std::uint8_t format = 6; format <= 10; ++format) {
    const CloudPoint point = decode_one(LasBytes(4, format, 3).add_point({1, -2, 300}, kNewFields));
    EXPECT_DOUBLE_EQ(point.x, 1000.01);
    EXPECT_EQ(point.intensity, 0x1234);
    EXPECT_EQ(point.return_number, 2);
    EXPECT_EQ(point.number_of_returns, 5);
    EXPECT_EQ(point.classification, 200);
    EXPECT_EQ(point.flags, 0x0c);
    EXPECT_EQ(point.source_id, 0x4321);
  }
}

TEST(DecodeLasRecords, OldOverlapClassBecomesAFlag) {
  const CloudPoint point = decode_one(LasBytes(2, 0).add_point({}, std::string("\0\0\0\x0c", 4)));
  EXPECT_EQ(point.classification, 12);
  EXPECT_EQ(point.flags, 8);
}

TEST(DecodeLasRecords, AppliesUnitsBeforeTheOrigin) {
  const LocalFromFile local_from_feet{.unit_m = {0.3048, 0.3048, 1.0}, .origin_m = {300, 600, 1}};
  const CloudPoint point = decode_one(LasBytes(2, 0).add_point({100, 0, 250}), local_from_feet);
  constexpr double kToleranceM = 1e-12;  // a rounding of a few hundred metres
  EXPECT_NEAR(point.x, 1001.0 * 0.3048 - 300.0, kToleranceM);
  EXPECT_NEAR(point.y, 2000.0 * 0.3048 - 600.0, kToleranceM);
  EXPECT_NEAR(point.z, 1.5, kToleranceM);
}

TEST(DecodeLasRecords, RefusesPartsOfRecords) {
  const std::string text = LasBytes(2, 0).add_point({}).bytes();
  const auto bytes = std::as_bytes(std::span(text));
  const LasHeader header = parse_las_header(bytes, "tile.las");
  std::array<CloudPoint, 2> points{};
  EXPECT_THROW(decode_las_records(bytes.subspan(header.point_offset), header, {}, points),
               std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::io
