// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/compare/matcher_runs.h"
#include "evaluate/compare/comparison.h"
#include "evaluate/tables/shift_text.h"
#include "io/files/atomic_file.h"
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

/// Compares the methods of a single folder with each other, or each further folder with the first.
evaluate::ComparisonReport compare_all(const std::vector<std::string>& paths) {
  std::vector<evaluate::ResultFolder> folders;
  folders.reserve(paths.size());
  for (const std::string& path : paths) folders.push_back(results::read_result_folder(path));
  evaluate::ComparisonReport report;
  if (folders.size() > 1) {
    report = evaluate::compare_folders(folders);
  } else {
    report.comparisons = evaluate::compare_methods(folders.front());
    check(!report.comparisons.empty(), "compare: ", paths.front(),
          " holds one method; give a second folder");
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
    const std::filesystem::path folder(out);
    io::write_file((folder / "compare.md").string(), evaluate::to_markdown(comparison));
    io::write_file((folder / "compare.json").string(), evaluate::to_json(comparison));
  }
  fmt::print("{}", evaluate::to_terminal(comparison));
}

int run_compare(const CompareArguments& a) {
  if (have_different_matchers(a.folders)) {
    const std::vector<evaluate::MatcherFigures> rows = read_matcher_figures(a.folders);
    check(!rows.empty(), "compare: the runs have no patch in common");
    write_comparison(rows, a.out);
  } else {
    write_comparison(compare_all(a.folders), a.out);
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
