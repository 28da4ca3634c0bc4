// SPDX-License-Identifier: BSD-3-Clause
#include "tests/io/laz/copc_builder.h"

#include "io/cloud/laz/return_contexts.h"
#include "io/cloud/laz/running_median.h"
#include "tests/io/laz/arithmetic_encoder.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string_view>

namespace ridgeline::io::laz {
namespace {

constexpr std::size_t kRecordSize = 30;
constexpr std::size_t kCopcHeaderSize = 375;
constexpr std::size_t kCopcVlrHeaderSize = 54;
constexpr std::size_t kEvlrHeaderSize = 60;
constexpr std::size_t kInfoSize = 160;
constexpr std::size_t kEntrySize = 32;
constexpr double kScale = 0.01;

FileBytes raw_record(const CopcPoint& point) {
  FileBytes record(kRecordSize);
  for (std::size_t axis = 0; axis < 3; ++axis) put(record, 4 * axis, point.x[axis]);
  put(record, 14, std::uint8_t{0x11});  // return 1 of 1
  put(record, 16, point.classification);
  return record;
}

std::int32_t step(std::int32_t from, std::int32_t to) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(to) -
                                   static_cast<std::uint32_t>(from));
}

std::uint64_t hash(const CopcPoint& point) {
  std::uint64_t h = 0;
  for (const std::int32_t c : point.x) {
    h = (h ^ static_cast<std::uint32_t>(c)) * 0x9e3779b97f4a7c15ULL;
    h ^= h >> 29U;
  }
  return h;
}

/// The cube around all points.
struct Cube {
  std::array<std::int64_t, 3> low{};
  std::int64_t size = 1;
};

Cube cube_of(std::span<const CopcPoint> points) {
  Cube cube;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::ranges::minmax(points, {}, [axis](const CopcPoint& point) { return point.x[axis]; });
    cube.low[axis] = low.x[axis];
    cube.size = std::max(cube.size, std::int64_t{high.x[axis]} - low.x[axis] + 1);
  }
  return cube;
}

using NodeKey = std::array<std::int32_t, 4>;  // level, x, y, z

NodeKey node_of(const CopcPoint& point, const Cube& cube, int n_levels) {
  // Level l has 4^l of the 4^0 + 4^1 + ... shares.
  const auto n_shares = ((std::uint64_t{1} << (2 * n_levels)) - 1) / 3;
  std::uint64_t share = hash(point) % n_shares;
  int level = 0;
  for (; share >= (std::uint64_t{1} << (2 * level)); ++level)
    share -= std::uint64_t{1} << (2 * level);
  NodeKey key{level};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    key[axis + 1] =
        static_cast<std::int32_t>(((point.x[axis] - cube.low[axis]) << level) / cube.size);
  }
  return key;
}

struct BuiltNode {
  NodeKey key;
  FileBytes bytes;
  std::uint32_t n_points;
};

std::vector<BuiltNode> nodes_of(std::span<const CopcPoint> points, const Cube& cube, int n_levels) {
  std::map<NodeKey, std::vector<CopcPoint>> by_node;
  for (const CopcPoint& point : points) by_node[node_of(point, cube, n_levels)].push_back(point);
  std::vector<BuiltNode> nodes;
  nodes.reserve(by_node.size());
  for (const auto& [key, own] : by_node) {
    nodes.push_back({key, encode_layered_chunk(own), static_cast<std::uint32_t>(own.size())});
  }
  return nodes;
}

void append_entry(FileBytes& page,
                  const NodeKey& key,
                  std::uint64_t offset,
                  std::uint32_t n_bytes,
                  std::int32_t n_points) {
  for (const std::int32_t part : key) append(page, part);
  append(page, offset);
  append(page, n_bytes);
  append(page, n_points);
}

/// The pages one after another. Each page except the last ends in an entry for the next.
FileBytes hierarchy(std::span<const BuiltNode> nodes,
                    std::uint64_t first_chunk,
                    std::uint64_t first_page,
                    std::size_t entries_per_page,
                    std::uint64_t& root_bytes) {
  FileBytes pages;
  std::uint64_t offset = first_chunk;
  for (std::size_t begin = 0; begin < nodes.size(); begin += entries_per_page) {
    const std::size_t end = std::min(begin + entries_per_page, nodes.size());
    for (const BuiltNode& node : nodes.subspan(begin, end - begin)) {
      const auto n_bytes = static_cast<std::uint32_t>(node.bytes.size());
      append_entry(pages, node.key, offset, n_bytes, static_cast<std::int32_t>(node.n_points));
      offset += n_bytes;
    }
    if (end < nodes.size()) {
      const std::size_t n_next = std::min(entries_per_page, nodes.size() - end);
      const bool has_link = end + n_next < nodes.size();
      append_entry(pages, nodes[end].key, first_page + pages.size() + kEntrySize,
                   static_cast<std::uint32_t>((n_next + (has_link ? 1 : 0)) * kEntrySize), -1);
    }
    if (begin == 0) root_bytes = pages.size();
  }
  return pages;
}

void append_vlr_header(FileBytes& file,
                       std::string_view user,
                       std::uint16_t id,
                       std::uint16_t size) {
  const std::size_t vlr = file.size();
  file.resize(vlr + kCopcVlrHeaderSize);
  put_text(file, vlr + 2, user);
  put(file, vlr + 18, id);
  put(file, vlr + 20, size);
}

