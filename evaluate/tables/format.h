// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ridgeline::evaluate {

/// Tables print metres to the millimetre, as the published tables do: a tenth of the accuracy of
/// the LIDAR. All renderings of a table but JSON use it, so they agree to the printed digit.
inline constexpr int kMetreDecimals = 3;

/// What stands for a figure that does not exist; never 0.000.
inline constexpr std::string_view kNoValue = "-";

/// Fixed-point decimal; `missing` for an empty or non-finite value. Never "-0.000".
std::string fixed(std::optional<double> value, int decimals, std::string_view missing = kNoValue);

inline std::string metres(std::optional<double> value_m, std::string_view missing = kNoValue) {
  return fixed(value_m, kMetreDecimals, missing);
}

/// A share as percent with one decimal and without the sign: 0.971 -> "97.1".
std::string percent(std::optional<double> share);

std::string escape_csv(std::string_view text);  ///< quoted where RFC 4180 asks for it
/// `text` for a cell of a Markdown table: on one line, with markup escaped. An underscore stays, as
/// it is literal within a word.
std::string escape_markdown(std::string_view text);
std::string escape_latex(std::string_view text);
/// `text` for XML elements and attribute values. Control characters, which XML 1.0 cannot hold,
/// become U+FFFD; line feed and tab stay.
std::string escape_xml(std::string_view text);

}  // namespace ridgeline::evaluate
