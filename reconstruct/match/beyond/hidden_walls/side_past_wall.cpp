// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/hidden_walls/side_past_wall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

/// The grid is coarser than that of the final comparison, because many heights are tried.
constexpr StripGrid kGrid{1.5, 2.0, 4, 12, 1, false};

std::vector<Eigen::Vector2d> shifted(std::vector<Eigen::Vector2d> points,
                                     const Eigen::Vector2d& by) {
  for (Eigen::Vector2d& x : points) x += by;
  return points;
}

/// The strips on one side of an edge in both images, on level surfaces at and below the edge.
class LoweredStrips {
 public:
  /// @param sign  -1 for the left side of the edge, 1 for the right one
  LoweredStrips(const ImagePair& images,
                const EdgePair& edges,
                const LocalTransfer& transfer,
                double sign)
      : images_(images), transfer_(transfer), frame_(strip_frame(edges, kGrid.most_along)) {
    side_in_left_ = sign * frame_.side_in_left;
    side_in_right_ = transfer.jacobian * side_in_left_;
    const Eigen::Vector2d n = normal({frame_.on_right.front(), frame_.on_right.back()});
    const double outwards = n.dot(side_in_right_) > 0.0 ? 1.0 : -1.0;
    right_px_per_m_ = -outwards * n.dot(transfer.per_height);
    at_edge_ = {sample_strip(images.left, frame_.on_left, side_in_left_, kGrid),
                sample_strip(images.right, frame_.on_right, side_in_right_, kGrid)};
  }

  /// Width in pixels of the wall in the image that shows it, per metre of its height.
  [[nodiscard]] double wall_px_per_m() const { return std::abs(right_px_per_m_); }

  /// The similarity of both images of the strip on a level surface at this depth below the edge.
  /// The image that faces the wall shows the strip beyond the wall; the other one shows it beside
  /// the edge.
  [[nodiscard]] std::optional<SideAppearance> look_at(double drop_m) const {
    const Eigen::Vector2d shift_px = -drop_m * transfer_.per_height;
    if (right_px_per_m_ > 0.0) {
      const Strip lowered =
          sample_strip(images_.right, shifted(frame_.on_right, shift_px), side_in_right_, kGrid);
      return compare(at_edge_[0], lowered, images_.radiometry, images_.left.n_bands());
    }
    const Eigen::Vector2d back_px = -transfer_.jacobian.inverse() * shift_px;
    const Strip lowered =
        sample_strip(images_.left, shifted(frame_.on_left, back_px), side_in_left_, kGrid);
    return compare(lowered, at_edge_[1], images_.radiometry, images_.left.n_bands());
  }

 private:
  const ImagePair& images_;
  const LocalTransfer& transfer_;
  StripFrame frame_;
  Eigen::Vector2d side_in_left_, side_in_right_;
  double right_px_per_m_ = 0.0;  ///< positive: the right image shows the wall
  std::array<Strip, 2> at_edge_;
};

}  // namespace

void appearance_past_wall(const ImagePair& images,
                          const EdgePair& edges,
                          const LocalTransfer& transfer,
                          double most_drop_m,
                          EdgeAppearance& appearance) {
  constexpr double kMaxAgreement = 0.8;     // a side that agrees better (at most 2) needs no wall
  constexpr double kMinWidth_px = 2.0;      // width of a wall, across the line
  constexpr double kMaxParallax_px = 36.0;  // largest parallax of the wall
  constexpr double kStep_px = 1.5;          // step of the parallax between two heights
  // The best of many heights appears better by this much even if none of them is correct.
  constexpr SideAppearance kByChance{0.2, 0.012};
  if (!appearance.sides[0] || !appearance.sides[1]) return;
  const int worse = appearance.sides[0]->agreement() < appearance.sides[1]->agreement() ? 0 : 1;
  if (appearance.sides[worse]->agreement() > kMaxAgreement) return;
  const LoweredStrips strips(images, edges, transfer, worse == 0 ? -1.0 : 1.0);
  const double parallax_px_per_m = transfer.per_height.norm();
  const double highest_m = std::min(kMaxParallax_px / parallax_px_per_m, most_drop_m);
  const double lowest_m = kMinWidth_px / strips.wall_px_per_m();
  const double step_m = kStep_px / parallax_px_per_m;
  for (int k = 0; lowest_m + k * step_m <= highest_m; ++k) {
    std::optional<SideAppearance> found = strips.look_at(lowest_m + k * step_m);
    if (!found) continue;
    found->ncc -= kByChance.ncc;
    found->colour_difference += kByChance.colour_difference;
    if (found->agreement() <= appearance.sides[worse]->agreement()) continue;
    appearance.sides[worse] = found;
    appearance.is_past_wall[worse] = true;
  }
}

}  // namespace ridgeline::reconstruct
