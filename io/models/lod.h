// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::io {

/// The level of detail in which something is read, out of those in which it has faces. `wanted`:
/// see ReadModelOptions::lod. Returns std::nullopt if there is no such level. Levels without a
/// number rank as 1; among equal ranks, the last one is taken.
std::optional<std::string> chosen_lod(const std::set<std::string>& lods, const std::string& wanted);

/// A building or a part of one, with the levels of detail in which it has faces.
struct LodObject {
  std::string id;
  std::set<std::string> lods;
};

/// Chooses the levels of detail of buildings and their parts, and notes which of them are read in
/// another level than most, and which are left out.
class LodChoice {
 public:
  explicit LodChoice(std::string wanted) : wanted_(std::move(wanted)) {}

  /// The levels in which the objects of a building are read: each in the wanted one, otherwise in
  /// its highest. Nothing is read of a building without the wanted level. `objects` begins with the
  /// building itself. Its own faces in a lower level than those of a part are an outline of the
  /// whole: only one of the two is read, the wanted level or the higher one.
  std::vector<std::optional<std::string>> choose(const std::vector<LodObject>& objects);

  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  using Ids = std::vector<std::string>;

  std::string wanted_;
  std::map<std::string, Ids> read_;      ///< ids of the objects by level
  std::map<std::string, Ids> repeated_;  ///< left out beside the parts, or the whole
  Ids without_faces_;                    ///< in a level that may be read
};

}  // namespace ridgeline::io
