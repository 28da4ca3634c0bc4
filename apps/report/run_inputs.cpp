// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/run_inputs.h"

#include "apps/evaluate/judge_files.h"
#include "io/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

namespace ridgeline::apps {
namespace fs = std::filesystem;

RunInputs::RunInputs(const evaluate::Json& run, const std::string& file) {
  try {
    is_of_files_ = run.value("command", "") == "evaluate";
    for (const evaluate::Json& input : run.value("inputs", evaluate::Json::array())) {
      inputs_.push_back({input.at("role").get<std::string>(), input.at("path").get<std::string>(),
                         input.at("bytes").get<std::uint64_t>()});
    }
  } catch (const evaluate::Json::exception& error) {
    throw io::IoError(file, std::string("is no run's record: ") + error.what());
  }
}

std::vector<std::string> RunInputs::paths(const std::string& role) const {
  std::vector<std::string> found;
  for (const Input& input : inputs_) {
    if (input.role == role) found.push_back(input.path);
  }
  return found;
}

std::vector<std::string> RunInputs::all_paths() const {
  std::vector<std::string> paths;
  paths.reserve(inputs_.size());
  for (const Input& input : inputs_) paths.push_back(input.path);
  return paths;
}

std::string RunInputs::unchanged(const std::string& path) const {
  if (!fs::exists(path)) throw io::IoError(path, "is no longer there");
  const auto input =
      std::find_if(inputs_.begin(), inputs_.end(), [&](const Input& i) { return i.path == path; });
  if (input == inputs_.end() || !fs::is_regular_file(path)) return path;
  const std::uintmax_t bytes = fs::file_size(path);
  if (bytes != input->bytes) {
    throw io::IoError(
        path, fmt::format("has changed since the run: {} bytes, it had {}", bytes, input->bytes));
  }
  return path;
}

std::string RunInputs::lines_of(const std::string& method) const {
  for (const Input& input : inputs_) {
    if (input.role == "lines" && stem_of(input.path) == method) return input.path;
  }
  return {};
}

std::optional<io::PatchFile> RunInputs::patch(const std::string& id) const {
  std::string gone;
  for (const std::string& path : paths("patch")) {
    if (!fs::exists(path)) {
      gone = path;
      continue;
    }
    io::PatchFile patch = io::read_patch(unchanged(path));
    if (patch.id == id) return patch;
  }
  if (!gone.empty()) throw io::IoError(gone, "is no longer there");
  return std::nullopt;
}

std::optional<std::string> RunInputs::reference_lines(
    const std::optional<io::PatchFile>& patch) const {
  if (is_of_files_) {
    const std::vector<std::string> given = paths("reference");
    return given.empty() ? std::nullopt : std::optional(given.front());
  }
  return patch ? patch->reference_lines : std::nullopt;
}

}  // namespace ridgeline::apps
