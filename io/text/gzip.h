// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// Whether bytes begin with the gzip signature.
bool is_gzip(std::string_view bytes);

/// The decompressed text, or its first `most_bytes`. If the bytes end early or become invalid, the
/// text stops there and `is_whole` is false.
struct Inflated {
  std::string text;
  bool is_whole = false;
};
Inflated inflated(std::string_view bytes, std::size_t most_bytes);

}  // namespace ridgeline::io
