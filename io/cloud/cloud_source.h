// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/local_from_file.h"
#include "io/cloud/point_cloud.h"
#include "io/crs/crs.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::io {

/// What a cloud file states about itself before its points are read.
struct CloudFileInfo {
  std::string path;
  std::string format;  ///< "LAS 1.4, point format 6", "PCD, binary", ...
  Crs crs{};
  /// Metres per coordinate unit by axis, from the CRS or the file's own unit keys.
  Eigen::Vector3d unit_m = Eigen::Vector3d::Ones();
  bool has_sure_unit = false;  ///< whether the unit is known although no CRS states it
  bool is_geographic = false;
  std::uint64_t n_points = 0;
  /// Whether coordinates are stored as binary float32, which has steps of 0.5 m at UTM northings.
  bool has_float_coordinates = false;
  /// Bounds stated by the header, file units. They are often wrong, so they are only compared with
  /// the points.
  std::optional<Eigen::AlignedBox3d> stated_bounds{};
  std::optional<Eigen::Vector3d> scale{};  ///< of LAS coordinates: x = scale * integer + offset
  std::optional<Eigen::Vector3d> offset{};
  std::vector<std::string> warnings{};  ///< without the path
};

/// What a file's own index states about a block, without decoding it.
struct BlockExtent {
  Eigen::AlignedBox3d box_in_file;  ///< contains all points of the block, file units
  std::uint64_t n_points = 0;
};

/// An open cloud file whose points are decoded block by block, in any order and from any thread,
/// so that neither the file nor its points have to be held in memory twice.
class CloudSource {
 public:
  explicit CloudSource(CloudFileInfo file_info) : info_(std::move(file_info)) {}
  virtual ~CloudSource() = default;
  CloudSource(const CloudSource&) = delete;
  CloudSource& operator=(const CloudSource&) = delete;

  [[nodiscard]] const CloudFileInfo& info() const { return info_; }

  [[nodiscard]] virtual std::size_t n_blocks() const = 0;

  /// Number of points of the largest block, which bounds the memory of a decoded block.
  [[nodiscard]] virtual std::size_t max_block_points() const { return 16384; }

  /// The extent of a block in a file with a spatial index (COPC), used to skip blocks outside a
  /// region; std::nullopt for other files.
  [[nodiscard]] virtual std::optional<BlockExtent> block_extent(std::size_t /*block*/) const {
    return std::nullopt;
  }

  /// Whether an open source holds no points, so that thousands can be open, and can decode any
  /// block without decoding those before it.
  [[nodiscard]] virtual bool is_light() const { return true; }

  /// Tells the source that these blocks are not needed for now, so that the pages of a mapped file
  /// do not pile up in memory.
  virtual void release_blocks(std::size_t /*first*/, std::size_t /*count*/) const {}

  /// Replaces `points` with all points of a block, in file order.
  /// Throws IoError if the block is damaged.
  virtual void decode_block(std::size_t block,
                            const LocalFromFile& local_from_file,
                            std::vector<CloudPoint>& points) const = 0;

 private:
  CloudFileInfo info_;
};

struct OpenCloudOptions {
  bool salvage = false;           ///< read the records that are present if a file is truncated
  double max_resolution_m = 0.0;  ///< see ReadOptions
};

/// Opens LAS, LAZ, COPC, PCD, PLY or a text file of `x y z` lines. The format is detected from the
/// first bytes, not from the name; only text files are recognised by name (.xyz .txt .csv .asc
/// .pts). Throws IoError naming the path.
std::unique_ptr<CloudSource> open_cloud(const std::string& path,
                                        const OpenCloudOptions& options = {});

}  // namespace ridgeline::io
