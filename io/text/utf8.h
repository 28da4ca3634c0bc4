// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace ridgeline::io {

/// The text without the byte order mark of UTF-8 that it may begin with.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

/// Whether the bytes are UTF-8 of RFC 3629: no overlong forms, no surrogates.
bool is_utf8(std::string_view bytes);

/// The text in UTF-8. Bytes that are no UTF-8 are taken as Latin-1.
std::string as_utf8(std::string_view text);

}  // namespace ridgeline::io
