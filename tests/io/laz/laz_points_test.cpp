// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/laz_points.h"

#include "io/cloud/bytes.h"
#include "io/cloud/laz/sequential_records.h"
#include "io/error.h"
#include "tests/io/laz/laz_builder.h"
#include "tests/io/laz/laz_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace ridgeline::io::laz {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

// Byte of the first difference, for a message shorter than two dumps.
std::size_t first_difference(const FileBytes& a, const FileBytes& b) {
  return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

class LazPair : public testing::TestWithParam<const char*> {};

TEST_P(LazPair, DecodesToTheRecordsOfTheLas) {
  const std::string name = GetParam();
  RIDGELINE_NEED_SHARED_FILE(name + ".laz");
  const FileBytes expected = las_records(read_file(shared_file(name + ".las")));
  const DecodedFile actual = decode_laz(read_file(shared_file(name + ".laz")));
  EXPECT_THAT(actual.warnings, IsEmpty());
  ASSERT_EQ(actual.records.size(), expected.size());
  EXPECT_EQ(first_difference(actual.records, expected), expected.size());
}

INSTANTIATE_TEST_SUITE_P(SharedSamples,
                         LazPair,
                         testing::Values("las_samples/lazperf_point10-1.0",
                                         "las_samples/lazrs_point-time",
                                         "las_samples/laspy_simple",
                                         "las_samples/loadersgl_pdrf4-1.3",
                                         "las_samples/laspy_1_4_w_evlr",
                                         "las_samples/loadersgl_pdrf7-v4-1.4",
                                         "las_samples/loadersgl_pdrf8-1.4",
                                         "las_samples/loadersgl_pdrf10-1.4",
                                         "ign/test_data_77060_627760_LA93_IGN69"),
                         [](const auto& pair) {
                           std::string name = std::strchr(pair.param, '/') + 1;
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

std::int32_t coordinate(const FileBytes& records,
                        std::size_t record,
                        std::size_t length,
                        int axis) {
  return load<std::int32_t>(&records[record * length + 4 * static_cast<std::size_t>(axis)]);
}

TEST(LazPoints, DecodesChunksOfOnePoint) {
  LazBuilder builder;
  for (std::int32_t i = 0; i < 300; ++i) builder.add_single_point(i, -i, 1 << (i % 31));
  const DecodedFile decoded = decode_laz(builder.build());
  ASSERT_EQ(decoded.records.size(), 300U * 20U);
  for (std::size_t i = 0; i < 300; ++i) {
    EXPECT_EQ(coordinate(decoded.records, i, 20, 0), static_cast<std::int32_t>(i));
    EXPECT_EQ(coordinate(decoded.records, i, 20, 1), -static_cast<std::int32_t>(i));
  }
}

TEST(LazPoints, AcceptsAFileWithoutPoints) {
  for (const std::uint16_t compressor : {std::uint16_t{1}, std::uint16_t{2}}) {
    LazBuilder builder;
    builder.compressor = compressor;
    const DecodedFile decoded = decode_laz(builder.build());
    EXPECT_THAT(decoded.records, IsEmpty());
    EXPECT_THAT(decoded.warnings, IsEmpty());
  }
}

// The file without chunks (compressor 1) that holds the stream of a file of one chunk.
FileBytes without_chunks(const FileBytes& chunked) {
  const LasHeader header = parse_las_header(chunked, "test.laz");
  FileBytes file = chunked;
  const auto offset = file.begin() + static_cast<std::ptrdiff_t>(header.point_offset);
  file.erase(offset, offset + 8);
  put(file, find_vlr(header, "laszip encoded", 22204)->data_offset, std::uint16_t{1});
  return file;
}

TEST(LazPoints, DecodesAFileWithoutChunks) {
  RIDGELINE_NEED_SHARED_FILE("las_samples/laspy_simple.laz");
  const FileBytes chunked = read_file(shared_file("las_samples/laspy_simple.laz"));
  const DecodedFile decoded = decode_laz(without_chunks(chunked));
  EXPECT_EQ(decoded.records, decode_laz(chunked).records);
  EXPECT_THAT(decoded.warnings, IsEmpty());
}

TEST(SequentialRecords, HandsOutBlocksInAnyOrder) {
  constexpr std::uint32_t kBlockSize = 10;
  constexpr std::uint32_t kPoints = 40 * kBlockSize + 5;  // more blocks than are kept
  LazBuilder builder;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    builder.add_single_point(static_cast<std::int32_t>(i), 0, 0);
  }
  const FileBytes file = builder.build();
  const LasHeader header = parse_las_header(file, "test.laz");
  const std::span<const std::byte> bytes = file;
  SequentialRecords records(bytes.subspan(header.point_offset + 8),
                            read_laszip_record(file, header, "test.laz"), kPoints, "test.laz",
                            kBlockSize);
  ASSERT_EQ(records.n_blocks(), 41U);
  EXPECT_EQ(records.n_records(40), 5U);
  for (const std::size_t block : {0U, 40U, 38U, 1U, 40U, 0U, 0U}) {
    const FileBytes decoded = records.block(block);
    EXPECT_EQ(load<std::uint32_t>(decoded.data()), block * kBlockSize);
    EXPECT_EQ(decoded.size(), records.n_records(block) * 20);
  }
}

TEST(SequentialRecords, MeetsADamageAgain) {
  LazBuilder builder;
  for (std::int32_t i = 0; i < 3; ++i) builder.add_single_point(i, 0, 0);
  const FileBytes file = builder.build();
  const LasHeader header = parse_las_header(file, "test.laz");
  const std::span<const std::byte> bytes = file;
  const auto two_chunks = bytes.subspan(header.point_offset + 8, 2 * 24);
  SequentialRecords records(two_chunks, read_laszip_record(file, header, "test.laz"), 3, "test.laz",
                            1);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(records.block(1).size(), 20U);
    EXPECT_THAT([&] { records.block(2); },
                ThrowsMessage<IoError>(HasSubstr("chunk 2, point 0 cannot be decoded")));
  }
}

TEST(LazPoints, ReadsItemsOfVersion1) {
  // A real stream of version 1, cut after about 90 points, under a header whose coder was made 15.
  RIDGELINE_NEED_SHARED_FILE("las_samples/laszip_broken_coder.laz");
  FileBytes file = read_file(shared_file("las_samples/laszip_broken_coder.laz"));
  const LasHeader header = parse_las_header(file, "test.laz");
  put(file, find_vlr(header, "laszip encoded", 22204)->data_offset + 2, std::uint16_t{0});
  put(file, 107, std::uint32_t{80});
  const DecodedFile decoded = decode_laz(file);
  double last_time = 0.0;
  for (std::size_t i = 0; i < 80; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double value =
          coordinate(decoded.records, i, 28, axis) * header.scale[axis] + header.offset[axis];
      EXPECT_GE(value, header.stated_min[axis]) << i;
      EXPECT_LE(value, header.stated_max[axis]) << i;
    }
    const auto time = load<double>(&decoded.records[i * 28 + 20]);
    EXPECT_GE(time, last_time) << i;
    last_time = time;
  }
}

