// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ridgeline::evaluate {

/// Tables show metres to the millimetre, like the published tables: a tenth of the accuracy of the
/// LIDAR. All renderings of a table except JSON use it, so they agree to the last printed digit.
inline constexpr int kMetreDecimals = 3;

/// Shown for a missing figure instead of 0.000.
inline constexpr std::string_view kNoValue = "-";

/// Fixed-point decimal; `missing` for an empty or non-finite value. Never "-0.000".
std::string fixed(std::optional<double> value, int decimals, std::string_view missing = kNoValue);

inline std::string metres(std::optional<double> value_m, std::string_view missing = kNoValue) {
  return fixed(value_m, kMetreDecimals, missing);
}

/// A share in percent with one decimal, without the percent sign: 0.971 -> "97.1".
std::string percent(std::optional<double> share);

std::string escape_csv(std::string_view text);  ///< quoted where RFC 4180 requires it
/// `text` for a cell of a Markdown table: on one line, with markup escaped. Underscores are kept,
/// because they are literal within a word.
std::string escape_markdown(std::string_view text);
std::string escape_latex(std::string_view text);
/// `text` for XML elements and attribute values. Control characters, which XML 1.0 does not allow,
/// become U+FFFD; line feeds and tabs are kept.
std::string escape_xml(std::string_view text);

}  // namespace ridgeline::evaluate
