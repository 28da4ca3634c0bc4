// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// How a line is moved to a wrong position. As for a real error of that kind, the evidence that the
/// line is judged by either moves with it or stays behind.
enum class DecoyKind : std::uint8_t {
  kHeight,  ///< up or down; its image segments stay where they are
  kAcross,  ///< in plan at right angles to the line; its image segments stay where they are
  kMatch,  ///< along the rays of its first image; its other image segments move as in a false match
  kElsewhere,  ///< far away in plan, together with its cameras; not a decoy for decoy_figures(),
               ///< see cloud_following()
};
const char* name(DecoyKind kind);  ///< "height" | "across" | "match" | "elsewhere"

inline constexpr std::array kDecoyKinds{DecoyKind::kHeight, DecoyKind::kAcross, DecoyKind::kMatch};
inline constexpr std::array kDecoyDistances_m{0.5, 1.0, 2.0, 5.0};
inline constexpr std::array kElsewhere_m{20.0, 50.0, 100.0};

/// A line that was moved deliberately.
struct Decoy {
  std::size_t parent = 0;  ///< number of the original line
  DecoyKind kind = DecoyKind::kHeight;
  double distance_m = 0.0;  ///< > 0
  JudgedLine line;
  std::size_t number = 0;  ///< among the decoys of all lines, if only an area is judged
};

/// The line moved by `distance_m`: up (kHeight, kMatch) or to its left in plan (kAcross), as seen
/// from the end that comes first in x, then y, then z; a negative distance moves it down or to the
/// right. The order of its ends has no effect.
///   - kMatch keeps the projections of both ends in the first image. Each other segment becomes the
///     projection of the moved line plus the segment's residual from the projection of the original
///     line, end by end.
///   - kHeight and kAcross leave the image segments unchanged. The line then lies off its own
///     segments, like one that was badly intersected.
/// Empty for a line that cannot be moved in this way: kMatch without images, out of the images'
/// height range, or along rays so flat that they move the line more than ten times as far as the
/// change in height; kAcross for a line without a direction in plan. Throws std::invalid_argument
/// for kElsewhere.
std::optional<JudgedLine> moved_line(const JudgedLine& line, DecoyKind kind, double distance_m);

/// How many decoys are made from `n_lines` lines unless the user specifies otherwise: half as many,
/// at least 200 and at most 2,000.
std::size_t default_n_decoys(std::size_t n_lines);

/// `n_decoys` decoys of lines that can be judged, or fewer if there are not enough possible moves.
/// A hash of a line's coordinates decides whether and how it is moved, and forms the decoy's id, so
/// that ids and order of the lines have no effect. Each line is moved in one of its possible ways
/// (kind, distance, direction), or in several if there are fewer lines than decoys. A line with the
/// same coordinates as an earlier one is left out.
std::vector<Decoy> make_decoys(std::span<const JudgedLine> lines, std::size_t n_decoys);

/// 200 lines, each moved in plan by one of kElsewhere_m, or by several of them if there are fewer
/// lines. They are drawn as in make_decoys(). A line is moved in one of eight directions in which
/// it stays within the rectangle around all of these lines, so that no other parts of the cloud
/// need to be read. If there is no such direction, it is not moved.
std::vector<Decoy> move_elsewhere(std::span<const JudgedLine> lines);

}  // namespace ridgeline::evaluate
