// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_files.h"

#include <pybind11/numpy.h>

#include <cstddef>
#include <memory>
#include <span>

namespace ridgeline::python {

/// The options of the entries assume_crs, bounds, classes, include_withheld, last_returns,
/// max_points, max_resolution_m, salvage and strict; each may be missing. Throws
/// std::invalid_argument for an impossible value.
io::ReadOptions read_options(const pybind11::dict& entries);

/// Points that lie in an array, which must outlive this.
struct PointsInMemory {
  std::span<const std::byte> bytes;
  bool has_attributes = false;  ///< rows of io::CloudPoint, else three doubles
  io::Crs crs{};
};

/// The points of an array that read_cloud() returned or that holds doubles (n, 3). Throws
/// std::invalid_argument for any other array.
PointsInMemory points_in_memory(const pybind11::array& array);

/// A cloud source that reads the points. Throws std::invalid_argument for a reference system that
/// PROJ cannot read.
std::unique_ptr<io::CloudSource> open_points(const PointsInMemory& points, const io::Crs& crs);

}  // namespace ridgeline::python
