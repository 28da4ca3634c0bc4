// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/laszip_record.h"

#include "io/error.h"
#include "tests/io/laz/laz_builder.h"
#include "tests/io/laz/laz_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ridgeline::io::laz {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

LaszipRecord record_of(const FileBytes& file) {
  return read_laszip_record(file, parse_las_header(file, "test.laz"), "test.laz");
}

TEST(ReadLaszipRecord, ReadsItemsAndChunkSize) {
  LazBuilder builder;
  builder.chunk_size = 50'000;
  const LaszipRecord laszip = record_of(builder.build());
  EXPECT_EQ(laszip.compressor, Compressor::kPointwiseChunked);
  EXPECT_EQ(laszip.chunk_size, 50'000U);
  EXPECT_FALSE(laszip.has_variable_chunks());
  ASSERT_EQ(laszip.items.size(), 1U);
  EXPECT_EQ(laszip.items[0].type, ItemType::kPoint10);
  EXPECT_EQ(laszip.items[0].version, 2);
}

TEST(ReadLaszipRecord, RefusesWhatItDoesNotKnowByName) {
  struct Case {
    void (*change)(LazBuilder&);
    const char* message;
  };
  for (const auto& [change, message] : {
           Case{[](LazBuilder& b) { b.compressor = 16; }, "LASzip compressor is 16; must be 1"},
           Case{[](LazBuilder& b) { b.compressor = 0; }, "LASzip compressor is 0; must be 1"},
           Case{[](LazBuilder& b) { b.coder = 15; }, "LASzip coder is 15; must be 0 (arithmetic)"},
           Case{[](LazBuilder& b) { b.items[0].type = static_cast<ItemType>(22); },
                "LASzip item 1 has type 22; must be 0 or 6 to 14"},
           Case{[](LazBuilder& b) { b.items[0].version = 6; },
                "LASzip item POINT10 has version 6; supported are 1 to 2"},
           Case{[](LazBuilder& b) { b.items[0].size = 21; },
                "LASzip item POINT10 has size 21; must be 20"},
           Case{[](LazBuilder& b) {
                  b.items.push_back({ItemType::kByte, 0, 2});
                },
                "LASzip item BYTE has size 0; must be above 0"},
           Case{[](LazBuilder& b) {
                  b.items.push_back({ItemType::kByte, 8193, 2});
                },
                "LASzip item BYTE has size 8193; at most 8192 extra bytes"},
           Case{[](LazBuilder& b) {
                  b.items.push_back({ItemType::kRgb12, 6, 2});
                },
                "LASzip items are POINT10 RGB12 (26 bytes); they must match point format 0 (20 "
                "bytes)"},
           Case{[](LazBuilder& b) { b.items.clear(); }, "LASzip items are  (0 bytes)"},
           Case{[](LazBuilder& b) { b.compressor = 3; },
                "LASzip compressor 3 cannot hold point format 0"},
           Case{[](LazBuilder& b) { b.chunk_size = 0; }, "LASzip chunk size is 0"},
       }) {
    LazBuilder builder;
    change(builder);
    EXPECT_THAT([&] { record_of(builder.build()); },
                ThrowsMessage<IoError>(HasSubstr(std::string("test.laz: ") + message)));
  }
}

TEST(ReadLaszipRecord, RefusesAFileWithoutTheRecord) {
  FileBytes file = LazBuilder().build();
  put(file, 227 + 2, 'X');
  EXPECT_THAT([&] { record_of(file); }, ThrowsMessage<IoError>(HasSubstr("but the LASzip record")));
}

TEST(ReadLaszipRecord, RefusesARecordThatIsTooShort) {
  FileBytes file = LazBuilder().build();
  put(file, 227 + 20, std::uint16_t{33});
  EXPECT_THAT([&] { record_of(file); }, ThrowsMessage<IoError>(HasSubstr("must have at least 34")));
  put(file, 227 + 20, std::uint16_t{39});
  EXPECT_THAT([&] { record_of(file); },
              ThrowsMessage<IoError>(HasSubstr("must have 40 for 1 items")));
}

TEST(ReadLaszipRecord, RefusesTheBrokenFilesOfLaszip) {
  RIDGELINE_NEED_SHARED_FILE("las_samples/laszip_broken_coder.laz");
  EXPECT_THAT([&] { record_of(read_file(shared_file("las_samples/laszip_broken_coder.laz"))); },
              ThrowsMessage<IoError>(HasSubstr("LASzip coder is 15")));
  EXPECT_THAT([&] { record_of(read_file(shared_file("las_samples/laszip_broken_size.laz"))); },
              ThrowsMessage<IoError>(HasSubstr("LASzip item POINT10 has version 6")));
}

}  // namespace
}  // namespace ridgeline::io::laz
