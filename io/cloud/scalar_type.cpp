// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/scalar_type.h"

#include "io/cloud/bytes.h"

#include <array>
#include <cstdint>
#include <utility>

namespace ridgeline::io {

namespace {

template <typename T>
double load_as(const std::byte* source, bool is_big_endian) {
  return static_cast<double>(is_big_endian ? load_big_endian<T>(source) : load<T>(source));
}

}  // namespace

std::size_t size_of(ScalarType type) {
  switch (type) {
    case ScalarType::kInt8:
    case ScalarType::kUint8:
      return 1;
    case ScalarType::kInt16:
    case ScalarType::kUint16:
      return 2;
    case ScalarType::kInt32:
    case ScalarType::kUint32:
    case ScalarType::kFloat32:
      return 4;
    case ScalarType::kInt64:
    case ScalarType::kUint64:
    case ScalarType::kFloat64:
      break;
  }
  return 8;
}

std::optional<ScalarType> scalar_type_of_ply_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, ScalarType>, 16> kNames{
      {{"char", ScalarType::kInt8},
       {"int8", ScalarType::kInt8},
       {"uchar", ScalarType::kUint8},
       {"uint8", ScalarType::kUint8},
       {"short", ScalarType::kInt16},
       {"int16", ScalarType::kInt16},
       {"ushort", ScalarType::kUint16},
       {"uint16", ScalarType::kUint16},
       {"int", ScalarType::kInt32},
       {"int32", ScalarType::kInt32},
       {"uint", ScalarType::kUint32},
       {"uint32", ScalarType::kUint32},
       {"float", ScalarType::kFloat32},
       {"float32", ScalarType::kFloat32},
       {"double", ScalarType::kFloat64},
       {"float64", ScalarType::kFloat64}}};
  for (const auto& [known, type] : kNames) {
    if (known == name) return type;
  }
  return std::nullopt;
}

std::optional<ScalarType> scalar_type_of_pcd_field(char type, std::size_t size) {
  const bool is_signed = type == 'I';
  if (type == 'F') {
    if (size == 4) return ScalarType::kFloat32;
    if (size == 8) return ScalarType::kFloat64;
    return std::nullopt;
  }
  if (type != 'I' && type != 'U') return std::nullopt;
  switch (size) {
    case 1:
      return is_signed ? ScalarType::kInt8 : ScalarType::kUint8;
    case 2:
      return is_signed ? ScalarType::kInt16 : ScalarType::kUint16;
    case 4:
      return is_signed ? ScalarType::kInt32 : ScalarType::kUint32;
    case 8:
      return is_signed ? ScalarType::kInt64 : ScalarType::kUint64;
    default:
      return std::nullopt;
  }
}

double load_scalar(const std::byte* source, ScalarType type, bool is_big_endian) {
  switch (type) {
    case ScalarType::kInt8:
      return load<std::int8_t>(source);
    case ScalarType::kUint8:
      return load<std::uint8_t>(source);
    case ScalarType::kInt16:
      return load_as<std::int16_t>(source, is_big_endian);
    case ScalarType::kUint16:
      return load_as<std::uint16_t>(source, is_big_endian);
    case ScalarType::kInt32:
      return load_as<std::int32_t>(source, is_big_endian);
    case ScalarType::kUint32:
      return load_as<std::uint32_t>(source, is_big_endian);
    case ScalarType::kInt64:
      return load_as<std::int64_t>(source, is_big_endian);
    case ScalarType::kUint64:
      return load_as<std::uint64_t>(source, is_big_endian);
    case ScalarType::kFloat32:
      return load_as<float>(source, is_big_endian);
    case ScalarType::kFloat64:
      break;
  }
  return load_as<double>(source, is_big_endian);
}

}  // namespace ridgeline::io
