// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/reference_matches.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ridgeline::simulate {
namespace {

using View = SurfaceOracle::View;

struct Candidate {
  ReferenceMatch match;
  int rank = 0;
};

Eigen::Vector2d side_of(const Segment2& segment) {
  const Eigen::Vector2d u = (segment.end - segment.start).normalized();
  return {-u.y(), u.x()};
}

Segment2 image_of(const SurfaceOracle& oracle, View view, const Segment3& edge, Interval part) {
  return {oracle.pixel_of(view, point_at(edge, part.begin)),
          oracle.pixel_of(view, point_at(edge, part.end))};
}

/// Whether a view sees a point of an edge: nothing hides it and its two sides show different surfaces.
bool is_seen(const SurfaceOracle& oracle,
             View view,
             const Eigen::Vector3d& x,
             const Eigen::Vector2d& side_px) {
  if (!oracle.visible(view, x)) return false;
  const Eigen::Vector2d x_px = oracle.pixel_of(view, x);
  const auto a = oracle.seen_at(view, x_px + side_px);
  const auto b = oracle.seen_at(view, x_px - side_px);
  return a && b && !oracle.same_surface(*a, *b);
}

/// Value of a band in [0, 1], bilinear; outside of the image that of the nearest pixel.
double sample(const cv::Mat& image, const Eigen::Vector2d& x_px, int band) {
  const auto at = [&](int column, int row) -> double {
    const int c = std::clamp(column, 0, image.cols - 1);
    const int r = std::clamp(row, 0, image.rows - 1);
    const std::size_t i = static_cast<std::size_t>(c) * image.channels() + band;
    return image.depth() == CV_8U ? image.ptr<std::uint8_t>(r)[i] / 255.0
                                  : image.ptr<std::uint16_t>(r)[i] / 65535.0;
  };
  const int column = static_cast<int>(std::floor(x_px.x()));
  const int row = static_cast<int>(std::floor(x_px.y()));
  const double s = x_px.x() - column;
  const double t = x_px.y() - row;
  return (1.0 - t) * ((1.0 - s) * at(column, row) + s * at(column + 1, row)) +
         t * ((1.0 - s) * at(column, row + 1) + s * at(column + 1, row + 1));
}

/// Mean difference across a segment, in the band where it is largest.
double contrast(const cv::Mat& image, const Segment2& segment) {
  constexpr double kBesidePx = 1.5;
  const Eigen::Vector2d side = kBesidePx * side_of(segment);
  const int samples = 1 + static_cast<int>(length(segment));
  double largest = 0.0;
  for (int band = 0; band < image.channels(); ++band) {
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
      const Eigen::Vector2d x = segment.start + (i + 0.5) / samples * (segment.end - segment.start);
      sum += sample(image, x + side, band) - sample(image, x - side, band);
    }
    largest = std::max(largest, std::abs(sum) / samples);
  }
  return largest;
}

Interval common(const Interval& a, const Interval& b) {
  return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

/// The pairs of runs with the longest common parts; each run is used once.
std::vector<std::pair<Interval, Interval>> paired(const std::vector<Interval>& left,
                                                  const std::vector<Interval>& right) {
  struct Pair {
    std::size_t i, k;
    double common_length;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (std::size_t k = 0; k < right.size(); ++k) {
      const Interval both = common(left[i], right[k]);
      if (!both.empty()) pairs.push_back({i, k, both.end - both.begin});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.common_length > b.common_length; });
  std::vector<char> left_used(left.size(), 0);
  std::vector<char> right_used(right.size(), 0);
  std::vector<std::pair<Interval, Interval>> result;
  for (const Pair& pair : pairs) {
    if (left_used[pair.i] != 0 || right_used[pair.k] != 0) continue;
    left_used[pair.i] = right_used[pair.k] = 1;
    result.emplace_back(left[pair.i], right[pair.k]);
  }
  return result;
}

std::vector<Candidate> candidates_of(const PhysicalEdge& edge,
                                     const SurfaceOracle& oracle,
                                     const std::array<cv::Mat, 2>& images,
                                     const ReferenceOptions& options) {
  const auto left = visible_runs(oracle, View::kLeft, edge.segment, options);
  if (left.empty()) return {};
  const auto right = visible_runs(oracle, View::kRight, edge.segment, options);
  std::vector<Candidate> candidates;
  for (const auto& [in_left, in_right] : paired(left, right)) {
    const Candidate candidate{{edge.kind, image_of(oracle, View::kLeft, edge.segment, in_left),
                               image_of(oracle, View::kRight, edge.segment, in_right)},
                              edge.rank};
    const ReferenceMatch& match = candidate.match;
    if (length(match.left) < options.shortest_px || length(match.right) < options.shortest_px ||
        contrast(images[0], match.left) < options.least_contrast ||
        contrast(images[1], match.right) < options.least_contrast) {
      continue;
    }
    candidates.push_back(candidate);
  }
  return candidates;
}

/// Whether most of a segment lies within a pixel of another one.
bool covered_by(const Segment2& segment, const Segment2& other) {
  constexpr double kWithinPx = 1.0;
  constexpr double kMost = 0.7;
  const int samples = 1 + static_cast<int>(length(segment));
  int covered = 0;
  for (int i = 0; i < samples; ++i) {
    const Eigen::Vector2d x = segment.start + (i + 0.5) / samples * (segment.end - segment.start);
    covered += distance(other, x) < kWithinPx ? 1 : 0;
  }
  return covered >= kMost * samples;
}

bool covered_by(const ReferenceMatch& match, const ReferenceMatch& other) {
  return covered_by(match.left, other.left) && covered_by(match.right, other.right);
}

/// The candidates without duplicates. Among coinciding ones that of the lowest rank stays, at equal rank the longest.
std::vector<ReferenceMatch> without_duplicates(std::vector<Candidate> candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) {
                     if (a.rank != b.rank) return a.rank < b.rank;
                     return length(a.match.left) > length(b.match.left);
                   });
  std::vector<ReferenceMatch> kept;
  for (Candidate& candidate : candidates) {
    const bool duplicate = std::any_of(kept.begin(), kept.end(), [&](const ReferenceMatch& other) {
      return covered_by(candidate.match, other);
    });
    if (!duplicate) kept.push_back(std::move(candidate.match));
  }
  std::stable_sort(kept.begin(), kept.end(), [](const ReferenceMatch& a, const ReferenceMatch& b) {
    return std::pair(a.left.start.x(), a.left.start.y()) <
           std::pair(b.left.start.x(), b.left.start.y());
  });
  return kept;
}

