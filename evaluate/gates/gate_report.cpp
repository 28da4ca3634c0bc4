// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/gates/gate_report.h"

#include "evaluate/tables/format.h"
#include "evaluate/tables/summary_json.h"
#include "evaluate/tables/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ridgeline::evaluate {
namespace {

constexpr int kDecimals = 4;  // limits may be finer than the tables' millimetres

std::string number(std::optional<double> value) { return fixed(value, kDecimals); }

std::string cell_name(const GateResult& r) {
  return fmt::format("patch {}, {}", r.patch, r.method);
}

/// Every number of a result, one "key: value" per line.
std::string details(const GateResult& r) {
  return fmt::format(
      "gate: {}\npatch: {}\nclass: {}\nmethod: {}\nverdict: {}\nvalue: {}\n95 % interval: {}\n"
      "clusters: {}\nbound: {}\nlimit: {}\nbaseline: {}\nn: {}\ncoverage: {}\n{}\n",
      r.rule, r.patch, r.line_class.empty() ? kNoValue : std::string_view(r.line_class), r.method,
      name(r.verdict), number(r.value),
      r.ci95 ? fmt::format("{} - {}", number(r.ci95->low), number(r.ci95->high)) : "-",
      r.n_clusters > 0 ? std::to_string(r.n_clusters) : std::string(kNoValue), name(r.bound),
      number(r.limit), number(r.baseline), r.n, number(r.evaluated_share), r.explanation);
}

std::size_t count_failed(const GateReport& report) {
  return static_cast<std::size_t>(
      std::count_if(report.results.begin(), report.results.end(),
                    [](const GateResult& r) { return r.verdict != Verdict::kPassed; }));
}

std::string note_of(const GateResult& r) {
  if (!r.baseline_can_be_tightened) return r.explanation;
  return r.explanation + (r.explanation.empty() ? "" : "; ") + "baseline can be tightened";
}

/// The table of the results, failures first.
PrintedTable table_of(const GateReport& report) {
  std::vector<GateResult> rows = report.results;
  std::stable_partition(rows.begin(), rows.end(),
                        [](const GateResult& r) { return r.verdict != Verdict::kPassed; });
  PrintedTable table({"gate", "patch", "method"},
                     {{"value:", "limit:", "baseline:", "n:", "verdict"}});
  for (const GateResult& r : rows) {
    table.add(r.rule, r.patch, r.method, number(r.value), number(r.limit), number(r.baseline), r.n,
              name(r.verdict));
    table.add_note(note_of(r));
  }
  return table;
}

std::string verdict_line(const GateReport& report, Markup markup) {
  const char* bold = markup == Markup::kMarkdown ? "**" : "";
  return fmt::format("Accuracy gate: {}{}{} ({} of {} checks passed).\n\n", bold,
                     report.passed() ? "passed" : "failed", bold,
                     report.results.size() - count_failed(report), report.results.size());
}

/// A part of a JUnit class name. Viewers interpret dots as levels and build paths from it, so every
/// character except letters, digits and - becomes _. The testcase name contains patch and method
/// unchanged.
std::string classname_part(std::string_view text) {
  std::string result(text);
  const auto is_kept = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  std::replace_if(
      result.begin(), result.end(), [&](char c) { return !is_kept(c); }, '_');
  return result;
}

/// `text` escaped for XML, with invalid UTF-8 bytes replaced. File names may contain such bytes,
/// and readers reject the whole XML because of them.
std::string xml_text(std::string_view text) {
  return escape_xml(Json::parse(dump(Json(text))).get<std::string>());
}

std::string escape_percent(std::string_view text, std::string_view special) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) == std::string_view::npos) {
      result += c;
    } else {
      result += fmt::format("%{:02X}", static_cast<unsigned>(c));
    }
  }
  return result;
}

}  // namespace

