// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/flank_correlation.h"

#include "reconstruct/geometry/parabola.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr int kFewestSamples = 20;
constexpr int kMostSamples = 60;
constexpr double kGain = 12.0;
constexpr double kFullLength_px = 30.0;  // short strips correlate by chance
constexpr double kBelow = 3.0;           // what a depth of its own costs the lower side
constexpr double kMostSquared = 0.95;
constexpr double kOutlier = 0.02;
/// Step between places: finer than the strips correlate.
constexpr double kStep = 1.0 / FlankStrip::kRightStep_px;
constexpr double kSteepest = 1.2;
constexpr double kApart = 2.0 * kStep;  // lines that are others

/// Score of the two sides, with the best of each below.
double score_of(const std::array<double, 2>& here, const std::array<double, 2>& below) {
  const auto with_upper = [&](std::size_t upper) {
    const std::size_t lower = 1 - upper;
    return here[upper] + std::max({here[lower], below[lower] - kBelow, 0.0});
  };
  return std::max(with_upper(0), with_upper(1));
}

Eigen::Vector3d intersection(const Eigen::Vector4d& a,
                             const Eigen::Vector4d& b,
                             const Eigen::Vector4d& c) {
  Eigen::Matrix3d normals;
  normals << a.head<3>().transpose(), b.head<3>().transpose(), c.head<3>().transpose();
  return normals.inverse() * -Eigen::Vector3d(a.w(), b.w(), c.w());
}

struct Candidate {
  double score, start, end;  ///< offsets of the places
};

/// The best few that are not the same.
std::vector<Candidate> distinct(std::vector<Candidate> candidates) {
  constexpr std::size_t kMost = 3;
  std::ranges::stable_sort(candidates, std::greater{}, &Candidate::score);
  std::vector<Candidate> best;
  for (const Candidate& c : candidates) {
    if (best.size() == kMost) break;
    const bool is_other = std::ranges::none_of(best, [&](const Candidate& b) {
      return std::abs(b.start - c.start) <= kApart && std::abs(b.end - c.end) <= kApart;
    });
    if (is_other && c.score > 0.0) best.push_back(c);
  }
  return best;
}

}  // namespace

FlankCorrelation::FlankCorrelation(const StereoLines& lines,
                                   const ObservedPair& line,
                                   const FlankStrips& strips,
                                   bool runs_back)
    : line_(line),
      left_from_object_(lines.stereo.views[0].image_from_object),
      right_from_object_(lines.stereo.views[1].image_from_object),
      n_right_(strips.right.n_along) {
  if (strips.left.n_along == 0 || n_right_ < 2) return;
  const ImageConditioning& image = lines.stereo.views[1].image;
  right_axis_ = {image.conditioned_from_image(strips.right.axis.start),
                 image.conditioned_from_image(strips.right.axis.end)};
  const std::vector<int> columns = set_samples(lines, strips.left);
  if (columns.size() < kFewestSamples) return;

  constexpr double kRise = 0.01;
  const Sample& middle = samples_[samples_.size() / 2];
  const double places_per_unit =
      (place(at_height(middle, kRise)) - place(at_height(middle, 0.0))) / kRise;
  if (!std::isfinite(places_per_unit) || places_per_unit == 0.0) return;
  up_ = places_per_unit > 0.0 ? 1.0 : -1.0;
  const double places_per_length =
      std::abs(places_per_unit) *
      (at_height(samples_.back(), 0.0) - at_height(samples_.front(), 0.0)).norm();
  const double length_px = (samples_.back().parameter - samples_.front().parameter) *
                           length(line_[0].segment) * lines.stereo.views[0].image.scale_px;
  gain_ = kGain * std::min(1.0, length_px / kFullLength_px);
  strips_.emplace(strips, columns, runs_back,
                  places_per_length * FlankStrip::kRightStep_px / length_px);
  for (const Sample& sample : samples_) {
    level_.push_back(place(at_height(sample, 0.0)));
  }
  const auto [least, most] = std::minmax(level_.front(), level_.back());
  lowest_ = up_ > 0.0 ? -most : least - n_right_;
  highest_ = up_ > 0.0 ? n_right_ - least : most;
  search_horizontal();
  search(std::min(kSteepest * places_per_length, static_cast<double>(n_right_)));
}

