// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/display_width.h"

#include <algorithm>
#include <array>

namespace ridgeline::evaluate {
namespace {

struct CharacterRange {
  char32_t first, last;
};

constexpr char32_t kReplacement = 0xFFFD;

/// The Unicode combining marks and joiners that may occur in names.
constexpr std::array kNoWidth{CharacterRange{0x0300, 0x036F}, CharacterRange{0x200B, 0x200F},
                              CharacterRange{0x20D0, 0x20FF}, CharacterRange{0xFE00, 0xFE0F},
                              CharacterRange{0xFE20, 0xFE2F}};

/// The characters of East Asian Width W and F (Unicode Standard Annex 11), by blocks.
constexpr std::array kDoubleWidth{
    CharacterRange{0x1100, 0x115F},   CharacterRange{0x2E80, 0x303E},
    CharacterRange{0x3041, 0xA4CF},   CharacterRange{0xAC00, 0xD7A3},
    CharacterRange{0xF900, 0xFAFF},   CharacterRange{0xFE30, 0xFE6F},
    CharacterRange{0xFF00, 0xFF60},   CharacterRange{0xFFE0, 0xFFE6},
    CharacterRange{0x1F300, 0x1FAFF}, CharacterRange{0x20000, 0x3FFFD}};

template <std::size_t N>
bool is_in(const std::array<CharacterRange, N>& ranges, char32_t c) {
  return std::ranges::any_of(ranges,
                             [c](const CharacterRange& r) { return r.first <= c && c <= r.last; });
}

bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

/// Number of bytes that follow the first byte of a character; 0 for a byte that cannot start one.
std::size_t n_following(unsigned char first) {
  if (first < 0xC2 || first > 0xF4) return 0;
  if (first >= 0xF0) return 3;
  return first >= 0xE0 ? 2 : 1;
}

/// Returns the character at `at` and moves `at` past it; U+FFFD for a byte that is not part of a
/// character.
char32_t next(std::string_view text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  if (first < 0x80) return first;
  const std::size_t n = n_following(first);
  if (n == 0 || text.size() - at < n) return kReplacement;
  char32_t c = first & (0x3FU >> n);
  for (const char byte : text.substr(at, n)) {
    const auto bits = static_cast<unsigned char>(byte);
    if ((bits & 0xC0U) != 0x80U) return kReplacement;
    c = (c << 6U) | (bits & 0x3FU);
  }
  at += n;
  return c;
}

}  // namespace

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char32_t c = next(text, at);
    if (is_in(kNoWidth, c)) continue;
    width += is_in(kDoubleWidth, c) ? 2 : 1;
  }
  return width;
}

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    const char32_t c = next(text, at);
    if (is_control(c)) {
      result += ' ';
    } else if (c == kReplacement) {
      result += "\xEF\xBF\xBD";
    } else {
      result += text.substr(begin, at - begin);
    }
  }
  return result;
}

}  // namespace ridgeline::evaluate
