// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Versions of this program and of the libraries it runs with.
nlohmann::ordered_json versions();

/// A file that a run reads.
struct InputFile {
  std::string role;  ///< see RunRecord::add_input()
  std::string path;
};
std::vector<std::string> paths_of(const std::vector<InputFile>& files);

/// run.json: what was run on what, with which options, how long and with how much memory. Only its
/// times and memory differ between two equal runs.
class RunRecord {
 public:
  explicit RunRecord(std::string command);

  void set_options(nlohmann::ordered_json options) { options_ = std::move(options); }
  void set(const std::string& key, nlohmann::ordered_json value) { facts_[key] = std::move(value); }
  /// Records the file with its size and SHA-256. Files of the roles `cloud`, `patch`, `area`,
  /// `surface_model`, `orientation`, `image` and `reference` are the data that two runs must share
  /// to be compared; `lines` are what is judged. A folder (LIMAP's tracks) is recorded as each of
  /// its files. Throws IoError if it cannot be read.
  void add_input(const InputFile& file);
  /// Adds an input as another run has recorded it.
  void add_recorded_input(nlohmann::ordered_json input) { inputs_.push_back(std::move(input)); }
  /// The SHA-256 of a file that is known already; add_input() does not read the file then.
  void know_hash(const std::string& path, const std::string& sha256) { known_[path] = sha256; }
  /// The SHA-256 of a file that add_input() was given. Throws std::invalid_argument for another
  /// one.
  [[nodiscard]] std::string hash_of(const std::string& path) const;
  void add_warnings(const std::vector<std::string>& warnings);
  [[nodiscard]] std::vector<std::string> warnings() const { return warnings_; }
  /// Leaves out the time since the last stage ended, in which the program did something else.
  void resume();
  /// Ends the stage that runs now. Records its wall time since the last one, and the peak memory so
  /// far.
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
