// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/copc.h"

#include "io/cloud/bytes.h"
#include "io/cloud/laz/codec_error.h"
#include "io/cloud/laz/laz_points.h"
#include "tests/io/laz/copc_builder.h"
#include "tests/io/laz/laz_builder.h"
#include "tests/io/laz/laz_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

namespace ridgeline::io::laz {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kCopcFiles[] = {"las_samples/laspy_simple.copc.laz",
                                      "las_samples/lasrs_autzen.copc.laz"};

TEST(ReadCopcHierarchy, IsUnsetForAPlainFile) {
  const FileBytes file = LazBuilder().build();
  EXPECT_FALSE(read_copc_hierarchy(file, parse_las_header(file, "test.laz")));
}

TEST(ReadCopcHierarchy, ListsEveryChunkOnceWithItsPoints) {
  for (const char* name : kCopcFiles) {
    RIDGELINE_NEED_SHARED_FILE(name);
    const FileBytes file = read_file(shared_file(name));
    const LasHeader header = parse_las_header(file, name);
    const LazPoints points(file, header, name);
    const auto hierarchy = read_copc_hierarchy(file, header);
    ASSERT_TRUE(hierarchy) << name;
    std::set<std::pair<std::uint64_t, std::uint64_t>> nodes;
    std::set<std::pair<std::uint64_t, std::uint64_t>> chunks;
    for (const CopcNode& node : hierarchy->nodes) nodes.emplace(node.offset, node.n_points);
    for (const Chunk& chunk : points.chunks()) chunks.emplace(chunk.offset, chunk.n_points);
    EXPECT_EQ(nodes, chunks) << name;
  }
}

TEST(NodeCube, HoldsThePointsOfTheNode) {
  for (const char* name : kCopcFiles) {
    RIDGELINE_NEED_SHARED_FILE(name);
    const FileBytes file = read_file(shared_file(name));
    const LasHeader header = parse_las_header(file, name);
    const LazPoints points(file, header, name);
    const auto hierarchy = read_copc_hierarchy(file, header);
    ASSERT_TRUE(hierarchy);
    const double tolerance = header.scale.maxCoeff();  // coordinates are rounded to the scale
    for (std::size_t block = 0; block < points.n_blocks(); ++block) {
      const auto node =
          std::ranges::find(hierarchy->nodes, points.chunks()[block].offset, &CopcNode::offset);
      ASSERT_NE(node, hierarchy->nodes.end());
      const Eigen::AlignedBox3d cube = node_cube(*hierarchy, *node);
      points.decode(
          block, RecordParts::kCloudPoint, [&](std::span<const std::byte> records, std::size_t) {
            for (std::size_t at = 0; at < records.size(); at += header.record_length) {
              Eigen::Vector3d raw;
              for (int axis = 0; axis < 3; ++axis) {
                raw[axis] = load<std::int32_t>(&records[at + 4 * axis]);
              }
              const Eigen::Vector3d point = raw.cwiseProduct(header.scale) + header.offset;
              EXPECT_LE(cube.exteriorDistance(point), tolerance) << name;
            }
          });
    }
  }
}

TEST(LevelOfResolution, HalvesTheSpacingPerLevel) {
  CopcHierarchy hierarchy;
  hierarchy.spacing = 8.0;
  EXPECT_EQ(level_of_resolution(hierarchy, 100.0), 0);
  EXPECT_EQ(level_of_resolution(hierarchy, 8.0), 0);
  EXPECT_EQ(level_of_resolution(hierarchy, 7.9), 1);
  EXPECT_EQ(level_of_resolution(hierarchy, 1.0), 3);
  EXPECT_EQ(level_of_resolution(hierarchy, 1e-300), 30);
}

TEST(ReadCopcHierarchy, RefusesDamage) {
  RIDGELINE_NEED_SHARED_FILE(kCopcFiles[0]);
  struct Case {
    void (*change)(FileBytes& file, std::size_t info, std::size_t page);
    const char* message;
  };
  const FileBytes file = read_file(shared_file(kCopcFiles[0]));
  const LasHeader header = parse_las_header(file, "test.laz");
  const std::size_t info = find_vlr(header, "copc", 1)->data_offset;
  const auto page = load<std::uint64_t>(&file[info + 40]);
  for (const auto& [change, message] : {
           Case{[](FileBytes&f, std::size_t i, std::size_t) { put(f, i + 24, -1.0); },
                "half size -1"},
           Case{[](FileBytes&f, std::size_t i, std::size_t) { put(f, i + 40, ~std::uint64_t{0}); },
                "COPC page at byte 18446744073709551615"},
           Case{[](FileBytes&f, std::size_t i, std::size_t) { put(f, i + 48, std::uint64_t{33}); },
                "should have 33 bytes"},
           Case{[](FileBytes&f, std::size_t, std::size_t p) { put(f, p, 40); }, "COPC node 40-"},
           Case{[](FileBytes&f, std::size_t, std::size_t p) { put(f, p + 28, -2); },
                "with -2 points"},
       }) {
    FileBytes damaged = file;
    change(damaged, info, page);
    EXPECT_THAT([&] { read_copc_hierarchy(damaged, header); },
                ThrowsMessage<CodecError>(HasSubstr(message)));
  }
}

std::vector<CopcPoint> random_points(std::size_t n) {
  std::mt19937 rng(5);
  std::vector<CopcPoint> points(n);
  for (CopcPoint& point : points) {
    for (std::int32_t& x : point.x) x = static_cast<std::int32_t>(rng() % 100000);
    point.classification = static_cast<std::uint8_t>(rng() % 20);
  }
  return points;
}

TEST(CopcBuilder, WritesFilesWithEveryPointOnceInTheCubeOfItsNode) {
  const std::vector<CopcPoint> points = random_points(5000);
  const FileBytes file = CopcBuilder{.n_levels = 4, .entries_per_page = 10}.build(points);
  const LasHeader header = parse_las_header(file, "test.laz");
  const auto hierarchy = read_copc_hierarchy(file, header);
  ASSERT_TRUE(hierarchy);
  using Stored = std::array<std::int32_t, 4>;
  std::multiset<Stored> expected;
  for (const CopcPoint& p : points) expected.insert({p.x[0], p.x[1], p.x[2], p.classification});
  const LazPoints records(file, header, "test.laz");
  std::multiset<Stored> found;
  for (std::size_t block = 0; block < records.n_blocks(); ++block) {
    const auto node =
        std::ranges::find(hierarchy->nodes, records.chunks()[block].offset, &CopcNode::offset);
    ASSERT_NE(node, hierarchy->nodes.end());
    const Eigen::AlignedBox3d cube = node_cube(*hierarchy, *node);
    records.decode(block, RecordParts::kAll, [&](std::span<const std::byte> bytes, std::size_t) {
      for (std::size_t at = 0; at < bytes.size(); at += header.record_length) {
        const Stored p{load<std::int32_t>(&bytes[at]), load<std::int32_t>(&bytes[at + 4]),
                       load<std::int32_t>(&bytes[at + 8]), load<std::uint8_t>(&bytes[at + 16])};
        found.insert(p);
        EXPECT_LE(cube.exteriorDistance(0.01 * Eigen::Vector3d(p[0], p[1], p[2])), 0.01);
      }
    });
  }
  EXPECT_EQ(found, expected);
}

TEST(ReadCopcHierarchy, RefusesPagesWithinEachOther) {
  // Each entry of the root names a page of its own that begins a byte further: read one by one, the
  // pages would be as many times the file as there are entries.
  FileBytes file = CopcBuilder{.n_levels = 4}.build(random_points(2000));
  const LasHeader header = parse_las_header(file, "test.laz");
  const std::size_t info = find_vlr(header, "copc", 1)->data_offset;
  const auto page = load<std::uint64_t>(&file[info + 40]);
  const auto page_bytes = load<std::uint64_t>(&file[info + 48]);
  for (std::uint64_t entry = page; entry < page + page_bytes; entry += 32) {
    put(file, entry + 16, page + (entry - page) / 32 * 32);
    put(file, entry + 24, static_cast<std::uint32_t>(page_bytes - (entry - page)));
    put(file, entry + 28, -1);
  }
  EXPECT_THAT([&] { read_copc_hierarchy(file, header); },
              ThrowsMessage<CodecError>(HasSubstr("overlap")));
}

TEST(ReadCopcHierarchy, EndsForAPageThatRefersToItself) {
  RIDGELINE_NEED_SHARED_FILE(kCopcFiles[0]);
  FileBytes file = read_file(shared_file(kCopcFiles[0]));
  const LasHeader header = parse_las_header(file, "test.laz");
  const std::size_t info = find_vlr(header, "copc", 1)->data_offset;
  const auto page = load<std::uint64_t>(&file[info + 40]);
  put(file, page + 16, page);  // the first entry names this page as its child page
  put(file, page + 28, -1);
  EXPECT_TRUE(read_copc_hierarchy(file, header));
}

}  // namespace
}  // namespace ridgeline::io::laz
