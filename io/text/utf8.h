// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace ridgeline::io {

/// The text without a leading UTF-8 byte order mark.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

/// Whether the bytes are UTF-8 as defined by RFC 3629: no overlong forms, no surrogates.
bool is_utf8(std::string_view bytes);

/// The text in UTF-8. Bytes that are not UTF-8 are read as Latin-1.
std::string as_utf8(std::string_view text);

}  // namespace ridgeline::io
