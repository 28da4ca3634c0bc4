// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/made_from.h"

#include "evaluate/files/version.h"
#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/files/input_file.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <span>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

nlohmann::json read_stages(const fs::path& file) {
  if (!fs::exists(file)) return nlohmann::json::object();
  nlohmann::json json = nlohmann::json::parse(io::read_text_file(file.string()), nullptr, false);
  return json.is_object() ? json : nlohmann::json::object();
}

std::int64_t modified_ns(const std::string& path) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             fs::last_write_time(path).time_since_epoch())
      .count();
}

std::string text_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  return fmt::format("{}", fmt::join(matrix.reshaped(), " "));
}

/// The interior orientation as text; empty without one.
std::string lens_text(const io::PatchImage& image) {
  if (!image.interior) return "";
  const auto& [focal_length_px, principal_point_px, lens, size_px] = *image.interior;
  const Eigen::Vector2i size = size_px.value_or(Eigen::Vector2i::Zero());
  return fmt::format("{} {} {} {} {} {} {} {} {}", text_of(focal_length_px),
                     text_of(principal_point_px), lens.k1, lens.k2, lens.k3, lens.p1, lens.p2,
                     size.x(), size.y());
}

/// The parameters for reading a file, as text.
std::string reading_text(const io::PatchImage& image) {
  const io::Window window = image.window.value_or(io::Window{});
  std::string text =
      fmt::format("{} {} {} {} {} {}", window.column, window.row, window.width, window.height,
                  static_cast<int>(image.turn), text_of(image.window_px));
  for (const auto& [low, high] : image.radiometry) text += fmt::format(" {} {}", low, high);
  return text;
}

}  // namespace

FileState state_of(const std::string& role, const std::string& path, bool with_hash) {
  io::require_regular_file(path);
  return {role, path, fs::file_size(path), modified_ns(path),
          with_hash ? io::sha256_of_file(path) : ""};
}

bool is_unchanged(const FileState& file) {
  const FileState now = state_of(file.role, file.path, false);
  if (now.bytes != file.bytes) return false;
  if (now.modified_ns == file.modified_ns) return true;
  return !file.sha256.empty() && io::sha256_of_file(file.path) == file.sha256;
}

std::string key_of(const std::vector<std::string>& parts) {
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

std::string key_of_picture(const io::PatchImage& image, const std::string& sha256) {
  return key_of({image.id, sha256, reading_text(image), lens_text(image)});
}

std::string key_of_view(const io::PatchImage& image, const std::string& sha256) {
  return key_of({key_of_picture(image, sha256), text_of(image.image_from_world)});
}

MadeFrom::MadeFrom(fs::path folder, bool resume) : folder_(std::move(folder)), resume_(resume) {
  if (resume_) stages_ = read_stages(folder_ / kStagesFile);
}

bool MadeFrom::is_done(const std::string& stage, const std::string& key) const {
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

std::optional<std::string> MadeFrom::written_file(const std::string& stage,
                                                  const std::string& name) const {
  const nlohmann::json::json_pointer place =
      nlohmann::json::json_pointer() / stage / "files" / name;
  if (!stages_.contains(place)) return std::nullopt;
  std::string file = (folder_ / name).string();
  if (!fs::exists(file)) throw io::IoError(file, "no longer exists");
  if (stages_[place] != io::sha256_of_file(file)) {
    throw io::IoError(file, "has changed since the run");
  }
  return file;
}

void MadeFrom::set_done(const std::string& stage,
                        const std::string& key,
                        const std::vector<std::string>& files) {
  nlohmann::json hashes = nlohmann::json::object();
  for (const std::string& name : files) {
    hashes[name] = io::sha256_of_file((folder_ / name).string());
  }
  stages_[stage] = {{"key", key}, {"files", std::move(hashes)}};
  io::write_file((folder_ / kStagesFile).string(), stages_.dump(2) + "\n");
}

}  // namespace ridgeline::apps
