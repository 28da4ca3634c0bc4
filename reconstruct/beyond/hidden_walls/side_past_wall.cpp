// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/hidden_walls/side_past_wall.h"

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

/// Coarser than what decides: many heights are tried.
constexpr StripGrid kGrid{1.5, 2.0, 4, 12, 1, false};

/// What the right image shows farther out than the left one if a side lies lower than its line, as
/// the width of the wall between: negative where the left image does.
double px_per_m_of_drop(const StripFrame& frame, double sign, const LocalTransfer& transfer) {
  const Eigen::Vector2d n = normal({frame.on_right.front(), frame.on_right.back()});
  const double outwards = n.dot(sign * frame.side_in_right) > 0.0 ? 1.0 : -1.0;
  return -outwards * n.dot(transfer.per_height);
}

std::vector<Eigen::Vector2d> shifted(std::vector<Eigen::Vector2d> points,
                                     const Eigen::Vector2d& by) {
  for (Eigen::Vector2d& x : points) x += by;
  return points;
}

}  // namespace

void look_past_wall(const ImagePair& images,
                    const EdgePair& edges,
                    const LocalTransfer& transfer,
                    double most_drop_m,
                    EdgeLook& look) {
  constexpr double kMostSimilar = 0.8;   // of at most 2: a side that agrees needs no wall
  constexpr double kNarrowest_px = 2.0;  // of a wall, across the line
  constexpr double kFarthest_px = 36.0;  // of parallax
  constexpr double kStep_px = 1.5;
  // what the best of many heights gains without being right
  constexpr SideLook kByChance{0.2, 0.012};
  if (!look.sides[0] || !look.sides[1]) return;
  const int worse = look.sides[0]->agreement() < look.sides[1]->agreement() ? 0 : 1;
  if (look.sides[worse]->agreement() > kMostSimilar) return;
  const double sign = worse == 0 ? -1.0 : 1.0;
  StripFrame frame = strip_frame(edges, kGrid.most_along);
  frame.side_in_right = transfer.jacobian * frame.side_in_left;
  const double px_per_m = px_per_m_of_drop(frame, sign, transfer);
  const double parallax_px_per_m = transfer.per_height.norm();
  const double narrowest_m = kNarrowest_px / std::abs(px_per_m);
  const double lowest_m = std::min(kFarthest_px / parallax_px_per_m, most_drop_m);
  const double step_m = kStep_px / parallax_px_per_m;
  const Eigen::Vector2d side_in_left = sign * frame.side_in_left;
  const Eigen::Vector2d side_in_right = sign * frame.side_in_right;
  const Eigen::Matrix2d left_from_right = transfer.jacobian.inverse();
  Strip on_left = sample_strip(images.left, frame.on_left, side_in_left, kGrid);
  Strip on_right = sample_strip(images.right, frame.on_right, side_in_right, kGrid);
  for (int k = 0; narrowest_m + k * step_m <= lowest_m; ++k) {
    // the strips on a level that much lower: beside the line where no wall hides it, farther out in
    // the other image
    const Eigen::Vector2d shift_px = -(narrowest_m + k * step_m) * transfer.per_height;
    if (px_per_m > 0.0) {
      on_right =
          sample_strip(images.right, shifted(frame.on_right, shift_px), side_in_right, kGrid);
    } else {
      const Eigen::Vector2d back_px = -left_from_right * shift_px;
      on_left = sample_strip(images.left, shifted(frame.on_left, back_px), side_in_left, kGrid);
    }
    std::optional<SideLook> found =
        compare(on_left, on_right, images.radiometry, images.left.n_bands());
    if (!found) continue;
    found->ncc -= kByChance.ncc;
    found->colour_difference += kByChance.colour_difference;
    if (found->agreement() <= look.sides[worse]->agreement()) continue;
    look.sides[worse] = found;
    look.is_past_wall[worse] = true;
  }
}

}  // namespace ridgeline::reconstruct
