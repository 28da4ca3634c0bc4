// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/epipolar_transfer.h"
#include "reconstruct/geometry/track.h"
#include "reconstruct/scene/scene.h"

#include <array>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The positions in a view of the ends of a segment of another view, as functions of their heights.
using EndStretches = std::array<Stretch, 2>;

/// The views of a scene, prepared for searching segments: a spatial index of each view's segments,
/// the transfers between the views, and the matches by appearance. It does not own the scene.
class SearchedViews {
 public:
  SearchedViews(const Scene& scene, std::span<const MatchedPair> pairs);

  [[nodiscard]] std::size_t size() const { return views_.size(); }
  [[nodiscard]] const std::array<double, 2>& heights_m() const {
    return scene_.height_range_in_local_m;
  }
  [[nodiscard]] std::size_t n_segments(std::size_t view) const { return views_[view].lines.size(); }
  [[nodiscard]] const UncertainSegment2& line(const Observation& s) const {
    return views_[s.view].lines[static_cast<std::size_t>(s.segment)];
  }
  [[nodiscard]] const BoxIndex2& by_place(std::size_t view) const { return views_[view].index; }
  [[nodiscard]] bool shows(std::size_t view, const Eigen::Vector2d& x_px) const;

  /// The other views, nearest first.
  [[nodiscard]] std::span<const std::size_t> others(std::size_t view) const {
    return views_[view].others;
  }
  [[nodiscard]] EndStretches stretches(const Observation& from, std::size_t to) const;
  /// The object points at the ends of a segment, at the given heights.
  [[nodiscard]] Segment3 object_segment(const Observation& s,
                                        const Eigen::Vector2d& heights_m) const;

  enum class MatchState { kUnknown, kMatched, kMatchedElsewhere };
  /// Whether two segments were matched with each other by appearance, or one of them was matched
  /// with a different segment of the other's view.
  [[nodiscard]] MatchState match_state(const Observation& a, const Observation& b) const;

 private:
  struct SearchedView {
    std::vector<UncertainSegment2> lines;
    BoxIndex2 index;
    std::vector<std::size_t> others;
    std::vector<EpipolarTransfer> to;       ///< by view
    std::vector<std::vector<int>> matched;  ///< by view and segment; -1: none
  };

  const Scene& scene_;
  std::vector<SearchedView> views_;
};

}  // namespace ridgeline::reconstruct
