// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Versions of this program and of the libraries that it uses.
nlohmann::ordered_json versions();

/// A file that a run reads.
struct InputFile {
  std::string role;  ///< see RunRecord::add_input()
  std::string path;
};
std::vector<std::string> paths_of(const std::vector<InputFile>& files);

/// The content of run.json: command, inputs, options, run times and memory use. Between two
/// identical runs, only the times and the memory use differ.
class RunRecord {
 public:
  explicit RunRecord(std::string command);

  void set_options(nlohmann::ordered_json options) { options_ = std::move(options); }
  void set(const std::string& key, nlohmann::ordered_json value) { facts_[key] = std::move(value); }
  /// Records the file with its size and SHA-256. Files of the roles `cloud`, `patch`, `area`,
  /// `surface_model`, `orientation`, `image` and `reference` are the data that two runs must share
  /// to be comparable; `lines` are the lines to be judged. For a folder (LIMAP's tracks), each of
  /// its files is recorded. Throws IoError if a file cannot be read.
  void add_input(const InputFile& file);
  /// Adds an input as recorded by another run.
  void add_recorded_input(nlohmann::ordered_json input) { inputs_.push_back(std::move(input)); }
  /// Sets the SHA-256 of a file, so that add_input() need not read the file.
  void know_hash(const std::string& path, const std::string& sha256) { known_[path] = sha256; }
  /// The SHA-256 of a file passed to add_input(). Throws std::invalid_argument for any other file.
  [[nodiscard]] std::string hash_of(const std::string& path) const;
  void add_warnings(const std::vector<std::string>& warnings);
  [[nodiscard]] std::vector<std::string> warnings() const { return warnings_; }
  /// Excludes the time since the end of the last stage, which was spent on other work.
  void resume();
  /// Ends the current stage. Records the wall time since the end of the previous stage and the peak
  /// memory so far.
  void end_stage(const std::string& name);

  /// The facts, for OutputFolder::write_record().
  [[nodiscard]] nlohmann::ordered_json to_json() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::string command_;
  Clock::time_point start_, stage_start_;
  nlohmann::ordered_json options_, facts_, inputs_, stages_, warnings_;
  std::map<std::string, std::string> known_;  ///< SHA-256 by path
};

}  // namespace ridgeline::results
