// SPDX-License-Identifier: BSD-3-Clause
#include "apps/run/run_patches.h"

#include "apps/common/outcome.h"
#include "apps/common/say.h"
#include "apps/pipeline/check_patch.h"
#include "apps/pipeline/open_patch.h"
#include "apps/pipeline/parameters.h"
#include "apps/report/write_report.h"
#include "evaluate/files/judged_map.h"
#include "evaluate/files/write_results.h"
#include "evaluate/statistics/product_method.h"
#include "evaluate/tables/completeness_table.h"
#include "evaluate/tables/decoy_table.h"
#include "evaluate/tables/terminal_table.h"
#include "io/error.h"
#include "io/text/text.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

namespace ridgeline::apps {
namespace {

std::vector<io::Patch> open_patches(const std::vector<std::string>& files,
                                    const RunOptions& options) {
  std::vector<io::Patch> patches;
  std::map<std::string, std::string> file_of_id;
  for (const std::string& file : files) {
    const auto before_check = [&](const io::Patch& patch) {
      inform_of(patch.decisions);
      const auto [other, is_new] = file_of_id.emplace(io::lower_case(patch.id), file);
      if (is_new) return;
      throw io::IoError(file, fmt::format("id {} is also that of {} (ignoring case); ids must be "
                                          "unique, as results are named after them",
                                          patch.id, other->second));
    };
    patches.push_back(open_patch(file, {options.max_image_mpx, options.assume_crs}, before_check));
  }
  return patches;
}

std::vector<results::InputFile> inputs_of(const std::vector<io::Patch>& patches,
                                          const RunOptions& options) {
  std::vector<results::InputFile> inputs;
  for (const io::Patch& patch : patches) {
    for (results::InputFile& file : input_files(patch)) inputs.push_back(std::move(file));
  }
  if (!options.config_path.empty()) inputs.push_back({"config", options.config_path});
  if (!options.shift.geoid.empty()) inputs.push_back({"geoid", options.shift.geoid});
  return inputs;
}

std::string method_name(reconstruct::Method method) { return reconstruct::name(method); }

nlohmann::ordered_json echo_options(const RunOptions& options) {
  nlohmann::ordered_json json;
  json["methods"] = transformed(options.methods, method_name);
  json["max_image_mpx"] = options.max_image_mpx;
  json["max_y_parallax_px"] = options.max_y_parallax_px;
  json["matcher"] = reconstruct::name(options.parameters.method.matching.matcher);
  json.update(echo(options.parameters));
  json["assume_crs"] = options.assume_crs.definition;
  json["apply_shift"] = options.shift.apply;
  json["geoid"] = options.shift.geoid;
  if (options.n_decoys) json["decoys"] = *options.n_decoys;
  if (options.completeness) json["completeness"] = true;
  if (options.until != kLastStage) json["until"] = options.until;
  json["gross_m"] = options.summary.gross_m;
  json["bootstrap_seed"] = options.summary.bootstrap.seed;
  return json;
}

void write_table1(const evaluate::Table1& table, const results::OutputFolder& out) {
  out.write("table1.md", evaluate::to_markdown(table));
  out.write("table1.csv", evaluate::to_csv(table));
  out.write("table1.json", evaluate::to_json(table));
  if (table.tracks.empty()) {
    out.remove("table1.tracks.csv");
  } else {
    out.write("table1.tracks.csv", evaluate::to_tracks_csv(table));
  }
}

/// The number of images of each patch from which lines are reconstructed.
nlohmann::ordered_json n_views_by_patch(const std::vector<io::Patch>& patches, bool all_views) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const io::Patch& patch : patches)
    json[patch.id] = all_views ? patch.images.size() : std::size_t{2};
  return json;
}

/// The windows read from the images of each patch, [column, row, columns, rows], unless whole
/// images were read.
nlohmann::ordered_json windows_by_patch(const std::vector<io::Patch>& patches) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const io::Patch& patch : patches) {
    for (const io::PatchImage& image : patch.images) {
      if (!image.window) continue;
      const io::Window& w = *image.window;
      json[patch.id][image.id] = {w.column, w.row, w.width, w.height};
    }
  }
  return json;
}

/// Warnings about images of a patch with identical content, caused by a copied path or file.
std::vector<std::string> same_pictures(const io::Patch& patch, const results::RunRecord& record) {
  std::vector<std::string> warnings;
  std::map<std::string, std::string> path_of_hash;
  for (const io::PatchImage& image : patch.images) {
    const auto [other, is_new] = path_of_hash.emplace(record.hash_of(image.path), image.path);
    if (is_new) continue;
    warnings.push_back(
        fmt::format("{}: {} and {} have the same pixels; views must have different images",
                    patch.path, other->second, image.path));
  }
  return warnings;
}

