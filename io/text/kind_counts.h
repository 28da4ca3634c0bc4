// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// The name, in messages, of a kind of content other than 3D lines in a line file.
struct LeftOutKind {
  std::string_view one, several;
};

namespace kinds {
inline constexpr LeftOutKind kPoint{"point", "points"};
inline constexpr LeftOutKind kFlatPolygon{"polygon without heights", "polygons without heights"};
inline constexpr LeftOutKind kPolygon{"polygon with heights", "polygons with heights"};
inline constexpr LeftOutKind kFace{"face", "faces"};
inline constexpr LeftOutKind kVertex{"vertex", "vertices"};
inline constexpr LeftOutKind kTableRow{"row without geometry", "rows without geometry"};
inline constexpr LeftOutKind kHiddenEntity{"entity of hidden layers", "entities of hidden layers"};
inline constexpr LeftOutKind kFlatLine{"line without z", "lines without z"};
inline constexpr LeftOutKind kNullGeometry{"null geometry", "null geometries"};
inline constexpr LeftOutKind kNonFiniteLine{"line with NaN or infinity",
                                            "lines with NaN or infinity"};
}  // namespace kinds

/// Counts things by kind.
class KindCounts {
 public:
  void add(const LeftOutKind& kind, std::size_t n = 1);
  void add(const KindCounts& others);
  [[nodiscard]] bool empty() const { return counts_.empty(); }

  /// The counts as text, "7 points, 1 polygon without heights"; kinds in alphabetical order.
  [[nodiscard]] std::string text() const;

 private:
  struct KindCount {
    std::string one;
    std::size_t n = 0;
  };
  std::map<std::string, KindCount> counts_;  ///< the key is LeftOutKind::several
};

}  // namespace ridgeline::io
