// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/output_folder.h"

#include "io/atomic_file.h"
#include "io/error.h"
#include "reconstruct/geometry/check.h"

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
  for (const std::string& input : inputs) inputs_.push_back(fs::weakly_canonical(input).string());
}

std::string OutputFolder::path(std::string_view name) const {
  return output_file((folder_ / name).string(), inputs_);
}

std::string output_file(const std::string& file, const std::vector<std::string>& others) {
  const fs::path canonical = fs::weakly_canonical(file);
  for (const std::string& other : others) {
    if (other.empty() || fs::weakly_canonical(other) != canonical) continue;
    throw io::IoError(file,
                      "is an input, or another output, and would be written over; choose another "
                      "name");
  }
  return file;
}

void check_is_png(const std::string& option, const std::string& file) {
  check(file.empty() || fs::path(file).extension() == ".png", option, " = ", file,
        ", must end in .png: PNG is what is written");
}

void OutputFolder::write(std::string_view name, std::string_view content) const {
  io::write_file(path(name), content);
}

void OutputFolder::remove(std::string_view name) const { fs::remove(path(name)); }

}  // namespace ridgeline::apps
