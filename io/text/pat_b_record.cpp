// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/pat_b_record.h"

#include "io/text/text.h"

#include <algorithm>
#include <string>

namespace ridgeline::io {
namespace {

bool is_flag(std::string_view word) {
  constexpr long kMaxFlag = 99;
  const std::optional<long> value = to_integer(word);
  return value && *value >= -kMaxFlag && *value <= kMaxFlag;
}

}  // namespace

std::optional<double> fortran_number(std::string_view text) {
  std::string with_e(text);
  std::ranges::replace(with_e, 'D', 'E');
  std::ranges::replace(with_e, 'd', 'e');
  return to_double(with_e);
}

std::vector<std::string_view> pat_b_words(std::string_view record, std::size_t n_words) {
  std::vector<std::string_view> words = words_of(record);
  while (words.size() > n_words && is_flag(words.back())) words.pop_back();
  return words;
}

}  // namespace ridgeline::io
