// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/shared_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace ridgeline::io {
namespace {

struct SharedWarning {
  std::string text;  ///< from the colon behind the path
  std::string first_path;
  std::set<std::string> paths;

  [[nodiscard]] std::string sentence() const {
    const std::size_t n_more = paths.size() - 1;
    if (n_more == 0) return first_path + text;
    return fmt::format("{} and {} more file{}{}", first_path, n_more, n_more == 1 ? "" : "s", text);
  }
};

}  // namespace

std::vector<std::string> shared_warnings(const std::vector<std::string>& warnings) {
  std::vector<SharedWarning> all;
  for (const std::string& warning : warnings) {
    const std::size_t colon = std::min(warning.find(": "), warning.size());
    const std::string path = warning.substr(0, colon);
    const std::string text = warning.substr(colon);
    const auto known = std::ranges::find(all, text, &SharedWarning::text);
    SharedWarning& shared =
        known == all.end() ? all.emplace_back(SharedWarning{text, path, {}}) : *known;
    shared.paths.insert(path);
  }
  std::vector<std::string> sentences;
  sentences.reserve(all.size());
  for (const SharedWarning& shared : all) sentences.push_back(shared.sentence());
  return sentences;
}

}  // namespace ridgeline::io
