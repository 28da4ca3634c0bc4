// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The files of a folder that this program wrote, with digests of their contents, to distinguish
/// them from the user's files, which are not listed or were changed since. Names are relative to
/// the folder.
class OwnFiles {
 public:
  explicit OwnFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Adds entries of to_json(); anything else is ignored.
  void add(const nlohmann::json& entries);
  /// The entry of a file that will have this name. Throws IoError if it cannot be read.
  static nlohmann::json entry_of(const std::string& name, const std::filesystem::path& file);
  void forget(const std::string& name) { files_.erase(name); }

  /// Whether the program wrote the current content of the file. A GeoPackage that was merely opened
  /// in QGIS is still ours, although SQLite has updated counters in its header. One with pending
  /// changes in a file next to it is not.
  [[nodiscard]] bool holds(const std::string& name) const;

  /// An array of {"path", "sha256"} of the files that exist, sorted by path; for SQLite files also
  /// "sha256_after_header".
  [[nodiscard]] nlohmann::ordered_json to_json() const;

 private:
  std::filesystem::path folder_;
  /// For each name, the entries of all versions that the program wrote, the newest last. A killed
  /// process may have left either of the last two.
  std::map<std::string, std::vector<nlohmann::json>> files_;
};

}  // namespace ridgeline::io
