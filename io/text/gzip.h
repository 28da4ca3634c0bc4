// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// Whether bytes begin as those of gzip.
bool is_gzip(std::string_view bytes);

/// The text that gzip compressed, or its first `most_bytes`. It ends where the bytes end, or are no
/// longer gzip's: `is_whole` then stays false.
struct Inflated {
  std::string text;
  bool is_whole = false;
};
Inflated inflated(std::string_view bytes, std::size_t most_bytes);

}  // namespace ridgeline::io
