// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/point_attribute.h"

#include "io/text/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace ridgeline::io {

namespace {

template <typename T>
T code(double value) {
  const bool fits = value >= 0.0 && value <= std::numeric_limits<T>::max();  // false for NaN
  return fits && value == std::floor(value) ? static_cast<T>(value) : T{0};
}

std::uint16_t intensity(double value) {
  constexpr double kMaxIntensity = std::numeric_limits<std::uint16_t>::max();
  return std::isnan(value)
             ? std::uint16_t{0}
             : static_cast<std::uint16_t>(std::round(std::clamp(value, 0.0, kMaxIntensity)));
}

double local(double value, int axis, const LocalFromFile& local_from_file) {
  return value * local_from_file.unit_m[axis] - local_from_file.origin_m[axis];
}

}  // namespace

std::optional<PointAttribute> attribute_of_column(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, PointAttribute>, 11> kColumns{
      {{"x", PointAttribute::kX},
       {"y", PointAttribute::kY},
       {"z", PointAttribute::kZ},
       {"intensity", PointAttribute::kIntensity},
       {"classification", PointAttribute::kClassification},
       {"class", PointAttribute::kClassification},
       {"label", PointAttribute::kClassification},
       {"return_number", PointAttribute::kReturnNumber},
       {"returnnumber", PointAttribute::kReturnNumber},
       {"number_of_returns", PointAttribute::kNumberOfReturns},
       {"point_source_id", PointAttribute::kSourceId}}};
  std::string lower = lower_case(name);
  constexpr std::string_view kCloudComparePrefix = "scalar_";
  if (lower.starts_with(kCloudComparePrefix)) lower.erase(0, kCloudComparePrefix.size());
  for (const auto& [known, attribute] : kColumns) {
    if (known == lower) return attribute;
  }
  return std::nullopt;
}

void set_attribute(PointAttribute attribute,
                   double value,
                   const LocalFromFile& local_from_file,
                   CloudPoint& point) {
  switch (attribute) {
    case PointAttribute::kX:
      point.x = local(value, 0, local_from_file);
      break;
    case PointAttribute::kY:
      point.y = local(value, 1, local_from_file);
      break;
    case PointAttribute::kZ:
      point.z = local(value, 2, local_from_file);
      break;
    case PointAttribute::kIntensity:
      point.intensity = intensity(value);
      break;
    case PointAttribute::kClassification:
      point.classification = code<std::uint8_t>(value);
      break;
    case PointAttribute::kFlags:
      point.flags = code<std::uint8_t>(value);
      break;
    case PointAttribute::kReturnNumber:
      point.return_number = code<std::uint8_t>(value);
      break;
    case PointAttribute::kNumberOfReturns:
      point.number_of_returns = code<std::uint8_t>(value);
      break;
    case PointAttribute::kSourceId:
      point.source_id = code<std::uint16_t>(value);
      break;
  }
}

}  // namespace ridgeline::io
