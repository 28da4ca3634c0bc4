// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/output_folder.h"

#include "evaluate/files/version.h"
#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/files/text_file.h"
#include "reconstruct/geometry/check.h"

#include <exception>
#include <utility>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

using evaluate::Json;

/// Whether a new file would replace something.
bool would_be_lost(const fs::path& file) {
  const fs::file_status status = fs::symlink_status(file);
  if (fs::is_regular_file(status)) return fs::file_size(file) > 0;
  return fs::is_symlink(status) && !io::is_device(file.string());
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder,
                           const std::vector<std::string>& inputs,
                           std::string record_name)
    : folder_(std::move(folder)),
      record_name_(std::move(record_name)),
      made_(folder_),
      lock_(io::FolderLock::of(folder_)) {
  for (const std::string& input : inputs) inputs_.insert(fs::weakly_canonical(input).string());
}

OutputFolder::~OutputFolder() {
  try {
    const fs::path record = folder_ / record_name_;
    if (lock_->has_unlisted() && io::is_record(record))
      write_record(Json::parse(io::read_text_file(record.string())));
  } catch (const std::exception&) {  // the lock file still contains the list
  }
}

std::string OutputFolder::path(std::string_view name) const {
  const fs::path file = folder_ / name;
  const fs::path subfolder = file.parent_path();
  if (subfolder != folder_ && fs::is_symlink(subfolder)) {
    throw io::IoError(subfolder.string(), "is a link; results are not written through links");
  }
  if (inputs_.contains(fs::weakly_canonical(file).string())) {
    throw io::IoError(file.string(), "is an input and would be overwritten; choose another folder");
  }
  if (!fs::is_directory(file)) lock_->require_own(std::string(name));
  return file.string();
}

void OutputFolder::write(std::string_view name, std::string_view content) const {
  io::write_file(path(name), content);
}

void OutputFolder::remove(std::string_view name) const {
  if (!inputs_.contains(fs::weakly_canonical(folder_ / name).string()))
    lock_->remove(std::string(name));
}

void OutputFolder::write_record(Json facts) const {
  facts["versions"]["ridgeline"] = kVersion;
  facts["files"] = lock_->own_files();
  io::write_file(path(record_name_), evaluate::dump(facts));
  lock_->set_listed();
}

std::vector<std::string> OutputFolder::own_files_in(std::string_view subfolder) const {
  const fs::path prefix = fs::path(subfolder) / "";
  std::vector<std::string> names;
  for (const Json& entry : lock_->own_files()) {
    const auto name = entry.at("path").get<std::string>();
    if (name.starts_with(prefix.string())) names.push_back(name);
  }
  return names;
}

void check_output_file(const std::string& file,
                       const std::vector<std::string>& others,
                       bool overwrite) {
  if (file.empty()) return;
  const fs::path canonical = fs::weakly_canonical(file);
  for (const std::string& other : others) {
    if (other.empty() || fs::weakly_canonical(other) != canonical) continue;
    throw io::IoError(
        file, "is an input or another output and would be overwritten; choose another name");
  }
  if (!overwrite && would_be_lost(file)) {
    throw io::IoError(file, "already exists; `overwrite` replaces it");
  }
}

void check_is_png(const std::string& option, const std::string& file) {
  check(file.empty() || fs::path(file).extension() == ".png", option, " = ", file,
        ", must end in .png");
}

}  // namespace ridgeline::results
