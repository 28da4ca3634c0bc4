// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/matcher_runs.h"

#include "evaluate/files/result_folder_reader.h"
#include "io/error.h"
#include "io/files/csv_table.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

using Pair = std::pair<int, int>;  ///< left and right segment

/// The results of a run on one patch.
struct PatchOfRun {
  evaluate::MatcherFigures figures;
  std::set<Pair> matches;
  std::map<Pair, std::string> verdicts;  ///< empty without reference matches
};

/// The options in the run.json of a folder; std::nullopt if the file is missing or its options do
/// not include a matcher.
std::optional<nlohmann::json> options_of(const std::string& folder) {
  const fs::path file = fs::path(folder) / "run.json";
  if (!fs::exists(file)) return std::nullopt;
  const auto run = nlohmann::json::parse(io::read_text_file(file.string()), nullptr, false);
  if (!run.is_object() || !run.contains("options")) return std::nullopt;
  const nlohmann::json& options = run["options"];
  if (!options.is_object() || !options.contains("matcher")) return std::nullopt;
  return options;
}

std::set<Pair> pairs_in(const fs::path& file) {
  const io::CsvTable table(file.string());
  const std::size_t left = table.column("left_id");
  const std::size_t right = table.column("right_id");
  std::set<Pair> pairs;
  for (std::size_t row = 0; row < table.size(); ++row) {
    pairs.emplace(table.index(row, left), table.index(row, right));
  }
  return pairs;
}

std::set<std::string> segment_hashes(const fs::path& files) {
  std::set<std::string> hashes;
  for (const auto& entry : fs::directory_iterator(files)) {
    if (entry.path().filename().string().starts_with("segments."))
      hashes.insert(io::sha256_of_file(entry.path().string()));
  }
  return hashes;
}

std::map<Pair, std::string> verdicts_in(const fs::path& file) {
  std::map<Pair, std::string> verdicts;
  if (!fs::exists(file)) return verdicts;
  const io::CsvTable table(file.string());
  const std::size_t left = table.column("left_id");
  const std::size_t right = table.column("right_id");
  const std::size_t verdict = table.column("verdict");
  for (std::size_t row = 0; row < table.size(); ++row) {
    verdicts[{table.index(row, left), table.index(row, right)}] = table.text(row, verdict);
  }
  return verdicts;
}

/// Calls `visit(table, row)` for the rows of a patch. A missing file is treated as empty, because
/// runs without reference lines do not write every table.
template <typename Visit>
void for_rows_of(const fs::path& file, const std::string& patch, const Visit& visit) {
  if (!fs::exists(file)) return;
  const io::CsvTable table(file.string());
  const std::size_t column = table.column("patch");
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table.text(row, column) == patch) visit(table, row);
  }
}

std::size_t count(const io::CsvTable& table, std::size_t row, const char* column) {
  return static_cast<std::size_t>(table.index(row, table.column(column)));
}

double number_or_zero(const io::CsvTable& table, std::size_t row, const char* column) {
  const std::size_t c = table.column(column);
  return table.text(row, c).empty() ? 0.0 : table.number(row, c);
}

/// The last row is used: it belongs to the list of matches from which lines were reconstructed.
void read_table1(const fs::path& folder, evaluate::MatcherFigures& figures) {
  for (const evaluate::Table1Row& row : results::read_matching(folder, false).rows) {
    if (row.patch == figures.patch) figures.counts = row.counts;
  }
}

/// The last method is used: its rows replace those of earlier methods.
void read_accuracy(const fs::path& folder, evaluate::MatcherFigures& figures) {
  const auto is_total = [](const io::CsvTable& table, std::size_t row) {
    return table.text(row, table.column("class")) == "total";
  };
  for_rows_of(folder / "table2.csv", figures.patch,
              [&](const io::CsvTable& table, std::size_t row) {
                if (!is_total(table, row)) return;
                figures.n_lines = count(table, row, "n_lines");
                figures.n_evaluated = count(table, row, "n_evaluated");
                const double rms_m = number_or_zero(table, row, "rms_m");
                figures.sum_squares_m2 = rms_m * rms_m * static_cast<double>(figures.n_evaluated);
              });
  for_rows_of(folder / "reference_errors.csv", figures.patch,
              [&](const io::CsvTable& table, std::size_t row) {
                if (!is_total(table, row)) return;
                figures.n_true = count(table, row, "n_on_reference");
                const double rms_m = number_or_zero(table, row, "rms_m");
                const auto n = static_cast<double>(figures.n_true);
                figures.true_sum_squares_m2 = rms_m * rms_m * n;
                figures.n_true_gross = number_or_zero(table, row, "gross_share") * n;
              });
}

