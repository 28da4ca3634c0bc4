// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ridgeline::apps {

/// Encodes bytes as base64 (RFC 4648), padded and without line breaks.
std::string base64(std::span<const std::byte> bytes);

/// Encodes the values as they are stored in memory: little-endian on every supported platform.
template <typename T>
std::string base64(const std::vector<T>& values) {
  static_assert(std::is_arithmetic_v<T>);
  return base64(std::as_bytes(std::span(values)));
}

}  // namespace ridgeline::apps