FileBytes start_of_file(std::span<const CopcPoint> points, const Cube& cube, int n_levels) {
  FileBytes file(kCopcHeaderSize);
  put_text(file, 0, "LASF");
  put(file, 24, std::uint8_t{1});
  put(file, 25, std::uint8_t{4});
  put(file, 94, static_cast<std::uint16_t>(kCopcHeaderSize));
  put(file, 100, std::uint32_t{2});
  put(file, 104, std::uint8_t{0x80 | 6});
  put(file, 105, static_cast<std::uint16_t>(kRecordSize));
  put(file, 247, static_cast<std::uint64_t>(points.size()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::ranges::minmax(points, {}, [axis](const CopcPoint& point) { return point.x[axis]; });
    put(file, 131 + 8 * axis, kScale);
    put(file, 179 + 16 * axis, kScale * high.x[axis]);
    put(file, 187 + 16 * axis, kScale * low.x[axis]);
  }
  append_vlr_header(file, "copc", 1, kInfoSize);
  const double half_size = 0.5 * kScale * static_cast<double>(cube.size);
  for (const std::int64_t low : cube.low)
    append(file, kScale * static_cast<double>(low) + half_size);
  append(file, half_size);
  append(file, 2.0 * half_size / (1 << n_levels));  // the root's spacing
  file.resize(kCopcHeaderSize + kCopcVlrHeaderSize + kInfoSize);
  append_vlr_header(file, "laszip encoded", 22204, 40);
  append(file, std::uint16_t{3});  // layered
  append(file, std::uint16_t{0});
  append(file, std::uint32_t{0x00000304});  // version 3.4
  append(file, std::uint32_t{0});
  append(file, LaszipRecord::kVariableChunkSize);
  append(file, std::int64_t{-1});
  append(file, std::int64_t{-1});
  append(file, std::uint16_t{1});
  append(file, static_cast<std::uint16_t>(ItemType::kPoint14));
  append(file, static_cast<std::uint16_t>(kRecordSize));
  append(file, std::uint16_t{3});
  put(file, 96, static_cast<std::uint32_t>(file.size()));
  return file;
}

}  // namespace

FileBytes encode_layered_chunk(std::span<const CopcPoint> points) {
  constexpr std::size_t kLayers = 9;
  std::array<ArithmeticEncoder, 3> layers;  // x and y, z, class; the other layers never change
  auto& [xy, z, classes] = layers;
  SymbolModel changed(128);
  IntegerCompressor dx(32, 2);
  IntegerCompressor dy(32, 22);
  IntegerCompressor heights(32, 20);
  std::vector<SymbolModel> class_models(64, SymbolModel(256));
  RunningMedian median_dx;
  RunningMedian median_dy;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const CopcPoint& last = points[i - 1];
    const CopcPoint& point = points[i];
    xy.encode_symbol(changed, 0);
    const std::int32_t x_step = step(last.x[0], point.x[0]);
    dx.encode(xy, median_dx.get(), x_step, 1);
    median_dx.add(x_step);
    const std::int32_t y_step = step(last.x[1], point.x[1]);
    dy.encode(xy, median_dy.get(), y_step, 1 + even_part(dx.last_bit_count(), 20));
    median_dy.add(y_step);
    const unsigned mean_bits = (dx.last_bit_count() + dy.last_bit_count()) / 2;
    heights.encode(z, last.x[2], point.x[2], 1 + even_part(mean_bits, 18));
    classes.encode_symbol(class_models[2 * (last.classification & 0x1FU) + 1],
                          point.classification);
  }
  FileBytes chunk = raw_record(points.front());
  append(chunk, static_cast<std::uint32_t>(points.size()));
  std::array<FileBytes, kLayers> bytes;
  for (std::size_t i = 0; i < layers.size(); ++i) bytes[i] = layers[i].finish();
  for (const FileBytes& layer : bytes) append(chunk, static_cast<std::uint32_t>(layer.size()));
  for (const FileBytes& layer : bytes) chunk.insert(chunk.end(), layer.begin(), layer.end());
  return chunk;
}

FileBytes CopcBuilder::build(std::span<const CopcPoint> points) const {
  const Cube cube = cube_of(points);
  FileBytes file = start_of_file(points, cube, n_levels);
  const std::vector<BuiltNode> nodes = nodes_of(points, cube, n_levels);
  const std::size_t point_offset = file.size();
  append(file, std::int64_t{0});
  const std::uint64_t first_chunk = file.size();
  std::vector<ChunkSize> sizes;
  sizes.reserve(nodes.size());
  for (const BuiltNode& node : nodes) {
    sizes.push_back({node.n_points, static_cast<std::uint32_t>(node.bytes.size())});
    file.insert(file.end(), node.bytes.begin(), node.bytes.end());
  }
  put(file, point_offset, static_cast<std::int64_t>(file.size()));
  const FileBytes table = encode_chunk_table(sizes, true);
  file.insert(file.end(), table.begin(), table.end());

  const std::size_t evlr = file.size();
  put(file, 235, static_cast<std::uint64_t>(evlr));
  put(file, 243, std::uint32_t{1});
  file.resize(evlr + kEvlrHeaderSize);
  std::uint64_t root_bytes = 0;
  const FileBytes pages = hierarchy(nodes, first_chunk, file.size(), entries_per_page, root_bytes);
  put_text(file, evlr + 2, "copc");
  put(file, evlr + 18, std::uint16_t{1000});
  put(file, evlr + 20, static_cast<std::uint64_t>(pages.size()));
  put(file, kCopcHeaderSize + kCopcVlrHeaderSize + 40, static_cast<std::uint64_t>(file.size()));
  put(file, kCopcHeaderSize + kCopcVlrHeaderSize + 48, root_bytes);
  file.insert(file.end(), pages.begin(), pages.end());
  return file;
}

}  // namespace ridgeline::io::laz