void read_coverage(const fs::path& folder, evaluate::MatcherFigures& figures) {
  std::string method;
  for_rows_of(folder / "reference_completeness.csv", figures.patch,
              [&](const io::CsvTable& table, std::size_t row) {
                const std::string_view kind = table.text(row, table.column("kind"));
                if (table.text(row, table.column("method")) != method) {
                  method = table.text(row, table.column("method"));
                  figures.n_roof_lines = figures.n_roof_lines_found = 0;
                }
                if (kind == "all" || kind == "ground") return;
                figures.n_roof_lines += count(table, row, "n_reference_lines");
                figures.n_roof_lines_found += count(table, row, "n_reconstructed");
              });
}

PatchOfRun read_patch_of_run(const std::string& folder, const std::string& patch) {
  PatchOfRun run;
  run.figures.patch = patch;
  run.figures.run = fs::path(folder).lexically_normal().filename().string();
  const fs::path files = fs::path(folder) / patch;
  run.matches = pairs_in(files / "matches.csv");
  run.figures.n_matches = run.matches.size();
  run.verdicts = verdicts_in(files / "verdicts.csv");
  read_table1(folder, run.figures);
  read_accuracy(folder, run.figures);
  read_coverage(folder, run.figures);
  return run;
}

/// The matcher of a run: "pairwise" or "chio".
std::string matcher_name(const std::string& folder) {
  const std::string file = (fs::path(folder) / "run.json").string();
  try {
    return options_of(folder).value().at("matcher").get<std::string>();
  } catch (const nlohmann::json::exception& error) {
    throw io::IoError(file, std::string("has no matcher: ") + error.what());
  }
}

std::vector<std::string> patches_in(const std::string& folder) {
  std::vector<std::string> patches;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (fs::exists(entry.path() / "matches.csv"))
      patches.push_back(entry.path().filename().string());
  }
  std::sort(patches.begin(), patches.end());
  return patches;
}

void count_alone(std::vector<PatchOfRun>& runs) {
  for (PatchOfRun& run : runs) {
    for (const Pair& pair : run.matches) {
      const auto holders = std::count_if(runs.begin(), runs.end(), [&](const PatchOfRun& other) {
        return other.matches.contains(pair);
      });
      if (holders > 1) continue;
      const auto verdict = run.verdicts.find(pair);
      const std::string what = verdict == run.verdicts.end() ? "" : verdict->second;
      if (run.verdicts.empty() || what == "correct") ++run.figures.n_alone;
      if (what == "false") ++run.figures.n_alone_false;
    }
  }
}

}  // namespace

bool have_different_matchers(const std::vector<std::string>& folders) {
  std::set<std::string> settings;
  for (const std::string& folder : folders) {
    const std::optional<nlohmann::json> options = options_of(folder);
    if (!options) return false;
    settings.insert(options->at("matcher").dump());
  }
  return settings.size() > 1;
}

bool match_same_segments(const std::vector<std::string>& folders) {
  for (const std::string& patch : patches_in(folders.front())) {
    std::vector<std::set<std::string>> hashes;
    for (const std::string& folder : folders) {
      if (fs::exists(fs::path(folder) / patch / "matches.csv"))
        hashes.push_back(segment_hashes(fs::path(folder) / patch));
    }
    const bool in_all = hashes.size() == folders.size();
    if (in_all && std::ranges::any_of(hashes, [&](const auto& h) { return h != hashes[0]; }))
      return false;
  }
  return true;
}

std::vector<evaluate::MatcherFigures> read_matcher_figures(
    const std::vector<std::string>& folders) {
  std::vector<evaluate::MatcherFigures> rows;
  for (const std::string& patch : patches_in(folders.front())) {
    std::vector<PatchOfRun> runs;
    for (const std::string& folder : folders) {
      if (!fs::exists(fs::path(folder) / patch / "matches.csv")) continue;
      runs.push_back(read_patch_of_run(folder, patch));
      runs.back().figures.matcher = matcher_name(folder);
    }
    if (runs.size() != folders.size()) continue;
    count_alone(runs);
    for (PatchOfRun& run : runs) rows.push_back(std::move(run.figures));
  }
  return rows;
}

}  // namespace ridgeline::apps