/// The intervals after gaps shorter than `longest_gap` are closed.
std::vector<Interval> closed(const std::vector<Interval>& intervals, double longest_gap) {
  std::vector<Interval> result;
  for (const Interval& interval : intervals) {
    if (!result.empty() && interval.begin - result.back().end < longest_gap) {
      result.back().end = interval.end;
    } else {
      result.push_back(interval);
    }
  }
  return result;
}

}  // namespace

std::vector<Interval> visible_runs(const SurfaceOracle& oracle,
                                   View view,
                                   const Segment3& edge,
                                   const ReferenceOptions& options) {
  const Segment2 image = image_of(oracle, view, edge, {});
  if (length(image) < options.shortest_px) return {};
  const Eigen::Vector2d side_px = options.flank_px * side_of(image);
  const int samples = 1 + static_cast<int>(length(edge) / options.step_m);
  std::vector<Interval> runs;
  for (int i = 0; i < samples; ++i) {
    const Interval step{static_cast<double>(i) / samples, static_cast<double>(i + 1) / samples};
    const Eigen::Vector3d middle = point_at(edge, 0.5 * (step.begin + step.end));
    if (!is_seen(oracle, view, middle, side_px)) continue;
    if (!runs.empty() && runs.back().end == step.begin) {
      runs.back().end = step.end;
    } else {
      runs.push_back(step);
    }
  }
  return closed(runs, options.longest_gap_m / length(edge));
}

std::vector<ReferenceMatch> reference_matches(const Scene& scene,
                                              const SurfaceOracle& oracle,
                                              const std::array<cv::Mat, 2>& images,
                                              const ReferenceOptions& options) {
  const std::vector<PhysicalEdge> edges = physical_edges(scene);
  std::vector<std::vector<Candidate>> found(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
    found[i] = candidates_of(edges[i], oracle, images, options);
  });
  std::vector<Candidate> candidates;
  for (std::vector<Candidate>& of_edge : found) {
    std::move(of_edge.begin(), of_edge.end(), std::back_inserter(candidates));
  }
  return without_duplicates(std::move(candidates));
}

std::vector<std::array<double, 2>> visible_shares(const Scene& scene,
                                                  const SurfaceOracle& oracle,
                                                  const ReferenceOptions& options) {
  std::vector<std::array<double, 2>> shares(scene.lines.size());
  tbb::parallel_for(std::size_t{0}, shares.size(), [&](std::size_t i) {
    for (const View view : {View::kLeft, View::kRight}) {
      double sum = 0.0;
      for (const Interval& run : visible_runs(oracle, view, scene.lines[i].segment, options)) {
        sum += run.end - run.begin;
      }
      shares[i][view] = sum;
    }
  });
  return shares;
}

std::string reference_csv(std::span<const ReferenceMatch> matches) {
  std::string text =
      "id,kind,left_x1_px,left_y1_px,left_x2_px,left_y2_px,"
      "right_x1_px,right_y1_px,right_x2_px,right_y2_px\n";
  int id = 0;
  for (const ReferenceMatch& match : matches) {
    text += fmt::format("{},{}", id++, match.kind);
    for (const Segment2& s : {match.left, match.right}) {
      text += fmt::format(",{:.3f},{:.3f},{:.3f},{:.3f}", s.start.x(), s.start.y(), s.end.x(),
                          s.end.y());
    }
    text += "\n";
  }
  return text;
}

}  // namespace ridgeline::simulate
