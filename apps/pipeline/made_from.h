// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The state of a file when a result was made from it.
struct FileState {
  std::string role;  ///< see results::RunRecord::add_input()
  std::string path;
  std::uint64_t bytes = 0;
  std::int64_t modified_ns = 0;  ///< modification time, by the clock of the file system
  std::string sha256;            ///< empty for large files, which are not hashed
};

/// The current state of the file, with its hash if `with_hash`. Throws IoError if it is missing.
FileState state_of(const std::string& role, const std::string& path, bool with_hash);

/// Whether the file still has the same content. A new modification time alone does not count as a
/// change if the hash is known. Throws IoError if the file is missing.
bool is_unchanged(const FileState& file);

/// The key of a result: a hash of the program and of everything on which the result depends. The
/// parts are the values that were finally used rather than the files from which they were read: a
/// pose contributes to the key regardless of its format and file.
std::string key_of(const std::vector<std::string>& parts);

/// The key of an image as read: its id, the hash of its file, window, turn, radiometry and lens,
/// but not its pose.
std::string key_of_picture(const io::PatchImage& image, const std::string& sha256);

/// key_of_picture() with the projection matrix.
std::string key_of_view(const io::PatchImage& image, const std::string& sha256);

/// The file of MadeFrom.
inline constexpr const char* kStagesFile = "stages.json";

/// Records what the results in a folder were made from: for every stage, stages.json contains its
/// key and the hashes of the files that it wrote. A stage is done if its key is the same and its
/// files are unchanged.
class MadeFrom {
 public:
  /// No stage counts as done if `resume` is false or stages.json cannot be read.
  explicit MadeFrom(std::filesystem::path folder, bool resume = true);

  [[nodiscard]] bool is_done(const std::string& stage, const std::string& key) const;

  /// The path of a file if the stage wrote it. Throws IoError if the file is missing or has
  /// changed.
  [[nodiscard]] std::optional<std::string> written_file(const std::string& stage,
                                                        const std::string& name) const;

  /// Records that the stage is done, with its key and the files that it wrote (names relative to
  /// the folder).
  void set_done(const std::string& stage,
                const std::string& key,
                const std::vector<std::string>& files);

 private:
  std::filesystem::path folder_;
  bool resume_;
  nlohmann::json stages_ = nlohmann::json::object();
};

}  // namespace ridgeline::apps
