// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/image_count.h"
#include "evaluate/statistics/interval.h"

#include <cstddef>
#include <optional>
#include <string>

namespace ridgeline::evaluate {

/// Numbers of true edges visible in two images or more, and of their observations.
struct TrackCounts {
  std::size_t n_edges = 0, n_edges_found = 0;
  std::size_t n_shown = 0, n_shown_found = 0;  ///< images that show an edge, summed over the edges
  std::size_t n_right = 0, n_wrong = 0;        ///< observations of the tracks of these edges

  /// Share of the edges on which a track lies, of their images in such tracks, and of the tracks'
  /// observations that are correct; empty if the denominator is 0.
  [[nodiscard]] std::optional<double> edge_recall() const { return share(n_edges_found, n_edges); }
  [[nodiscard]] std::optional<double> observation_recall() const {
    return share(n_shown_found, n_shown);
  }
  [[nodiscard]] std::optional<double> observation_precision() const {
    return share(n_right, n_right + n_wrong);
  }

 private:
  static std::optional<double> share(std::size_t part, std::size_t whole) {
    if (whole == 0) return std::nullopt;
    return static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// The edges of a class that are visible in a given number of images.
struct TrackCell {
  std::string line_class;            ///< not_aligned, aligned, total
  std::optional<std::size_t> group;  ///< image_group(); empty: all
  TrackCounts counts;
};

}  // namespace ridgeline::evaluate
