// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/segment_depth.h"

#include "reconstruct/geometry/degrees.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

constexpr double kMaxTurn_rad = 15.0 * kRadPerDeg;  // between a segment and its prediction
constexpr double kMinOverlap_px = 3.0;
/// Odds that a match by appearance is correct; ours.
constexpr double kAppearanceOdds = 20.0;
constexpr double kChiSquare2 = 13.816;  // 99.9 %, 2 degrees of freedom

/// The search for the line of one segment.
class Search {
 public:
  Search(const SearchedViews& views,
         const Observation& reference,
         const CandidateOptions& candidates,
         const TrackOptions& options,
         const IsFree& is_free)
      : views_(views),
        reference_(reference),
        own_(views.line(reference)),
        candidates_(candidates),
        options_(options),
        is_free_(is_free) {
    for (std::size_t w = 0; w < views.size(); ++w) ends_.push_back(views.stretches(reference, w));
  }

  [[nodiscard]] std::optional<ProposedTrack> best() const {
    std::vector<ProposedTrack> all;
    for (const std::size_t view : views_.others(reference_.view)) {
      std::vector<Hypothesis> of_view = hypotheses(view);
      const double start = std::log(kSeenShare / (static_cast<double>(of_view.size()) + 1.0));
      for (Hypothesis& h : of_view) {
        h.said[view].log_odds += start;
        follow(view, h);
        all.push_back(track_of(h));
      }
    }
    return decided(all);
  }

 private:
  /// The evidence of a view for or against a hypothesis.
  struct Answer {
    double log_odds = 0.0;  ///< logarithm of the factor for the odds
    std::optional<std::pair<int, PredictionResidual>> seen;
  };

  struct Hypothesis {
    std::vector<Answer> said;  ///< by view

    [[nodiscard]] std::vector<PredictionResidual> residuals() const {
      std::vector<PredictionResidual> all;
      for (const Answer& answer : said) {
        if (answer.seen) all.push_back(answer.seen->second);
      }
      return all;
    }
    [[nodiscard]] SegmentDepth depth() const { return depth_by(residuals()); }
  };

  [[nodiscard]] double log_appearance(const Observation& s) const {
    switch (views_.match_state(reference_, s)) {
      case SearchedViews::MatchState::kMatched:
        return std::log(kAppearanceOdds);
      case SearchedViews::MatchState::kMatchedElsewhere:
        return -std::log(kAppearanceOdds);
      default:
        return 0.0;
    }
  }

  /// The interval of the prediction that overlaps a segment; std::nullopt if it is too short or the
  /// directions differ too much.
  [[nodiscard]] std::optional<std::array<double, 2>> overlap(const PredictedLine& p,
                                                             const Segment2& seen) const {
    if (acute_angle_rad(seen, p.segment) > kMaxTurn_rad) return std::nullopt;
    const auto [low, high] = span_on(p.segment, seen);
    const double from = std::max(0.0, low);
    const double to = std::min(1.0, high);
    if (to - from < kMinEpipolarOverlap * std::min(1.0, high - low) ||
        (to - from) * length(p.segment) < kMinOverlap_px) {
      return std::nullopt;
    }
    return std::array{from, to};
  }

  [[nodiscard]] bool is_possible(const Eigen::Vector2d& heights_m) const {
    const auto& [lowest_m, highest_m] = views_.heights_m();
    if (!heights_m.allFinite() || heights_m.minCoeff() < lowest_m ||
        heights_m.maxCoeff() > highest_m)
      return false;
    const Segment3 x = views_.object_segment(reference_, heights_m);
    const Eigen::Vector3d d = x.end - x.start;
    return std::abs(d.z()) <= std::tan(candidates_.max_slope_deg * kRadPerDeg) * d.head<2>().norm();
  }

  /// The lines defined by the segment and each of a view's segments.
  [[nodiscard]] std::vector<Hypothesis> hypotheses(std::size_t view) const {
    const auto& [lowest_m, highest_m] = views_.heights_m();
    const EndStretches& ends = ends_[view];
    Eigen::AlignedBox2d band;
    for (const Stretch& end : ends) band.extend(end.at(lowest_m)).extend(end.at(highest_m));
    std::vector<Hypothesis> all;
    for (const std::size_t segment : views_.by_place(view).near(band, 0.0)) {
      const Observation seen{view, static_cast<int>(segment)};
      if (!is_free_(seen)) continue;
      if (const auto residual = intersection_with(seen)) {
        all.emplace_back().said.resize(views_.size());
        all.back().said[view] = {log_appearance(seen), std::pair{seen.segment, *residual}};
      }
    }
    return all;
  }

