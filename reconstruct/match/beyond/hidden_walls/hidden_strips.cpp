// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/hidden_walls/hidden_strips.h"

#include "reconstruct/match/beyond/hidden_walls/close_lines.h"

#include <algorithm>
#include <array>

namespace ridgeline::reconstruct {
namespace {

/// A match by its segments in the left and in the right image.
using Ids = std::array<int, 2>;

/// A pair of images with the close lines of their segments.
struct StripPair {
  const SearchedPair& views;
  const Radiometry& radiometry;
  std::array<CloseLines, 2> close;

  [[nodiscard]] const View& view(int image) const { return image == 0 ? views.left : views.right; }
  [[nodiscard]] const EdgeSegment& segment(int image, int id) const {
    return view(image).segments[id];
  }
  [[nodiscard]] const std::vector<CloseLine>& beside(int image, int id) const {
    return close[image][id];
  }
};

/// A strip that one image shows. The other image has one segment for it, and both edges of the
/// strip are candidates for this segment.
struct HiddenStrip {
  int image = 0;  ///< the image that shows the strip
  Ids lower{}, upper{};
  const Candidate* lower_candidate = nullptr;
  const Candidate* upper_candidate = nullptr;
  std::array<Eigen::Vector2d, 2> towards_upper;  ///< direction from the lower edge, in both images
};

double mean_height_m(const Candidate& candidate) {
  return 0.5 * (candidate.overlap.height_m[0] + candidate.overlap.height_m[1]);
}

/// The shift of a point in an image when it rises by a metre; zero at the nadir.
Eigen::Vector2d px_per_m_up(const StripPair& pair,
                            int image,
                            const Eigen::Vector2d& x_px,
                            double height_m) {
  const EpipolarTransfer& transfer =
      image == 0 ? pair.views.search.right_from_left : pair.views.search.left_from_right;
  const ProjectionMatrix& image_from_local = pair.view(image).image_from_local;
  const Eigen::Vector3d x = image_from_local * transfer.object_point(x_px, height_m).homogeneous();
  const Eigen::Vector3d up = image_from_local.col(2);
  return (up.head<2>() - up.z() * x_px) / x.z();
}

/// Whether a line and `other` may be the edges of something vertical, at most 4 m high, with
/// `other` as the upper one.
bool is_below(const Eigen::Vector2d& px_per_m_up, const CloseLine& other) {
  constexpr double kMaxHeight_m = 4.0;
  return px_per_m_up.dot(other.towards) * kMaxHeight_m > other.distance_px;
}

/// Whether a segment has such a strip of its own: a close line on the same side, far enough away.
bool shows_strip(const std::vector<CloseLine>& beside,
                 const Eigen::Vector2d& towards,
                 double width_px) {
  // share of the width in the other image; a gutter is not a wall
  constexpr double kMinWidthShare = 0.4;
  return std::ranges::any_of(beside, [&](const CloseLine& line) {
    return line.towards.dot(towards) > 0.0 && line.distance_px > kMinWidthShare * width_px;
  });
}

const Candidate* with_counterpart(const std::vector<Candidate>& candidates, int right) {
  const auto found = std::ranges::find(candidates, right, &Candidate::right);
  return found == candidates.end() ? nullptr : &*found;
}

/// The strips of which a candidate is the lower edge, in one of the images.
void add_strips(const StripPair& pair,
                int image,
                int left,
                const Candidate& lower,
                const Candidates& candidates,
                std::vector<HiddenStrip>& strips) {
  const Ids ids{left, lower.right};
  if (pair.beside(image, ids[image]).empty()) return;
  const double height_m = mean_height_m(lower);
  const Eigen::Vector2d up_px_per_m =
      px_per_m_up(pair, image, midpoint(pair.segment(image, ids[image]).line.segment), height_m);
  const Eigen::Matrix2d right_from_left =
      local_transfer(pair.views.search.right_from_left,
                     midpoint(pair.segment(0, left).line.segment), height_m)
          .jacobian;
  for (const CloseLine& above : pair.beside(image, ids[image])) {
    if (!is_below(up_px_per_m, above)) continue;
    HiddenStrip strip{image, ids, ids, &lower, nullptr, {}};
    strip.upper[image] = above.id;
    strip.towards_upper[image] = above.towards;
    strip.towards_upper[1 - image] =
        image == 0 ? Eigen::Vector2d(right_from_left * above.towards)
                   : Eigen::Vector2d(right_from_left.inverse() * above.towards);
    if (shows_strip(pair.beside(1 - image, ids[1 - image]), strip.towards_upper[1 - image],
                    above.distance_px)) {
      continue;
    }
    strip.upper_candidate = with_counterpart(candidates[strip.upper[0]], strip.upper[1]);
    if (strip.upper_candidate == nullptr || strip.upper_candidate->overlap.aligned) continue;
    strips.push_back(strip);
  }
}

/// 0 for the left side of a segment, 1 for the right one, as in EdgeAppearance.
int side_of(const EdgeSegment& edge, const Eigen::Vector2d& towards) {
  return normal(edge.line.segment).dot(towards) > 0.0 ? 1 : 0;
}

Flank& flank(EdgeSegment& edge, int side) { return side == 0 ? edge.left : edge.right; }

/// The upper candidate with the strip cut out: on the side of the strip, it has the appearance of
/// the lower candidate beyond the strip. It has no profile across the line, because none can be
/// formed this way.
Candidate across(const HiddenStrip& strip, const StripPair& pair) {
  EdgeAppearance appearance;
  const int above = side_of(pair.segment(0, strip.upper[0]), strip.towards_upper[0]);
  appearance.sides[above] = strip.upper_candidate->appearance.sides[above];
  appearance.sides[1 - above] =
      strip.lower_candidate->appearance
          .sides[side_of(pair.segment(0, strip.lower[0]), -strip.towards_upper[0])];
  std::array<EdgeSegment, 2> seen{pair.segment(0, strip.upper[0]), pair.segment(1, strip.upper[1])};
  const Eigen::Vector2d down = -strip.towards_upper[strip.image];
  EdgeSegment lower = pair.segment(strip.image, strip.lower[strip.image]);
  EdgeSegment& upper = seen[strip.image];
  flank(upper, side_of(upper, down)) = flank(lower, side_of(lower, down));
  Candidate candidate = *strip.upper_candidate;
  candidate.appearance = appearance;
  candidate.measures =
      line_measures({seen[0], seen[1], candidate.overlap}, appearance, pair.radiometry);
  candidate.similarity = line_similarity(candidate.measures);
  return candidate;
}

std::vector<HiddenStrip> hidden_strips(const StripPair& pair, const Candidates& candidates) {
  std::vector<HiddenStrip> strips;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (const Candidate& candidate : candidates[i]) {
      if (candidate.overlap.aligned) continue;
      for (const int image : {0, 1}) {
        add_strips(pair, image, static_cast<int>(i), candidate, candidates, strips);
      }
    }
  }
  return strips;
}

}  // namespace

void compare_across_hidden_strips(const SearchedPair& views,
                                  const Radiometry& radiometry,
                                  Candidates& candidates) {
  constexpr double kMinRatio = 0.8;  // ratio of the upper edge's similarity to the lower one's
  const StripPair pair{
      views,
      radiometry,
      {close_lines(ideal_segments(views.left)), close_lines(ideal_segments(views.right))}};
  Candidates changed = candidates;
  for (const HiddenStrip& strip : hidden_strips(pair, candidates)) {
    const Candidate whole = across(strip, pair);
    if (whole.similarity < kMinRatio * strip.lower_candidate->similarity) continue;
    for (Candidate& upper : changed[strip.upper[0]]) {
      if (upper.right == whole.right && upper.similarity < whole.similarity) upper = whole;
    }
    std::erase_if(changed[strip.lower[0]],
                  [&](const Candidate& c) { return c.right == strip.lower[1]; });
  }
  for (std::vector<Candidate>& list : changed) {
    std::ranges::stable_sort(list, std::greater{}, &Candidate::similarity);
  }
  candidates = std::move(changed);
}

}  // namespace ridgeline::reconstruct
