// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/lod.h"

#include "io/text/text.h"

#include <algorithm>
#include <string_view>

namespace ridgeline::io {
namespace {

/// Level 0 is a footprint, level 4 has rooms.
constexpr double kMinLevel = 1.0;
constexpr double kBelow = 4.0;

double level_of(const std::string& lod) { return to_double(lod).value_or(kMinLevel); }

bool is_of(const std::string& lod, std::string_view wanted) {
  if (wanted.empty()) return level_of(lod) >= kMinLevel && level_of(lod) < kBelow;
  return lod == wanted ||
         (wanted.size() == 1 && lod.starts_with(wanted) && lod.size() > 1 && lod[1] == '.');
}

}  // namespace

std::optional<std::string> chosen_lod(const std::set<std::string>& lods,
                                      const std::string& wanted) {
  const std::string* chosen = nullptr;
  for (const std::string& lod : lods) {
    if (is_of(lod, wanted) && (chosen == nullptr || level_of(lod) >= level_of(*chosen)))
      chosen = &lod;
  }
  return chosen == nullptr ? std::nullopt : std::optional(*chosen);
}

}  // namespace ridgeline::io
