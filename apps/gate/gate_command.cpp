// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/exit_code.h"
#include "apps/common/result_folder_reader.h"
#include "evaluate/gates/gate.h"
#include "evaluate/gates/gate_report.h"
#include "io/atomic_file.h"
#include "io/error.h"
#include "io/gates_file.h"

#include <fmt/chrono.h>
#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

struct GateArguments {
  std::string results, gates, baseline, junit, summary, json;
};

std::optional<evaluate::BaselineAllowance> allowance(
    const std::optional<io::GateEntry::Allowance>& entry) {
  if (!entry) return std::nullopt;
  return evaluate::BaselineAllowance{entry->value};
}

evaluate::Gate gate_of(const io::GateEntry& entry) {
  evaluate::Gate gate;
  gate.patch = entry.patch;
  gate.method = entry.method;
  if (entry.line_class) gate.line_class = *entry.line_class;
  if (entry.metric) gate.metric = *entry.metric;
  gate.max = entry.max;
  gate.min = entry.min;
  gate.max_ratio_to_class = entry.max_ratio_to_class;
  if (entry.ratio) gate.ratio = *entry.ratio;
  gate.max_increase_over_baseline = allowance(entry.max_increase_over_baseline);
  gate.max_decrease_below_baseline = allowance(entry.max_decrease_below_baseline);
  if (entry.n_min) gate.n_min = static_cast<std::size_t>(*entry.n_min);
  return gate;
}

std::string now_utc() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(std::time(nullptr)));
}

evaluate::GateReport apply(const GateArguments& a) {
  std::vector<evaluate::Gate> gates;
  for (const io::GateEntry& entry : io::read_gates_file(a.gates)) gates.push_back(gate_of(entry));
  const evaluate::ResultFolder results = read_result_folder(a.results);
  if (a.baseline.empty()) return evaluate::apply_gates(gates, results);
  const evaluate::ResultFolder baseline = read_result_folder(a.baseline);
  return evaluate::apply_gates(gates, results, &baseline);
}

/// The reports must not land on what was read: the gates or a file of the results.
void refuse_writing_over_inputs(const GateArguments& a) {
  for (const std::string& report : {a.junit, a.summary, a.json}) {
    if (report.empty() || !fs::exists(report)) continue;
    const std::string name = fs::path(report).filename().string();
    const bool is_result =
        (name.starts_with("evaluation.") && name.ends_with(".json")) || name == "run.json";
    if (is_result || fs::equivalent(report, a.gates)) {
      throw io::IoError(report, "is an input and would be written over; choose another name");
    }
  }
}

int run_gate(const GateArguments& a) {
  evaluate::GateReport report;
  try {
    report = apply(a);
  } catch (const std::invalid_argument& error) {
    throw io::IoError(a.gates, error.what());
  }
  refuse_writing_over_inputs(a);
  const std::string markdown = evaluate::to_markdown(report);
  if (!a.junit.empty()) io::write_file(a.junit, evaluate::to_junit(report, now_utc()));
  if (!a.summary.empty()) io::write_file(a.summary, markdown);
  if (!a.json.empty()) io::write_file(a.json, evaluate::to_json(report));
  fmt::print("{}", markdown);
  if (std::getenv("GITHUB_ACTIONS") != nullptr) {
    for (const std::string& line : evaluate::to_annotations(report)) fmt::print("{}\n", line);
  }
  for (const std::string& warning : report.warnings) spdlog::warn("{}", warning);
  return report.passed() ? kDone : kGateFailed;
}

}  // namespace

Run add_gate(CLI::App& subcommand) {
  auto a = std::make_shared<GateArguments>();
  subcommand.add_option("results", a->results, "folder that evaluate, run or demo wrote")
      ->required();
  subcommand.add_option("--gates", a->gates, "gates file (YAML)")->required();
  subcommand.add_option("--baseline", a->baseline, "results of an earlier run on the same data");
  subcommand.add_option("--junit", a->junit, "write JUnit XML, one testcase per gate");
  subcommand.add_option("--summary", a->summary, "write Markdown for the job's page");
  subcommand.add_option("--json", a->json, "write the verdicts as JSON");
  return [a] { return run_gate(*a); };
}

}  // namespace ridgeline::apps
