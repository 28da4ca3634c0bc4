// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The files of a folder that this program wrote, with their content at that time, so that a file
/// of the user is told from them: one that is not listed, or that was changed since. Names are
/// relative to the folder.
class OwnFiles {
 public:
  explicit OwnFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Takes entries of to_json(); what is none is ignored.
  void add(const nlohmann::json& entries);
  /// The entry of a file that will have this name. Throws IoError if it cannot be read.
  static nlohmann::json entry_of(const std::string& name, const std::filesystem::path& file);
  void forget(const std::string& name) { files_.erase(name); }

  /// Whether the program wrote what is there. A GeoPackage that QGIS has opened is still ours:
  /// SQLite counts that in its header. One that is open there with changes beside it is not.
  [[nodiscard]] bool holds(const std::string& name) const;

  /// An array of {"path", "sha256"} of the files that exist, sorted by path; of SQLite's files also
  /// "sha256_after_header".
  [[nodiscard]] nlohmann::ordered_json to_json() const;

 private:
  std::filesystem::path folder_;
  /// By name, the entries of all contents that the program gave the file; the last one is the
  /// newest. A killed process may have left either of two.
  std::map<std::string, std::vector<nlohmann::json>> files_;
};

}  // namespace ridgeline::io
