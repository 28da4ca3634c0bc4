// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/local_from_file.h"
#include "io/cloud/point_cloud.h"

#include <optional>
#include <string_view>

namespace ridgeline::io {

/// The part of a point that a named column of a PCD, PLY or text file provides.
enum class PointAttribute {
  kX,
  kY,
  kZ,
  kIntensity,
  kClassification,
  kReturnNumber,
  kNumberOfReturns,
  kFlags,
  kSourceId
};

/// The attribute for a column of this name, ignoring case and CloudCompare's prefix "scalar_";
/// `label` is read as the class. Returns std::nullopt for columns that are not kept.
std::optional<PointAttribute> attribute_of_column(std::string_view name);

/// Stores a file's number in a point. Coordinates are converted to local metres; a code that is not
/// an integer in the range of its field becomes 0, and an intensity is clamped.
void set_attribute(PointAttribute attribute,
                   double value,
                   const LocalFromFile& local_from_file,
                   CloudPoint& point);

}  // namespace ridgeline::io
