// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/made_folders.h"

#include "io/error.h"

#include <system_error>

namespace ridgeline::io {
namespace fs = std::filesystem;

MadeFolders::MadeFolders(const fs::path& folder) {
  if (folder.empty()) return;
  std::error_code error;
  for (fs::path missing = fs::absolute(folder).lexically_normal(); !fs::exists(missing, error);
       missing = missing.parent_path()) {
    if (missing.has_filename()) made_.push_back(missing);
    if (missing == missing.parent_path()) break;
  }
  fs::create_directories(folder, error);
  if (fs::is_directory(folder)) return;
  const std::string why = error ? error.message() : "a file of that name exists";
  throw IoError(folder.string(), "the folder cannot be created: " + why);
}

MadeFolders::~MadeFolders() {
  std::error_code is_in_use;  // a folder in use is kept
  for (const fs::path& folder : made_) fs::remove(folder, is_in_use);
}

}  // namespace ridgeline::io
