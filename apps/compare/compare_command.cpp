// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/exit_code.h"
#include "apps/compare/matcher_runs.h"
#include "evaluate/compare/comparison.h"
#include "io/atomic_file.h"
#include "io/results/result_folder_reader.h"
#include "reconstruct/geometry/check.h"

#include <fmt/core.h>

#include <filesystem>
#include <memory>

namespace ridgeline::apps {
namespace {

struct CompareArguments {
  std::vector<std::string> folders;
  std::string out;
};

/// One folder: its methods among each other. Several: each with the first.
evaluate::ComparisonReport compare_all(const std::vector<std::string>& paths) {
  std::vector<evaluate::ResultFolder> folders;
  folders.reserve(paths.size());
  for (const std::string& path : paths) folders.push_back(results::read_result_folder(path));
  if (folders.size() > 1) return evaluate::compare_folders(folders);
  evaluate::ComparisonReport report;
  report.comparisons = evaluate::compare_methods(folders.front());
  check(!report.comparisons.empty(), "compare: ", paths.front(),
        " holds one method; give a second folder");
  return report;
}

/// Markdown to the output, and both forms to the folder, if one is given.
void write_comparison(const std::string& markdown,
                      const std::string& json,
                      const std::string& out) {
  if (!out.empty()) {
    const std::filesystem::path folder(out);
    io::write_file((folder / "compare.md").string(), markdown);
    io::write_file((folder / "compare.json").string(), json);
  }
  fmt::print("{}", markdown);
}

int run_compare(const CompareArguments& a) {
  if (have_different_matchers(a.folders)) {
    const std::vector<evaluate::MatcherFigures> rows = read_matcher_figures(a.folders);
    check(!rows.empty(), "compare: the runs have no patch in common");
    write_comparison(evaluate::to_markdown(rows), evaluate::to_json(rows), a.out);
  } else {
    const evaluate::ComparisonReport report = compare_all(a.folders);
    write_comparison(evaluate::to_markdown(report), evaluate::to_json(report), a.out);
  }
  return kDone;
}

}  // namespace

Run add_compare(CLI::App& subcommand) {
  auto a = std::make_shared<CompareArguments>();
  subcommand
      .add_option(
          "folders", a->folders,
          "folders that evaluate, run or demo wrote; one: its methods are compared; of runs "
          "with different matchers: what each of these finds")
      ->required();
  subcommand.add_option("--out", a->out, "folder for compare.md and compare.json");
  return [a] { return run_compare(*a); };
}

}  // namespace ridgeline::apps
