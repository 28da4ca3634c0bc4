// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/unread_elements.h"

#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace ridgeline::io {
namespace {

bool is_off(const std::string& text) {
  return text.empty() || lower_case(text) == "false" || to_double(text) == 0.0;
}

}  // namespace

void UnreadElements::note(const XmlElement& element,
                          std::initializer_list<std::string_view> known) {
  for (const XmlElement& child : element.children()) {
    const bool is_property = child.name() == "property";
    const std::string name = is_property ? child.attribute("name") : child.name();
    if (std::ranges::find(known, name) != known.end()) continue;
    const bool is_empty = is_off(is_property ? child.attribute("value") : child.text());
    if (is_empty && child.children().empty()) continue;
    ++counts_[fmt::format("{} in {}", name, element.name())];
  }
}

std::string UnreadElements::sentence() const {
  std::string list;
  for (const auto& [name, count] : counts_) {
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", name, count);
  }
  return list.empty() ? "" : "elements that are not read: " + list;
}

}  // namespace ridgeline::io
