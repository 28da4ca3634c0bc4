// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// A number as Fortran writes it: its exponent may begin with D. std::nullopt if the text is not a
/// number.
std::optional<double> fortran_number(std::string_view text);

/// The words of a PAT-B record without the flags that some programs append: whole numbers of at
/// most two digits beyond the first `n_words`.
std::vector<std::string_view> pat_b_words(std::string_view record, std::size_t n_words);

}  // namespace ridgeline::io
