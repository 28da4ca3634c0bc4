// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/stated_turn.h"

#include "io/images/tiff_tag.h"

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace ridgeline::io {
namespace {

std::optional<std::uint64_t> exif_orientation(GDALDataset& dataset) {
  const char* const text = dataset.GetMetadataItem("EXIF_Orientation");
  if (text == nullptr) return std::nullopt;
  return static_cast<std::uint64_t>(std::strtoul(text, nullptr, 10));
}

}  // namespace

ImageTurn stated_turn(const std::string& path, GDALDataset& dataset) {
  const std::string_view format = dataset.GetDriver()->GetDescription();
  std::optional<std::uint64_t> value;
  if (format == "GTiff") value = tiff_tag(path, kTiffOrientation);
  if (format == "JPEG") value = exif_orientation(dataset);
  constexpr auto kLast = static_cast<std::uint64_t>(ImageTurn::kCounterClockwise);
  if (!value || *value < 1 || *value > kLast) return ImageTurn::kNone;
  return static_cast<ImageTurn>(*value);
}

}  // namespace ridgeline::io