std::vector<std::string> early_warnings(const std::vector<io::Patch>& patches,
                                        bool all_views,
                                        const results::RunRecord& record) {
  std::vector<std::string> warnings;
  for (const io::Patch& patch : patches) {
    std::ranges::copy(patch.warnings, std::back_inserter(warnings));
    std::ranges::move(same_pictures(patch, record), std::back_inserter(warnings));
    if (patch.images.size() == 2 || all_views) continue;
    warnings.push_back(
        fmt::format("{}: {} images; the published methods use two: reconstructing from the first "
                    "ones, {} and {}",
                    patch.path, patch.images.size(), patch.images[0].id, patch.images[1].id));
  }
  return warnings;
}

bool adjusts_to_faces(const RunOptions& options) {
  return options.parameters.method.estimation.beyond.adjusts_to_faces();
}

}  // namespace

PatchesResult write_patches(const std::vector<std::string>& patch_files,
                            const RunOptions& options,
                            const std::string& folder,
                            results::RunRecord& record) {
  record.set_options(echo_options(options));
  PatchesResult found;
  found.patches = open_patches(patch_files, options);
  const std::vector<io::Patch>& patches = found.patches;
  const std::vector<results::InputFile> inputs = inputs_of(patches, options);
  const results::OutputFolder out(folder, results::paths_of(inputs));
  for (const char* name : {"table1.md", "table1.csv", "table1.json", "table1.tracks.csv"})
    (void)out.path(name);
  for (const std::string& name : results::result_names({})) (void)out.path(name);
  for (const results::InputFile& input : inputs) record.add_input(input);
  record.end_stage("hash_inputs");
  const bool all_views = options.parameters.method.matching.tracks.all_views;
  std::vector<std::string> early = early_warnings(patches, all_views, record);
  warn_of(early);  // printed first, because they may explain a later failure
  for (const io::Patch& patch : patches)
    early.insert(early.end(), patch.decisions.begin(), patch.decisions.end());
  record.add_warnings(early);
  for (const io::Patch& patch : patches) check_run(patch, options, out, record);

  Progress progress(patches.size() * count_steps(options));
  std::vector<results::TruthRows> truth;
  nlohmann::ordered_json edges = nlohmann::ordered_json::object();
  for (const io::Patch& patch : patches) {
    PatchResult result = run_patch(patch, options, out, progress, record);
    if (result.matching) found.table1.rows.push_back(std::move(*result.matching));
    if (result.tracks) found.table1.tracks.push_back(std::move(*result.tracks));
    std::ranges::move(result.evaluations, std::back_inserter(found.evaluations));
    std::ranges::move(result.truth, std::back_inserter(truth));
    std::ranges::move(result.messages, std::back_inserter(found.messages));
    found.n_skipped_stages += result.n_skipped_stages;
    edges[patch.id] = std::move(result.edges);
  }
  progress.clear();
  for (const std::string& warning : record.warnings()) {
    if (std::ranges::find(early, warning) == early.end()) spdlog::warn("{}", warning);
  }

  // Table 1 is always written: an old table next to new ones would be misleading.
  write_table1(found.table1, out);
  if (options.until == kLastStage) {
    results::write_tables(found.evaluations, truth, out, adjusts_to_faces(options));
  } else {
    for (const std::string& name : results::result_names({})) {
      if (name != "run.json") out.remove(name);
    }
  }
  record.end_stage("write");
  record.set("messages", found.messages);
  record.set("page", to_json(options.page));
  record.set("n_views", n_views_by_patch(patches, all_views));
  record.set("edges", edges);
  if (const auto windows = windows_by_patch(patches); !windows.empty())
    record.set("windows_px", windows);
  out.write_record(record.to_json());
  return found;
}

void run_patches(const std::string& command,
                 const std::vector<std::string>& patch_files,
                 const RunOptions& options,
                 const std::string& folder) {
  results::RunRecord record(command);
  PatchesResult found = write_patches(patch_files, options, folder, record);
  if (options.resume) spdlog::info("{} finished stages skipped", found.n_skipped_stages);
  if (!found.table1.rows.empty() || !found.table1.tracks.empty())
    say("{}\n", evaluate::to_terminal(found.table1));
  if (has_figures(found.evaluations)) {
    say("{}\n",
        evaluate::to_terminal(evaluate::make_table2(found.evaluations, adjusts_to_faces(options))));
  }
  const std::vector<std::string> methods = transformed(options.methods, method_name);
  const std::string& product = methods[evaluate::product_index(methods)];
  std::erase_if(found.evaluations, [&](const auto& e) { return e.method != product; });
  if (const std::string decoys = evaluate::decoys_to_terminal(found.evaluations); !decoys.empty()) {
    say("{}\n", decoys);
  }
  if (const std::string edges = evaluate::completeness_to_terminal(found.evaluations);
      !edges.empty()) {
    say("{}\n", edges);
  }
  for (const std::string& message : found.messages) say("{}\n", message);
  const std::filesystem::path results = std::filesystem::absolute(folder).lexically_normal();
  say("Results: {}\n", results.string());
  if (options.until != kLastStage) return write_report_of_run(results.string(), false);
  for (const io::Patch& patch : found.patches) {
    say("Map for QGIS: {}\n", (results / patch.id / results::map_name(product)).string());
  }
  write_report_of_run(results.string(), options.report);
}

}  // namespace ridgeline::apps
