// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/grow_planes.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/disjoint_sets.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr std::size_t kMinRegionPoints = 8;
constexpr double kMaxNormalAngle_deg = 20.0;
/// A point near a plane whose own surroundings are steeper to it than this is on a wall.
constexpr double kMaxFringeAngle_deg = 60.0;
/// A point of a plane has at least this share of its neighbours on it.
constexpr double kMinSharedNeighbours = 0.34;
/// A point belongs to a plane up to this many standard deviations of its points.
constexpr double kMaxDeviation = 3.5;
constexpr double kMinTolerance_m = 0.05, kMaxTolerance_m = 0.35;
/// Planes that meet at a smaller angle are one if they continue each other.
constexpr double kMaxUnitedAngle_deg = 4.0;
/// Planes that meet at a smaller angle do not show on which side of their intersection a point is.
constexpr double kMinSeparatedAngle_deg = 10.0;

/// The plane through the neighbours of a point.
struct LocalPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double sigma_m = HUGE_VAL;  ///< of the neighbours across it
};

LocalPlane local_plane(std::span<const Eigen::Vector3d> points,
                       std::span<const std::uint32_t> near) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Vector3d& x0 = points[near[0]];
  for (const std::uint32_t k : near) sum += points[k] - x0;
  const Eigen::Vector3d mean = x0 + sum / static_cast<double>(near.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const std::uint32_t k : near) {
    const Eigen::Vector3d d = points[k] - mean;
    scatter.noalias() += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(scatter);
  const double squares = std::max(0.0, solver.eigenvalues()(0));
  return {solver.eigenvectors().col(0),
          std::sqrt(squares / (static_cast<double>(near.size()) - 3.0))};
}

double tolerance_of(double sigma_m) {
  return std::clamp(kMaxDeviation * sigma_m, kMinTolerance_m, kMaxTolerance_m);
}

PlaneFit fitted(std::span<const Eigen::Vector3d> points, std::span<const std::size_t> of_region) {
  thread_local std::vector<Eigen::Vector3d> chosen;  // pages that are new each time cost more
  chosen.clear();
  for (const std::size_t i : of_region) chosen.push_back(points[i]);
  if (const auto fit = fit_plane(chosen)) return *fit;
  PlaneFit none;
  none.axes.setZero();
  none.spread_m2.setZero();
  return none;
}

/// The fit without points of other surfaces that the tolerance let in.
PlaneFit trimmed_fit(std::span<const Eigen::Vector3d> points, std::vector<std::size_t> of_region) {
  constexpr int kRounds = 8;
  constexpr double kRounding_m = 1e-7;
  PlaneFit fit = fitted(points, of_region);
  for (int round = 0; round < kRounds; ++round) {
    const auto n = std::erase_if(of_region, [&](std::size_t i) {
      return fit.plane.absDistance(points[i]) > kMaxDeviation * fit.sigma0_m + kRounding_m;
    });
    if (n == 0 || of_region.size() < kMinRegionPoints) break;
    fit = fitted(points, of_region);
  }
  return fit;
}

class Growth {
 public:
  Growth(std::span<const Eigen::Vector3d> points, const PointNeighbours& neighbours)
      : points_(points), neighbours_(neighbours), region_of_(points.size(), kNoRegion) {
    local_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      local_.push_back(local_plane(points, neighbours.of(i)));
    max_noise_m_ = max_noise_m();
  }

  PlaneRegions grow() {
    seed_regions();
    look_closer();
    seed_regions();
    fill();
    unite();
    separate();
    prune();
    return collected();
  }

 private:
  /// The median of the noise around a point, which, unlike its own, is not chosen to be small.
  double noise_around_m(std::size_t i) const {
    std::vector<double> sigmas;
    for (const std::uint32_t k : neighbours_.of(i)) sigmas.push_back(local_[k].sigma_m);
    const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
    std::ranges::nth_element(sigmas, middle);
    return *middle;
  }

