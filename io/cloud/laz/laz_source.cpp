// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/laz_source.h"

#include "io/cloud/las_records.h"
#include "io/cloud/laz/codec_error.h"
#include "io/cloud/laz/copc.h"
#include "io/cloud/laz/laz_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

namespace ridgeline::io {
namespace {

// A block of the source: a block of the compressed records, and its cube if known.
struct LazBlock {
  std::size_t index;
  std::optional<Eigen::AlignedBox3d> box_in_file;
};

class LazSource final : public CloudSource {
 public:
  LazSource(MappedFile file,
            LasHeader header,
            laz::LazPoints records,
            std::vector<LazBlock> blocks,
            CloudFileInfo file_info)
      : CloudSource(std::move(file_info)),
        file_(std::move(file)),
        header_(std::move(header)),
        records_(std::move(records)),
        blocks_(std::move(blocks)) {}

  [[nodiscard]] std::size_t n_blocks() const override { return blocks_.size(); }

  [[nodiscard]] std::size_t max_block_points() const override {
    std::size_t most = 0;
    for (const LazBlock& block : blocks_) most = std::max(most, records_.n_points(block.index));
    return most;
  }

  [[nodiscard]] std::optional<BlockExtent> block_extent(std::size_t block) const override {
    const auto& [index, box] = blocks_[block];
    if (!box) return std::nullopt;
    return BlockExtent{.box_in_file = *box, .n_points = records_.n_points(index)};
  }

  /// Without a chunk table, a file is one stream whose decoded parts are kept, so it is not light.
  [[nodiscard]] bool is_light() const override {
    return !records_.chunks().empty() || blocks_.empty();
  }

  void release_blocks(std::size_t first, std::size_t count) const override {
    if (!is_light()) return;
    for (const LazBlock& block : std::span(blocks_).subspan(first, count)) {
      const laz::Chunk& chunk = records_.chunks()[block.index];
      MappedFile::release(file_.bytes().subspan(chunk.offset, chunk.n_bytes));
    }
  }

  void decode_block(std::size_t block,
                    const LocalFromFile& local_from_file,
                    std::vector<CloudPoint>& points) const override {
    const std::size_t index = blocks_[block].index;
    points.resize(records_.n_points(index));
    records_.decode(index, laz::RecordParts::kCloudPoint,
                    [&](std::span<const std::byte> records, std::size_t first) {
                      const std::size_t count = records.size() / header_.record_length;
                      decode_las_records(records, header_, local_from_file,
                                         std::span<CloudPoint>(points).subspan(first, count));
                    });
  }

 private:
  MappedFile file_;
  LasHeader header_;
  laz::LazPoints records_;  // refers to the bytes of file_
  std::vector<LazBlock> blocks_;
};

std::optional<laz::CopcHierarchy> read_hierarchy(const MappedFile& file,
                                                 const LasHeader& header,
                                                 CloudFileInfo& file_info) {
  try {
    return laz::read_copc_hierarchy(file.bytes(), header);
  } catch (const laz::CodecError& error) {
    file_info.warnings.push_back(
        fmt::format("hierarchy cannot be used: {}; all points are read", error.what()));
    return std::nullopt;
  }
}

std::vector<LazBlock> all_blocks(const laz::LazPoints& records) {
  std::vector<LazBlock> blocks(records.n_blocks());
  for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i].index = i;
  return blocks;
}

// The blocks of the nodes up to `max_level`. Chunks without a node are kept, without a box, because
// only points that the hierarchy places elsewhere may be left out.
std::vector<LazBlock> blocks_of_hierarchy(const laz::LazPoints& records,
                                          const LasHeader& header,
                                          const laz::CopcHierarchy& hierarchy,
                                          int max_level) {
  std::unordered_map<std::uint64_t, const laz::CopcNode*> node_at;
  for (const laz::CopcNode& node : hierarchy.nodes) node_at.emplace(node.offset, &node);
  std::vector<LazBlock> blocks;
  for (std::size_t i = 0; i < records.chunks().size(); ++i) {
    const auto found = node_at.find(records.chunks()[i].offset);
    if (found == node_at.end()) {
      blocks.push_back({.index = i, .box_in_file = std::nullopt});
    } else if (found->second->level <= max_level) {
      // Stored coordinates are rounded to the scale and may lie that much outside their cube.
      Eigen::AlignedBox3d box = node_cube(hierarchy, *found->second);
      const Eigen::Vector3d rounding = header.scale.cwiseAbs();
      box = {Eigen::Vector3d(box.min() - rounding), Eigen::Vector3d(box.max() + rounding)};
      blocks.push_back({.index = i, .box_in_file = box});
    }
  }
  return blocks;
}

}  // namespace

std::unique_ptr<CloudSource> open_laz(MappedFile file,
                                      LasHeader header,
                                      CloudFileInfo file_info,
                                      const OpenCloudOptions& options) {
  laz::LazPoints records(file.bytes(), header, file_info.path);
  file_info.warnings.insert(file_info.warnings.end(), records.warnings().begin(),
                            records.warnings().end());
  const auto hierarchy = read_hierarchy(file, header, file_info);
  std::vector<LazBlock> blocks;
  if (hierarchy) {
    const double resolution = options.max_resolution_m / file_info.unit_m.x();
    const int max_level =
        resolution > 0.0 ? level_of_resolution(*hierarchy, resolution) : laz::kMaxCopcLevel;
    blocks = blocks_of_hierarchy(records, header, *hierarchy, max_level);
    file_info.format = fmt::format("COPC, {}", file_info.format);
    file_info.n_points = 0;
    for (const LazBlock& block : blocks) file_info.n_points += records.n_points(block.index);
    // The header's bounds cover all levels, not only those that are read.
    if (blocks.size() < records.n_blocks()) file_info.stated_bounds.reset();
  } else {
    blocks = all_blocks(records);
  }
  return std::make_unique<LazSource>(std::move(file), std::move(header), std::move(records),
                                     std::move(blocks), std::move(file_info));
}

}  // namespace ridgeline::io