std::vector<int> FlankCorrelation::set_samples(const StereoLines& lines, const FlankStrip& left) {
  const ImageConditioning& image = lines.stereo.views[0].image;
  const Eigen::Vector2d start = image.conditioned_from_image(left.axis.start);
  const Eigen::Vector2d along = image.conditioned_from_image(left.axis.end) - start;
  const int stride = (left.n_along + kMostSamples - 1) / kMostSamples;
  std::vector<int> columns;
  for (int i = 0; i < left.n_along; i += stride) {
    const Eigen::Vector2d x = start + i * along / std::max(1, left.n_along - 1);
    const double parameter = parameter_along(line_[0].segment, x);
    if (!(parameter >= 0.0 && parameter <= 1.0)) continue;
    columns.push_back(i);
    samples_.push_back({parameter, 0.0, plane_across(left_from_object_, x, along)});
  }
  for (std::size_t s = 1; s < samples_.size(); ++s) {
    samples_[s].share = static_cast<double>(s) / static_cast<double>(samples_.size() - 1);
  }
  return columns;
}

Eigen::Vector3d FlankCorrelation::at(const DepthLine& line, const Sample& sample) const {
  const double s =
      -sample.across.dot(line.through.homogeneous()) / sample.across.head<3>().dot(line.direction);
  return line.through + s * line.direction;
}

Eigen::Vector3d FlankCorrelation::at_height(const Sample& sample, double z) const {
  return intersection(line_[0].plane.mean, sample.across, Eigen::Vector4d(0.0, 0.0, 1.0, -z));
}

double FlankCorrelation::place(const Eigen::Vector3d& x) const {
  return (n_right_ - 1) * parameter_along(right_axis_, project(right_from_object_, x));
}

Eigen::Vector3d FlankCorrelation::seen_at(const Sample& sample, double place) const {
  const Eigen::Vector2d along = right_axis_.end - right_axis_.start;
  return intersection(
      line_[0].plane.mean, sample.across,
      plane_across(right_from_object_, point_at(right_axis_, place / (n_right_ - 1)), along));
}

DepthLine FlankCorrelation::line_through(const Places& places) const {
  const Eigen::Vector3d first = seen_at(samples_.front(), places.front());
  const Eigen::Vector3d last = seen_at(samples_.back(), places.back());
  return {first, (last - first).normalized()};
}

FlankCorrelation::Places FlankCorrelation::places_of(const LineAt& profile) const {
  return transformed(
      samples_, [&](const Sample& sample) { return place(at(profile(sample.parameter), sample)); });
}

double FlankCorrelation::gain(double rho) const {
  return rho <= 0.0 ? 0.0 : -gain_ * std::log(1.0 - std::min(rho * rho, kMostSquared));
}

FlankCorrelation::Places FlankCorrelation::raised(const Places& places,
                                                  double at_start,
                                                  double at_end) const {
  Places moved(places);
  for (std::size_t s = 0; s < moved.size(); ++s) {
    moved[s] += up_ * (at_start + (at_end - at_start) * samples_[s].share);
  }
  return moved;
}

/// How the sides correlate along horizontal profiles, from the lowest one up.
void FlankCorrelation::search_horizontal() {
  const auto n = static_cast<std::size_t>((highest_ - lowest_) / kStep) + 1;
  for (std::size_t k = 0; k < n; ++k) {
    const double rise = lowest_ + static_cast<double>(k) * kStep;
    const Places places = raised(level_, rise, rise);
    for (const std::size_t side : {0U, 1U}) {
      horizontal_[side].push_back(gain(strips_->best(side, places)));
      const double so_far = below_[side].empty() ? 0.0 : below_[side].back();
      below_[side].push_back(std::max(so_far, horizontal_[side].back()));
    }
  }
}

/// Gains of the sides at horizontal profiles that are below both ends of a profile.
std::array<double, 2> FlankCorrelation::gains_below(double rise_at_start,
                                                    double rise_at_end) const {
  const double steps = std::ceil((std::min(rise_at_start, rise_at_end) - lowest_) / kStep);
  if (!(steps >= 1.0)) return {};
  const auto n = static_cast<double>(below_[0].size());
  const std::size_t last = static_cast<std::size_t>(std::min(n, steps)) - 1;
  return {below_[0][last], below_[1][last]};
}

/// The best profiles that are straight in the places, over the whole strip.
void FlankCorrelation::search(double most_slope) {
  std::array<std::vector<Candidate>, 2> candidates;  // horizontal, sloping
  constexpr double kSlopeSpacing =
      2.0 * kStep;  // a pixel at either end: no farther than score() looks
  const int n_slopes = static_cast<int>(most_slope / kSlopeSpacing);
  for (int slope = -n_slopes; slope <= n_slopes; ++slope) {
    const double rise = slope * kSlopeSpacing;
    for (std::size_t k = 0; k < horizontal_[0].size(); ++k) {
      const double at_start = lowest_ + static_cast<double>(k) * kStep - 0.5 * rise;
      std::array<double, 2> gains{horizontal_[0][k], horizontal_[1][k]};
      if (slope != 0) {
        const Places places = raised(level_, at_start, at_start + rise);
        gains = {gain(strips_->level(0, places)), gain(strips_->level(1, places))};
      }
      const double score = score_of(gains, gains_below(at_start, at_start + rise));
      candidates[slope == 0 ? 0 : 1].push_back({score, at_start, at_start + rise});
      max_score_ = std::max(max_score_, score);
    }
  }
  for (std::vector<Candidate>& all : candidates) {
    for (const Candidate& c : distinct(std::move(all))) {
      likely_lines_.push_back(line_through(raised(level_, c.start, c.end)));
    }
  }
}

