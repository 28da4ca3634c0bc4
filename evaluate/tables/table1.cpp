// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/table1.h"

#include "evaluate/tables/format.h"
#include "evaluate/tables/summary_json.h"
#include "evaluate/tables/text_table.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

constexpr int kShareDecimals = 3;  // the published tenths of a percent

std::string share_with_interval(std::optional<double> share, const std::optional<Interval>& ci95) {
  if (!ci95) return percent(share);
  return fmt::format("{} ({} - {})", percent(share), percent(ci95->low), percent(ci95->high));
}

std::size_t number_of(const Json& row, const char* key) {
  const Json& value = row.at(key);
  check(value.is_number_unsigned(), key, ": ", value.dump(), "; must be a whole number >= 0");
  return value.get<std::size_t>();
}

}  // namespace

std::string to_markdown(const Table1& table) {
  TextTable written({"patch", "matcher", "correct:", "false:", "missed:", "correctness %:",
                     "completeness %:", "quality %:"});
  for (const Table1Row& row : table.rows) {
    const MatchQuality q = match_quality(row.counts);
    written.add(row.patch, row.matcher, row.counts.n_correct, row.counts.n_false,
                row.counts.n_missed, share_with_interval(q.correctness, q.correctness_ci95),
                share_with_interval(q.completeness, q.completeness_ci95),
                share_with_interval(q.quality, q.quality_ci95));
  }
  std::string text = written.text(Markup::kMarkdown) +
                     "\nIn parentheses: 95 % Wilson interval. Basis: number of matches.\n";
  for (const Table1Row& row : table.rows) {
    if (row.n_unjudged == 0) continue;
    text +=
        fmt::format("Patch {}, {}: {} more matches, of lines that the reference does not hold.\n",
                    escape_markdown(row.patch), escape_markdown(row.matcher), row.n_unjudged);
  }
  return text;
}

std::string to_csv(const Table1& table) {
  std::string text = "patch,matcher,correct,false,missed,correctness,completeness,quality\n";
  const auto share = [](std::optional<double> value) { return fixed(value, kShareDecimals, ""); };
  for (const Table1Row& row : table.rows) {
    const MatchQuality q = match_quality(row.counts);
    text += fmt::format("{},{},{},{},{},{},{},{}\n", escape_csv(row.patch), escape_csv(row.matcher),
                        row.counts.n_correct, row.counts.n_false, row.counts.n_missed,
                        share(q.correctness), share(q.completeness), share(q.quality));
  }
  return text;
}

std::string to_json(const Table1& table) {
  Json rows = Json::array();
  for (const Table1Row& row : table.rows) {
    const MatchQuality q = match_quality(row.counts);
    rows.push_back({{"patch", row.patch},
                    {"matcher", row.matcher},
                    {"correct", row.counts.n_correct},
                    {"false", row.counts.n_false},
                    {"missed", row.counts.n_missed},
                    {"unjudged", row.n_unjudged},
                    {"correctness", number_json(q.correctness)},
                    {"correctness_ci95", interval_json(q.correctness_ci95)},
                    {"completeness", number_json(q.completeness)},
                    {"completeness_ci95", interval_json(q.completeness_ci95)},
                    {"quality", number_json(q.quality)},
                    {"quality_ci95", interval_json(q.quality_ci95)}});
  }
  return dump(Json{{"rows", std::move(rows)}});
}

Table1 parse_table1(std::string_view json) {
  Table1 table;
  try {
    const Json parsed = Json::parse(json);
    for (const Json& row : parsed.at("rows")) {
      table.rows.push_back(
          {row.at("patch").get<std::string>(),
           row.at("matcher").get<std::string>(),
           {number_of(row, "correct"), number_of(row, "false"), number_of(row, "missed")},
           number_of(row, "unjudged")});
    }
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("is no Table 1: ") + error.what());
  }
  return table;
}

}  // namespace ridgeline::evaluate
