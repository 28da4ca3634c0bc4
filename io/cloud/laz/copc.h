// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_header.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::io::laz {

inline constexpr int kMaxCopcLevel = 30;  ///< cell indices have 32 bits

/// A cube of the octree with the points added at its level; they form one LAZ chunk.
struct CopcNode {
  std::int32_t level;  ///< 0: the root
  std::int32_t x, y, z;
  std::uint64_t offset;  ///< byte offset of its chunk in the file
  std::int32_t n_points;
};

/// The octree of a cloud-optimised file (COPC 1.0). Lengths in the file's units.
struct CopcHierarchy {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double half_size = 0.0;       ///< half of the side of the root's cube
  double spacing = 0.0;         ///< distance between the points of the root; each level halves it
  std::vector<CopcNode> nodes;  ///< nodes with points, in the order of the pages
};

/// Reads VLR "copc" 1 and the pages of the hierarchy; std::nullopt if the file has no such VLR.
/// Throws CodecError with the reason if they are damaged.
/// Source: COPC specification 1.0, copc.io.
std::optional<CopcHierarchy> read_copc_hierarchy(std::span<const std::byte> file,
                                                 const LasHeader& header);

/// The cube of a node, in file coordinates.
Eigen::AlignedBox3d node_cube(const CopcHierarchy& hierarchy, const CopcNode& node);

/// The coarsest level at which points are at most `resolution` (file units, above 0) apart if all
/// levels down to it are read.
int level_of_resolution(const CopcHierarchy& hierarchy, double resolution);

}  // namespace ridgeline::io::laz
