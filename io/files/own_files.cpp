// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/own_files.h"

#include "io/files/mapped_file.h"
#include "io/files/sha256.h"

#include <algorithm>
#include <array>
#include <system_error>

namespace ridgeline::io {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

std::string text_at(const json& entry, const char* key) {
  const auto found = entry.find(key);
  return found != entry.end() && found->is_string() ? found->get<std::string>() : "";
}

bool is_sqlite(const fs::path& name) { return name.extension() == ".gpkg"; }

/// The digest of an SQLite file without its 100-byte header, which contains counters.
std::string sha256_after_header(const fs::path& path) {
  constexpr std::size_t kHeaderBytes = 100;
  const MappedFile file(path.string());
  Sha256 digest;
  digest.update(file.bytes().subspan(std::min(kHeaderBytes, file.bytes().size())));
  return digest.hex_digest();
}

/// Whether another program has the SQLite file open with changes that have not yet been written to
/// it.
bool has_changes_beside(const fs::path& file) {
  return std::ranges::any_of(std::array{"-wal", "-journal"}, [&](const char* ending) {
    std::error_code none;
    const auto size = fs::file_size(file.string() + ending, none);
    return !none && size > 0;
  });
}

}  // namespace

void OwnFiles::add(const json& entries) {
  if (!entries.is_array()) return;
  for (const json& entry : entries) {
    const bool is_entry = entry.is_object() && !text_at(entry, "path").empty();
    if (is_entry && !text_at(entry, "sha256").empty())
      files_[text_at(entry, "path")].push_back(entry);
  }
}

json OwnFiles::entry_of(const std::string& name, const fs::path& file) {
  json entry{{"path", name}, {"sha256", sha256_of_file(file.string())}};
  if (is_sqlite(name)) entry["sha256_after_header"] = sha256_after_header(file);
  return entry;
}

bool OwnFiles::holds(const std::string& name) const {
  const auto listed = files_.find(name);
  const fs::path file = folder_ / name;
  if (listed == files_.end() || !fs::is_regular_file(fs::symlink_status(file))) return false;
  if (is_sqlite(file) && has_changes_beside(file)) return false;
  const json now = entry_of(name, file);
  return std::ranges::any_of(listed->second, [&](const json& then) {
    const std::string rest = text_at(then, "sha256_after_header");
    return text_at(then, "sha256") == text_at(now, "sha256") ||
           (!rest.empty() && rest == text_at(now, "sha256_after_header"));
  });
}

nlohmann::ordered_json OwnFiles::to_json() const {
  auto entries = nlohmann::ordered_json::array();
  for (const auto& [name, contents] : files_)
    if (fs::exists(folder_ / name)) entries.push_back(nlohmann::ordered_json(contents.back()));
  return entries;
}

}  // namespace ridgeline::io
