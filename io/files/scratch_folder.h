// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace ridgeline::io {

/// A temporary folder for a format of several files, or for a library that needs the final name. It
/// lies beside the target, on the same disk, so that finished files can be renamed into place. It
/// is removed with all that is left in it. A single file that we write ourselves needs AtomicFile
/// only.
class ScratchFolder {
 public:
  /// Makes missing folders. Throws IoError naming `target` if that fails or writing is forbidden.
  explicit ScratchFolder(const std::string& target);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// The path at which to write what will become `target`.
  [[nodiscard]] std::string draft() const;

  /// Moves all files of the folder beside the target, replacing older ones. The target itself is
  /// moved last, so that all files are there once it is. Throws IoError.
  void publish() const;

 private:
  std::filesystem::path target_;
  std::filesystem::path folder_;
};

}  // namespace ridgeline::io
