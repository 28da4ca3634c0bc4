// SPDX-License-Identifier: BSD-3-Clause
// PCD, PLY and text clouds.

#include "io/cloud/lzf.h"
#include "io/cloud/read_cloud.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

namespace ridgeline::io {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

constexpr double kEasting = 513123.456;
constexpr double kNorthing = 5403210.987;

template <typename T>
std::string bytes_of(T value, bool big_endian = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (big_endian) std::ranges::reverse(bytes);
  return bytes;
}

PointCloud read_text(const TempFolder& folder, std::string_view name, std::string_view content) {
  ReadOptions options;
  options.frame = LocalFrame{};
  return read_cloud({folder.write(name, content)}, options);
}

std::string error_of(std::string_view name, std::string_view content) {
  const TempFolder folder;
  return io_error_of([&] { read_text(folder, name, content); });
}

void expect_utm_point(const PointCloud& cloud, std::size_t index = 0) {
  ASSERT_GT(cloud.points.size(), index);
  EXPECT_EQ(cloud.points[index].x, kEasting);
  EXPECT_EQ(cloud.points[index].y, kNorthing);
  EXPECT_EQ(cloud.points[index].z, 250.5);
}

std::string pcd_header(std::string_view data, int n_points = 1) {
  const std::string n = std::to_string(n_points);
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb label\nSIZE 8 8 8 1 4\nTYPE F F F U U\n"
         "COUNT 1 1 1 3 1\nWIDTH " +
         n + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n + "\nDATA " + std::string(data) +
         "\n";
}

std::string pcd_row() {
  return bytes_of(kEasting) + bytes_of(kNorthing) + bytes_of(250.5) + "rgb" + bytes_of(6U);
}

/// Packs bytes as LZF with literal runs only.
std::string pack_literals(std::string_view bytes) {
  std::string packed;
  for (std::size_t i = 0; i < bytes.size(); i += 32) {
    const std::string_view run = bytes.substr(i, 32);
    packed += static_cast<char>(run.size() - 1);
    packed += run;
  }
  return bytes_of(static_cast<std::uint32_t>(packed.size())) +
         bytes_of(static_cast<std::uint32_t>(bytes.size())) + packed;
}

TEST(ReadPcd, KeepsDoublesInEveryEncoding) {
  const TempFolder folder;
  const std::array<std::string, 3> contents{
      pcd_header("ascii") + "513123.456 5403210.987 250.5 1 2 3 6\n",
      pcd_header("binary") + pcd_row(), pcd_header("binary_compressed") + pack_literals(pcd_row())};
  for (const std::string& content : contents) {
    const PointCloud cloud = read_text(folder, "a.pcd", content);
    expect_utm_point(cloud);
    EXPECT_EQ(cloud.points[0].classification, 6);
    EXPECT_THAT(cloud.warnings, testing::Not(Contains(HasSubstr("float32"))));
  }
}

TEST(ReadPcd, ReadsPackedFieldsOneAfterTheOther) {
  const TempFolder folder;
  std::string columns;
  for (const double value : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) columns += bytes_of(value);
  columns += "rgbrgb" + bytes_of(2U) + bytes_of(6U);
  const PointCloud cloud =
      read_text(folder, "a.pcd", pcd_header("binary_compressed", 2) + pack_literals(columns));
  ASSERT_EQ(cloud.points.size(), 2U);
  EXPECT_EQ(cloud.points[1].x, 2.0);
  EXPECT_EQ(cloud.points[1].z, 6.0);
  EXPECT_EQ(cloud.points[1].classification, 6);
}

TEST(ReadPcd, NamesWhatIsWrong) {
  const auto replaced = [](std::string text, std::string_view from, std::string_view to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string good = pcd_header("binary") + pcd_row();
  struct Case {
    std::string content;
    const char* message;
  };
  for (const auto& [content, message] : {
           Case{pcd_header("binary") + pcd_row().substr(1), "declares 1 points but holds only"},
           Case{pcd_header("ascii"), "declares 1 points but has only 0 lines"},
           Case{pcd_header("ascii") + "1 2 x 4 5 6 7\n", "line 12: \"x\" is not a number"},
           Case{pcd_header("ascii") + "1 2 3\n", "line 12 has too few numbers"},
           Case{pcd_header("zipped"), "DATA is zipped"},
           Case{replaced(good, "POINTS 1", "POINTS 2"), "WIDTH x HEIGHT"},
           Case{replaced(good, "WIDTH 1", "WIDTH -1"), "must be a whole number"},
           Case{replaced(good, "SIZE 8", "SIZE 3"), "field x has TYPE F and SIZE 3"},
           Case{replaced(good, "SIZE 8 8", "SIZE 8"), "SIZE has 4 entries; 5 are needed"},
           Case{replaced(good, "FIELDS x", "FIELDS w"), "has no column x"},
           Case{replaced(good, "COUNT 1", "COUNT 9999999"), "at most"},
           Case{replaced(good, "COUNT 1 1", "COUNT 600000 600000"), "at most 1048576 numbers"},
           Case{replaced(good, "DATA binary\n", ""), "the header does not end"},
           Case{pcd_header("binary_compressed") + "1234", "ends before the sizes"},
           Case{pcd_header("binary_compressed") + bytes_of(99U) + bytes_of(31U) + "x",
                "declares 99 bytes of packed data"},
           Case{pcd_header("binary_compressed") + bytes_of(1U) + bytes_of(30U) + "x",
                "packed data unpack to 30 bytes"},
           Case{pcd_header("binary_compressed") + bytes_of(1U) + bytes_of(31U) + "x",
                "cannot be unpacked by LZF"},
       }) {
    EXPECT_THAT(error_of("a.pcd", content), HasSubstr(message));
  }
}

TEST(UnpackLzf, ExpandsOverlappingReferences) {
  // One literal 'a', then a copy of 5 bytes from 1 back: "aaaaaa".
  const std::string packed(
      "\x00"
      "a\x60\x00",
      4);
  const auto unpacked = unpack_lzf(std::as_bytes(std::span(packed)), 6);
  ASSERT_TRUE(unpacked.has_value());
  EXPECT_TRUE(std::ranges::all_of(*unpacked, [](std::byte b) { return b == std::byte{'a'}; }));
}

TEST(UnpackLzf, RefusesDamage) {
  const auto fails = [](std::string_view packed, std::size_t size) {
    return !unpack_lzf(std::as_bytes(std::span(packed)), size).has_value();
  };
  EXPECT_TRUE(fails(std::string_view("\x60\x00", 2), 5));  // reference before the start
  EXPECT_TRUE(fails(std::string_view("\x05"
                                     "ab",
                                     3),
                    6));  // literals are missing
  EXPECT_TRUE(fails(std::string_view("\x00"
                                     "a\xe0",
                                     3),
                    9));  // reference is cut short
  EXPECT_TRUE(fails(std::string_view("\x01"
                                     "ab",
                                     3),
                    1));  // too many bytes
  EXPECT_TRUE(fails(std::string_view("\x01"
                                     "ab",
                                     3),
                    3));  // too few bytes
  EXPECT_TRUE(fails(std::string_view("\x00"
                                     "a",
                                     2),
                    4000000000U));  // out of reach
}

TEST(ReadPly, KeepsDoublesInEveryEncodingAndSkipsElementsBefore) {
  const TempFolder folder;
  for (const bool big : {false, true}) {
    const std::string header =
        std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\ncomment made by hand\nelement camera 2\nproperty float32 f\n"
        "element face 1\nproperty list uchar int vertex_indices\n"
        "element vertex 2\nproperty double x\nproperty float64 y\nproperty double z\n"
        "property list uint8 short near\nproperty ushort scalar_Intensity\n"
        "property uchar classification\nend_header\n";
    std::string data = bytes_of(1.0F, big) + bytes_of(2.0F, big) + "\x03" + bytes_of(0, big) +
                       bytes_of(1, big) + bytes_of(2, big);
    for (const char list_size : {'\0', '\2'}) {
      data += bytes_of(kEasting, big) + bytes_of(kNorthing, big) + bytes_of(250.5, big);
      data += list_size + std::string(static_cast<std::size_t>(list_size) * 2, 'l');
      data += bytes_of(std::uint16_t{513}, big) + "\x06";
    }
    const PointCloud cloud = read_text(folder, "a.ply", header + data);
    expect_utm_point(cloud, 0);
    expect_utm_point(cloud, 1);
    EXPECT_EQ(cloud.points[1].intensity, 513);
    EXPECT_EQ(cloud.points[1].classification, 6);
    for (std::size_t size = 0; size < data.size(); ++size) {
      EXPECT_NE(error_of("a.ply", header + data.substr(0, size)), "") << size;
    }
  }
}

TEST(ReadPly, ReadsRowsOfOneSizeInPlace) {
  const TempFolder folder;
  const PointCloud cloud =
      read_text(folder, "a.ply",
                "ply\r\nformat binary_big_endian 1.0\r\nelement vertex 1\r\nproperty int x\r\n"
                "property short y\r\nproperty char z\r\nend_header\r\n" +
                    bytes_of(-70000, true) + bytes_of(std::int16_t{-2}, true) + "\xff");
  ASSERT_EQ(cloud.points.size(), 1U);
  EXPECT_EQ(cloud.points[0].x, -70000.0);
  EXPECT_EQ(cloud.points[0].y, -2.0);
  EXPECT_EQ(cloud.points[0].z, -1.0);
}

TEST(ReadPly, ReadsAscii) {
  const TempFolder folder;
  const PointCloud cloud = read_text(
      folder, "a.ply",
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int v\nelement vertex 1\n"
      "property list uchar int w\nproperty double x\nproperty double y\nproperty double z\n"
      "end_header\n3 0 1 2\n2 8 9 513123.456 5403210.987 250.5\n");
  expect_utm_point(cloud);
}

TEST(ReadPly, NamesWhatIsWrong) {
  const std::string start = "ply\nformat ascii 1.0\nelement vertex 1\n";
  struct Case {
    std::string content;
    const char* message;
  };
  for (const auto& [content, message] : {
           Case{"ply\nformat ebcdic 1.0\n", "line 2: format is ebcdic"},
           Case{"ply\nelement vertex 0\nend_header\n", "no format line"},
           Case{start + "property quad x\nend_header\n", "line 4: \"quad\" is not a PLY type"},
           Case{start + "property double\n", "line 4: a property must be"},
           Case{start + "whatever\n", "\"whatever\" is not expected here"},
           Case{start, "the header does not end"},
           Case{"ply\nformat ascii 1.0\nelement face 0\nend_header\n", "has no element vertex"},
           Case{start + "property double x\nproperty double y\nend_header\n1 2\n", "no column z"},
           Case{"ply\nformat binary_little_endian 1.0\nelement a 18446744073709551615\n"
                "property list int double p\nelement vertex 1\nend_header\nxxxx",
                "ends before the 18446744073709551615 rows of element a"},
       }) {
    EXPECT_THAT(error_of("a.ply", content), HasSubstr(message));
  }
}

TEST(ReadFloats, WarnsOfDamagedCoordinatesAndRefusesThemIfStrict) {
  const TempFolder folder;
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n";
  const std::string utm =
      folder.write("utm.ply", header + bytes_of(513123.F) + bytes_of(5403210.F) + bytes_of(250.F));
  EXPECT_THAT(read_cloud({utm}).warnings,
              Contains(AllOf(HasSubstr("float32"), HasSubstr("y in steps of 0.5 m"))));
  ReadOptions options;
  options.strict = true;
  EXPECT_THAT(io_error_of([&] { read_cloud({utm}, options); }), HasSubstr("float32"));
  const std::string local =
      folder.write("local.ply", header + bytes_of(1.F) + bytes_of(2.F) + bytes_of(3.F));
  EXPECT_THAT(read_cloud({local}, options).warnings, testing::Not(Contains(HasSubstr("float32"))));
}

TEST(ReadXyz, ReadsBlanksCommasCommentsAndWindowsLines) {
  const TempFolder folder;
  const PointCloud cloud =
      read_text(folder, "a.XYZ",
                "# easting northing\r\n513123.456 5403210.987 250.5 255 0\r\n\r\n"
                "+513123.456,5403210.987; 250.5");
  expect_utm_point(cloud, 0);
  expect_utm_point(cloud, 1);
  EXPECT_EQ(cloud.points.size(), 2U);
}

TEST(ReadXyz, FollowsColumnNames) {
  const TempFolder folder;
  const PointCloud cloud =
      read_text(folder, "a.csv", "class,Z,\"Y\",X\n6,250.5,5403210.987,513123.456\n");
  expect_utm_point(cloud);
  EXPECT_EQ(cloud.points[0].classification, 6);
}

TEST(ReadXyz, NamesTheLineThatIsNoPoint) {
  EXPECT_THAT(error_of("a.xyz", "1 2 3\n# note\n1 2\n"), HasSubstr("line 3 has too few numbers"));
  EXPECT_THAT(error_of("a.xyz", "1 2 3\nhello 2 3\n"),
              HasSubstr("line 2: \"hello\" is not a number"));
}

TEST(ReadXyz, ManyLinesKeepTheirOrderAcrossBlocks) {
  const TempFolder folder;
  std::string text;
  constexpr int kLines = 40000;
  for (int i = 0; i < kLines; ++i) text += std::to_string(i) + " 0 0\n";
  const PointCloud cloud = read_text(folder, "a.xyz", text);
  ASSERT_EQ(cloud.points.size(), static_cast<std::size_t>(kLines));
  for (int i = 0; i < kLines; ++i) EXPECT_EQ(cloud.points[static_cast<std::size_t>(i)].x, i);
}

TEST(OpenPly, BlankAfterTheMagicWordIsADamagedPlyAndNoLas) {
  EXPECT_THAT(error_of("a.ply", "ply \nformat nonsense 1.0\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("nonsense")));
}

TEST(OpenXyz, AnEndlessWordIsQuotedInPart) {
  const std::string message = error_of("a.xyz", "1 2 3\n" + std::string(1'000'000, 'x'));
  EXPECT_THAT(message, HasSubstr("line 2: \"xxx"));
  EXPECT_LT(message.size(), 300U);
}

TEST(OpenPcd, PackedDataThatGrowBeyondMeasureAreRefused) {
  const std::uint32_t unpacked_size = 3'000'000 * 24;
  std::string packed(2, '\0');  // a byte, then copies of 264 bytes of it
  while (packed.size() < 1'000'000) packed += std::string("\xE0\xFF\x00", 3);
  const std::string header =
      "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3000000\nHEIGHT "
      "1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3000000\nDATA binary_compressed\n";
  const std::string content = header + bytes_of(static_cast<std::uint32_t>(packed.size())) +
                              bytes_of(unpacked_size) + packed;
  EXPECT_THAT(error_of("a.pcd", content), HasSubstr("would grow to 72000000 bytes"));
}

}  // namespace
}  // namespace ridgeline::io
