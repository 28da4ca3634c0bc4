// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ridgeline::evaluate {

/// Number of columns that `text` (UTF-8) takes in a terminal: zero for combining marks, two for
/// wide East Asian characters and emoji. An invalid UTF-8 byte takes one column, like its
/// replacement character.
std::size_t display_width(std::string_view text);

/// `text` on one line, unable to move the cursor or colour the terminal: control characters become
/// blanks, and invalid UTF-8 bytes become U+FFFD.
std::string printable(std::string_view text);

}  // namespace ridgeline::evaluate
