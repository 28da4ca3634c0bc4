// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/patch_matchers.h"

#include <fmt/core.h>

#include <algorithm>

namespace ridgeline::apps {

using reconstruct::Matcher;

void add_matcher_option(CLI::App& app, std::vector<std::string>& names) {
  app.add_option("--matcher", names, "of the line segments: pairwise, chio, or both: pairwise,chio")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"pairwise", "chio"}))
      ->capture_default_str();
}

std::vector<Matcher> matchers_named(const std::vector<std::string>& names) {
  std::vector<Matcher> matchers;
  for (const Matcher matcher : {Matcher::kPairwise, Matcher::kChio}) {
    if (std::find(names.begin(), names.end(), name(matcher)) != names.end()) {
      matchers.push_back(matcher);
    }
  }
  return matchers;
}

std::string unmatched_csv(const reconstruct::MatchList& list) {
  std::string text = "left_id,reason\n";
  for (std::size_t i = 0; i < list.reasons.size(); ++i) {
    if (list.reasons[i] == "matched") continue;
    text += fmt::format("{},{}\n", i, list.reasons[i]);
  }
  return text;
}

}  // namespace ridgeline::apps
