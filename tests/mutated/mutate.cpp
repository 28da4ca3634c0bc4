// SPDX-License-Identifier: BSD-3-Clause
#include "tests/mutated/mutate.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::test {
namespace {

std::size_t below(Random& random, std::size_t n) {
  return std::min(static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(n))), n - 1);
}

void flip_bytes(std::string& content, Random& random) {
  const std::size_t count = 1 + below(random, 8);
  for (std::size_t i = 0; i < count; ++i) {
    content[below(random, content.size())] = static_cast<char>(below(random, 256));
  }
}

void cut_off(std::string& content, Random& random) {
  content.resize(below(random, content.size()));
}

void leave_out(std::string& content, Random& random) {
  const std::size_t begin = below(random, content.size());
  content.erase(begin, 1 + below(random, 200));
}

void repeat(std::string& content, Random& random) {
  const std::size_t begin = below(random, content.size());
  content.insert(begin, content.substr(begin, 1 + below(random, 2000)));
}

/// Overwrites a number of 1, 2, 4 or 8 bytes in the first bytes, where headers stand.
void set_header_number(std::string& content, Random& random) {
  constexpr std::size_t kHeader = 400;
  constexpr std::array<std::uint64_t, 8> kExtremes{0,
                                                   1,
                                                   0x7fffffffffffffffULL,
                                                   0x8000000000000000ULL,
                                                   0xffffffffffffffffULL,
                                                   0x7fffffff7fffffffULL,
                                                   0x7ff0000000000000ULL,   // infinity
                                                   0x547d42aea2879f2eULL};  // 1e99
  const std::size_t n_bytes = std::size_t{1} << below(random, 4);
  if (content.size() < n_bytes) return;
  const std::size_t at = below(random, std::min(kHeader, content.size() - n_bytes + 1));
  const std::uint64_t value = kExtremes[below(random, kExtremes.size())];
  for (std::size_t i = 0; i < n_bytes; ++i) {
    content[at + i] = static_cast<char>(value >> (8 * (8 - n_bytes + i)));  // little endian
  }
}

bool is_of_number(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+';
}

/// [begin, end) of the digits in a text.
std::vector<std::pair<std::size_t, std::size_t>> numbers_in(std::string_view text) {
  std::vector<std::pair<std::size_t, std::size_t>> numbers;
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    if (!is_of_number(text[begin])) continue;
    std::size_t end = begin;
    while (end < text.size() && is_of_number(text[end])) ++end;
    numbers.emplace_back(begin, end);
    begin = end;
  }
  return numbers;
}

void set_text_number(std::string& content, Random& random) {
  constexpr std::array<std::string_view, 18> kOthers{
      "1e308", "-1e308", "1e400", "1e30", "1e10",       "-1e9",
      "1e7",   "1e-320", "0",     "-1",   "nan",        "-inf",
      "",      "null",   "x",     "[]",   "4294967296", "9223372036854775807"};
  const auto numbers = numbers_in(content);
  if (numbers.empty()) return flip_bytes(content, random);
  const auto [begin, end] = numbers[below(random, numbers.size())];
  content.replace(begin, end - begin, kOthers[below(random, kOthers.size())]);
}

}  // namespace

std::string mutated(std::string content, Random& random) {
  constexpr std::array kDamages{flip_bytes,        cut_off,         leave_out,      repeat,
                                set_header_number, set_text_number, set_text_number};
  if (content.empty()) return content;
  kDamages[below(random, kDamages.size())](content, random);
  return content;
}

}  // namespace ridgeline::test
