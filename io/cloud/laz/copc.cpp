// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/copc.h"

#include "io/cloud/bytes.h"
#include "io/cloud/laz/codec_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ridgeline::io::laz {
namespace {

constexpr std::size_t kInfoSize = 160;
constexpr std::size_t kEntrySize = 32;
constexpr std::int32_t kChildPage = -1;

struct Page {
  std::uint64_t offset;
  std::uint64_t n_bytes;
};

Page root_page(std::span<const std::byte> info) {
  return {load<std::uint64_t>(&info[40]), load<std::uint64_t>(&info[48])};
}

CopcHierarchy read_info(std::span<const std::byte> info) {
  CopcHierarchy hierarchy;
  hierarchy.center = {load<double>(&info[0]), load<double>(&info[8]), load<double>(&info[16])};
  hierarchy.half_size = load<double>(&info[24]);
  hierarchy.spacing = load<double>(&info[32]);
  if (!hierarchy.center.allFinite() || !(hierarchy.half_size > 0.0) ||
      !std::isfinite(hierarchy.half_size) || !(hierarchy.spacing > 0.0) ||
      !std::isfinite(hierarchy.spacing)) {
    throw CodecError(fmt::format("COPC cube has half size {} and spacing {}; both must be above 0",
                                 hierarchy.half_size, hierarchy.spacing));
  }
  return hierarchy;
}

CopcNode read_node(const std::byte* entry, std::uint64_t file_size) {
  const CopcNode node{.level = load<std::int32_t>(entry),
                      .x = load<std::int32_t>(entry + 4),
                      .y = load<std::int32_t>(entry + 8),
                      .z = load<std::int32_t>(entry + 12),
                      .offset = load<std::uint64_t>(entry + 16),
                      .n_points = load<std::int32_t>(entry + 28)};
  const auto is_cell = [&](std::int32_t index) {
    return index >= 0 && index < (std::int32_t{1} << node.level);
  };
  if (node.level < 0 || node.level > kMaxCopcLevel || !is_cell(node.x) || !is_cell(node.y) ||
      !is_cell(node.z) || node.n_points < kChildPage || node.offset > file_size) {
    throw CodecError(fmt::format("COPC node {}-{}-{}-{} with {} points at byte {} cannot exist",
                                 node.level, node.x, node.y, node.z, node.n_points, node.offset));
  }
  return node;
}

// Every page is read once, and all pages together are no longer than the file, so reading
// terminates even if the hierarchy refers to itself or its pages overlap.
std::vector<CopcNode> read_pages(std::span<const std::byte> file, Page root) {
  std::vector<CopcNode> nodes;
  std::uint64_t n_left = file.size();
  std::vector<Page> pages{root};
  std::set<std::uint64_t> seen{root.offset};
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const auto [offset, n_bytes] = pages[i];
    if (offset > file.size() || n_bytes > file.size() - offset || n_bytes % kEntrySize != 0) {
      throw CodecError(fmt::format("COPC page at byte {} should have {} bytes of {}", offset,
                                   n_bytes, file.size()));
    }
    if (n_bytes > n_left) throw CodecError("COPC pages overlap");
    n_left -= n_bytes;
    for (std::uint64_t at = offset; at < offset + n_bytes; at += kEntrySize) {
      const CopcNode node = read_node(&file[at], file.size());
      if (node.n_points > 0) nodes.push_back(node);
      if (node.n_points == kChildPage && seen.insert(node.offset).second) {
        pages.push_back({node.offset, load<std::uint32_t>(&file[at + 24])});
      }
    }
  }
  return nodes;
}

}  // namespace

std::optional<CopcHierarchy> read_copc_hierarchy(std::span<const std::byte> file,
                                                 const LasHeader& header) {
  const std::optional<LasVlr> vlr = find_vlr(header, "copc", 1);
  if (!vlr) return std::nullopt;
  if (vlr->data_size < kInfoSize) {
    throw CodecError(fmt::format("COPC record at byte {} has {} bytes; must have {}",
                                 vlr->data_offset, vlr->data_size, kInfoSize));
  }
  const std::span<const std::byte> info = file.subspan(vlr->data_offset, kInfoSize);
  CopcHierarchy hierarchy = read_info(info);
  hierarchy.nodes = read_pages(file, root_page(info));
  return hierarchy;
}

Eigen::AlignedBox3d node_cube(const CopcHierarchy& hierarchy, const CopcNode& node) {
  const double size = 2.0 * hierarchy.half_size / std::exp2(node.level);
  const Eigen::Vector3d root_min = hierarchy.center.array() - hierarchy.half_size;
  const Eigen::Vector3d min = root_min + size * Eigen::Vector3d(node.x, node.y, node.z);
  return {min, Eigen::Vector3d(min.array() + size)};
}

int level_of_resolution(const CopcHierarchy& hierarchy, double resolution) {
  const double level = std::ceil(std::log2(hierarchy.spacing / resolution));
  return static_cast<int>(std::clamp(level, 0.0, static_cast<double>(kMaxCopcLevel)));
}

}  // namespace ridgeline::io::laz
