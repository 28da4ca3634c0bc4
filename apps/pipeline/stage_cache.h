// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The file of a StageCache.
inline constexpr const char* kStagesFile = "stages.json";

/// What is finished of a patch, for `--resume`: stages.json in its folder holds for every stage the
/// key that it was run with and the hashes of the files that it wrote. A stage is done if its key
/// is the same and its files are still as they were written.
class StageCache {
 public:
  /// No stage counts as done if `resume` is false or stages.json cannot be read.
  StageCache(std::filesystem::path folder, bool resume);

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

/// Hash of all that a stage's result depends on: the program, its options, the hashes of its input
/// files and the keys of the stages before it.
std::string stage_key(const std::vector<std::string>& parts);

}  // namespace ridgeline::apps
