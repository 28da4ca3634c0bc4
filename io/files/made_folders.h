// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace ridgeline::io {

/// Makes a folder with those above it. The destructor removes the folders that were made if they
/// are empty, so that a command that fails leaves no trace.
class MadeFolders {
 public:
  /// Throws IoError if the folder cannot be made or is a file. An empty path makes nothing.
  explicit MadeFolders(const std::filesystem::path& folder);
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< deepest first
};

}  // namespace ridgeline::io
