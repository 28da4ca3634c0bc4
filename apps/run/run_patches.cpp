// SPDX-License-Identifier: BSD-3-Clause
#include "apps/run/run_patches.h"

#include "apps/common/option_flags.h"
#include "apps/common/patch_views.h"
#include "apps/evaluate/write_results.h"
#include "apps/report/write_report.h"
#include "io/cloud/read_cloud.h"
#include "io/error.h"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <map>

namespace ridgeline::apps {
namespace {

std::vector<io::PatchFile> read_patches(const std::vector<std::string>& files) {
  std::vector<io::PatchFile> patches;
  std::map<std::string, std::string> file_of_id;
  for (const std::string& file : files) {
    io::PatchFile patch = io::read_patch(file);
    const auto [other, is_new] = file_of_id.emplace(patch.id, file);
    if (!is_new) {
      throw io::IoError(file, fmt::format("id {} is that of {}, too; results are named after it",
                                          patch.id, other->second));
    }
    check_patch(patch);
    patches.push_back(std::move(patch));
  }
  return patches;
}

struct Input {
  const char* role;
  std::string path;
};

std::vector<Input> inputs_of(const std::vector<io::PatchFile>& patches) {
  std::vector<Input> inputs;
  for (const io::PatchFile& patch : patches) {
    inputs.push_back({"patch", patch.path});
    for (const io::PatchImage& image : patch.images) inputs.push_back({"image", image.path});
    if (!patch.lidar.empty()) {
      for (const std::string& file : io::expand_patterns(patch.lidar)) {
        inputs.push_back({"cloud", file});
      }
    }
    if (patch.reference_matches) inputs.push_back({"reference", *patch.reference_matches});
    if (patch.reference_lines) inputs.push_back({"reference", *patch.reference_lines});
  }
  return inputs;
}

nlohmann::ordered_json echo_options(const RunOptions& options) {
  nlohmann::ordered_json json;
  json["methods"] = nlohmann::ordered_json::array();
  for (const reconstruct::Method method : options.methods) {
    json["methods"].push_back(reconstruct::name(method));
  }
  json["detector"] = reconstruct::name(options.extract.detector);
  json["extract"] = echo(options.extract);
  json["matchers"] = nlohmann::ordered_json::array();
  for (const Matcher matcher : options.matching.matchers) json["matchers"].push_back(name(matcher));
  json["propagate_heights"] = options.matching.propagate_heights;
  json["propagate_range_m"] = options.matching.propagate_range_m;
  json["propagate_min_similarity"] = options.matching.propagate_min_similarity;
  json["match"] = echo(options.matching.pairwise);
  json["chio"] = echo(options.matching.chio);
  json["reconstruct"] = echo(options.reconstruct);
  json["judge"] = echo(options.judge);
  json["gross_m"] = options.summary.gross_m;
  json["bootstrap_seed"] = options.summary.bootstrap.seed;
  return json;
}

std::string write_table1(const evaluate::Table1& table, const OutputFolder& out) {
  std::string markdown = evaluate::to_markdown(table);
  out.write("table1.md", markdown);
  out.write("table1.csv", evaluate::to_csv(table));
  out.write("table1.json", evaluate::to_json(table));
  return markdown;
}

void warn_of_surplus_images(const std::vector<io::PatchFile>& patches) {
  for (const io::PatchFile& patch : patches) {
    if (patch.images.size() == 2) continue;
    spdlog::warn("{}: {} images; lines are matched between the first two, {} and {}", patch.path,
                 patch.images.size(), patch.images[0].id, patch.images[1].id);
  }
}

}  // namespace

void run_patches(const std::string& command,
                 const std::vector<std::string>& patch_files,
                 const RunOptions& options,
                 const std::string& folder) {
  RunRecord record(command);
  record.set_options(echo_options(options));
  const std::vector<io::PatchFile> patches = read_patches(patch_files);
  warn_of_surplus_images(patches);
  const std::vector<Input> inputs = inputs_of(patches);
  std::vector<std::string> paths;
  paths.reserve(inputs.size());
  for (const Input& input : inputs) paths.push_back(input.path);
  const OutputFolder out(folder, paths);

  Progress progress(patches.size() * count_steps(options));
  evaluate::Table1 table1;
  std::vector<evaluate::Evaluation> evaluations;
  std::vector<TruthRows> truth;
  std::size_t n_skipped = 0;
  for (const io::PatchFile& patch : patches) {
    PatchResult result = run_patch(patch, options, out, progress, record);
    for (auto& row : result.matching) table1.rows.push_back(std::move(row));
    for (auto& evaluation : result.evaluations) evaluations.push_back(std::move(evaluation));
    for (auto& rows : result.truth) truth.push_back(std::move(rows));
    n_skipped += result.n_skipped_stages;
  }
  progress.clear();
  if (options.resume) spdlog::info("{} finished stages skipped", n_skipped);

  // always written: an old table beside new ones would mislead
  const std::string markdown1 = write_table1(table1, out);
  if (!table1.rows.empty()) fmt::print("{}\n", markdown1);
  fmt::print("{}", write_table2(evaluations, out));
  write_truth(truth, out);
  for (const Input& input : inputs) record.add_input(input.role, input.path);
  record.end_stage("write");
  out.write("run.json", record.to_json());
  const std::filesystem::path results = std::filesystem::absolute(folder).lexically_normal();
  fmt::print("\nResults: {}\n", results.string());
  if (options.report) {
    const std::optional<std::string> report = write_report_of_run(results.string());
    if (report) fmt::print("Report: {}\n", *report);
  }
}

}  // namespace ridgeline::apps
