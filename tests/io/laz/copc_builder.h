// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/io/laz/laz_builder.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::io::laz {

/// A single return of point format 6; the other fields are 0.
struct CopcPoint {
  std::array<std::int32_t, 3> x;  ///< stored coordinates
  std::uint8_t classification = 2;
};

/// One chunk of point format 6, version 3, as LASzip would write it.
FileBytes encode_layered_chunk(std::span<const CopcPoint> points);

/// Writes COPC files for tests and benchmarks: an octree over a square whose levels hold four times
/// the points of the level above. Scale 0.01, offset 0, no reference system.
struct CopcBuilder {
  int n_levels = 3;
  std::size_t entries_per_page = 1U << 20U;  ///< if there are more nodes, child pages follow

  /// Points in any order; every one is in the file once.
  [[nodiscard]] FileBytes build(std::span<const CopcPoint> points) const;
};

}  // namespace ridgeline::io::laz
