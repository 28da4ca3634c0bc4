// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/close_lines.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/match/segment_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ridgeline::reconstruct {
namespace {

using CloseLines = std::vector<std::vector<CloseLine>>;

constexpr double kClose_px = 3.0;
constexpr double kParallel_deg = 8.0;
constexpr double kSmallestOverlap = 0.6;  // of the shorter line

/// Signed distance of b from a, in the middle of what they have in common; empty if b does not run
/// along a.
std::optional<double> offset_px(const Segment2& a, const Segment2& b) {
  if (acute_angle_rad(Eigen::Vector2d(a.end - a.start), Eigen::Vector2d(b.end - b.start)) >
      kParallel_deg * kRadPerDeg) {
    return std::nullopt;
  }
  const double len = length(a);
  const Eigen::Vector2d along = (a.end - a.start) / len;
  const Eigen::Vector2d normal(-along.y(), along.x());
  const double start = along.dot(b.start - a.start);
  const double end = along.dot(b.end - a.start);
  const double low = std::max(0.0, std::min(start, end));
  const double high = std::min(len, std::max(start, end));
  if (high - low < kSmallestOverlap * std::min(len, std::abs(end - start))) return std::nullopt;
  const double share = (0.5 * (low + high) - start) / (end - start);
  const double offset = normal.dot((1.0 - share) * b.start + share * b.end - a.start);
  if (std::abs(offset) > kClose_px) return std::nullopt;
  return offset;
}

std::vector<CloseLine> close_lines_of(const SegmentIndex& index,
                                      std::span<const Segment2> segments,
                                      int id) {
  const Segment2& a = segments[static_cast<std::size_t>(id)];
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kClose_px);
  Eigen::AlignedBox2d box(a.start);
  box.extend(a.end);
  box = Eigen::AlignedBox2d(box.min() - margin, box.max() + margin);
  const Eigen::Vector2d along = (a.end - a.start).normalized();
  const Eigen::Vector2d normal(-along.y(), along.x());
  std::array<std::optional<CloseLine>, 2> nearest;
  std::array<double, 2> distance{std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::infinity()};
  for (const int other : index.in_box(box)) {
    if (other == id) continue;
    const auto offset = offset_px(a, segments[static_cast<std::size_t>(other)]);
    if (!offset) continue;
    const std::size_t side = *offset < 0.0 ? 0 : 1;
    if (std::abs(*offset) >= distance[side]) continue;
    distance[side] = std::abs(*offset);
    nearest[side] = CloseLine{other, side == 0 ? Eigen::Vector2d(-normal) : normal, distance[side]};
  }
  std::vector<CloseLine> found;
  for (const auto& line : nearest) {
    if (line) found.push_back(*line);
  }
  return found;
}

/// Where a point of an image moves as it rises by a metre; zero in the nadir.
Eigen::Vector2d px_per_m_up(const ProjectionMatrix& image_from_local,
                            const EpipolarTransfer& from_image,
                            const Eigen::Vector2d& x_px,
                            double height_m) {
  const Eigen::Vector3d image =
      image_from_local * from_image.object_point(x_px, height_m).homogeneous();
  const Eigen::Vector3d up = image_from_local.col(2);
  return (up.head<2>() - up.z() * x_px) / image.z();
}

}  // namespace

std::vector<std::vector<CloseLine>> close_lines(std::span<const Segment2> segments) {
  const SegmentIndex index(segments);
  CloseLines found(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    found[i] = close_lines_of(index, segments, static_cast<int>(i));
  }
  return found;
}

namespace {

/// The two views of the pair with the lines close to others.
struct ClosePair {
  const MatchView& left;
  const MatchView& right;
  const StereoSearch& search;
  CloseLines by_left, by_right;
};

bool exchanges_sides(const ClosePair& pair, int left_id, const Candidate& candidate) {
  const CloseLine& beside_left = pair.by_left[static_cast<std::size_t>(left_id)].front();
  const CloseLine& beside_right = pair.by_right[static_cast<std::size_t>(candidate.right)].front();
  const Segment2& segment = pair.left.segments[static_cast<std::size_t>(left_id)].line.segment;
  const double height_m = 0.5 * (candidate.overlap.height_m[0] + candidate.overlap.height_m[1]);
  const LocalTransfer transfer =
      local_transfer(pair.search.right_from_left, midpoint(segment), height_m);
  return (transfer.jacobian * beside_left.towards).dot(beside_right.towards) < 0.0;
}

/// Whether the lines may be the edges of something vertical, seen at that width, and the other one is
/// the upper one.
bool is_below(const Eigen::Vector2d& px_per_m_up, const CloseLine& other) {
  constexpr double kHighest_m = 4.0;
  return px_per_m_up.dot(other.towards) * kHighest_m > other.distance_px;
}

/// Whether a right segment may be the mate of a segment with these candidates about as well as that
/// of another one, whose candidate it is with the given similarity.
bool competes(const std::vector<Candidate>& candidates, int right_id, double similarity) {
  constexpr double kSmallestRatio = 0.8;
  return std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) {
    return c.right == right_id && c.similarity >= kSmallestRatio * similarity;
  });
}

bool breaks_order(const ClosePair& pair,
                  const std::vector<std::vector<Candidate>>& candidates,
                  int left_id,
                  const Candidate& candidate) {
  const std::vector<CloseLine>& beside_left = pair.by_left[static_cast<std::size_t>(left_id)];
  const std::vector<CloseLine>& beside_right =
      pair.by_right[static_cast<std::size_t>(candidate.right)];
  if (beside_left.size() == 1 && beside_right.size() == 1) {
    return exchanges_sides(pair, left_id, candidate);
  }
  const double height_m = 0.5 * (candidate.overlap.height_m[0] + candidate.overlap.height_m[1]);
  if (beside_left.size() == 1 && beside_right.empty()) {
    const CloseLine& other = beside_left.front();
    const Segment2& segment = pair.left.segments[static_cast<std::size_t>(left_id)].line.segment;
    return is_below(px_per_m_up(pair.left.image_from_local, pair.search.right_from_left,
                                midpoint(segment), height_m),
                    other) &&
           competes(candidates[static_cast<std::size_t>(other.id)], candidate.right,
                    candidate.similarity);
  }
  if (beside_left.empty() && beside_right.size() == 1) {
    const CloseLine& other = beside_right.front();
    const Segment2& segment =
        pair.right.segments[static_cast<std::size_t>(candidate.right)].line.segment;
    return is_below(px_per_m_up(pair.right.image_from_local, pair.search.left_from_right,
                                midpoint(segment), height_m),
                    other) &&
           competes(candidates[static_cast<std::size_t>(left_id)], other.id, candidate.similarity);
  }
  return false;
}

}  // namespace

void keep_order_of_close_lines(const MatchView& left,
                               const MatchView& right,
                               const StereoSearch& search,
                               std::vector<std::vector<Candidate>>& candidates) {
  const ClosePair pair{left, right, search, close_lines(ideal_segments(left)),
                       close_lines(ideal_segments(right))};
  const std::vector<std::vector<Candidate>> before = candidates;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    std::erase_if(candidates[i], [&](const Candidate& c) {
      return breaks_order(pair, before, static_cast<int>(i), c);
    });
  }
}

}  // namespace ridgeline::reconstruct
