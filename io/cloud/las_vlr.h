// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_header.h"

#include <cstddef>
#include <span>

namespace ridgeline::io {

/// Appends the VLRs between header and points, then the EVLRs, to `header.vlrs`. A list that
/// extends into the points (or beyond the end of the file) is cut there with a warning: the records
/// read so far, and the points, remain usable.
void collect_vlrs(std::span<const std::byte> file, LasHeader& header);

}  // namespace ridgeline::io
