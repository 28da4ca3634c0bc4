// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/cells.h"

#include "evaluate/tables/format.h"

namespace ridgeline::evaluate {

std::string markdown_head(const std::vector<std::string>& columns) {
  std::string head = "|";
  std::string rule = "|";
  for (const std::string& column : columns) {
    const bool is_right = column.ends_with(':');
    head += " " + column.substr(0, column.size() - (is_right ? 1 : 0)) + " |";
    rule += is_right ? "--:|" : "---|";
  }
  return head + "\n" + rule + "\n";
}

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

}  // namespace ridgeline::evaluate
