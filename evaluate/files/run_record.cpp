// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/run_record.h"

#include "evaluate/files/version.h"
#include "io/files/library_versions.h"
#include "io/files/sha256.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <pcl/pcl_config.h>
#include <sys/resource.h>
#include <tbb/version.h>

#include <algorithm>
#include <filesystem>

namespace ridgeline::results {
namespace {

double peak_memory_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

nlohmann::ordered_json versions() {
  nlohmann::ordered_json json;
  json["ridgeline"] = kVersion;
  json["git_hash"] = kGitHash;
  json["pcl"] = PCL_VERSION_PRETTY;
  json["eigen"] = std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) +
                  "." + std::to_string(EIGEN_MINOR_VERSION);
  json["tbb"] = TBB_runtime_version();
  for (const auto& [library, version] : io::library_versions()) json[library] = version;
  return json;
}

std::vector<std::string> paths_of(const std::vector<InputFile>& files) {
  return transformed(files, &InputFile::path);
}

RunRecord::RunRecord(std::string command)
    : command_(std::move(command)), start_(Clock::now()), stage_start_(start_) {
  inputs_ = nlohmann::ordered_json::array();
  stages_ = nlohmann::ordered_json::array();
  warnings_ = nlohmann::ordered_json::array();
}

void RunRecord::add_input(const InputFile& file) {
  if (std::filesystem::is_directory(file.path)) {
    for (const std::string& path : files_in(file.path)) add_input({file.role, path});
    return;
  }
  const auto known = known_.find(file.path);
  inputs_.push_back(
      {{"role", file.role},
       {"path", file.path},
       {"bytes", std::filesystem::file_size(file.path)},
       {"sha256", known != known_.end() ? known->second : io::sha256_of_file(file.path)}});
}

std::string RunRecord::hash_of(const std::string& path) const {
  const auto input = std::ranges::find_if(
      inputs_, [&](const auto& one) { return one["path"].template get<std::string>() == path; });
  check(input != inputs_.end(), path, ": is not an input of the run");
  return (*input)["sha256"].get<std::string>();
}

void RunRecord::add_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) warnings_.push_back(warning);
}

void RunRecord::resume() {
  const Clock::time_point now = Clock::now();
  start_ += now - stage_start_;
  stage_start_ = now;
}

void RunRecord::end_stage(const std::string& name) {
  stages_.push_back({{"stage", name},
                     {"seconds", seconds_since(stage_start_)},
                     {"peak_memory_mib", peak_memory_mib()}});
  stage_start_ = Clock::now();
}

nlohmann::ordered_json RunRecord::to_json() const {
  nlohmann::ordered_json json;
  json["command"] = command_;
  json["versions"] = versions();
  json["options"] = options_;
  for (const auto& [key, value] : facts_.items()) json[key] = value;
  json["inputs"] = inputs_;
  json["warnings"] = warnings_;
  json["stages"] = stages_;
  json["seconds"] = seconds_since(start_);
  json["peak_memory_mib"] = peak_memory_mib();
  return json;
}

}  // namespace ridgeline::results