/// Score of the best profile within a step at both ends.
double FlankCorrelation::score(const Places& places) const {
  const std::array<double, 2> below =
      gains_below(up_ * (places.front() - level_.front()), up_ * (places.back() - level_.back()));
  double best = 0.0;
  for (const double at_start : {-kStep, 0.0, kStep}) {
    for (const double at_end : {-kStep, 0.0, kStep}) {
      const Places moved = raised(places, at_start, at_end);
      best = std::max(
          best, score_of({gain(strips_->best(0, moved)), gain(strips_->best(1, moved))}, below));
    }
  }
  return best;
}

double FlankCorrelation::log_likelihood(const LineAt& profile) const {
  if (max_score_ <= 0.0) return std::log(kOutlier);
  const double below_best = std::min(0.0, score(places_of(profile)) - max_score_);
  return std::log(kOutlier + (1.0 - kOutlier) * std::exp(below_best));
}

/// How far to raise a profile at both ends for a side of a given slope to correlate best.
FlankCorrelation::Refined FlankCorrelation::refined(const Places& places,
                                                    bool horizontal,
                                                    std::size_t side,
                                                    std::size_t slope) const {
  constexpr int kReach = 4;
  const auto rho = [&](double at_start, double at_end) {
    return strips_->at_slope(side, slope, raised(places, at_start, at_end));
  };
  Refined best;
  for (int i = -kReach; i <= kReach; ++i) {
    for (int k = horizontal ? i : -kReach; k <= (horizontal ? i : kReach); ++k) {
      const double here = rho(i, k);
      if (here > best.rho) best = {here, static_cast<double>(i), static_cast<double>(k)};
    }
  }
  const auto [middle, start, end] = best;
  if (horizontal) {
    best.start +=
        vertex_of_parabola(rho(start - 1.0, end - 1.0), middle, rho(start + 1.0, end + 1.0));
    best.end = best.start;
  } else {
    best.start += vertex_of_parabola(rho(start - 1.0, end), middle, rho(start + 1.0, end));
    best.end += vertex_of_parabola(rho(start, end - 1.0), middle, rho(start, end + 1.0));
  }
  best.rho = std::max(middle, rho(best.start, best.end));
  return best;
}

/// The same for the better side. Few rows hardly tell its slope, which moves the line with it: the
/// mean over the slopes, by their likelihood.
FlankCorrelation::Refined FlankCorrelation::refined(const Places& places, bool horizontal) const {
  std::array<std::array<Refined, StripCorrelation::kSlopes>, 2> all;
  Refined best;
  std::size_t better = 0;
  for (const std::size_t side : {0U, 1U}) {
    for (std::size_t k = 0; k < StripCorrelation::kSlopes; ++k) {
      all[side][k] = refined(places, horizontal, side, k);
      if (all[side][k].rho <= best.rho) continue;
      best = all[side][k];
      better = side;
    }
  }
  Refined mean{best.rho, 0.0, 0.0};
  double sum = 0.0;
  for (const Refined& r : all[better]) {
    const double likelihood = std::exp(gain(r.rho) - gain(best.rho));
    sum += likelihood;
    mean.start += likelihood * r.start;
    mean.end += likelihood * r.end;
  }
  mean.start /= sum;
  mean.end /= sum;
  return mean;
}

std::optional<std::array<FlankCorrelation::Homologous, 2>> FlankCorrelation::homologous(
    const DepthLine& line, bool horizontal) const {
  constexpr double kClearly = 1.0;
  constexpr double kLeastCorrelation = 0.7;
  constexpr double kInset = 0.1;  // of the points, from either end
  if (max_score_ <= 0.0) return std::nullopt;
  const Places places = places_of([&](double) -> const DepthLine& { return line; });
  if (score(places) < max_score_ - kClearly) return std::nullopt;
  const Refined found = refined(places, horizontal);
  if (found.rho < kLeastCorrelation) return std::nullopt;
  const Places best = raised(places, found.start, found.end);
  const auto point = [&](double share) {
    const auto last = static_cast<double>(samples_.size() - 1);
    const auto s = static_cast<std::size_t>(std::lround(share * last));
    const Segment2& left = line_[0].segment;
    return Homologous{point_at(left, samples_[s].parameter),
                      point_at(right_axis_, best[s] / (n_right_ - 1))};
  };
  return std::array{point(kInset), point(1.0 - kInset)};
}

}  // namespace ridgeline::reconstruct
