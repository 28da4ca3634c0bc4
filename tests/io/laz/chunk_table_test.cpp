// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/chunk_table.h"

#include "io/cloud/laz/codec_error.h"
#include "io/error.h"
#include "tests/io/laz/laz_builder.h"
#include "tests/io/laz/laz_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ridgeline::io::laz {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

LazBuilder three_points() {
  LazBuilder builder;
  for (std::int32_t i = 0; i < 3; ++i) builder.add_single_point(i, i, i);
  return builder;
}

std::vector<Chunk> chunks_of(const FileBytes& file) {
  const LasHeader header = parse_las_header(file, "test.laz");
  return read_chunk_table(file, header, read_laszip_record(file, header, "test.laz"));
}

std::uint32_t point_offset(const FileBytes& file) {
  return parse_las_header(file, "test.laz").point_offset;
}

TEST(ReadChunkTable, GivesWhereEachChunkLies) {
  for (const std::uint32_t chunk_size : {1U, LaszipRecord::kVariableChunkSize}) {
    LazBuilder builder = three_points();
    builder.chunk_size = chunk_size;
    const FileBytes file = builder.build();
    const std::vector<Chunk> chunks = chunks_of(file);
    ASSERT_EQ(chunks.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(chunks[i].offset, point_offset(file) + 8 + 24 * i);
      EXPECT_EQ(chunks[i].n_bytes, 24U);
      EXPECT_EQ(chunks[i].first_record, i);
      EXPECT_EQ(chunks[i].n_points, 1U);
    }
  }
}

TEST(ReadChunkTable, LeavesTheRestToTheLastChunk) {
  LazBuilder builder = three_points();
  builder.chunk_size = 2;
  builder.chunks.pop_back();  // two chunks for 2 + 1 points
  const std::vector<Chunk> chunks = chunks_of(builder.build());
  ASSERT_EQ(chunks.size(), 2U);
  EXPECT_EQ(chunks[0].n_points, 2U);
  EXPECT_EQ(chunks[1].n_points, 1U);
}

TEST(ReadChunkTable, FindsTheTableThroughTheEndOfTheFile) {
  LazBuilder builder = three_points();
  builder.table = LazBuilder::Table::kAtEndOfFile;
  EXPECT_EQ(chunks_of(builder.build()).size(), 3U);
}

TEST(ReadChunkTable, RefusesTablesThatContradictTheFile) {
  struct Case {
    void (*change)(FileBytes& file, std::size_t table);
    const char* message;
  };
  for (const auto& [change, message] : {
           Case{[](FileBytes&f, std::size_t t) { put(f, t, 1U); }, "version 1, not 0"},
           Case{[](FileBytes&f, std::size_t t) { put(f, t + 4, 2U); }, "3 points in chunks of 1"},
           Case{[](FileBytes&f, std::size_t t) { put(f, t + 4, 4'000'000'000U); },
                "4000000000 chunks in 72 bytes"},
           Case{[](FileBytes&f, std::size_t t) { f.resize(t + 9); }, "bytes too short"},
           Case{[](FileBytes&f, std::size_t t) { put(f, t + 8, std::uint64_t{0x0123456789}); },
                "chunk 0 should have"},
           Case{[](FileBytes&f, std::size_t) { put(f, point_offset(f), std::int64_t{1} << 40); },
                "at byte 1099511627776"},
           Case{[](FileBytes&f, std::size_t) { put(f, point_offset(f), std::int64_t{-7}); },
                "at byte -7"},
       }) {
    FileBytes file = three_points().build();
    change(file, point_offset(file) + 8 + 3 * 24);
    EXPECT_THAT([&] { chunks_of(file); }, ThrowsMessage<CodecError>(HasSubstr(message)));
  }
}

TEST(ReadChunkTable, RefusesMorePointsThanAChunkMayHold) {
  LazBuilder builder = three_points();
  builder.chunk_size = LaszipRecord::kVariableChunkSize;
  builder.chunks[0].n_points = 2'000'001;
  builder.n_points = 2'000'003;
  EXPECT_THAT([&] { chunks_of(builder.build()); },
              ThrowsMessage<CodecError>(HasSubstr("chunk 0 should hold 2000001 points")));
}

TEST(ReadChunkTable, RefusesChunksThatDoNotHoldAllPoints) {
  LazBuilder builder = three_points();
  builder.chunk_size = LaszipRecord::kVariableChunkSize;
  builder.n_points = 4;
  EXPECT_THAT(
      [&] { chunks_of(builder.build()); },
      ThrowsMessage<CodecError>(HasSubstr("the chunks hold 3 points, but the header has 4")));
  builder.n_points = 2;
  EXPECT_THAT(
      [&] { chunks_of(builder.build()); },
      ThrowsMessage<CodecError>(HasSubstr("chunk 2 should hold 1 points, but only 0 are left")));
}

TEST(LostChunkTable, IsReplacedByDecodingInOrderIfChunksHaveOneSize) {
  const FileBytes expected = decode_laz(three_points().build()).records;
  for (const auto table : {LazBuilder::Table::kMissing, LazBuilder::Table::kZero}) {
    LazBuilder builder = three_points();
    builder.table = table;
    const DecodedFile decoded = decode_laz(builder.build());
    EXPECT_EQ(decoded.records, expected);
    EXPECT_THAT(decoded.warnings, ElementsAre(HasSubstr("did not store the chunk table")));
  }
}

TEST(LostChunkTable, IsAnErrorIfChunksVaryInSize) {
  LazBuilder builder = three_points();
  builder.chunk_size = LaszipRecord::kVariableChunkSize;
  builder.table = LazBuilder::Table::kMissing;
  EXPECT_THAT([&] { decode_laz(builder.build()); },
              ThrowsMessage<IoError>(HasSubstr("locate chunks of varying size")));
}

TEST(LostChunkTable, IsReplacedInRealFilesOfBothKinds) {
  for (const char* name :
       {"las_samples/loadersgl_pdrf4-1.3.laz", "las_samples/loadersgl_pdrf8-1.4.laz",
        "ign/test_data_77060_627760_LA93_IGN69.laz"}) {
    RIDGELINE_NEED_SHARED_FILE(name);
    FileBytes file = read_file(shared_file(name));
    const FileBytes expected = decode_laz(file).records;
    put(file, point_offset(file), std::int64_t{0});
    const DecodedFile decoded = decode_laz(file);
    EXPECT_TRUE(decoded.records == expected) << name;
    EXPECT_EQ(decoded.warnings.size(), 1U) << name;
  }
}

}  // namespace
}  // namespace ridgeline::io::laz