  /// The largest noise of a surface that is plane: not much more than the lower quartile of all
  /// points, because ground and plants are rougher than roofs.
  double max_noise_m() const {
    constexpr double kMaxNoise = 1.6, kMinNoise_m = 0.005;
    std::vector<double> sigmas;
    sigmas.reserve(local_.size());
    for (const LocalPlane& plane : local_) sigmas.push_back(plane.sigma_m);
    const auto quartile = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 4);
    std::ranges::nth_element(sigmas, quartile);
    return std::max(kMaxNoise * *quartile, kMinNoise_m);
  }

  /// Planes through fewer neighbours for the points that have no region yet: the sides of a dormer
  /// are so small that the surroundings of all their points reach across its ridge.
  void look_closer() {
    constexpr std::size_t kCloseNeighbours = 7;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (region_of_[i] == kNoRegion)
        local_[i] = local_plane(points_, neighbours_.of(i).first(kCloseNeighbours));
  }

  void seed_regions() {
    std::vector<std::size_t> seeds;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (region_of_[i] == kNoRegion && local_[i].sigma_m <= max_noise_m_) seeds.push_back(i);
    std::ranges::stable_sort(seeds, {}, [&](std::size_t i) { return local_[i].sigma_m; });
    tried_.assign(points_.size(), 0);
    for (const std::size_t seed : seeds) {
      if (region_of_[seed] == kNoRegion && tried_[seed] == 0) grow_from(seed);
    }
  }

  void grow_from(std::size_t seed) {
    const int id = static_cast<int>(fits_.size());
    Plane3 plane(local_[seed].normal, mean_around(seed));
    const double tolerance_m = tolerance_of(std::min(noise_around_m(seed), max_noise_m_));
    std::vector<std::size_t> members{seed};
    region_of_[seed] = id;
    std::size_t refit_at = kMinRegionPoints;
    for (std::size_t next = 0; next < members.size(); ++next) {
      for (const std::uint32_t k : neighbours_.of(members[next])) {
        if (region_of_[k] != kNoRegion || !is_on(k, plane, tolerance_m)) continue;
        region_of_[k] = id;
        members.push_back(k);
      }
      if (members.size() < refit_at) continue;
      plane = fitted(points_, members).plane;
      refit_at = members.size() + members.size() / 2;
    }
    if (members.size() < kMinRegionPoints) {
      for (const std::size_t i : members) region_of_[i] = kNoRegion;
      tried_[seed] = 1;
      return;
    }
    fits_.push_back(fitted(points_, members));
    add_fringe(id, members);
    members_.push_back(std::move(members));
  }

  /// Takes in the points next to a region whose normals are mixed with those of its neighbours.
  /// Without them these points would form planes of their own.
  void add_fringe(int id, std::vector<std::size_t>& members) {
    constexpr int kRings = 2;
    std::size_t first = 0;
    for (int ring = 0; ring < kRings; ++ring) {
      const std::size_t last = members.size();
      for (std::size_t i = first; i < last; ++i) {
        for (const std::uint32_t k : neighbours_.of(members[i])) {
          if (region_of_[k] != kNoRegion || deviation(k, id) > 1.0) continue;
          region_of_[k] = id;
          members.push_back(k);
        }
      }
      first = last;
    }
  }

  Eigen::Vector3d mean_around(std::size_t i) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t k : neighbours_.of(i)) sum += points_[k] - points_[i];
    return points_[i] + sum / static_cast<double>(neighbours_.per_point());
  }

  bool is_on(std::size_t i, const Plane3& plane, double tolerance_m) const {
    static const double min_cosine = std::cos(kMaxNormalAngle_deg * kRadPerDeg);
    return plane.absDistance(points_[i]) <= tolerance_m &&
           std::abs(plane.normal().dot(local_[i].normal)) >= min_cosine;
  }

  /// How far a point lies from the plane of a region, 1 being the limit for its points; infinite
  /// for the points of a wall that crosses it.
  double deviation(std::size_t i, int region) const {
    static const double min_cosine = std::cos(kMaxFringeAngle_deg * kRadPerDeg);
    const PlaneFit& fit = fits_[static_cast<std::size_t>(region)];
    if (std::abs(fit.plane.normal().dot(local_[i].normal)) < min_cosine) return HUGE_VAL;
    return fit.plane.absDistance(points_[i]) / tolerance_of(fit.sigma0_m);
  }

  /// Points without a region join that of a neighbour on whose plane they lie, wave by wave.
  void fill() {
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (region_of_[i] == kNoRegion) front.push_back(i);
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<std::pair<std::size_t, int>> joined;
      for (const std::size_t i : front) {
        int best = kNoRegion;
        double least = 1.0;
        for (const std::uint32_t k : neighbours_.of(i)) {
          if (region_of_[k] == kNoRegion || region_of_[k] == best) continue;
          const double d = deviation(i, region_of_[k]);
          if (d > least || (d == least && region_of_[k] > best)) continue;
          least = d;
          best = region_of_[k];
        }
        if (best != kNoRegion) joined.emplace_back(i, best);
      }
      for (const auto& [i, region] : joined) {
        region_of_[i] = region;
        members_[static_cast<std::size_t>(region)].push_back(i);
        changed = true;
      }
      std::erase_if(front, [&](std::size_t i) { return region_of_[i] != kNoRegion; });
    }
    refit();
  }

  void refit() {
    for (std::size_t r = 0; r < members_.size(); ++r) {
      std::ranges::sort(members_[r]);
      if (members_[r].size() >= kMinRegionPoints) fits_[r] = trimmed_fit(points_, members_[r]);
    }
  }

  bool continue_each_other(int a, int b) const {
    const PlaneFit& fa = fits_[static_cast<std::size_t>(a)];
    const PlaneFit& fb = fits_[static_cast<std::size_t>(b)];
    if (std::abs(fa.plane.normal().dot(fb.plane.normal())) <
        std::cos(kMaxUnitedAngle_deg * kRadPerDeg))
      return false;
    // the smaller one lies on the larger one
    const int small = fa.n < fb.n ? a : b;
    const PlaneFit& large = fa.n < fb.n ? fb : fa;
    const auto& members = members_[static_cast<std::size_t>(small)];
    double squares = 0.0;
    for (const std::size_t i : members)
      squares += std::pow(large.plane.signedDistance(points_[i]), 2);
    const double rms_m = std::sqrt(squares / static_cast<double>(members.size()));
    return rms_m <= 0.5 * tolerance_of(large.sigma0_m);
  }

  void unite() {
    DisjointSets sets(members_.size());
    for (const auto& [pair, n] : contacts_of(region_of_, neighbours_)) {
      constexpr int kMinContacts = 6;
      if (n >= kMinContacts && continue_each_other(pair.first, pair.second))
        sets.join(static_cast<std::size_t>(pair.first), static_cast<std::size_t>(pair.second));
    }
    for (std::size_t r = members_.size(); r-- > 0;) {
      const std::size_t name = sets.name_of(r);
      if (name == r) continue;
      for (const std::size_t i : members_[r]) region_of_[i] = static_cast<int>(name);
      std::ranges::copy(members_[r], std::back_inserter(members_[name]));
      members_[r].clear();
    }
    refit();
  }

  /// A roof is the lower of two planes that meet in a ridge or hip, and the higher of two that meet
  /// in a valley.
  void separate() {
    std::map<std::pair<int, int>, int> sides;
    for (const auto& [pair, n] : contacts_of(region_of_, neighbours_))
      sides[pair] = side_of(pair.first, pair.second);
    std::vector<std::pair<std::size_t, int>> moved;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const int a = region_of_[i];
      if (a == kNoRegion) continue;
      for (const std::uint32_t k : neighbours_.of(i)) {
        const int b = region_of_[k];
        if (b == kNoRegion || b == a || deviation(i, b) > 1.0) continue;
        const int side = sides.at(std::minmax(a, b));
        const auto height = [&](int r) {
          return height_at(fits_[static_cast<std::size_t>(r)].plane, points_[i].head<2>());
        };
        if (side * (height(a) - height(b)) <= 0.0) continue;
        moved.emplace_back(i, b);
        break;
      }
    }
    for (const auto& [i, region] : moved) region_of_[i] = region;
    collect_members();
  }

  /// Points of other surfaces where these cross a plane, such as a wall, have few neighbours on it.
  void prune() {
    std::vector<std::size_t> dropped;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (region_of_[i] == kNoRegion) continue;
      const auto n = std::ranges::count_if(
          neighbours_.of(i), [&](std::uint32_t k) { return region_of_[k] == region_of_[i]; });
      if (static_cast<double>(n) <
          kMinSharedNeighbours * static_cast<double>(neighbours_.per_point()))
        dropped.push_back(i);
    }
    for (const std::size_t i : dropped) region_of_[i] = kNoRegion;
    collect_members();
  }

  void collect_members() {
    for (auto& members : members_) members.clear();
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (region_of_[i] != kNoRegion)
        members_[static_cast<std::size_t>(region_of_[i])].push_back(i);
    refit();
  }

  /// 1 if each region lies below the plane of the other (ridge, hip), -1 if above (valley), else 0.
  int side_of(int a, int b) const {
    const PlaneFit& fa = fits_[static_cast<std::size_t>(a)];
    const PlaneFit& fb = fits_[static_cast<std::size_t>(b)];
    constexpr double kMinVertical = 0.2;
    if (std::abs(fa.plane.normal().z()) < kMinVertical ||
        std::abs(fb.plane.normal().z()) < kMinVertical)
      return 0;
    if (std::abs(fa.plane.normal().dot(fb.plane.normal())) >
        std::cos(kMinSeparatedAngle_deg * kRadPerDeg))
      return 0;
    const double a_above = fb.plane.signedDistance(fa.centroid);
    const double b_above = fa.plane.signedDistance(fb.centroid);
    if (a_above < 0.0 && b_above < 0.0) return 1;
    if (a_above > 0.0 && b_above > 0.0) return -1;
    return 0;
  }

  /// Whether the points lie so close to a line that they show no tilt across it.
  static bool is_strip(const PlaneFit& fit) {
    constexpr double kMinHalfWidth_m = 0.25;
    return fit.n == 0 || std::sqrt(fit.spread_m2.y() / fit.n) < kMinHalfWidth_m;
  }

  PlaneRegions collected() {
    constexpr double kMaxNoise = 1.5;  // of a plane, against that of the surroundings of its seed
    PlaneRegions result;
    result.region_of.assign(points_.size(), kNoRegion);
    for (std::size_t r = 0; r < members_.size(); ++r) {
      if (members_[r].size() < kMinRegionPoints || is_strip(fits_[r]) ||
          fits_[r].sigma0_m > kMaxNoise * max_noise_m_)
        continue;
      for (const std::size_t i : members_[r])
        result.region_of[i] = static_cast<int>(result.regions.size());
      result.regions.push_back({fits_[r], std::move(members_[r])});
    }
    return result;
  }

  std::span<const Eigen::Vector3d> points_;
  const PointNeighbours& neighbours_;
  std::vector<LocalPlane> local_;
  std::vector<int> region_of_;
  std::vector<char> tried_;
  double max_noise_m_ = 0.0;
  std::vector<PlaneFit> fits_;
  std::vector<std::vector<std::size_t>> members_;
};

}  // namespace

std::map<std::pair<int, int>, int> contacts_of(std::span<const int> region_of,
                                               const PointNeighbours& neighbours) {
  std::map<std::pair<int, int>, int> n;
  for (std::size_t i = 0; i < region_of.size(); ++i) {
    const int a = region_of[i];
    if (a == kNoRegion) continue;
    for (const std::uint32_t k : neighbours.of(i)) {
      const int b = region_of[k];
      if (b != kNoRegion && b != a) ++n[std::minmax(a, b)];
    }
  }
  return n;
}

PlaneRegions grow_planes(std::span<const Eigen::Vector3d> points,
                         const PointNeighbours& neighbours) {
  return Growth(points, neighbours).grow();
}

}  // namespace ridgeline::evaluate
