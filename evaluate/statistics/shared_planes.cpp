// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/shared_planes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
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

class PlaneNumbers {
 public:
  explicit PlaneNumbers(const std::vector<SampledFit>& fits) {
    for (const SampledFit& fit : fits) {
      const auto [entry, is_new] = numbers_.try_emplace({fit.run, fit.plane->id}, parents_.size());
      if (is_new) parents_.push_back(entry->second);
    }
  }
  [[nodiscard]] std::size_t of(const SampledFit& fit) {
    std::size_t i = numbers_.at({fit.run, fit.plane->id});
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void unite(const SampledFit& a, const SampledFit& b) { parents_[of(a)] = of(b); }

 private:
  std::map<std::pair<std::size_t, std::uint64_t>, std::size_t> numbers_;  ///< by run and id
  std::vector<std::size_t> parents_;
};

/// The earlier plane that most points of fit `k` are of, if that is a good part of them.
const SampledFit* nearest_earlier(
    std::size_t k,
    const std::vector<SampledFit>& fits,
    const std::unordered_map<std::uint32_t, std::vector<std::size_t>>& earlier_at) {
  constexpr double kShared = 0.3;  // as BatchJudge
  std::vector<std::size_t> candidates;
  for (const std::uint32_t point : fits[k].plane->sample) {
    const auto found = earlier_at.find(point);
    if (found == earlier_at.end()) continue;
    candidates.insert(candidates.end(), found->second.begin(), found->second.end());
  }
  std::ranges::sort(candidates);
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  const SampledFit* nearest = nullptr;
  double best = kShared;
  for (const std::size_t i : candidates) {
    const double share = shared_part(*fits[k].plane, *fits[i].plane);
    if (share < best || (nearest != nullptr && share == best)) continue;
    nearest = &fits[i];
    best = share;
  }
  return nearest;
}

}  // namespace

std::vector<std::uint32_t> point_sample(std::span<const std::uint64_t> point_keys) {
  constexpr unsigned kDroppedBits = 34;
  std::vector<std::uint64_t> smallest(std::min(kSampleSize, point_keys.size()));
  std::partial_sort_copy(point_keys.begin(), point_keys.end(), smallest.begin(), smallest.end());
  std::vector<std::uint32_t> sample;
  for (const std::uint64_t key : smallest) {
    sample.push_back(static_cast<std::uint32_t>(key >> kDroppedBits));
  }
  return sample;
}

void join_planes(std::span<const JudgedRun> runs) {
  const std::vector<SampledFit> fits = fits_by_place(runs);
  PlaneNumbers numbers(fits);
  std::unordered_map<std::uint32_t, std::vector<std::size_t>> earlier_at;
  for (std::size_t k = 0; k < fits.size(); ++k) {
    const SampledFit* const nearest = nearest_earlier(k, fits, earlier_at);
    if (nearest != nullptr && nearest->run != fits[k].run) numbers.unite(fits[k], *nearest);
    for (const std::uint32_t point : fits[k].plane->sample) earlier_at[point].push_back(k);
  }
  std::map<std::size_t, std::uint64_t> ids;
  std::vector<std::uint64_t> id_of;
  for (const SampledFit& fit : fits) {
    id_of.push_back(ids.try_emplace(numbers.of(fit), ids.size() + 1).first->second);
  }
  for (std::size_t k = 0; k < fits.size(); ++k) fits[k].plane->id = id_of[k];
}

}  // namespace ridgeline::evaluate
