// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/compare/matcher_runs.h"
#include "evaluate/compare/comparison.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/files/result_folder_reader.h"
#include "evaluate/gates/metric.h"
#include "evaluate/tables/format.h"
#include "evaluate/tables/shift_text.h"
#include "io/text/text.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace ridgeline::apps {
namespace {

struct CompareArguments {
  std::vector<std::string> folders;
  std::string out;
  std::vector<std::string> fail_if_worse;  ///< METRIC:MARGIN
};

struct Margin {
  evaluate::Metric metric;
  double margin;
};

/// Line figures for which one direction is worse.
std::vector<evaluate::Metric> metrics_with_a_worse_side() {
  std::vector<evaluate::Metric> metrics = evaluate::accuracy_metrics();
  std::erase_if(metrics, [](const evaluate::Metric& metric) { return metric.is_signed; });
  return metrics;
}

Margin parsed_margin(const std::string& text) {
  const std::size_t colon = text.find(':');
  const double margin =
      colon == std::string::npos ? -1.0 : io::to_double(text.substr(colon + 1)).value_or(-1.0);
  check(margin >= 0.0, "--fail-if-worse ", text,
        ": must be METRIC:MARGIN with a margin of 0 or more, as rms_m:0.01");
  const std::vector<evaluate::Metric> metrics = metrics_with_a_worse_side();
  const std::string name = text.substr(0, colon);
  const auto known = std::ranges::find(metrics, name, &evaluate::Metric::name);
  check(known != metrics.end(), "--fail-if-worse ", text, ": the metric must be one of ",
        fmt::format(
            "{}",
            fmt::join(transformed(metrics, [](const auto& metric) { return metric.name; }), ", ")));
  return {*known, margin};
}

/// One sentence per figure that is worse by more than its margin.
std::string worse_text(const evaluate::ComparisonReport& report,
                       const std::vector<Margin>& margins) {
  std::string text;
  for (const auto& [metric, margin] : margins) {
    const std::string_view name = metric.name;
    const auto figure = [name](const evaluate::Summary& s) { return metric_value(s, name); };
    const bool more_is_better = name.starts_with("evaluated_share");
    for (const auto& f : evaluate::worse_figures(report, figure, more_is_better, margin)) {
      text +=
          fmt::format("Worse: patch {}: {} by more than {}: {} in {}, {} in {}\n", f.patch, name,
                      margin, evaluate::fixed(f.a, 4), f.name_a, evaluate::fixed(f.b, 4), f.name_b);
    }
  }
  return text;
}

/// Compares the methods of a single folder with each other, or each further folder with the first.
evaluate::ComparisonReport compare_all(const std::vector<evaluate::ResultFolder>& folders) {
  evaluate::ComparisonReport report;
  if (folders.size() > 1) {
    report = evaluate::compare_folders(folders);
  } else {
    report.comparisons = evaluate::compare_methods(folders.front());
    check(!report.comparisons.empty(), "compare: ", folders.front().name,
          " has only one method; give a second folder");
  }
  for (const evaluate::ResultFolder& folder : folders) {
    for (const std::string& note : evaluate::moved_notes(folder.evaluations)) {
      report.warnings.push_back(folder.name + ": " + note);
    }
  }
  return report;
}

/// Writes `comparison` to the terminal, and into the folder `out` if one is given.
template <typename Compared>
void write_comparison(const Compared& comparison, const std::string& out) {
  if (!out.empty()) {
    const results::OutputFolder folder(out, {}, "compare.json");
    folder.write("compare.md", evaluate::to_markdown(comparison));
    folder.write_record(evaluate::Json::parse(evaluate::to_json(comparison)));
  }
  answer(evaluate::to_terminal(comparison));
}

int run_compare(const CompareArguments& a) {
  const std::vector<Margin> margins = transformed(a.fail_if_worse, parsed_margin);
  if (margins.empty() && have_different_matchers(a.folders) && match_same_segments(a.folders)) {
    const std::vector<evaluate::MatcherFigures> rows = read_matcher_figures(a.folders);
    check(!rows.empty(), "compare: the runs have no patch in common");
    write_comparison(rows, a.out);
    return kDone;
  }
  const evaluate::ComparisonReport report =
      compare_all(transformed(a.folders, results::read_result_folder));
  write_comparison(report, a.out);
  const std::string worse = worse_text(report, margins);
  fmt::print("{}", worse);
  return worse.empty() ? kDone : kGateFailed;
}

}  // namespace

Run add_compare(CLI::App& subcommand) {
  auto a = std::make_shared<CompareArguments>();
  subcommand
      .add_option("folders", a->folders,
                  "results folders of evaluate, run, block or demo; with one folder, its methods "
                  "are compared; for runs with different matchers of the same segments, shows what "
                  "each one finds")
      ->required();
  subcommand.add_option("--out", a->out, "folder for compare.md and compare.json");
  subcommand
      .add_option(
          "--fail-if-worse", a->fail_if_worse,
          "METRIC:MARGIN: exit with code 3 if the total figure of another folder is worse than "
          "that of the first by more than the margin, e.g. rms_m:0.01 or evaluated_share:0.05")
      ->allow_extra_args(false);
  return [a] { return run_compare(*a); };
}

}  // namespace ridgeline::apps
