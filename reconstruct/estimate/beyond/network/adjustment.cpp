// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/adjustment.h"

#include "reconstruct/geometry/halved_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ridgeline::reconstruct {
namespace {

constexpr NetworkAdjustment::Prediction kUncontrolled{0.0, std::numeric_limits<double>::infinity()};

}  // namespace

NetworkAdjustment::NetworkAdjustment(const ConditionedViews& frames,
                                     std::vector<const NetworkLine*> lines,
                                     std::vector<Meeting> meetings,
                                     const std::array<double, 2>& heights_m,
                                     double sigma_slope)
    : weights(meetings.size(), 1.0),
      frames_(frames),
      lines_(std::move(lines)),
      meetings_(std::move(meetings)),
      sigma_slope_(sigma_slope),
      height_((0.5 * (heights_m[0] + heights_m[1]) - frames.object.centre_m.z()) /
              frames.object.scale_m),
      sigma_height_((heights_m[1] - heights_m[0]) / (std::sqrt(12.0) * frames.object.scale_m)) {
  for (const NetworkLine* line : lines_) {
    conditions_.push_back(conditions_of(*line));
    estimates_.push_back(line->start);
    bases_.push_back(line_tangent_basis(line->start));
  }
}

NetworkAdjustment::LineConditions NetworkAdjustment::conditions_of(const NetworkLine& line) const {
  const ConditionedView& base = frames_.of(line.track.base());
  const Segment2& segment = line.track.base().segment;
  LineConditions conditions{
      {}, {end_plane(base, segment, segment.start), end_plane(base, segment, segment.end)}, {}};
  for (const ObservedLine& seen : line.track.observations)
    conditions.images.emplace_back(frames_.of(seen).image_from_object, seen.line);
  for (const auto& end : line.ends)
    conditions.base_ends.push_back(end_plane(base, segment, end[0]));
  return conditions;
}

/// Calls `add(condition, sigma)` for all conditions on a single line.
template <typename Add>
void NetworkAdjustment::for_each_condition(std::size_t line,
                                           const Vector6d& at,
                                           const Add& add) const {
  const LineConditions& c = conditions_[line];
  for (const ImageCondition& image : c.images) {
    for (const OfLine& deviation : image.at(at)) add(deviation, 1.0);
  }
  for (const Eigen::Vector4d& plane : c.end_planes) {
    OfLine height = height_in_plane(at, plane);
    height.value -= height_;
    add(height, sigma_height_);
  }
  if (lines_[line]->is_horizontal) add(rise(at), sigma_slope_);
  // The point is uncertain along both segments.
  const ObservedLine& other = lines_[line]->track.other();
  const ConditionedView& view = frames_.of(other);
  const double sigma_end = std::numbers::sqrt2 * lines_[line]->sigma_ends_px / view.image.scale_px;
  for (std::size_t e = 0; e < c.base_ends.size(); ++e) {
    add(end_parallax(at, c.base_ends[e], view, other.segment, lines_[line]->ends[e][1]), sigma_end);
  }
}

double NetworkAdjustment::sum_of_squares(const std::vector<Vector6d>& at) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    for_each_condition(i, at[i], [&](const OfLine& c, double sigma) {
      sum += c.value * c.value / (sigma * sigma);
    });
  }
  for (std::size_t m = 0; m < meetings_.size(); ++m) {
    if (weights[m] == 0.0) continue;
    const double miss = signed_distance(at[static_cast<std::size_t>(meetings_[m].first)],
                                        at[static_cast<std::size_t>(meetings_[m].second)]) /
                        sigma_of(m);
    sum += weights[m] * miss * miss;
  }
  return sum;
}

Eigen::SparseMatrix<double> NetworkAdjustment::normal_matrix(Eigen::VectorXd& right) const {
  std::vector<Eigen::Triplet<double>> elements;
  const auto add_block = [&](std::size_t row, std::size_t column, const Eigen::Matrix4d& block) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const auto r = static_cast<int>(4 * row) + i;
        const auto c = static_cast<int>(4 * column) + j;
        if (r >= c) elements.emplace_back(r, c, block(i, j));
      }
    }
  };
  right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(4 * lines_.size()));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    Eigen::Matrix4d block = Eigen::Matrix4d::Zero();
    for_each_condition(i, estimates_[i], [&](const OfLine& c, double sigma) {
      const Eigen::Vector4d by_unknowns = bases_[i].transpose() * c.by_line / sigma;
      block += by_unknowns * by_unknowns.transpose();
      right.segment<4>(static_cast<Eigen::Index>(4 * i)) -= c.value / sigma * by_unknowns;
    });
    add_block(i, i, block);
  }
  for (std::size_t m = 0; m < meetings_.size(); ++m) {
    const auto a = static_cast<std::size_t>(meetings_[m].first);
    const auto b = static_cast<std::size_t>(meetings_[m].second);
    // Meetings of weight zero are added too, because predicted() needs their elements in the
    // pattern.
    const OfLinePair miss = meeting(estimates_[a], estimates_[b]);
    const double root = std::sqrt(weights[m]) / sigma_of(m);
    const Eigen::Vector4d by_a = root * bases_[a].transpose() * miss.by_first;
    const Eigen::Vector4d by_b = root * bases_[b].transpose() * miss.by_second;
    add_block(a, a, by_a * by_a.transpose());
    add_block(b, b, by_b * by_b.transpose());
    add_block(std::max(a, b), std::min(a, b),
              a > b ? Eigen::Matrix4d(by_a * by_b.transpose())
                    : Eigen::Matrix4d(by_b * by_a.transpose()));
    right.segment<4>(static_cast<Eigen::Index>(4 * a)) -= root * miss.value * by_a;
    right.segment<4>(static_cast<Eigen::Index>(4 * b)) -= root * miss.value * by_b;
  }
  Eigen::SparseMatrix<double> matrix(right.size(), right.size());
  matrix.setFromTriplets(elements.begin(), elements.end());
  return matrix;
}

