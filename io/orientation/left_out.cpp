// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/left_out.h"

#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace ridgeline::io {

void LeftOut::add(std::string_view reason, std::string item) {
  auto entry = std::ranges::find(items_, reason,
                                 [](const auto& one) -> const std::string& { return one.first; });
  if (entry == items_.end()) entry = items_.insert(items_.end(), {std::string(reason), {}});
  entry->second.push_back(std::move(item));
}

std::vector<std::string> LeftOut::sentences() const {
  static constexpr std::size_t kMaxNamed = 5;
  return transformed(items_, [](const auto& entry) {
    const auto& [reason, items] = entry;
    const std::span named(items.data(), std::min(items.size(), kMaxNamed));
    return fmt::format("{}, left out: {} ({}{})", reason, items.size(), fmt::join(named, ", "),
                       items.size() > kMaxNamed ? ", ..." : "");
  });
}

}  // namespace ridgeline::io
