// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace ridgeline::io::laz {

/// Damage found inside a compressed stream, where path, chunk and point are not known. The chunk
/// decoder turns it into an IoError that names them.
class CodecError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace ridgeline::io::laz
