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
  /// Makes the folder and locks it. A folder that it made is removed again if it is empty in the end. Throws
  /// IoError if the folder cannot be made, is a file, or if another process is writing there.
  OutputFolder(std::filesystem::path folder, const std::vector<std::string>& inputs);

  /// The path of a file to be written. Throws IoError if it is one of the inputs, or in a subfolder that is a
  /// link: results would land among files of somebody else.
  [[nodiscard]] std::string path(std::string_view name) const;
  void write(std::string_view name, std::string_view content) const;
  /// Removes a file that an earlier run may have left, since it would look like one of this run.
  void remove(std::string_view name) const;

 private:
  std::filesystem::path folder_;
  io::MadeFolders made_;
  std::shared_ptr<io::FolderLock> lock_;
  std::vector<std::string> inputs_;  ///< canonical
};

/// The path of a single output file. Throws IoError if it is one of `others`, the inputs and other outputs, of
/// which empty ones are ignored.
std::string output_file(const std::string& file, const std::vector<std::string>& others);

/// Whether a file with content stands there. A link does not count: it is replaced, and what it names stays.
bool holds_something(const std::string& file);

/// Checks an output file named by an option: a file that stands there is replaced only if it is one of the program's
/// own. Throws IoError if it is not. `kind` is for the message.
void check_is_own(const std::string& file,
                  bool (*is_own)(const std::string& file),
                  std::string_view kind);
/// Checks an output file in the same way; the program's own files of that kind start with `beginning`.
void check_is_own(const std::string& file, std::string_view beginning, std::string_view kind);

/// Checks an option that names a picture to be written; an empty `file` is none. Throws std::invalid_argument
/// unless it ends in .png, since a PNG under another name misleads those who open it. Throws IoError if a file
/// stands there that is no picture of the program's.
void check_is_png(const std::string& option, const std::string& file);

}  // namespace ridgeline::results
