// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/damaged_chunk.h"

#include <fmt/format.h>

namespace ridgeline::io::laz {

IoError damaged_chunk(const std::string& path,
                      std::uint64_t chunk,
                      std::uint64_t point,
                      const CodecError& reason) {
  return {path, fmt::format("chunk {}, point {} cannot be decoded: {}; the file is damaged or cut "
                            "short",
                            chunk, point, reason.what())};
}

}  // namespace ridgeline::io::laz
