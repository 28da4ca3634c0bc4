// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/point_filter.h"

#include <bit>
#include <cmath>

namespace ridgeline::io {

namespace {

constexpr std::uint8_t kLowNoise = 7;
constexpr std::uint8_t kHighNoise = 18;
constexpr unsigned kWithheldFlag = 0x04;

std::bitset<256> kept_classes(const std::optional<std::set<std::uint8_t>>& classes) {
  std::bitset<256> kept;
  if (classes) {
    for (const std::uint8_t code : *classes) kept.set(code);
  } else {
    kept.set().reset(kLowNoise).reset(kHighNoise);
  }
  return kept;
}

}  // namespace

PointFilter::PointFilter(const ReadOptions& options, const LocalFromFile& local_from_file)
    : kept_classes_(kept_classes(options.classes)),
      exclude_withheld_(options.exclude_withheld),
      last_returns_(options.last_returns),
      near_(options.near ? &*options.near : nullptr),
      share_(options.share) {
  if (options.bounds_in_file) {
    bounds_in_local_ = local_from_file(*options.bounds_in_file);
  }
}

DropCounts PointFilter::apply(std::vector<CloudPoint>& points) const {
  DropCounts counts;
  const auto dropped = [&](const CloudPoint& point) {
    std::uint64_t DropCounts::*const reason = reason_to_drop(point);
    if (reason == nullptr) return false;
    ++(counts.*reason);
    return true;
  };
  std::erase_if(points, dropped);
  return counts;
}

std::uint64_t DropCounts::*PointFilter::reason_to_drop(const CloudPoint& point) const {
  // One sum replaces three tests. As coordinates are below 1e9, it is finite if all of them are.
  if (!std::isfinite(point.x + point.y + point.z)) return &DropCounts::non_finite;
  if (exclude_withheld_ && (point.flags & kWithheldFlag) != 0) return &DropCounts::withheld;
  if (!kept_classes_[point.classification]) return &DropCounts::classification;
  if (last_returns_ && point.return_number < point.number_of_returns) {
    return &DropCounts::not_last_return;
  }
  if (is_outside(point)) return &DropCounts::outside;
  return share_ < 1.0 && is_left_out(point) ? &DropCounts::share : nullptr;
}

bool PointFilter::is_left_out(const CloudPoint& point) const {
  constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15ULL;
  std::uint64_t hash = 0;
  for (const double coordinate : {point.x, point.y, point.z}) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * kMultiplier;
    hash ^= hash >> 32U;
  }
  return static_cast<double>(hash) >= share_ * 0x1p64;
}

bool PointFilter::excludes(const Eigen::AlignedBox3d& box_in_local) const {
  if (bounds_in_local_ && !bounds_in_local_->intersects(box_in_local)) return true;
  return near_ != nullptr &&
         !near_->overlaps(box_in_local.min().head<2>(), box_in_local.max().head<2>());
}

bool PointFilter::is_outside(const CloudPoint& point) const {
  if (bounds_in_local_ && !bounds_in_local_->contains(Eigen::Vector3d(point.x, point.y, point.z))) {
    return true;
  }
  return near_ != nullptr && !near_->contains(point.x, point.y);
}

}  // namespace ridgeline::io
