// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace ridgeline::io {

/// For a format of several files, or a library that needs the final name: a folder of its own
/// beside the target, on the same disk so that finished files can be renamed into place. Removed
/// with all that is left in it. One file written by us needs AtomicFile only.
class ScratchFolder {
 public:
  /// Makes missing folders. Throws IoError naming `target` if that fails or writing is forbidden.
  explicit ScratchFolder(const std::string& target);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// Where to write what will become `target`.
  [[nodiscard]] std::string draft() const;

  /// Moves all files of the folder beside the target, replacing older ones; the target itself last,
  /// so that where it is, all is. Throws IoError.
  void publish() const;

 private:
  std::filesystem::path target_;
  std::filesystem::path folder_;
};

}  // namespace ridgeline::io