std::vector<Vector6d> NetworkAdjustment::moved(const Eigen::VectorXd& step, double factor) const {
  std::vector<Vector6d> lines(lines_.size());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Eigen::Vector4d own = step.segment<4>(static_cast<Eigen::Index>(4 * i));
    lines[i] = project_to_pluecker_quadric(estimates_[i] + factor * bases_[i] * own);
  }
  return lines;
}

bool NetworkAdjustment::minimise(double tolerance_sigma, int most_passes) {
  converged_ = false;
  double before = std::numeric_limits<double>::infinity();  // the largest step, in sigmas
  for (int pass = 0; pass < most_passes; ++pass) {
    const double sum = sum_of_squares(estimates_);
    Eigen::VectorXd right;
    const Eigen::SparseMatrix<double> matrix = normal_matrix(right);
    const auto factors = SparseInverse::of(matrix);
    if (!factors || !std::isfinite(sum)) return false;
    const Eigen::VectorXd step = factors->solve(right);
    double largest = 0.0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(4 * i);
      const Eigen::Matrix4d lower = matrix.block(at, at, 4, 4);
      const Eigen::Vector4d own = step.segment<4>(at);
      largest = std::max(largest, own.dot(lower.selfadjointView<Eigen::Lower>() * own));
    }
    largest = std::sqrt(largest);
    // If the images of a line contradict each other, full steps may oscillate about the minimum
    // with growing amplitude, too small to show in the sum over all lines.
    const double largest_share = largest > before ? 0.5 : 1.0;
    const auto next = halved_step(
        sum, [&](double share) { return moved(step, share); },
        [&](const std::vector<Vector6d>& lines) { return sum_of_squares(lines); }, largest_share);
    before = largest;
    converged_ = largest < tolerance_sigma;
    if (next) estimates_ = *next;
    for (std::size_t i = 0; i < lines_.size(); ++i) bases_[i] = line_tangent_basis(estimates_[i]);
    if (converged_ || !next) break;
  }
  return true;
}

bool NetworkAdjustment::invert() {
  Eigen::VectorXd right;
  inverse_ = SparseInverse::of(normal_matrix(right));
  if (inverse_) inverse_->invert();
  return inverse_.has_value();
}

NetworkAdjustment::Prediction NetworkAdjustment::predicted_at_start(std::size_t m) const {
  const NetworkLine& first = *lines_[static_cast<std::size_t>(meetings_[m].first)];
  const NetworkLine& second = *lines_[static_cast<std::size_t>(meetings_[m].second)];
  if (!first.start_cov || !second.start_cov) return kUncontrolled;
  const OfLinePair miss = meeting(first.start, second.start);
  const double variance = miss.by_first.dot(*first.start_cov * miss.by_first) +
                          miss.by_second.dot(*second.start_cov * miss.by_second);
  return {miss.value / sigma_of(m), std::sqrt(variance) / sigma_of(m)};
}

Eigen::Matrix4d NetworkAdjustment::covariance_block(std::size_t row, std::size_t column) const {
  Eigen::Matrix4d block;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      block(i, j) = inverse_->at(static_cast<int>(4 * row) + i, static_cast<int>(4 * column) + j);
    }
  }
  return block;
}

NetworkAdjustment::Prediction NetworkAdjustment::predicted(std::size_t m) const {
  constexpr double kMinShare = 1e-9;  // minimum share of the others in the information
  const auto a = static_cast<std::size_t>(meetings_[m].first);
  const auto b = static_cast<std::size_t>(meetings_[m].second);
  const OfLinePair distance = meeting(estimates_[a], estimates_[b]);
  const Eigen::Vector4d by_a = bases_[a].transpose() * distance.by_first / sigma_of(m);
  const Eigen::Vector4d by_b = bases_[b].transpose() * distance.by_second / sigma_of(m);
  const double variance = by_a.dot(covariance_block(a, a) * by_a) +
                          2.0 * by_a.dot(covariance_block(a, b) * by_b) +
                          by_b.dot(covariance_block(b, b) * by_b);
  const double of_others = 1.0 - weights[m] * variance;
  if (of_others < kMinShare) return kUncontrolled;
  return {distance.value / sigma_of(m) / of_others, std::sqrt(variance / of_others)};
}

Matrix6d NetworkAdjustment::covariance(std::size_t i) const {
  return bases_[i] * covariance_block(i, i) * bases_[i].transpose();
}

double NetworkAdjustment::image_omega(std::size_t i) const {
  double sum = 0.0;
  for (const ImageCondition& image : conditions_[i].images) {
    for (const OfLine& deviation : image.at(estimates_[i]))
      sum += deviation.value * deviation.value;
  }
  return sum;
}

}  // namespace ridgeline::reconstruct
