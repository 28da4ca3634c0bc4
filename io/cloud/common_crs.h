// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/crs/crs.h"

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The common reference system of all files of a run.
struct CommonCrs {
  Crs crs;                              ///< unknown if no file states one
  std::vector<Eigen::Vector3d> unit_m;  ///< metres per coordinate unit, for each source
  std::vector<std::string> warnings;    ///< with paths
};

/// Finds the common system. If `assume_crs` is known, it replaces the CRS of every file. A file
/// that states no system is assumed to share that of the others, with a warning. Throws IoError if
/// two systems differ, naming both files and systems, and for degrees.
CommonCrs find_common_crs(std::span<const CloudFileInfo> files, const Crs& assume_crs);

}  // namespace ridgeline::io
