// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/lod.h"

#include "io/text/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace ridgeline::io {
namespace {

/// Level 0 is a footprint, level 4 has rooms.
constexpr double kMinLevel = 1.0;
constexpr double kBelow = 4.0;

double level_of(const std::string& lod) { return to_double(lod).value_or(kMinLevel); }

bool is_of(const std::string& lod, std::string_view wanted) {
  if (wanted.empty()) return level_of(lod) >= kMinLevel && level_of(lod) < kBelow;
  return lod == wanted ||
         (wanted.size() == 1 && lod.starts_with(wanted) && lod.size() > 1 && lod[1] == '.');
}

/// "1 of 3 buildings and parts is", followed by what is said of them and their ids.
std::string counted(const std::vector<std::string>& ids, std::size_t n_all, std::string_view text) {
  constexpr std::size_t kShown = 5;
  const std::size_t n = std::min(kShown, ids.size());
  const std::vector<std::string> shown(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(n));
  return fmt::format("{} of {} buildings and parts {} {}: {}{}", ids.size(), n_all,
                     ids.size() == 1 ? "is" : "are", text, fmt::join(shown, ", "),
                     ids.size() > n ? fmt::format(" and {} more", ids.size() - n) : "");
}

}  // namespace

std::optional<std::string> chosen_lod(const std::set<std::string>& lods,
                                      const std::string& wanted) {
  const std::string* chosen = nullptr;
  for (const std::string& lod : lods) {
    if (is_of(lod, wanted) && (chosen == nullptr || level_of(lod) >= level_of(*chosen)))
      chosen = &lod;
  }
  return chosen == nullptr ? std::nullopt : std::optional(*chosen);
}

std::vector<std::optional<std::string>> LodChoice::choose(const std::vector<LodObject>& objects) {
  std::vector<std::optional<std::string>> chosen;
  bool has_wanted = false;
  for (const LodObject& object : objects) {
    chosen.push_back(chosen_lod(object.lods, wanted_));
    has_wanted = has_wanted || chosen.back();
    if (!chosen.back()) chosen.back() = chosen_lod(object.lods, "");
  }
  if (!has_wanted) {
    const bool has_faces =
        std::ranges::any_of(objects, [](const LodObject& object) { return !object.lods.empty(); });
    if (has_faces) without_faces_.push_back(objects[0].id);
    return std::vector<std::optional<std::string>>(objects.size());
  }
  for (std::size_t i = 1; i < objects.size(); ++i)
    if (!chosen[i] && !objects[i].lods.empty()) without_faces_.push_back(objects[i].id);
  const auto leave_out = [&](std::size_t i) {
    repeated_[*chosen[i]].push_back(objects[i].id);
    chosen[i].reset();
  };
  for (std::size_t i = 1; i < objects.size() && chosen[0]; ++i) {
    if (!chosen[i] || level_of(*chosen[i]) <= level_of(*chosen[0])) continue;
    const bool is_outline_wanted = is_of(*chosen[0], wanted_) && !is_of(*chosen[i], wanted_);
    leave_out(is_outline_wanted ? i : 0);
  }
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (chosen[i]) read_[*chosen[i]].push_back(objects[i].id);
  return chosen;
}

std::vector<std::string> LodChoice::warnings() const {
  std::size_t n_all = without_faces_.size();
  std::string usual;
  for (const auto& [lod, ids] : read_) {
    n_all += ids.size();
    if (usual.empty() || ids.size() >= read_.at(usual).size()) usual = lod;
  }
  for (const auto& [lod, ids] : repeated_) n_all += ids.size();
  std::vector<std::string> warnings;
  const auto warn = [&](const Ids& ids, const std::string& text) {
    if (!ids.empty()) warnings.push_back(counted(ids, n_all, text));
  };
  for (const auto& [lod, ids] : read_)
    if (lod != usual) warn(ids, fmt::format("read in LoD {} (most in LoD {})", lod, usual));
  for (const auto& [lod, ids] : repeated_)
    warn(ids, fmt::format("left out, as the faces in LoD {} repeat those of another level", lod));
  warn(without_faces_, fmt::format("left out, as there are no faces in LoD {}",
                                   wanted_.empty() ? "1 to 3" : wanted_));
  return warnings;
}

}  // namespace ridgeline::io
