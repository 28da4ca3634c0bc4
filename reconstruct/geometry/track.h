// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/transformed.h"

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline {

/// The numbers of a view and of one of its segments that shows a line. Segment -1 stands for a
/// segment that was not extracted: the projection of a true edge or of an intersection of surfaces.
struct Observation {
  std::size_t view = 0;
  int segment = 0;
  friend auto operator<=>(const Observation&, const Observation&) = default;
};

/// A segment in one of several views, in ideal pixels: an extracted segment, a part of one, or a
/// segment that was not extracted.
struct ObservedSegment : Observation {
  Segment2 px;
};

/// The observations of one line in several views. A view that shows the line in pieces has several
/// observations.
template <typename Observed>
struct TrackOf {
  std::vector<Observed> observations;  ///< base(), other(), then the rest

  /// The observation that determines the ends of the line.
  [[nodiscard]] const Observed& base() const { return observations[0]; }
  [[nodiscard]] Observed& base() { return observations[0]; }
  /// The observation of another view that together with base() determines the line best.
  [[nodiscard]] const Observed& other() const { return observations[1]; }
  [[nodiscard]] Observed& other() { return observations[1]; }
};

using Track = TrackOf<Observation>;

/// The numbers of two of several views.
struct ViewPair {
  std::size_t base = 0, search = 1;
};

/// The matches of a pair of views.
struct MatchedPair {
  ViewPair views;
  std::vector<Correspondence> matches;
};

/// The tracks of a pair of views; track i belongs to match i.
inline std::vector<Track> tracks_of_pair(const ViewPair& views,
                                         std::span<const Correspondence> matches) {
  return transformed(matches, [&](const Correspondence& m) {
    return Track{{{views.base, m.base}, {views.search, m.other}}};
  });
}

}  // namespace ridgeline
