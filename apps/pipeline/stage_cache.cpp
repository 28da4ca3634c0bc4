// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/stage_cache.h"

#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"
#include "io/results/version.h"

#include <span>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

nlohmann::json read_stages(const fs::path& file) {
  if (!fs::exists(file)) return nlohmann::json::object();
  nlohmann::json json = nlohmann::json::parse(io::read_text_file(file.string()), nullptr, false);
  return json.is_object() ? json : nlohmann::json::object();
}

}  // namespace

StageCache::StageCache(fs::path folder, bool resume) : folder_(std::move(folder)), resume_(resume) {
  if (resume_) stages_ = read_stages(folder_ / kStagesFile);
}

bool StageCache::is_done(const std::string& stage, const std::string& key) const {
  if (!resume_ || !stages_.contains(stage)) return false;
  const nlohmann::json& record = stages_[stage];
  if (!record.is_object() || !record.contains("key") || record["key"] != key) return false;
  if (!record.contains("files") || !record["files"].is_object()) return false;
  for (const auto& [name, hash] : record["files"].items()) {
    const fs::path file = folder_ / name;
    if (!fs::is_regular_file(file) || hash != io::sha256_of_file(file.string())) return false;
  }
  return true;
}

std::optional<std::string> StageCache::written_file(const std::string& stage,
                                                    const std::string& name) const {
  const nlohmann::json::json_pointer place =
      nlohmann::json::json_pointer() / stage / "files" / name;
  if (!stages_.contains(place)) return std::nullopt;
  std::string file = (folder_ / name).string();
  if (!fs::exists(file)) throw io::IoError(file, "is no longer there");
  if (stages_[place] != io::sha256_of_file(file)) {
    throw io::IoError(file, "has changed since the run");
  }
  return file;
}

void StageCache::set_done(const std::string& stage,
                          const std::string& key,
                          const std::vector<std::string>& files) {
  nlohmann::json hashes = nlohmann::json::object();
  for (const std::string& name : files) {
    hashes[name] = io::sha256_of_file((folder_ / name).string());
  }
  stages_[stage] = {{"key", key}, {"files", std::move(hashes)}};
  io::write_file((folder_ / kStagesFile).string(), stages_.dump(2) + "\n");
}

std::string stage_key(const std::vector<std::string>& parts) {
  io::Sha256 digest;
  const auto add = [&digest](std::string_view text) {
    digest.update(std::as_bytes(std::span(text)));
    digest.update(std::as_bytes(std::span("\n", 1)));
  };
  add(results::kVersion);
  add(results::kGitHash);
  for (const std::string& part : parts) add(part);
  return digest.hex_digest();
}

}  // namespace ridgeline::apps
