// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"
#include "apps/report/write_report.h"
#include "evaluate/files/gate_files.h"

#include <memory>

namespace ridgeline::apps {
namespace {

struct ReportArguments {
  std::string results, gates, baseline;
  PageFacts page;
};

int run_report(const ReportArguments& a) {
  std::optional<evaluate::GateReport> gates;
  if (!a.gates.empty()) gates = results::apply_gate_files(a.gates, a.results, a.baseline);
  say("Report: {}\n", write_report(a.results, gates, to_json(a.page)));
  return kDone;
}

}  // namespace

Run add_report(CLI::App& subcommand) {
  auto a = std::make_shared<ReportArguments>();
  subcommand.add_option("results", a->results, "results folder of evaluate, run, block or demo")
      ->required();
  CLI::Option* gates = subcommand.add_option(
      "--gates", a->gates, "gates file (YAML) for the verdict at the top of the report");
  subcommand
      .add_option("--baseline", a->baseline, "results folder of an earlier run on the same data")
      ->needs(gates);
  add_page_options(subcommand, a->page);
  return [a] { return run_report(*a); };
}

}  // namespace ridgeline::apps
