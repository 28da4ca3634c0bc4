// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/local_from_file.h"
#include "io/cloud/point_cloud.h"

#include <optional>
#include <string_view>

namespace ridgeline::io {

/// What of a point a named column of a PCD, PLY or text file gives.
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

/// By the column's name, whatever its case, also with CloudCompare's prefix "scalar_"; `label` is
/// read as a class. Nothing for columns that are not kept.
std::optional<PointAttribute> attribute_of_column(std::string_view name);

/// Stores a file's number. Coordinates are reduced to local metres; a code that is no whole number
/// of its field's range becomes 0, and an intensity is clamped.
void set_attribute(PointAttribute attribute,
                   double value,
                   const LocalFromFile& local_from_file,
                   CloudPoint& point);

}  // namespace ridgeline::io
