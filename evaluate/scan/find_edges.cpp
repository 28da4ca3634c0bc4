// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/find_edges.h"

#include "evaluate/judge/point_grid.h"
#include "evaluate/scan/borders.h"
#include "evaluate/scan/corners.h"
#include "evaluate/scan/neighbours.h"
#include "evaluate/scan/rims.h"
#include "evaluate/scan/scan_region.h"
#include "evaluate/scan/seams.h"
#include "evaluate/scan/surroundings.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/disjoint_sets.h"
#include "reconstruct/geometry/faces/roof_edge.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr std::size_t kNeighbours = 12;
constexpr double kMinArea_m2 = 1.0;
constexpr double kMaxFootOffAxis_deg = 5.0;

std::vector<Eigen::Vector3d> in_order(std::span<const Eigen::Vector3d> points) {
  std::vector<Eigen::Vector3d> sorted;
  sorted.reserve(points.size());
  for (const Eigen::Vector3d& x : points)
    if (x.allFinite()) sorted.push_back(x);
  const auto key = [](const Eigen::Vector3d& x) { return std::tuple(x.x(), x.y(), x.z()); };
  std::ranges::sort(sorted, {}, key);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

class EdgeSearch {
 public:
  EdgeSearch(std::span<const Eigen::Vector3d> points, const ScanOptions& options)
      : points_(points),
        grid_(PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; })),
        only_roofs_(options.only_roofs),
        surroundings_(grid_, region_of_, is_roof_, options.only_roofs) {}

  ScanEdges find(const PointNeighbours& neighbours) {
    PlaneRegions planes = grow_planes(points_, neighbours);
    pairs_ = touching(planes, neighbours);
    region_of_ = std::move(planes.region_of);
    for (PlaneRegion& region : planes.regions)
      regions_.push_back(make_scan_region(std::move(region), points_, neighbours));
    seams_ = find_seams(regions_, pairs_);
    if (only_roofs_) {
      mark_all();
    } else {
      mark_roofs();
      drop_small_roofs();
    }
    add_planes();
    add_seams();
    add_borders();
    return finished();
  }

 private:
  static std::vector<std::pair<std::size_t, std::size_t>> touching(
      const PlaneRegions& planes, const PointNeighbours& neighbours) {
    constexpr int kMinContacts = 3;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const auto& [pair, n] : contacts_of(planes.region_of, neighbours))
      if (n >= kMinContacts) pairs.emplace_back(pair.first, pair.second);
    return pairs;
  }

  std::vector<Segment2> seams_in_plane(std::size_t r) const {
    std::vector<Segment2> seams;
    for (const Seam& seam : seams_) {
      if (seam.regions[0] != r && seam.regions[1] != r) continue;
      seams.push_back(
          {regions_[r].in_plane(seam.segment.start), regions_[r].in_plane(seam.segment.end)});
    }
    return seams;
  }

  bool may_be_roof(std::size_t r) const {
    return !regions_[r].is_upright && regions_[r].area_m2() >= kMinArea_m2;
  }

  void mark_all() {
    for (std::size_t r = 0; r < regions_.size(); ++r) is_roof_.push_back(may_be_roof(r));
  }

  /// Lengths of the free border of the regions that seams connect, m.
  struct Surrounded {
    double deep_m = 0.0;   ///< much lower ground lies beyond
    double other_m = 0.0;  ///< the rest, but for sides where another roof lies
  };

  /// A roof is what stands above most of what surrounds it. Sides where another roof lies show
  /// nothing, so that the roofs between others are found after these.
  void mark_roofs() {
    constexpr double kMinDeepShare = 0.5;
    DisjointSets bodies(regions_.size());
    for (const Seam& seam : seams_) bodies.join(seam.regions[0], seam.regions[1]);
    is_roof_.assign(regions_.size(), false);
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<Surrounded> around(regions_.size());
      for (std::size_t r = 0; r < regions_.size(); ++r)
        if (!regions_[r].is_upright) add_surroundings(r, around[bodies.name_of(r)]);
      for (std::size_t r = 0; r < regions_.size(); ++r) {
        const Surrounded& body = around[bodies.name_of(r)];
        if (is_roof_[r] || !may_be_roof(r) ||
            body.deep_m <= kMinDeepShare * (body.deep_m + body.other_m))
          continue;
        is_roof_[r] = changed = true;
      }
    }
  }

  /// The crowns of trees have small patches that are plane; a dormer is small, but touches a roof.
  void drop_small_roofs() {
    constexpr double kMinBody_m2 = 6.0;
    DisjointSets bodies(regions_.size());
    for (const auto& [a, b] : pairs_)
      if (is_roof_[a] && is_roof_[b]) bodies.join(a, b);
    std::vector<double> area_m2(regions_.size());
    for (std::size_t r = 0; r < regions_.size(); ++r)
      area_m2[bodies.name_of(r)] += regions_[r].area_m2();
    for (std::size_t r = 0; r < regions_.size(); ++r)
      if (area_m2[bodies.name_of(r)] < kMinBody_m2) is_roof_[r] = false;
  }

  void add_surroundings(std::size_t r, Surrounded& sum) const {
    const ScanRegion& region = regions_[r];
    constexpr double kReachSpacings = 3.0;  // the sides of cells lie up to a cell off
    const std::vector<Segment2> seams = seams_in_plane(r);
    for (const CellSide& side : coarse_border(region)) {
      if (is_next_to_seam(side.middle_m, seams, kReachSpacings * region.spacing_m)) continue;
      const Seen seen = surroundings_.beyond(region, side.middle_m, side.out);
      if (seen.what == Beyond::kNothing || seen.is_roof) continue;
      (seen.what == Beyond::kDeep ? sum.deep_m : sum.other_m) += region.spacing_m;
    }
  }

  void add_planes() {
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (is_roof_[r]) regions_[r].shape = alpha_shape(regions_[r].uv);
      ScanPlane plane{.fit = regions_[r].fit,
                      .area_m2 = regions_[r].area_m2(),
                      .is_roof = is_roof_[r],
                      .rings = {}};
      for (const auto& loop : regions_[r].shape.loops) {
        auto& ring = plane.rings.emplace_back();
        for (const std::size_t i : loop) ring.push_back(regions_[r].in_local(regions_[r].uv[i]));
      }
      result_.planes.push_back(std::move(plane));
    }
  }

  void add_seams() {
    for (const Seam& seam : seams_) {
      const auto [a, b] = seam.regions;
      if (!is_roof_[a] || !is_roof_[b]) continue;
      FoundEdge& found = edges_.emplace_back();
      found.edge.segment = seam.segment;
      found.edge.planes = {a, b};
      found.edge.kind = seam.is_valley ? "valley" : is_level(seam.segment) ? "ridge" : "hip";
      found.edge.support = seam.support;
      found.model = model_of_seam(seam.segment, regions_[a].fit, regions_[b].fit);
      found.spacing_m = std::max(regions_[a].spacing_m, regions_[b].spacing_m);
      set_along(found);
    }
  }

  void add_borders() {
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (!is_roof_[r]) continue;
      for (const Border& border : find_borders(regions_[r], seams_in_plane(r)))
        add_border(r, border);
    }
  }

  void add_border(std::size_t r, const Border& border) {
    const Beyond beyond = surroundings_.beyond(regions_[r], border.uv_m);
    const std::optional<Rim> rim = find_rim(regions_[r], border, surroundings_);
    if (!rim && (beyond == Beyond::kNothing || beyond == Beyond::kLevel)) return;
    const bool is_foot = rim || beyond == Beyond::kHigher;
    // a hole around a dormer or a chimney that the points do not show in full
    if (is_foot && border.off_axis_rad > kMaxFootOffAxis_deg * kRadPerDeg) return;
    add_border_edge(r, border.uv_m, border.line, border.support, is_foot);
    if (!rim) return;
    const double variance_m2 = rim->sigma_height_m * rim->sigma_height_m;
    add_border_edge(r, border.uv_m, border.line, border.support, false);
    raise(edges_.back(), 1, rim->height_m, variance_m2);
    add_border_edge(r, rim->outer_uv_m, rim->outer_line, border.support, false);
    raise(edges_.back(), 2, rim->height_m, variance_m2);
  }

  void add_border_edge(
      std::size_t r, const Segment2& uv_m, const BorderLine& line, double support, bool is_foot) {
    const ScanRegion& region = regions_[r];
    const Eigen::Vector2d u = along(uv_m);
    FoundEdge& found = edges_.emplace_back();
    found.edge.segment = {region.in_local(uv_m.start), region.in_local(uv_m.end)};
    found.edge.planes = {r};
    found.edge.kind = is_foot ? "step" : kind_of_border(region.fit.plane, found.edge.segment);
    found.edge.support = support;
    found.edge.moved_out_m = line.moved_out_m;
    found.model = model_of_border(found.edge.segment, region.axes * Eigen::Vector2d(u.y(), -u.x()),
                                  region.fit, line);
    found.spacing_m = region.spacing_m;
    set_along(found);
  }

  static void raise(FoundEdge& found, int level, double height_m, double variance_m2) {
    const Eigen::Vector3d up = height_m * Eigen::Vector3d::UnitZ();
    found.edge.segment = {found.edge.segment.start + up, found.edge.segment.end + up};
    found.model.middle += up;
    found.model.covariance(1, 1) += variance_m2;
    found.level = level;
  }

  /// The outermost point along a line lies about this far inside.
  static void set_along(FoundEdge& found) {
    found.along_m2.fill(0.25 * found.spacing_m * found.spacing_m);
  }

  ScanEdges finished() {
    meet_at_corners(edges_);
    for (FoundEdge& found : edges_) {
      found.edge.covariance_m2 = found.model.covariance_of_ends(found.edge.segment, found.along_m2);
      result_.edges.push_back(std::move(found.edge));
    }
    return std::move(result_);
  }

  std::span<const Eigen::Vector3d> points_;
  PointGrid grid_;
  std::vector<ScanRegion> regions_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  ///< regions that touch each other
  std::vector<Seam> seams_;
  std::vector<int> region_of_;
  std::vector<bool> is_roof_;
  bool only_roofs_;
  BorderSurroundings surroundings_;
  std::vector<FoundEdge> edges_;
  ScanEdges result_;
};

}  // namespace

ScanEdges find_edges(std::span<const Eigen::Vector3d> points_in_local,
                     const ScanOptions& options,
                     const NeighbourSearch& search) {
  const std::vector<Eigen::Vector3d> points = in_order(points_in_local);
  if (points.size() <= kNeighbours) return {};
  return EdgeSearch(points, options).find(search(points, kNeighbours));
}

}  // namespace ridgeline::evaluate