  /// The observation of a segment by the line that it defines together with the reference; its
  /// residuals are zero.
  [[nodiscard]] std::optional<PredictionResidual> intersection_with(const Observation& seen) const {
    const EndStretches& ends = ends_[seen.view];
    const UncertainSegment2& line = views_.line(seen);
    const Eigen::Vector2d n = normal(line.segment);
    const double offset = n.dot(line.segment.start);
    const Eigen::Vector2d heights_m(ends[0].height_on(n, offset), ends[1].height_on(n, offset));
    if (!is_possible(heights_m)) return std::nullopt;
    const PredictedLine p = predict(ends, heights_m);
    const double least_sine = std::sin(kMinEpipolarAngle_deg * kRadPerDeg);
    for (const Eigen::Vector2d& by : p.per_height) {
      if (!(std::abs(n.dot(by)) >= least_sine * by.norm())) return std::nullopt;
    }
    if (!overlap(p, line.segment)) return std::nullopt;
    return residual_of(own_, heights_m, p, line, {0.0, 1.0}, options_.sigma_edge_px);
  }

  /// Adds the evidence of all views except the first to a hypothesis.
  void follow(std::size_t first, Hypothesis& h) const {
    for (const std::size_t view : views_.others(reference_.view)) {
      if (view == first) continue;
      if (const auto answer = ask(view, h.depth())) h.said[view] = *answer;
    }
  }

  [[nodiscard]] ProposedTrack track_of(const Hypothesis& h) const {
    ProposedTrack track{{{reference_}}, h.depth(), 0.0};
    for (const std::size_t view : views_.others(reference_.view)) {
      track.log_odds += h.said[view].log_odds;
      if (h.said[view].seen) track.observations.push_back({view, h.said[view].seen->first});
    }
    return track;
  }

  /// The evidence of a view for a line; std::nullopt if the line is not in its image.
  [[nodiscard]] std::optional<Answer> ask(std::size_t view, const SegmentDepth& depth) const {
    constexpr double kWindow_px = 12.0;  // on each side of the prediction, for the density
    constexpr double kMaxReach_px = 40.0;
    constexpr double kReachSigma = 3.5;
    const PredictedLine p = predict(ends_[view], depth.heights_m);
    if (!views_.shows(view, midpoint(p.segment))) return std::nullopt;
    double reach_px = kWindow_px;
    for (const int i : {0, 1}) {
      reach_px = std::max(reach_px, kReachSigma * p.per_height[static_cast<std::size_t>(i)].norm() *
                                        std::sqrt(depth.cov_m2(i, i)));
    }
    reach_px = std::min(reach_px, kMaxReach_px);
    int n_parallel = 0;
    double best_ratio = 0.0;
    Answer answer;
    for (const std::size_t segment : views_.by_place(view).near(p.segment, reach_px)) {
      const Observation seen{view, static_cast<int>(segment)};
      const UncertainSegment2& line = views_.line(seen);
      const auto at = overlap(p, line.segment);
      if (!at) continue;
      const PredictionResidual o =
          residual_of(own_, depth.heights_m, p, line, *at, options_.sigma_edge_px);
      if (o.residual_px.cwiseAbs().maxCoeff() < reach_px) ++n_parallel;
      if (!is_free_(seen)) continue;
      const Eigen::Matrix2d cov_px2 = o.cov_with(depth);
      const double chi2 = chi_square(o, cov_px2);
      if (chi2 > kChiSquare2) continue;
      const double overlap_px = ((*at)[1] - (*at)[0]) * length(p.segment);
      const double area_px2 =
          4.0 * reach_px * std::min(reach_px, std::tan(kMaxTurn_rad) * overlap_px);
      const double ratio = std::exp(-0.5 * chi2 + log_appearance(seen)) * area_px2 /
                           (2.0 * std::numbers::pi * std::sqrt(cov_px2.determinant()));
      if (ratio <= best_ratio) continue;
      best_ratio = ratio;
      answer.seen = std::pair{seen.segment, o};
    }
    // 0.5 is added so that even a single segment is not certain.
    answer.log_odds = std::log(1.0 - kSeenShare + kSeenShare * best_ratio / (n_parallel + 0.5));
    return answer;
  }

