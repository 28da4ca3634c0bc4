// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::apps {

/// The folder of a run's results. Every file is written whole or not at all, and none of the
/// inputs is ever written over.
class OutputFolder {
 public:
  /// Creates the folder. Throws IoError if it cannot be made or is a file.
  OutputFolder(std::filesystem::path folder, const std::vector<std::string>& inputs);

  /// The path of a file to be written. Throws IoError if it is one of the inputs.
  [[nodiscard]] std::string path(std::string_view name) const;
  void write(std::string_view name, std::string_view content) const;
  /// Takes away what an earlier run has left there, if anything, which would look like of this one.
  void remove(std::string_view name) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::string> inputs_;  ///< canonical
};

/// A single output file, which must not be an input or another output; empty ones are none. Throws
/// IoError if it is.
std::string output_file(const std::string& file, const std::vector<std::string>& others);

/// Checks an option that names a picture to be written; empty is none. Throws std::invalid_argument
/// unless it ends in .png: a PNG under another name misleads those who open it.
void check_is_png(const std::string& option, const std::string& file);

}  // namespace ridgeline::apps
