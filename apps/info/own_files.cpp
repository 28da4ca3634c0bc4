// SPDX-License-Identifier: BSD-3-Clause
#include "apps/info/own_files.h"

#include "apps/common/say.h"
#include "apps/pipeline/parameters.h"
#include "evaluate/files/gate_files.h"
#include "evaluate/files/result_folder_reader.h"
#include "evaluate/tables/evaluation_json.h"
#include "io/error.h"
#include "io/files/csv_table.h"
#include "io/files/text_file.h"
#include "io/files/yaml_check.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace ridgeline::apps {
namespace {

using io::FileGroup;

/// The name of a kind without its article, for a title: "gates file".
std::string_view without_article(std::string_view what) {
  for (const std::string_view article : {"a ", "an ", "the "}) {
    if (what.starts_with(article)) return what.substr(article.size());
  }
  return what;
}

void print_gates(const std::string& path) {
  fmt::print("  gates       {}\n", results::read_gates(path).size());
  print_use(fmt::format("ridgeline gate RESULTS --gates {}", path));
}

void print_config(const std::string& path) {
  ParameterArguments arguments;
  arguments.config = path;
  (void)read_parameters(arguments);  // every key and value is checked
  std::vector<std::string> groups;
  for (const auto& group : io::load_yaml(path)) {
    groups.push_back(fmt::format("{} ({} values)", group.first.Scalar(), group.second.size()));
  }
  fmt::print("  groups      {}\n", fmt::join(groups, ", "));
  print_use(fmt::format("--config {} of run, extract, match, reconstruct or evaluate", path));
}

void print_rows(const std::string& path, const io::FileKind& kind) {
  fmt::print("  rows        {}\n", io::CsvTable(path).size());
  print_use(kind.advice);
}

void print_line_counts(const std::vector<evaluate::Evaluation>& evaluations) {
  std::size_t n_lines = 0;
  std::size_t n_judged = 0;
  for (const evaluate::Evaluation& evaluation : evaluations) {
    n_lines += evaluation.lines.size();
    n_judged += static_cast<std::size_t>(std::ranges::count(
        evaluation.lines, evaluate::Status::kEvaluated, &evaluate::LineEvaluation::status));
  }
  fmt::print("  lines       {}, {} of them judged\n", n_lines, n_judged);
}

void print_evaluation(const std::string& path, const io::FileKind& kind) {
  try {
    const evaluate::Evaluation evaluation = evaluate::parse_evaluation(io::read_text_file(path));
    fmt::print("  patch       {}\n  method      {}\n", evaluation.patch, evaluation.method);
    print_line_counts({evaluation});
  } catch (const std::invalid_argument& error) {
    throw io::IoError(path, error.what());
  }
  print_use(kind.advice);
}

/// The distinct values of the member `name`, in the order of the results.
std::vector<std::string> names_of(const std::vector<evaluate::Evaluation>& evaluations,
                                  std::string evaluate::Evaluation::*name) {
  std::vector<std::string> names;
  for (const evaluate::Evaluation& evaluation : evaluations) {
    const std::string& one = evaluation.*name;
    if (std::ranges::find(names, one) == names.end()) names.push_back(one);
  }
  return names;
}

void print_results(const std::string& folder) {
  const evaluate::ResultFolder results = results::read_result_folder(folder);
  const auto join = [&](std::string evaluate::Evaluation::*name) {
    return fmt::format("{}", fmt::join(names_of(results.evaluations, name), ", "));
  };
  if (!results.is_of_line_files) {
    fmt::print("  patches     {}\n", join(&evaluate::Evaluation::patch));
  }
  fmt::print("  {:<11} {}\n", results.is_of_line_files ? "line files" : "methods",
             join(&evaluate::Evaluation::method));
  print_line_counts(results.evaluations);
  std::string use =
      fmt::format("ridgeline gate {0} --gates GATES.yaml, ridgeline compare {0}", folder);
  const std::filesystem::path report = std::filesystem::path(folder) / "report.html";
  use += std::filesystem::exists(report) ? fmt::format("; open {}", report.string())
                                         : fmt::format(", ridgeline report {}", folder);
  print_use(use);
}

std::string title_of(const std::string& path, const io::FileKind& kind) {
  if (kind.group != FileGroup::kResultFolder) return std::string(without_article(kind.what));
  const evaluate::Json run = results::read_run_json(path);
  const bool is_named = run.contains("command") && run["command"].is_string();
  return is_named ? "results of ridgeline " + run["command"].get<std::string>() : "results";
}

}  // namespace

bool is_own_file(FileGroup group) {
  switch (group) {
    case FileGroup::kGates:
    case FileGroup::kConfig:
    case FileGroup::kMatches:
    case FileGroup::kReferenceMatches:
    case FileGroup::kReferenceTracks:
    case FileGroup::kSegments:
    case FileGroup::kEvaluation:
    case FileGroup::kResult:
    case FileGroup::kResultFolder:
      return true;
    default:
      return false;
  }
}

void print_own_file(const std::string& path, const io::FileKind& kind) {
  fmt::print("{}: {}\n", path, title_of(path, kind));
  const bool is_table = path.ends_with(".csv");
  if (kind.group == FileGroup::kGates) return print_gates(path);
  if (kind.group == FileGroup::kConfig) return print_config(path);
  if (kind.group == FileGroup::kEvaluation) return print_evaluation(path, kind);
  if (kind.group == FileGroup::kResultFolder) return print_results(path);
  if (kind.group != FileGroup::kResult || is_table) return print_rows(path, kind);
  print_use(kind.advice);
}

void print_use(const std::string& what) { answer(fmt::format("  use         {}\n", what)); }

}  // namespace ridgeline::apps