  /// The track with the largest odds, if it is sufficiently more likely than those with other
  /// heights.
  [[nodiscard]] std::optional<ProposedTrack> decided(std::vector<ProposedTrack>& all) const {
    constexpr double kSame_m = 0.3;
    const auto of_same_height = [&](const ProposedTrack& a, const ProposedTrack& b) {
      return (a.depth.heights_m - b.depth.heights_m).cwiseAbs().maxCoeff() < kSame_m;
    };
    std::ranges::stable_sort(all, std::greater{}, &ProposedTrack::log_odds);
    const auto best = std::ranges::find_if(
        all, [](const ProposedTrack& track) { return track.observations.size() >= 3; });
    if (best == all.end() || best->log_odds < options_.min_log_odds) return std::nullopt;
    double odds_of_others = 0.0;
    std::vector<const ProposedTrack*> distinct{&*best};
    for (const ProposedTrack& track : all) {
      if (std::ranges::any_of(distinct, [&](const auto* d) { return of_same_height(*d, track); }))
        continue;
      distinct.push_back(&track);
      odds_of_others += std::exp(track.log_odds - best->log_odds);
    }
    if (std::log(odds_of_others) > -options_.min_margin) return std::nullopt;
    return *best;
  }

  const SearchedViews& views_;
  Observation reference_;
  const UncertainSegment2& own_;
  const CandidateOptions& candidates_;
  const TrackOptions& options_;
  const IsFree& is_free_;
  std::vector<EndStretches> ends_;  ///< by view
};

}  // namespace

std::optional<ProposedTrack> propose_track(const SearchedViews& views,
                                           const Observation& reference,
                                           const CandidateOptions& candidates,
                                           const TrackOptions& options,
                                           const IsFree& is_free) {
  return Search(views, reference, candidates, options, is_free).best();
}

void add_pieces(const SearchedViews& views,
                const TrackOptions& options,
                const IsFree& is_free,
                ProposedTrack& track) {
  constexpr double kBeside_px = 1.5;
  constexpr double kMinShareWithin = 0.7;  // share of a piece within the part covered by the track
  const UncertainSegment2& own = views.line(track.base());
  std::vector<PredictedLine> predictions;
  std::array<double, 2> part{0.0, 1.0};
  for (std::size_t v = 0; v < views.size(); ++v)
    predictions.push_back(predict(views.stretches(track.base(), v), track.depth.heights_m));
  for (const Observation& s : track.observations) {
    const auto [from, to] = span_on(predictions[s.view].segment, views.line(s).segment);
    part = {std::min(part[0], from), std::max(part[1], to)};
  }
  for (std::size_t v = 0; v < views.size(); ++v) {
    const PredictedLine& p = predictions[v];
    const Segment2 whole{point_at(p.segment, part[0]), point_at(p.segment, part[1])};
    std::vector<std::array<double, 2>> known;
    for (const Observation& s : track.observations) {
      if (s.view == v) known.push_back(span_on(p.segment, views.line(s).segment));
    }
    for (const std::size_t segment : views.by_place(v).near(whole, kBeside_px)) {
      const Observation seen{v, static_cast<int>(segment)};
      const UncertainSegment2& line = views.line(seen);
      if (!is_free(seen) || acute_angle_rad(line.segment, p.segment) > kMaxTurn_rad) continue;
      const std::array<double, 2> span = span_on(p.segment, line.segment);
      const double within = std::min(span[1], part[1]) - std::max(span[0], part[0]);
      if (within < kMinShareWithin * (span[1] - span[0])) continue;
      const double shortest = kMinOverlap_px / length(p.segment);
      if (std::ranges::any_of(known, [&](const auto& k) {
            return std::min(k[1], span[1]) - std::max(k[0], span[0]) > shortest;
          })) {
        continue;
      }
      const PredictionResidual o =
          residual_of(own, track.depth.heights_m, p, line, span, options.sigma_edge_px);
      if (o.residual_px.cwiseAbs().maxCoeff() > kBeside_px ||
          chi_square(o, o.cov_with(track.depth)) > kChiSquare2) {
        continue;
      }
      track.observations.push_back(seen);
      known.push_back(span);
    }
  }
}

}  // namespace ridgeline::reconstruct
