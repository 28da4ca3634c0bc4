// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/output_folder.h"

#include "io/atomic_file.h"
#include "io/error.h"

#include <algorithm>
#include <system_error>

namespace ridgeline::apps {
namespace fs = std::filesystem;

OutputFolder::OutputFolder(fs::path folder, const std::vector<std::string>& inputs)
    : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!fs::is_directory(folder_)) {
    throw io::IoError(folder_.string(), "cannot be made a folder for the results");
  }
  for (const std::string& input : inputs) inputs_.push_back(fs::weakly_canonical(input));
}

std::string OutputFolder::path(std::string_view name) const {
  const fs::path file = folder_ / name;
  const fs::path canonical = fs::weakly_canonical(file);
  if (std::find(inputs_.begin(), inputs_.end(), canonical) != inputs_.end()) {
    throw io::IoError(file.string(), "is an input and would be written over; choose another --out");
  }
  return file.string();
}

void OutputFolder::write(std::string_view name, std::string_view content) const {
  io::write_file(path(name), content);
}

}  // namespace ridgeline::apps
