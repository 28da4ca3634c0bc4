// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/shared_planes.h"

#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr std::size_t kSampleSize = 32;

/// A plane as one line was judged by it.
struct SampledFit {
  JudgingPlane* plane;
  std::size_t run;
  std::array<double, 6> place;  ///< of the line, as BatchJudge puts lines into order
};

std::array<double, 6> place_of(const LineEvaluation& line) {
  if (!line.segment) return {};
  const auto& [a, b] = *line.segment;
  std::array<double, 6> place{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
  const std::array<double, 6> reversed{b.x(), b.y(), b.z(), a.x(), a.y(), a.z()};
  return std::min(place, reversed);
}

std::vector<SampledFit> fits_by_place(std::span<const JudgedRun> runs) {
  std::vector<SampledFit> fits;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (LineEvaluation* const line : runs[run]) {
      for (JudgingPlane& plane : line->planes) fits.push_back({&plane, run, place_of(*line)});
    }
  }
  std::ranges::stable_sort(fits, {}, &SampledFit::place);
  return fits;
}

/// The hash up to which a sample has all points of its plane.
std::uint32_t reach_of(const std::vector<std::uint32_t>& sample) {
  return sample.size() < kSampleSize ? ~std::uint32_t{0} : sample.back();
}

/// Share of the points of `plane` that `other` has, too.
double shared_part(const JudgingPlane& plane, const JudgingPlane& other) {
  const std::uint32_t reach = std::min(reach_of(plane.sample), reach_of(other.sample));
  std::size_t n = 0, n_shared = 0;
  for (const std::uint32_t point : plane.sample) {
    if (point > reach) break;
    ++n;
    if (std::ranges::binary_search(other.sample, point)) ++n_shared;
  }
  return n == 0 ? 0.0 : static_cast<double>(n_shared) / static_cast<double>(n);
}

/// The earlier fit that has the largest part of the points of another one.
struct Nearest {
  std::optional<std::size_t> fit;
  double part = 0.0;
};

/// Fits in the order of BatchJudge, each with the number of its plane.
class Numbering {
 public:
  explicit Numbering(std::span<const SampledFit> fits) : fits_(fits) {}

  /// Numbers the next fit. Within its run, its id says of which earlier fits it is; among these and
  /// those of other runs, it is of the one with most of its points. A number that another id of its
  /// run has is not taken: that run has seen all points and told the two apart.
  void add_next() {
    const std::size_t k = numbers_.size();
    const SampledFit& fit = fits_[k];
    const auto [first, is_new] = first_of_.try_emplace({fit.run, fit.plane->id}, k);
    const auto [own, other] = nearest_of(fit);
    const bool joins = other.fit && other.part >= kShared && (is_new || other.part > own.part) &&
                       is_free(numbers_[*other.fit], fit);
    if (joins) {
      numbers_.push_back(numbers_[*other.fit]);
    } else if (is_new) {
      numbers_.push_back(++n_planes_);
    } else {
      numbers_.push_back(numbers_[own.fit.value_or(first->second)]);
    }
    id_of_.try_emplace({fit.run, numbers_.back()}, fit.plane->id);
    for (const std::uint32_t point : fit.plane->sample) earlier_at_[point].push_back(k);
  }

  [[nodiscard]] const std::vector<std::uint64_t>& numbers() const { return numbers_; }

 private:
  static constexpr double kShared = 0.3;  // as BatchJudge

  /// The nearest earlier fit with the id of this one in its run, and the nearest of other runs.
  [[nodiscard]] std::pair<Nearest, Nearest> nearest_of(const SampledFit& fit) const {
    std::set<std::size_t> candidates;
    for (const std::uint32_t point : fit.plane->sample) {
      const auto found = earlier_at_.find(point);
      if (found != earlier_at_.end()) candidates.insert(found->second.begin(), found->second.end());
    }
    Nearest own, other;
    for (const std::size_t i : candidates) {
      const bool is_own = fits_[i].run == fit.run;
      if (is_own && fits_[i].plane->id != fit.plane->id) continue;
      Nearest& nearest = is_own ? own : other;
      const double part = shared_part(*fit.plane, *fits_[i].plane);
      if (part > nearest.part) nearest = {i, part};
    }
    return {own, other};
  }

  [[nodiscard]] bool is_free(std::uint64_t number, const SampledFit& fit) const {
    const auto found = id_of_.find({fit.run, number});
    return found == id_of_.end() || found->second == fit.plane->id;
  }

  std::span<const SampledFit> fits_;
  std::vector<std::uint64_t> numbers_;
  std::uint64_t n_planes_ = 0;
  std::map<std::pair<std::size_t, std::uint64_t>, std::size_t> first_of_;   ///< by run and id
  std::map<std::pair<std::size_t, std::uint64_t>, std::uint64_t> id_of_;    ///< by run and number
  std::unordered_map<std::uint32_t, std::vector<std::size_t>> earlier_at_;  ///< fits by point
};

}  // namespace

std::vector<std::uint32_t> point_sample(std::span<const std::uint64_t> point_keys) {
  constexpr unsigned kDroppedBits = 34;
  std::vector<std::uint64_t> smallest(std::min(kSampleSize, point_keys.size()));
  std::partial_sort_copy(point_keys.begin(), point_keys.end(), smallest.begin(), smallest.end());
  return transformed(
      smallest, [](std::uint64_t key) { return static_cast<std::uint32_t>(key >> kDroppedBits); });
}

void join_planes(std::span<const JudgedRun> runs) {
  const std::vector<SampledFit> fits = fits_by_place(runs);
  Numbering numbering(fits);
  for (std::size_t k = 0; k < fits.size(); ++k) numbering.add_next();
  for (std::size_t k = 0; k < fits.size(); ++k) fits[k].plane->id = numbering.numbers()[k];
}

}  // namespace ridgeline::evaluate
