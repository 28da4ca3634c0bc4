// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace ridgeline::io {

/// Type of a number stored in a PCD or PLY file.
enum class ScalarType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64
};

/// Bytes of one number.
std::size_t size_of(ScalarType type);

/// The type with this old (char .. double) or new (int8 .. float64) PLY name; std::nullopt for
/// other names.
std::optional<ScalarType> scalar_type_of_ply_name(std::string_view name);

/// The type with this PCD TYPE (I, U, F) and SIZE (1, 2, 4, 8); std::nullopt for other pairs.
std::optional<ScalarType> scalar_type_of_pcd_field(char type, std::size_t size);

/// The number at `source`, which has size_of(type) bytes. Integers above 2^53 are rounded.
double load_scalar(const std::byte* source, ScalarType type, bool is_big_endian);

}  // namespace ridgeline::io
