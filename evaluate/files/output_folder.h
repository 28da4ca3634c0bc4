// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/summary_json.h"
#include "io/files/folder_lock.h"
#include "io/files/made_folders.h"

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::results {

/// The folder of a run's results. Every file is written whole or not at all, and neither an input
/// nor a file of the user is ever written over or removed: see io::FolderLock, which knows the
/// program's own files. Nobody else writes results there meanwhile.
class OutputFolder {
 public:
  /// Makes the folder and locks it. A folder that it made is removed again if it is empty in the
  /// end. Throws IoError if the folder cannot be made, is a file, or if another process is writing
  /// there.
  /// @param record_name  of the file that lists the program's files: run.json, simulate.json or
  /// compare.json
  OutputFolder(std::filesystem::path folder,
               const std::vector<std::string>& inputs,
               std::string record_name = "run.json");
  /// Adds what was written or removed since write_record() to the record, if there is one.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The path of a file to be written. Throws IoError if it is one of the inputs, if somebody else
  /// wrote or changed what is there, or if it is in a subfolder that is a link: results would land
  /// among files of somebody else. May be called by several threads.
  [[nodiscard]] std::string path(std::string_view name) const;
  void write(std::string_view name, std::string_view content) const;
  /// Removes a file that an earlier run may have left, since it would look like one of this run. A
  /// file of the user stays, and so does an input.
  void remove(std::string_view name) const;
  /// Writes the folder's record: the facts of the run, the version of the program and, as `files`,
  /// its files there.
  void write_record(evaluate::Json facts) const;

  /// The names of the program's files in a subfolder, as they are relative to the folder.
  [[nodiscard]] std::vector<std::string> own_files_in(std::string_view subfolder) const;

 private:
  std::filesystem::path folder_;
  std::string record_name_;
  io::MadeFolders made_;
  std::shared_ptr<io::FolderLock> lock_;
  std::set<std::string> inputs_;  ///< canonical
};

/// Checks the path of a single output file; an empty one is none. Throws IoError if it is one of
/// `others`, the inputs and other outputs, of which empty ones are ignored, or if a file or a link
/// is there, unless `overwrite`. A link is replaced then, and what it names stays. An empty file,
/// as `mktemp` makes it, and devices count as nothing.
void check_output_file(const std::string& file,
                       const std::vector<std::string>& others,
                       bool overwrite);

/// Checks an option that names a picture to be written; an empty `file` is none. Throws
/// std::invalid_argument unless it ends in .png, since a PNG under another name misleads those who
/// open it.
void check_is_png(const std::string& option, const std::string& file);

}  // namespace ridgeline::results
