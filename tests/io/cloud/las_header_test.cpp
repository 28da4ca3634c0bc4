// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_header.h"

#include "tests/io/cloud/las_bytes.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <span>

namespace ridgeline::io {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LasHeader parse(const std::string& bytes, bool salvage = false) {
  return parse_las_header(std::as_bytes(std::span(bytes)), "tile.las", {.salvage = salvage});
}

std::string error_of(const LasBytes& las) {
  return io_error_of([&] { parse(las.bytes()); });
}

LasBytes one_point(int version_minor = 2, std::uint8_t point_format = 0) {
  return LasBytes(version_minor, point_format).add_point({1, 2, 3});
}

TEST(ParseLasHeader, ReadsEveryVersionAndPointFormat) {
  for (int minor = 0; minor <= 5; ++minor) {
    for (std::uint8_t format = 0; format <= 10; ++format) {
      SCOPED_TRACE(testing::Message() << "1." << minor << " format " << +format);
      const LasHeader header = parse(LasBytes(minor, format, 5).add_point({1, 2, 3}).bytes());
      EXPECT_EQ(header.version_minor, minor);
      EXPECT_EQ(header.point_format, format);
      EXPECT_EQ(header.record_length, las_record_size(format) + 5);
      EXPECT_EQ(header.n_points, 1U);
      EXPECT_EQ(header.scale, Eigen::Vector3d(0.01, 0.01, 0.01));
      EXPECT_EQ(header.offset, Eigen::Vector3d(1000, 2000, 0));
      EXPECT_FALSE(header.is_compressed());
      EXPECT_THAT(header.warnings, IsEmpty());
    }
  }
}

TEST(ParseLasHeader, NamesFieldByteValueAndRule) {
  EXPECT_EQ(error_of(one_point().set<std::uint16_t>(105, 19)),
            "tile.las: field record_length at byte 105 is 19; point format 0 needs at least 20");
}

TEST(ParseLasHeader, RefusesEachUnusableField) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    const char* name;
    LasBytes las;
    const char* message;
  };
  for (const auto& [name, las, message] : {
           Case{"major version", one_point().set<std::uint8_t>(24, 2), "version at byte 24 is 2.2"},
           Case{"minor version", one_point().set<std::uint8_t>(25, 6), "version at byte 24 is 1.6"},
           Case{"header size 0", one_point().set<std::uint16_t>(94, 0), "did not finish"},
           Case{"short header", one_point().set<std::uint16_t>(94, 226), "header_size at byte 94"},
           Case{"long header", one_point().set<std::uint16_t>(94, 9999), "has only 247 bytes"},
           Case{"point offset 0", one_point().set<std::uint32_t>(96, 0), "did not finish"},
           Case{"points in header", one_point().set<std::uint32_t>(96, 226), "point_offset"},
           Case{"points past end", one_point().set<std::uint32_t>(96, 248), "point_offset"},
           Case{"format", one_point().set<std::uint8_t>(104, 11), "point_format at byte 104 is 11"},
           Case{"scale 0", one_point().set(139, 0.0), "scale at byte 139 is 0"},
           Case{"scale NaN", one_point().set(131, kNan), "scale at byte 131 is nan"},
           Case{"scale infinite", one_point().set(147, HUGE_VAL), "scale at byte 147 is inf"},
           Case{"offset NaN", one_point().set(155, kNan), "offset at byte 155 is nan"},
           Case{"count", one_point().set<std::uint32_t>(107, 2), "room for 1 records of 20 bytes"},
           Case{"count 0", one_point().set<std::uint32_t>(107, 0), "did not finish"},
           Case{"unset bounds", LasBytes(2, 0).set<std::uint32_t>(96, 227).set(179, -DBL_MAX),
                "did not finish"},
           Case{"1.4 count", one_point(4, 6).set(247, std::uint64_t{1} << 63U), "room for 1"},
       }) {
    EXPECT_THAT(error_of(las), HasSubstr(message)) << name;
  }
}

TEST(ParseLasHeader, SaysWhatElseAFileIs) {
  const auto error = [](std::string_view content) {
    return io_error_of([&] { parse(std::string(content)); });
  };
  EXPECT_THAT(error(""), HasSubstr("nothing (the file is empty)"));
  EXPECT_THAT(error("<!DOCTYPE html>"), AllOf(HasSubstr("\"<!DOCTYP\""), HasSubstr("web page")));
  EXPECT_THAT(error(std::string("\x1f\x8b\x08\x00", 4)), HasSubstr("bytes 1f 8b 08 00"));
  EXPECT_THAT(error("LASF only"), HasSubstr("header is truncated: 9 bytes"));
}

