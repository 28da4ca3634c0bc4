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

/// The folder of a run's results. Every file is written completely or not at all. Inputs and files
/// of the user are never overwritten or removed; io::FolderLock keeps track of the program's own
/// files and keeps other processes from writing results there at the same time.
class OutputFolder {
 public:
  /// Creates the folder and locks it. A folder that it created is removed again if it stays empty.
  /// Throws IoError if the folder cannot be created, is a file, or is being written by another
  /// process.
  /// @param record_name  file that lists the program's files: run.json, simulate.json or
  /// compare.json
  OutputFolder(std::filesystem::path folder,
               const std::vector<std::string>& inputs,
               std::string record_name = "run.json");
  /// Updates the record, if any, with what was written or removed since write_record().
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The path of a file to be written. Throws IoError if it is an input, if an existing file was
  /// not written by the program or has been changed since, or if its subfolder is a link, because
  /// results would end up among foreign files. Thread-safe.
  [[nodiscard]] std::string path(std::string_view name) const;
  void write(std::string_view name, std::string_view content) const;
  /// Removes a file left by an earlier run, which would look like a result of this one. Inputs and
  /// files of the user are kept.
  void remove(std::string_view name) const;
  /// Writes the folder's record: the facts of the run, the version of the program and, under
  /// `files`, its files in the folder.
  void write_record(evaluate::Json facts) const;

  /// The names of the program's files in a subfolder, relative to the folder.
  [[nodiscard]] std::vector<std::string> own_files_in(std::string_view subfolder) const;

 private:
  std::filesystem::path folder_;
  std::string record_name_;
  io::MadeFolders made_;
  std::shared_ptr<io::FolderLock> lock_;
  std::set<std::string> inputs_;  ///< canonical
};

/// Checks the path of a single output file; empty means no output. Throws IoError if it is one of
/// `others` (inputs and other outputs; empty ones are ignored), or if a file or link exists there,
/// unless `overwrite`. With `overwrite`, a link is replaced and its target is kept. Empty files, as
/// created by `mktemp`, and devices do not count as existing.
void check_output_file(const std::string& file,
                       const std::vector<std::string>& others,
                       bool overwrite);

/// Checks an option that names an image file to be written; an empty `file` means none. Throws
/// std::invalid_argument unless it ends in .png, because a PNG with another extension is
/// misleading.
void check_is_png(const std::string& option, const std::string& file);

}  // namespace ridgeline::results
