// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/scene_record.h"

#include "io/error.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

constexpr const char* kRecord = "simulate.json";

/// The recorded hashes by file name; an empty object if there is no record or it cannot be read.
nlohmann::json recorded_files(const std::string& record) {
  if (!fs::is_regular_file(record)) return nlohmann::json::object();
  const nlohmann::json json = nlohmann::json::parse(io::read_text_file(record), nullptr, false);
  const bool has_files = json.is_object() && json.contains("files") && json["files"].is_object();
  return has_files ? json["files"] : nlohmann::json::object();
}

}  // namespace

void check_scene_files(const results::OutputFolder& out, const std::vector<std::string>& names) {
  const nlohmann::json recorded = recorded_files(out.path(kRecord));
  for (const std::string& name : names) {
    const std::string file = out.path(name);
    if (!fs::exists(file)) continue;
    const bool is_own = fs::is_regular_file(file) && recorded.contains(name) &&
                        recorded[name] == io::sha256_of_file(file);
    if (is_own) continue;
    throw io::IoError(file,
                      "stands there, not as an earlier scene left it, and would be written over; "
                      "choose another folder");
  }
}

void record_scene_files(const results::OutputFolder& out, const std::vector<std::string>& names) {
  nlohmann::json files = nlohmann::json::object();
  for (const std::string& name : names) files[name] = io::sha256_of_file(out.path(name));
  out.write(kRecord, nlohmann::json{{"files", files}}.dump(2) + "\n");
}

}  // namespace ridgeline::apps
