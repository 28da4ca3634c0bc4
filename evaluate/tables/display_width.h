// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ridgeline::evaluate {

/// Number of columns that `text` (UTF-8) takes in a terminal: none for combining marks, two for the
/// wide characters of East Asia and emoji. A byte that is no UTF-8 takes one column, as the sign
/// shown for it does.
std::size_t display_width(std::string_view text);

/// `text` on one line, without what would move the cursor or colour the terminal: control
/// characters become blanks, bytes that are no UTF-8 become U+FFFD.
std::string printable(std::string_view text);

}  // namespace ridgeline::evaluate
