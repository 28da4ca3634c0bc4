// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/run_inputs.h"

#include "apps/pipeline/open_patch.h"
#include "evaluate/files/judge_files.h"
#include "evaluate/files/result_folder_reader.h"
#include "io/error.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>

#include <filesystem>

namespace ridgeline::apps {
namespace fs = std::filesystem;

RunInputs::RunInputs(const evaluate::Json& run, const std::string& file) {
  try {
    is_of_files_ = results::is_of_line_files(run);
    options_ = run.value("options", evaluate::Json::object());
    const evaluate::Json cloud = run.value("cloud", evaluate::Json::object());
    const double horizontal_m = cloud.value("horizontal_unit_m", 1.0);
    cloud_unit_m_ = {horizontal_m, horizontal_m, cloud.value("vertical_unit_m", 1.0)};
    if (cloud.contains("plan_scale")) {
      plan_scale_ = {cloud["plan_scale"].at(0).get<double>(),
                     cloud["plan_scale"].at(1).get<double>()};
    }
    for (const evaluate::Json& input : run.value("inputs", evaluate::Json::array())) {
      inputs_.push_back({input.at("role").get<std::string>(), input.at("path").get<std::string>(),
                         input.at("bytes").get<std::uint64_t>()});
    }
  } catch (const evaluate::Json::exception& error) {
    throw io::IoError(file, std::string("is not a run record: ") + error.what());
  }
}

std::vector<std::string> RunInputs::paths(const std::string& role) const {
  std::vector<std::string> found;
  for (const Input& input : inputs_) {
    if (input.role == role) found.push_back(input.path);
  }
  return found;
}

std::vector<std::string> RunInputs::all_paths() const { return transformed(inputs_, &Input::path); }

std::vector<std::string> RunInputs::given_paths() const {
  std::vector<std::string> paths;
  for (const char* key : {"lines", "cloud"}) {
    for (const evaluate::Json& path : options_.value(key, evaluate::Json::array())) {
      paths.push_back(path.get<std::string>());
    }
  }
  paths.push_back(options_.value("patch", ""));
  return paths;
}

std::string RunInputs::unchanged(const std::string& path) const {
  if (!fs::exists(path)) throw io::IoError(path, "no longer exists");
  const bool is_folder = fs::is_directory(path);
  for (const Input& input : inputs_) {
    // a folder was recorded file by file
    const bool is_meant = is_folder ? fs::path(input.path).parent_path() / "" == fs::path(path) / ""
                                    : input.path == path;
    if (is_meant) require_unchanged(input);
  }
  return path;
}

void RunInputs::require_unchanged(const Input& input) {
  if (!fs::exists(input.path)) throw io::IoError(input.path, "no longer exists");
  if (!fs::is_regular_file(input.path)) return;
  const std::uintmax_t bytes = fs::file_size(input.path);
  if (bytes == input.bytes) return;
  throw io::IoError(input.path, fmt::format("has changed since the run: {} bytes instead of {}",
                                            bytes, input.bytes));
}

std::string RunInputs::lines_of(const std::string& method) const {
  for (const evaluate::Json& path : options_.value("lines", evaluate::Json::array())) {
    if (results::stem_of(path.get<std::string>()) == method) return path.get<std::string>();
  }
  return {};
}

std::optional<io::Patch> RunInputs::patch(const std::string& id) const {
  std::optional<io::IoError> first_error;  // thrown only if no patch has the id
  for (const std::string& path : paths("patch")) {
    try {
      io::Patch patch = read_patch(unchanged(path));
      for (const std::string& file : patch.orientation_files) (void)unchanged(file);
      for (const auto& file : {patch.area_file, patch.surface_model})
        if (file) (void)unchanged(*file);
      if (patch.id == id) return patch;
    } catch (const io::IoError& error) {
      if (!first_error) first_error = error;
    }
  }
  if (first_error) throw io::IoError(*first_error);
  return std::nullopt;
}

std::optional<std::string> RunInputs::reference_lines(const std::optional<io::Patch>& patch) const {
  if (is_of_files_) {
    const std::vector<std::string> given = paths("reference");
    return given.empty() ? std::nullopt : std::optional(given.front());
  }
  return patch ? patch->reference_lines : std::nullopt;
}

io::ReadLinesOptions RunInputs::lines_options(bool of_truth) const {
  io::ReadLinesOptions options;
  options.assume_crs.definition = options_.value("assume_crs", "");
  options.unit_m = cloud_unit_m_;
  options.plan_scale = plan_scale_;
  options.vertex_pairs = options_.value("vertex_pairs", false);
  options.lod = options_.value("lod", "");
  if (!of_truth) {
    options.id_column = options_.value("id", "");
    options.building_column = options_.value("building", "");
  }
  return options;
}

io::ReadOptions RunInputs::cloud_options() const {
  io::ReadOptions options;
  if (options_.contains("classes") && !options_["classes"].empty()) {
    options.classes = options_["classes"].get<std::set<std::uint8_t>>();
  }
  options.exclude_withheld = options_.value("exclude_withheld", true);
  options.last_returns = options_.value("last_returns", false);
  options.assume_crs.definition = options_.value("assume_crs", "");
  options.plan_scale = plan_scale_;
  options.max_resolution_m = options_.value("max_resolution_m", 0.0);
  if (options_.contains("bounds") && !options_["bounds"].empty()) {
    options.bounds_in_file = io::plan_bounds(options_["bounds"].get<std::vector<double>>());
  }
  return options;
}

double RunInputs::max_aligned_angle_deg() const {
  const evaluate::Json echoed = options_.value("reconstruct", evaluate::Json::object());
  return echoed.value("max_aligned_angle_deg", kMaxAlignedAngle_deg);
}

evaluate::JudgeOptions RunInputs::judge_options() const {
  evaluate::JudgeOptions options;
  const evaluate::Json echoed = options_.value("judge", evaluate::Json::object());
  options.fit_half_width_m = echoed.value("fit_half_width_m", options.fit_half_width_m);
  options.inlier_distance_m = echoed.value("inlier_distance_m", options.inlier_distance_m);
  return options;
}

}  // namespace ridgeline::apps
