// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/folder_lock.h"
#include "io/files/made_folders.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::results {

/// The folder of a run's results. Every file is written whole or not at all, and none of the
/// inputs is ever written over. Nobody else writes results there meanwhile.
class OutputFolder {
 public:
  /// Makes the folder and locks it; one that is empty in the end is gone again. Throws IoError if it cannot be
  /// made, is a file, or another process is writing there.
  OutputFolder(std::filesystem::path folder, const std::vector<std::string>& inputs);

  /// The path of a file to be written. Throws IoError if it is one of the inputs, or in a subfolder that is a
  /// link: results would land among files of somebody else.
  [[nodiscard]] std::string path(std::string_view name) const;
  void write(std::string_view name, std::string_view content) const;
  /// Takes away what an earlier run has left there, if anything, which would look like of this one.
  void remove(std::string_view name) const;

 private:
  std::filesystem::path folder_;
  io::MadeFolders made_;
  std::shared_ptr<io::FolderLock> lock_;
  std::vector<std::string> inputs_;  ///< canonical
};

/// A single output file, which must not be an input or another output; empty ones are none. Throws
/// IoError if it is.
std::string output_file(const std::string& file, const std::vector<std::string>& others);

/// Whether a file with content stands there. A link does not count: it is replaced, and what it names stays.
bool holds_something(const std::string& file);

/// Checks an output file named by an option: what stands there is replaced only if it is one of the program's own.
/// `kind` is for the message. Throws IoError if it is not.
void check_is_own(const std::string& file,
                  bool (*is_own)(const std::string& file),
                  std::string_view kind);
/// The same of files that begin as the program's own of that kind do.
void check_is_own(const std::string& file, std::string_view beginning, std::string_view kind);

/// Checks an option that names a picture to be written; empty is none. Throws std::invalid_argument
/// unless it ends in .png: a PNG under another name misleads those who open it; IoError if a picture stands there
/// that the program did not write.
void check_is_png(const std::string& option, const std::string& file);

}  // namespace ridgeline::results