std::string to_junit(const GateReport& report, std::string_view timestamp) {
  const std::string counts =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\" time=\"0\"",
                  report.results.size(), count_failed(report));
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"ridgeline gate\" {}>\n"
      "  <testsuite name=\"ridgeline gate\" {} timestamp=\"{}\">\n",
      counts, counts, xml_text(timestamp));
  for (const GateResult& r : report.results) {
    xml += fmt::format("    <testcase classname=\"ridgeline.gate.{}.{}\" name=\"{}\" time=\"0\"",
                       classname_part(r.patch), classname_part(r.method),
                       xml_text(fmt::format("{} ({})", r.rule, cell_name(r))));
    if (r.verdict == Verdict::kPassed) {
      xml += "/>\n";
      continue;
    }
    xml +=
        fmt::format(">\n      <failure message=\"{}\" type=\"{}\">{}</failure>\n    </testcase>\n",
                    xml_text(r.explanation), name(r.verdict), xml_text(details(r)));
  }
  return xml + "  </testsuite>\n</testsuites>\n";
}

std::string to_markdown(const GateReport& report, std::size_t max_bytes) {
  const PrintedTable table = table_of(report);
  std::string tail = "\n";
  for (const std::string& warning : report.warnings) {
    tail += "Warning: " + escape_markdown(warning) + "\n\n";
  }
  constexpr std::size_t kMaxTailBytes = 4096;  // a few warnings per patch and method
  constexpr std::size_t kNoteBytes = 128;
  if (tail.size() > kMaxTailBytes) tail = fmt::format("\n{} warnings.\n", report.warnings.size());

  std::string text = verdict_line(report, Markup::kMarkdown) + table.markdown_head();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::string row = table.markdown_row(i);
    if (text.size() + row.size() + tail.size() + kNoteBytes > max_bytes) {
      text += fmt::format("\n{} more rows: see the JUnit file of this job.\n", table.size() - i);
      break;
    }
    text += row;
  }
  return text + tail;
}

std::string to_terminal(const GateReport& report) {
  return verdict_line(report, Markup::kPlain) + table_of(report).text(Markup::kPlain);
}

std::string to_json(const GateReport& report) {
  Json gates = Json::array();
  for (const GateResult& r : report.results) {
    gates.push_back({{"rule", r.rule},
                     {"patch", r.patch},
                     {"method", r.method},
                     {"class", r.line_class},
                     {"metric", r.metric},
                     {"n_images", r.n_images ? Json(*r.n_images) : Json(nullptr)},
                     {"decided_by", r.decided_by ? Json(name(*r.decided_by)) : Json(nullptr)},
                     {"value", number_json(r.value)},
                     {"ci95", interval_json(r.ci95)},
                     {"n_clusters", r.n_clusters > 0 ? Json(r.n_clusters) : Json(nullptr)},
                     {"bound", name(r.bound)},
                     {"limit", number_json(r.limit)},
                     {"baseline", number_json(r.baseline)},
                     {"n", r.n},
                     {"evaluated_share", number_json(r.evaluated_share)},
                     {"verdict", name(r.verdict)},
                     {"explanation", r.explanation},
                     {"baseline_can_be_tightened", r.baseline_can_be_tightened}});
  }
  return dump(Json{
      {"passed", report.passed()}, {"gates", std::move(gates)}, {"warnings", report.warnings}});
}

std::vector<std::string> to_annotations(const GateReport& report) {
  constexpr std::size_t kMaxPerType = 10;
  std::vector<std::string> commands;
  for (const GateResult& r : report.results) {
    if (r.verdict == Verdict::kPassed || commands.size() == kMaxPerType) continue;
    commands.push_back(fmt::format(
        "::error title={}::{}", escape_annotation_property("Gate " + r.rule),
        escape_annotation(fmt::format("{}: {} (value {}, limit {}, n {})", cell_name(r),
                                      r.explanation, number(r.value), number(r.limit), r.n))));
  }
  const std::size_t n_warnings = std::min(kMaxPerType, report.warnings.size());
  for (std::size_t i = 0; i < n_warnings; ++i) {
    commands.push_back("::warning title=Gate::" + escape_annotation(report.warnings[i]));
  }
  return commands;
}

std::string escape_annotation(std::string_view text) { return escape_percent(text, "%\r\n"); }

std::string escape_annotation_property(std::string_view text) {
  return escape_percent(text, "%\r\n:,");
}

}  // namespace ridgeline::evaluate
