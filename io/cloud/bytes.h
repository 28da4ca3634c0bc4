// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace ridgeline::io {

static_assert(std::endian::native == std::endian::little,
              "LAS, PCD and little-endian PLY values are copied as they lie in the file");

/// The little-endian value at `source`, which need not be aligned. The caller has checked that
/// sizeof(T) bytes are there.
template <typename T>
T load(const std::byte* source) {
  static_assert(std::is_trivially_copyable_v<T>);
  T value;
  std::memcpy(&value, source, sizeof(T));
  return value;
}

/// The big-endian value at `source`, under the conditions of load().
template <typename T>
T load_big_endian(const std::byte* source) {
  std::array<std::byte, sizeof(T)> reversed;
  std::reverse_copy(source, source + sizeof(T), reversed.begin());
  return load<T>(reversed.data());
}

/// Text of a fixed-size field, up to its first NUL.
inline std::string load_text(std::span<const std::byte> field) {
  const auto* const first = reinterpret_cast<const char*>(field.data());
  return {first, std::find(first, first + field.size(), '\0')};
}

}  // namespace ridgeline::io
