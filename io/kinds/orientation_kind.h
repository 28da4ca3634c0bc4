// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace ridgeline::io {

/// Formats in which programs write camera poses.
enum class OrientationFormat : std::uint8_t {
  kOpkTable,
  kRollPitchYaw,  ///< refused: these angles describe the aircraft
  kOpensfm,
  kPix4d,
  kInpho,
  kPatB,
  kBlocksExchange,
  kMetashape,
};

/// Identifies the format of an orientation by the first bytes of its file, without a byte order
/// mark; std::nullopt if it is not an orientation.
std::optional<OrientationFormat> orientation_format(std::string_view bytes);

/// "an orientation of images (OpenSfM)".
const char* what_is(OrientationFormat format);

}  // namespace ridgeline::io
