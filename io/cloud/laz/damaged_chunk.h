// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/codec_error.h"
#include "io/error.h"

#include <cstdint>
#include <string>

namespace ridgeline::io::laz {

/// The error for a chunk that cannot be decoded at one of its points. `chunk` counts from 0 in the
/// file, `point` from 0 in the chunk.
IoError damaged_chunk(const std::string& path,
                      std::uint64_t chunk,
                      std::uint64_t point,
                      const CodecError& reason);

}  // namespace ridgeline::io::laz
