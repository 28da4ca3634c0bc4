// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/sample_data.h"

#include "io/error.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> places() {
  std::vector<fs::path> folders;
  if (const char* given = std::getenv("RIDGELINE_SAMPLE_DATA")) folders.emplace_back(given);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    folders.push_back(program.parent_path().parent_path() / "share/ridgeline/sample_data");
  }
  folders.emplace_back(RIDGELINE_SOURCE_SAMPLE_DATA);
  return folders;
}

std::vector<fs::path> patches_in(const fs::path& folder) {
  std::vector<fs::path> patches;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (fs::exists(entry.path() / "lidar.las")) patches.push_back(entry.path());
  }
  std::sort(patches.begin(), patches.end());
  return patches;
}

}  // namespace

std::vector<fs::path> sample_patches() {
  std::string tried;
  for (const fs::path& folder : places()) {
    std::vector<fs::path> patches = patches_in(folder);
    if (!patches.empty()) return patches;
    tried += (tried.empty() ? "" : ", ") + folder.string();
  }
  throw io::IoError("sample_data", "not found; searched in " + tried);
}

}  // namespace ridgeline::apps
