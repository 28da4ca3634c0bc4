// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
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
std::string observations_text(const std::vector<LineObservation>& observations);

/// An attribute that is a plain number.
struct NumberAttribute {
  std::string_view name;
  std::optional<double> Line::*member;
};
std::span<const NumberAttribute> number_attributes();

/// Reads the attributes of the features of a file. Names are case-insensitive; unknown ones are
/// ignored. Numbers may be given as text, arrays as JSON text (formats without arrays). The
/// covariance is 6x6 or 36 numbers; without it, `sigma_start_m` and `sigma_end_m` form a diagonal
/// one. A column with one of our names but values of a different shape is assumed to belong to
/// another tool, so none of its values are used.
class AttributeReader {
 public:
  /// The attributes of a feature. Throws IoError naming `where`, the line and the value if a
  /// variance or sigma is negative or not finite.
  Line line_of(const nlohmann::json& properties, const std::string& where);

  /// Removes from the lines the values read from other tools' columns. A warning names each such
  /// column and its first misfit.
  void finish(LineSet& set) const;

 private:
  struct Misfit {
    std::string first, where, rule;  ///< of the first value that does not fit
    std::size_t n_values = 0;
  };

  template <typename Take>
  void take(const nlohmann::json& values,
            std::string_view name,
            const std::string& where,
            const Take& take_value);
  void take_covariance(const nlohmann::json& values, const std::string& where, Line& line);

  std::map<std::string, Misfit> misfits_;
};

/// Text of an id or a name that may be a number: "7" for 7, empty for null.
std::string text_of(const nlohmann::json& value);

/// The covariance as nested JSON rows, with six significant digits: a relative error of 1e-5 is far
/// below the uncertainty of the variance itself.
std::string covariance_text(const Eigen::Matrix<double, 6, 6>& covariance_m2);

}  // namespace ridgeline::io