TEST(ParseLasHeader, EveryTruncationOfAHeaderIsAnError) {
  const std::string whole = LasBytes(4, 6).add_vlr("user", 1, "payload").add_point({}).bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(io_error_of([&] { parse(whole.substr(0, size)); }), "") << size;
  }
}

TEST(ParseLasHeader, TinyScaleAndZeroPointsAreLegal) {
  EXPECT_EQ(parse(one_point().set(131, 1e-8).bytes()).scale.x(), 1e-8);
  EXPECT_EQ(parse(LasBytes(2, 0).set<std::uint32_t>(96, 227).bytes()).n_points, 0U);
}

TEST(ParseLasHeader, Prefers64BitCountAndWarnsOfADifference) {
  const LasHeader legacy_zero = parse(one_point(4, 6).bytes());
  EXPECT_THAT(legacy_zero.warnings, IsEmpty());
  const LasHeader differs = parse(one_point(4, 6).set<std::uint32_t>(107, 7).bytes());
  EXPECT_EQ(differs.n_points, 1U);
  EXPECT_THAT(differs.warnings, ElementsAre(HasSubstr("legacy_point_count at byte 107 is 7")));
  const std::string only_legacy =
      one_point(4, 6).set<std::uint64_t>(247, 0).set<std::uint32_t>(107, 1).bytes();
  EXPECT_EQ(parse(only_legacy).n_points, 1U);
}

TEST(ParseLasHeader, SalvageReadsWhatIsThere) {
  const LasHeader cut = parse(one_point().set<std::uint32_t>(107, 5).bytes(), true);
  EXPECT_EQ(cut.n_points, 1U);
  EXPECT_THAT(cut.warnings, ElementsAre("salvaged 1 of 5 declared records"));
  EXPECT_EQ(parse(one_point().set<std::uint32_t>(107, 0).bytes(), true).n_points, 1U);
}

TEST(ParseLasHeader, ListsManyRecords) {
  LasBytes las(2, 0);
  for (std::uint16_t i = 0; i < 390; ++i) las.add_vlr("some_user", i, "abc");
  const LasHeader header = parse(las.add_point({}).bytes());
  ASSERT_EQ(header.vlrs.size(), 390U);
  const auto record = find_vlr(header, "some_user", 389);
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->data_size, 3U);
  EXPECT_EQ(record->data_offset + 3, header.point_offset);
  EXPECT_FALSE(find_vlr(header, "some_user", 390).has_value());
}

TEST(ParseLasHeader, StopsARecordListAtThePoints) {
  const LasBytes good = LasBytes(2, 0).add_vlr("a", 1, "abc").add_point({});
  const LasHeader garbage = parse(LasBytes(good).set<std::uint32_t>(100, 1069128089).bytes());
  EXPECT_EQ(garbage.vlrs.size(), 1U);
  EXPECT_THAT(garbage.warnings, ElementsAre(HasSubstr("VLR 2 of 1069128089 at byte 284")));
}

TEST(ParseLasHeader, ReadsRecordsBehindThePoints) {
  std::string evlr(60, '\0');
  evlr.replace(2, 4, "copc");
  evlr[18] = 7;
  evlr[20] = 2;
  LasBytes las = one_point(4, 6).add_tail(evlr + "xy");
  const std::uint64_t first = las.point_offset() + 30;
  const LasHeader header = parse(las.set(235, first).set<std::uint32_t>(243, 1).bytes());
  EXPECT_THAT(header.warnings, IsEmpty());
  ASSERT_TRUE(find_vlr(header, "copc", 7).has_value());
  EXPECT_EQ(find_vlr(header, "copc", 7)->data_offset, first + 60);
  // Records behind the points are no room for points.
  EXPECT_THAT(error_of(las.set<std::uint64_t>(247, 2)), HasSubstr("room for 1"));
  const LasHeader far = parse(one_point(4, 6)
                                  .set(235, std::numeric_limits<std::uint64_t>::max())
                                  .set<std::uint32_t>(243, 1)
                                  .bytes());
  EXPECT_THAT(far.warnings, ElementsAre(HasSubstr("EVLR 1 of 1")));
}

TEST(LasRecordSize, RefusesAnUnknownFormat) {
  EXPECT_THROW(las_record_size(11), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::io
