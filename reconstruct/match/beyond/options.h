// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// The options of the extensions of the matching; see match_extensions().
struct MatchExtensionOptions {
  bool matched_radiometry = true;
  bool hidden_walls = true;
  /// The depth of the surfaces beside a line counts for or against its candidates. See
  /// weigh_by_surface().
  bool surface = true;
  /// Counterparts of unmatched segments are searched for where the surfaces beside the segments
  /// predict them. See guided_matches().
  bool guided = true;

  static constexpr MatchExtensionOptions none() {
    return {.matched_radiometry = false, .hidden_walls = false, .surface = false, .guided = false};
  }

  static constexpr auto fields() {
    using O = MatchExtensionOptions;
    return std::tuple{
        Field{"matched_radiometry", &O::matched_radiometry, false, true,
              "estimate gain and offset of the images from common surfaces"},
        Field{"hidden_walls", &O::hidden_walls, false, true,
              "compare edges across walls visible to only one camera"},
        Field{"surface", &O::surface, false, true,
              "select among candidates by the depth of the adjacent surfaces (dense matching)"},
        Field{"guided", &O::guided, false, true,
              "search unmatched lines in the other image where these surfaces predict them"}};
  }
};

/// The options of the extensions of the matching in object space; see chio_extensions().
struct ChioExtensionOptions {
  bool allow_noise = true;
  bool by_appearance = true;
  double min_similarity = 0.3;

  static constexpr ChioExtensionOptions none() {
    return {.allow_noise = false, .by_appearance = false};
  }

  static constexpr auto fields() {
    using O = ChioExtensionOptions;
    return std::tuple{
        Field{"allow_noise", &O::allow_noise, false, true,
              "widen limits by noise and compare heights where lines meet; off: as published"},
        Field{"by_appearance", &O::by_appearance, false, true,
              "rank candidates by appearance; off: by their reliable pieces, as published"},
        Field{"min_similarity", &O::min_similarity, 0.0, 1.0,
              "by_appearance: minimum similarity of a match"}};
  }
};

}  // namespace ridgeline::reconstruct
