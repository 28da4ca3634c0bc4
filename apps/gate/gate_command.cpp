// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"
#include "apps/gate/gates_template.h"
#include "evaluate/files/gate_files.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/gates/gate_report.h"
#include "io/error.h"
#include "io/files/atomic_file.h"

#include <fmt/chrono.h>
#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

struct GateArguments {
  std::string results, gates, baseline, junit, summary, json;
  std::string init;
  bool overwrite = false;
  bool is_init = false;  ///< --init is given; without a file, the template is printed
};

std::string now_utc() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(std::time(nullptr)));
}

/// Whether the file has the name of an output file of `run` or `evaluate`.
bool is_result(const std::string& file) {
  const std::string name = fs::path(file).filename().string();
  return name == "run.json" || name == "stages.json" || name == "report.html" ||
         name.starts_with("evaluation.") || name.starts_with("table1.") ||
         name.starts_with("table2.");
}

/// The reports must not overwrite the gates, a file of the results, or each other.
void check_reports(const GateArguments& a) {
  std::vector<std::string> others{a.gates};
  for (const std::string& report : {a.junit, a.summary, a.json}) {
    if (report.empty()) continue;
    if (fs::exists(report) && is_result(report)) {
      throw io::IoError(report, "is an input and would be overwritten; choose another name");
    }
    results::check_output_file(report, others, a.overwrite);
    others.push_back(report);
  }
}

int write_template(const std::string& file) {
  if (file.empty()) {
    fmt::print("{}", gates_template());
    return kDone;
  }
  if (fs::exists(fs::symlink_status(file))) {
    throw io::IoError(file, "already exists; --init only creates new files");
  }
  io::write_file(file, gates_template());
  return kDone;
}

void check_given(const GateArguments& a) {
  if (!a.results.empty() && !a.gates.empty()) return;
  throw std::invalid_argument(
      fmt::format("gate: {} missing; RESULTS and --gates FILE are required. `ridgeline gate "
                  "--init` prints a gates file to start from",
                  a.results.empty() ? "RESULTS is" : "--gates is"));
}

int run_gate(const GateArguments& a) {
  if (a.is_init) return write_template(a.init);
  check_given(a);
  check_reports(a);
  const evaluate::GateReport report = results::apply_gate_files(a.gates, a.results, a.baseline);
  if (!a.junit.empty()) io::write_file(a.junit, evaluate::to_junit(report, now_utc()));
  if (!a.summary.empty()) io::write_file(a.summary, evaluate::to_markdown(report));
  if (!a.json.empty()) io::write_file(a.json, evaluate::to_json(report));
  answer(evaluate::to_terminal(report));
  if (std::getenv("GITHUB_ACTIONS") != nullptr) {
    for (const std::string& line : evaluate::to_annotations(report)) answer(line + "\n");
  }
  for (const std::string& warning : report.warnings) spdlog::warn("{}", warning);
  return report.passed() ? kDone : kGateFailed;
}

}  // namespace

Run add_gate(CLI::App& subcommand) {
  auto a = std::make_shared<GateArguments>();
  CLI::Option* results = subcommand.add_option(
      "results", a->results, "results folder of run, block, demo, evaluate or pool");
  CLI::Option* gates = subcommand.add_option("--gates", a->gates, "gates file (YAML)");
  CLI::Option* baseline = subcommand.add_option(
      "--baseline", a->baseline,
      "results folder of an earlier run on the same data, for gates with a baseline");
  subcommand.add_option("--junit", a->junit, "write JUnit XML with one test case per gate");
  subcommand.add_option("--summary", a->summary,
                        "write a Markdown summary for the page of a CI job");
  subcommand.add_option("--json", a->json, "write the verdicts as JSON");
  add_overwrite_flag(subcommand, a->overwrite);
  CLI::Option* init = subcommand.add_option("--init", a->init,
                                            "print a commented gates file with all keys and "
                                            "metrics, or write it to a new FILE; takes no results");
  init->expected(0, 1)->type_name("[FILE]")->excludes(results, gates, baseline);
  return [a, init] {
    a->is_init = init->count() > 0;
    return run_gate(*a);
  };
}

}  // namespace ridgeline::apps
