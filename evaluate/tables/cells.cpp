// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/cells.h"

#include "evaluate/tables/format.h"

#include <fmt/format.h>

namespace ridgeline::evaluate {

std::string interval_text(const std::optional<Interval>& interval_m) {
  if (!interval_m) return std::string(kNoValue);
  return fmt::format("{} - {}", metres(interval_m->low), metres(interval_m->high));
}

std::string interval_text(const Summary& summary) {
  const bool is_doubtful = summary.ci95_m && summary.few_clusters();
  return interval_text(summary.ci95_m) + (is_doubtful ? " (too few clusters)" : "");
}

std::string rms_text(const Summary* summary) {
  if (summary == nullptr) return std::string(kNoValue);
  return fmt::format("{} ({}/{})", metres(summary->rms_m), summary->n_evaluated, summary->n_lines);
}

std::string headline_text(const Summary* summary) {
  if (summary == nullptr || summary->by_group.empty()) return rms_text(summary);
  return fmt::format("{} + {}", rms_text(&summary->by_group[0]), rms_text(&summary->by_group[1]));
}

std::vector<ClassRow> rows_of(const Summary& summary) {
  if (summary.by_group.empty()) return {{summary.line_class, summary}};
  std::vector<ClassRow> rows;
  rows.reserve(std::size(kDecidedGroups) + 1);
  for (const DecidedGroup group : kDecidedGroups) {
    rows.push_back(
        {fmt::format("{} {}", summary.line_class, name(group)), summary.of_group(group)});
  }
  rows.push_back({summary.line_class + " all", summary});
  return rows;
}

}  // namespace ridgeline::evaluate
