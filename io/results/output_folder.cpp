// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/output_folder.h"

#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/images/png_writer.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse_foreign(const std::string& file, std::string_view kind) {
  throw io::IoError(file, fmt::format("is no {} of ridgeline and would be written over; choose "
                                      "another name or remove it",
                                      kind));
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder, const std::vector<std::string>& inputs)
    : folder_(std::move(folder)), made_(folder_), lock_(io::FolderLock::of(folder_)) {
  for (const std::string& input : inputs) inputs_.push_back(fs::weakly_canonical(input).string());
}

std::string OutputFolder::path(std::string_view name) const {
  const fs::path file = folder_ / name;
  const fs::path subfolder = file.parent_path();
  if (subfolder != folder_ && fs::is_symlink(subfolder)) {
    throw io::IoError(subfolder.string(), "is a link; results are not written through links");
  }
  return output_file(file.string(), inputs_);
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

bool holds_something(const std::string& file) {
  return fs::is_regular_file(fs::symlink_status(file)) && fs::file_size(file) > 0;
}

void check_is_own(const std::string& file,
                  bool (*is_own)(const std::string& file),
                  std::string_view kind) {
  if (holds_something(file) && !is_own(file)) refuse_foreign(file, kind);
}

void check_is_own(const std::string& file, std::string_view beginning, std::string_view kind) {
  if (!holds_something(file)) return;
  std::ifstream stream(file, std::ios::binary);
  std::string start(beginning.size(), '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (!stream || start != beginning) refuse_foreign(file, kind);
}

void check_is_png(const std::string& option, const std::string& file) {
  check(file.empty() || fs::path(file).extension() == ".png", option, " = ", file,
        ", must end in .png: PNG is what is written");
  check_is_own(file, io::is_own_png, "picture");
}

void OutputFolder::write(std::string_view name, std::string_view content) const {
  io::write_file(path(name), content);
}

void OutputFolder::remove(std::string_view name) const { fs::remove(path(name)); }

}  // namespace ridgeline::results
