// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/alpha_band.h"

#include "io/images/sample_places.h"

#include <algorithm>
#include <vector>

namespace ridgeline::io {
namespace {

/// Values of a band at the places of a sample. Blocks that cannot be decoded are left out: reading
/// the pixels reports the error.
std::vector<std::uint16_t> sample_of(GDALRasterBand& band) {
  std::vector<std::uint16_t> values;
  for (const Window& place : sample_places({band.GetXSize(), band.GetYSize()})) {
    std::vector<std::uint16_t> block(static_cast<std::size_t>(place.width) *
                                     static_cast<std::size_t>(place.height));
    if (band.RasterIO(GF_Read, place.column, place.row, place.width, place.height, block.data(),
                      place.width, place.height, GDT_UInt16, 0, 0, nullptr) == CE_None)
      values.insert(values.end(), block.begin(), block.end());
  }
  return values;
}

}  // namespace

std::optional<AlphaBand> alpha_band(GDALDataset& dataset) {
  constexpr double kNearlyAll = 0.9;  // blended borders have values in between
  for (int number = 1; number <= dataset.GetRasterCount(); ++number) {
    GDALRasterBand& band = *dataset.GetRasterBand(number);
    if (band.GetColorInterpretation() != GCI_AlphaBand) continue;
    const std::vector<std::uint16_t> values = sample_of(band);
    if (values.empty()) return std::nullopt;
    const std::uint16_t opaque = *std::ranges::max_element(values);
    const auto n_extreme = std::ranges::count_if(
        values, [opaque](std::uint16_t value) { return value == 0 || value == opaque; });
    if (static_cast<double>(n_extreme) < kNearlyAll * static_cast<double>(values.size()))
      return std::nullopt;
    return AlphaBand{number, opaque};
  }
  return std::nullopt;
}

}  // namespace ridgeline::io
