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

/// How a line is moved to a wrong place. What a line is judged by stays with it or does not, as for
/// a real error of that kind.
enum class DecoyKind : std::uint8_t {
  kHeight,     ///< up or down; its image segments stay where they are
  kAcross,     ///< in plan at right angles to the line; its image segments stay where they are
  kMatch,      ///< along the rays of its first image; its other image segments are moved as a false
               ///< match has them
  kElsewhere,  ///< in plan, far off, with its cameras; not a decoy of decoy_figures(), see
               ///< cloud_following()
};
const char* name(DecoyKind kind);  ///< "height" | "across" | "match" | "elsewhere"

inline constexpr std::array kDecoyKinds{DecoyKind::kHeight, DecoyKind::kAcross, DecoyKind::kMatch};
inline constexpr std::array kDecoyDistances_m{0.5, 1.0, 2.0, 5.0};
inline constexpr std::array kElsewhere_m{20.0, 50.0, 100.0};

/// A line that was moved on purpose.
struct Decoy {
  std::size_t parent = 0;  ///< number of the line that was moved
  DecoyKind kind = DecoyKind::kHeight;
  double distance_m = 0.0;  ///< > 0
  JudgedLine line;
  std::size_t number = 0;  ///< among those of all lines, if only an area is judged
};

/// The line moved by `distance_m`: up (kHeight, kMatch) or to its left in plan (kAcross), seen from
/// that end which comes first in x, then y, then z; a negative distance moves it down or to the
/// right. The order of its ends plays no part.
///   - kMatch keeps the images of both ends in the first image. Each other segment becomes the
///     projection of the moved line plus what the segment differed from the projection of the line
///     itself, end by end.
///   - kHeight and kAcross leave the image segments alone. The line is then off its own segments,
///     as one that was badly intersected is.
/// Nothing for a line that cannot be so moved: kMatch without images, out of the images' height
/// range, or along rays that are so flat that they lead more than ten times as far in plan as in
/// height; kAcross of a line without a direction in plan. Throws std::invalid_argument for
/// kElsewhere.
std::optional<JudgedLine> moved_line(const JudgedLine& line, DecoyKind kind, double distance_m);

/// How many decoys are made of `n_lines` lines unless a user says otherwise: half as many, at least
/// 200 and at most 2,000.
std::size_t default_n_decoys(std::size_t n_lines);

/// `n_decoys` decoys of lines that can be judged, fewer if there are not so many ways. A hash of a
/// line's coordinates decides whether it is moved and how, and makes the decoy's id, so that ids
/// and order of the lines play no part. Each line is moved in one of the ways (kind, distance,
/// sense) that it can be; of fewer lines than decoys in several. A line that has the coordinates of
/// an earlier one is left out.
std::vector<Decoy> make_decoys(std::span<const JudgedLine> lines, std::size_t n_decoys);

/// 200 lines moved in plan by one of kElsewhere_m; fewer lines by several of them. They are drawn
/// as make_decoys() does. A line is moved to one of eight sides where it stays in the rectangle
/// around all of them: other parts of the cloud need not be read for it. Without such a side it is
/// not moved.
std::vector<Decoy> move_elsewhere(std::span<const JudgedLine> lines);

}  // namespace ridgeline::evaluate
