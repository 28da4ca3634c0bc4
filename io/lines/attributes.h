// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// A text attribute of a line and its name in files.
struct TextAttribute {
  std::string_view name;
  std::string Line::*member;
};
std::span<const TextAttribute> text_attributes();

/// An attribute that holds an image segment, in files [x1, y1, x2, y2].
struct SegmentAttribute {
  std::string_view name;
  std::optional<Segment2> Line::*member;
};
std::span<const SegmentAttribute> segment_attributes();
std::string segment_text(const Segment2& segment_px);

/// An attribute that is a plain number.
struct NumberAttribute {
  std::string_view name;
  std::optional<double> Line::*member;
};
std::span<const NumberAttribute> number_attributes();

/// The attributes that a feature's properties state; names in any case, unknown ones are passed
/// over. Numbers may be given as text, arrays as JSON text (formats without arrays). The covariance
/// is 6x6 or 36 numbers; without it `sigma_start_m` and `sigma_end_m` make a diagonal one.
/// Throws IoError naming `where` for a known attribute with a value of the wrong shape.
Line line_from_properties(const nlohmann::json& properties, const std::string& where);

/// Text of an id or a name that may be a number: "7" for 7, empty for null.
std::string text_of(const nlohmann::json& value);

/// The covariance as nested JSON rows, six significant digits: relative 1e-5 of a variance is far
/// below what the variance itself is known to.
std::string covariance_text(const Eigen::Matrix<double, 6, 6>& covariance_m2);

}  // namespace ridgeline::io
