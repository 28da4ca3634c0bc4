// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace ridgeline::apps {

/// The flag of an option: "corridor_half_width_m" -> "--corridor-half-width-m".
inline std::string flag_of(std::string_view option) {
  std::string flag = "--" + std::string(option);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

/// Converts option names in backticks, as used in messages of the libraries, to flags:
/// "declare it with `assume_crs`" -> "declare it with --assume-crs". Other text in backticks is
/// kept.
inline std::string as_flags(std::string_view text) {
  constexpr std::string_view kOfNames = "abcdefghijklmnopqrstuvwxyz0123456789_";
  std::string shown;
  for (std::size_t open = text.find('`'); open != text.npos; open = text.find('`')) {
    const std::size_t end = text.find('`', open + 1);
    if (end == text.npos) break;
    const std::string_view name = text.substr(open + 1, end - open - 1);
    const bool is_option = !name.empty() && name.find_first_not_of(kOfNames) == name.npos;
    shown += text.substr(0, is_option ? open : end);
    if (is_option) shown += flag_of(name);
    text.remove_prefix(is_option ? end + 1 : end);  // else the second tick may open the next name
  }
  return shown += text;
}

}  // namespace ridgeline::apps