TEST(LazPoints, DecodesThePartsOfACloudPointAloneToTheSameValues) {
  constexpr std::size_t kLength = 38;
  RIDGELINE_NEED_SHARED_FILE("ign/test_data_77060_627760_LA93_IGN69.laz");
  const FileBytes file = read_file(shared_file("ign/test_data_77060_627760_LA93_IGN69.laz"));
  const FileBytes all = decode_laz(file).records;
  const FileBytes parts = decode_laz(file, RecordParts::kCloudPoint).records;
  ASSERT_EQ(parts.size(), all.size());
  const auto equal = [&](std::size_t begin, std::size_t end) {
    return std::memcmp(&parts[begin], &all[begin], end - begin) == 0;
  };
  for (std::size_t at = 0; at < all.size(); at += kLength) {
    // X, Y, Z, intensity, returns, flags and class, then the source.
    ASSERT_TRUE(equal(at, at + 17) && equal(at + 20, at + 22)) << "record " << at / kLength;
  }
}

TEST(LazPoints, NamesChunkAndPointOfADamage) {
  LazBuilder builder;
  builder.chunk_size = 10;
  for (int i = 0; i < 2; ++i) builder.add_single_point(1, 2, 3);
  builder.n_points = 12;
  // Zeros decode to points that repeat the first, until the four bytes of the chunk are used up.
  EXPECT_THAT([&] { decode_laz(builder.build()); },
              ThrowsMessage<IoError>(HasSubstr("test.laz: chunk 0, point 1 cannot be decoded: ")));
}

TEST(LazPoints, RefusesACountThatNoStreamCanHold) {
  LazBuilder builder;
  builder.compressor = 1;
  builder.add_single_point(1, 2, 3);
  builder.n_points = 4'000'000'000;
  EXPECT_THAT([&] { decode_laz(builder.build()); },
              ThrowsMessage<IoError>(HasSubstr("the header has 4000000000 points")));
}

}  // namespace
}  // namespace ridgeline::io::laz
