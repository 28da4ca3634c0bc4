// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/byte_stream.h"

#include <fmt/format.h>

namespace ridgeline::io::laz {

void ByteStream::throw_end(std::size_t needed) const {
  throw CodecError(fmt::format("the compressed data are {} bytes too short",
                               needed - (bytes_.size() - position_)));
}

}  // namespace ridgeline::io::laz
