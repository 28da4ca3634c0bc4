// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/line_match.h"
#include "reconstruct/geometry/transformed.h"

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline {

/// A segment of one of several views, by their numbers.
struct Sighting {
  std::size_t view = 0;
  int segment = 0;
  friend auto operator<=>(const Sighting&, const Sighting&) = default;
};

/// The segments that show one edge. The first two are of different views, the base view of the
/// track and its best partner. A view that shows the edge in pieces has several.
struct Track {
  std::vector<Sighting> seen;
};

/// Two of several views, by their numbers.
struct ViewPair {
  std::size_t base = 0, search = 1;
};

/// The matches of a pair of views.
struct MatchedPair {
  ViewPair views;
  std::vector<LineMatch> matches;
};

/// The tracks of a pair of views: track i is match i.
inline std::vector<Track> tracks_of_pair(const ViewPair& views,
                                         std::span<const LineMatch> matches) {
  return transformed(matches, [&](const LineMatch& m) {
    return Track{{{views.base, m.left}, {views.search, m.right}}};
  });
}

}  // namespace ridgeline
