// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/match_tables.h"

#include <fmt/core.h>

namespace ridgeline::apps {

std::string unmatched_csv(const reconstruct::MatchList& list) {
  std::string text = "left_id,reason\n";
  for (std::size_t i = 0; i < list.reasons.size(); ++i) {
    if (list.reasons[i] == "matched") continue;
    text += fmt::format("{},{}\n", i, list.reasons[i]);
  }
  return text;
}

}  // namespace ridgeline::apps
