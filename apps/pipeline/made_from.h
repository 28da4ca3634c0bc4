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

/// A file as it was when something was made from it.
struct FileState {
  std::string role;  ///< see results::RunRecord::add_input()
  std::string path;
  std::uint64_t bytes = 0;
  std::int64_t modified_ns = 0;  ///< time of the last change, by the clock of the file system
  std::string sha256;            ///< empty for large files, which are not read for it
};

/// The file as it is now, with its hash if `with_hash`. Throws IoError if it is missing.
FileState state_of(const std::string& role, const std::string& path, bool with_hash);

/// Whether the file is still what it was. A new time of change alone is no change if the hash is
/// known. Throws IoError if the file is missing.
bool is_unchanged(const FileState& file);

/// The key of a result: a hash of the program and of everything that the result depends on. The
/// parts are the values that the work consumes, as they were decided, rather than the files that
/// they were read from: a pose is part of the key in whichever format and file it is stated.
std::string key_of(const std::vector<std::string>& parts);

/// What is read of an image, and how: its id, the hash of its file, window, turn, radiometry and
/// lens. Its pose is left out.
std::string key_of_picture(const io::PatchImage& image, const std::string& sha256);

/// key_of_picture() and the projection matrix.
std::string key_of_view(const io::PatchImage& image, const std::string& sha256);

/// The file of MadeFrom.
inline constexpr const char* kStagesFile = "stages.json";

/// What the results of a folder were made from: stages.json holds for every stage the key that it
/// was run with and the hashes of the files that it wrote. A stage is done if its key is the same
/// and its files are still as they were written.
class MadeFrom {
 public:
  /// No stage counts as done if `resume` is false or stages.json cannot be read.
  explicit MadeFrom(std::filesystem::path folder, bool resume = true);

  [[nodiscard]] bool is_done(const std::string& stage, const std::string& key) const;

  /// The path of a file, if the stage has written it. Throws IoError if it is gone or has changed.
  [[nodiscard]] std::optional<std::string> written_file(const std::string& stage,
                                                        const std::string& name) const;

  /// Records that the stage is done, with its key and the files that it has written (names within
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
