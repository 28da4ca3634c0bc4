// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_files.h"

#include <pybind11/numpy.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::python {

/// The options from the entries assume_crs, bounds, classes, include_withheld, last_returns,
/// max_points, max_resolution_m, salvage and strict; all optional. Throws std::invalid_argument for
/// an invalid value.
io::ReadOptions read_options(const pybind11::dict& entries);

/// Points in an array, which must outlive this object.
struct PointsInMemory {
  std::span<const std::byte> bytes;
  bool has_attributes = false;  ///< rows of io::CloudPoint, else three doubles
  io::Crs crs{};
};

/// The points of an array returned by read_cloud(), or of an array (n, 3) of doubles. Throws
/// std::invalid_argument for any other array.
PointsInMemory points_in_memory(const pybind11::array& array);

/// A cloud source for the points. Throws std::invalid_argument for a reference system that PROJ
/// cannot read.
std::unique_ptr<io::CloudSource> open_points(const PointsInMemory& points, const io::Crs& crs);

/// A cloud: files, or points in an array.
struct CloudInput {
  std::vector<std::string> paths;
  std::optional<PointsInMemory> points;

  /// Points in memory without a reference system are assumed to be in that of the lines.
  [[nodiscard]] io::CloudFiles open(const io::ReadOptions& options,
                                    const io::Crs& crs_of_lines = {}) const;
};

/// `cloud`: list of paths, or an array, with its reference system in the entry `cloud_crs`. Throws
/// std::invalid_argument for an empty list.
CloudInput cloud_input(const pybind11::object& cloud, const pybind11::dict& entries);

}  // namespace ridgeline::python
