// SPDX-License-Identifier: BSD-3-Clause
#include "apps/edges/edges_page.h"

#include "apps/report/page.h"
#include "evaluate/faces/plan_polygon.h"
#include "evaluate/files/map_layers.h"
#include "evaluate/scan/edge_kinds.h"
#include "reconstruct/geometry/degrees.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace ridgeline::apps {
namespace {

using evaluate::ScanEdge;
using evaluate::ScanEdges;
using evaluate::ScanPlane;
using PageJson = nlohmann::ordered_json;

constexpr int kEdgesSchema = 1;
constexpr std::size_t kMaxEdges = 20000;   ///< in the plan, the longest; 2 MB
constexpr std::size_t kMaxPlanes = 20000;  ///< likewise, the largest
constexpr std::size_t kSectionsPerKind = 2;
constexpr double kSectionHalfWidth_m = 0.75;
constexpr double kSectionReach_m = 8.0;

double rounded(double x, double step) { return std::round(x / step) * step; }
double to_mm(double x_m) { return std::round(x_m * 1e3) / 1e3; }
double to_cm(double x_m) { return std::round(x_m * 1e2) / 1e2; }

/// The numbers of the largest by `size`, at most `n_most`, in ascending order.
template <typename Size>
std::vector<std::size_t> largest(std::size_t n, std::size_t n_most, const Size& size) {
  std::vector<std::size_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::ranges::stable_sort(numbers, std::greater<>(), size);
  numbers.resize(std::min(n, n_most));
  std::ranges::sort(numbers);
  return numbers;
}

/// A place where a section is drawn: across the middle of an edge.
struct SectionPlace {
  std::size_t edge = 0;
  Eigen::Vector3d middle;
  Eigen::Vector2d along, right;

  [[nodiscard]] Segment2 across() const {
    const Eigen::Vector2d x = middle.head<2>();
    return {x - kSectionReach_m * right, x + kSectionReach_m * right};
  }
};

/// The longest edges of each kind.
std::vector<SectionPlace> section_places(const ScanEdges& edges) {
  std::map<std::string, std::vector<std::size_t>> by_kind;
  for (std::size_t i = 0; i < edges.edges.size(); ++i) {
    const Segment2 in_plan = plan(edges.edges[i].segment);
    if (length(in_plan) > 0.0) by_kind[edges.edges[i].kind].push_back(i);
  }
  std::vector<SectionPlace> places;
  for (const evaluate::EdgesOfKind& row : evaluate::by_kind(edges.edges)) {
    std::vector<std::size_t> numbers = by_kind[row.kind];
    std::ranges::stable_sort(numbers, std::greater<>(),
                             [&](std::size_t i) { return length(edges.edges[i].segment); });
    numbers.resize(std::min(numbers.size(), kSectionsPerKind));
    for (const std::size_t i : numbers) {
      const Segment3& s = edges.edges[i].segment;
      const Eigen::Vector2d u = along(plan(s));
      places.push_back({i, midpoint(s), u, {u.y(), -u.x()}});
    }
  }
  return places;
}

/// The points of the section, [t, z].
PageJson section_points(const SectionPlace& place, const std::vector<io::CloudPoint>& points) {
  std::set<std::pair<double, double>> places;  // whatever the order of the points
  for (const io::CloudPoint& p : points) {
    const Eigen::Vector2d x = Eigen::Vector2d(p.x, p.y) - place.middle.head<2>();
    const double t = x.dot(place.right);
    if (std::abs(x.dot(place.along)) > kSectionHalfWidth_m || std::abs(t) > kSectionReach_m)
      continue;
    places.emplace(to_cm(t), to_cm(p.z - place.middle.z()));
  }
  return places;
}

/// The parts of the section on roof planes, [t, z, t, z].
PageJson section_planes(const SectionPlace& place, const ScanEdges& edges) {
  constexpr double kStep_m = 0.1;
  constexpr int kSteps = static_cast<int>(kSectionReach_m / kStep_m);
  PageJson json = PageJson::array();
  const Segment2 across = place.across();
  Eigen::AlignedBox2d reach(across.start);
  reach.extend(across.end);
  for (const ScanPlane& plane : edges.planes) {
    if (!plane.is_roof) continue;
    const evaluate::PlanPolygon outline(plane.rings);
    if (!outline.box().intersects(reach)) continue;
    const auto end = [&](double t) {
      const double z = height_at(plane.fit.plane, place.middle.head<2>() + t * place.right);
      return std::array{to_cm(t), to_cm(z - place.middle.z())};
    };
    constexpr int kNone = kSteps + 2;
    int first = kNone;
    for (int i = -kSteps; i <= kSteps + 1; ++i) {
      const bool inside =
          i <= kSteps && outline.contains(place.middle.head<2>() + i * kStep_m * place.right);
      if (inside && first == kNone) first = i;
      if (inside || first == kNone) continue;
      const auto [t0, z0] = end(first * kStep_m);
      const auto [t1, z1] = end((i - 1) * kStep_m);
      json.push_back({t0, z0, t1, z1});
      first = kNone;
    }
  }
  return json;
}

PageJson sections_json(const ScanEdges& edges, io::CloudFiles& cloud) {
  const std::vector<SectionPlace> places = section_places(edges);
  PageJson json = PageJson::array();
  if (places.empty()) return json;
  const std::vector<Segment2> across = transformed(places, &SectionPlace::across);
  const io::PointCloud points = cloud.read(io::PlanMask(across, kSectionHalfWidth_m));
  for (const SectionPlace& place : places) {
    const ScanEdge& edge = edges.edges[place.edge];
    json.push_back({{"id", fmt::format("{}", place.edge + 1)},
                    {"kind", edge.kind},
                    {"length_m", to_cm(length(edge.segment))},
                    {"support", to_cm(edge.support)},
                    {"sigma_m", to_mm(across_sigma_m(edge))},
                    {"moved_out_m", to_mm(edge.moved_out_m)},
                    {"z", 0.0},
                    {"points", section_points(place, points.points)},
                    {"planes", section_planes(place, edges)}});
  }
  return json;
}

PageJson kinds_json(const ScanEdges& edges) {
  PageJson json = PageJson::array();
  for (const evaluate::EdgesOfKind& row : evaluate::by_kind(edges.edges)) {
    json.push_back(
        {{"kind", row.kind},
         {"n", row.n},
         {"length_m", to_cm(row.length_m)},
         {"median_sigma_m", row.n == 0 ? PageJson() : PageJson(to_mm(row.median_sigma_m))}});
  }
  return json;
}

/// Collects what the plan shows, in coordinates from a corner in whole hundreds of metres.
class PlanJson {
 public:
  explicit PlanJson(const ScanEdges& edges) {
    for (const ScanEdge& edge : edges.edges) {
      box_.extend(edge.segment.start.head<2>()).extend(edge.segment.end.head<2>());
    }
    if (box_.isEmpty()) box_.extend(Eigen::Vector2d::Zero());
    const Eigen::Vector2d margin_m = Eigen::Vector2d::Constant(5.0);
    box_ = {box_.min() - margin_m, box_.max() + margin_m};
    origin_m_ = (box_.min() / 100.0).array().floor() * 100.0;
  }

  [[nodiscard]] const Eigen::Vector2d& origin_m() const { return origin_m_; }
  [[nodiscard]] PageJson box() const {
    const Eigen::Vector2d low = box_.min() - origin_m_, high = box_.max() - origin_m_;
    return {to_cm(low.x()), to_cm(low.y()), to_cm(high.x()), to_cm(high.y())};
  }
  [[nodiscard]] PageJson edges(const ScanEdges& all) const {
    PageJson json = PageJson::array();
    const auto size = [&](std::size_t i) { return length(all.edges[i].segment); };
    for (const std::size_t i : largest(all.edges.size(), kMaxEdges, size)) {
      const Segment2 s = plan(all.edges[i].segment);
      const Eigen::Vector2d a = s.start - origin_m_, b = s.end - origin_m_;
      json.push_back({fmt::format("{}", i + 1), all.edges[i].kind, to_cm(a.x()), to_cm(a.y()),
                      to_cm(b.x()), to_cm(b.y())});
    }
    return json;
  }
  [[nodiscard]] PageJson planes(const ScanEdges& all) const {
    PageJson json = PageJson::array();
    const auto size = [&](std::size_t i) { return all.planes[i].area_m2; };
    for (const std::size_t i : largest(all.planes.size(), kMaxPlanes, size)) {
      const ScanPlane& plane = all.planes[i];
      if (!plane.is_roof) continue;
      const std::optional<double> aspect_deg = results::aspect_deg(plane.fit.plane);
      json.push_back({{"slope_deg", rounded(deg_from_rad(slope_rad(plane.fit.plane)), 0.5)},
                      {"aspect_deg", aspect_deg ? PageJson(std::round(*aspect_deg)) : PageJson()},
                      {"rings", rings(plane)}});
    }
    return json;
  }

 private:
  [[nodiscard]] PageJson rings(const ScanPlane& plane) const {
    PageJson json = PageJson::array();
    for (const auto& ring : plane.rings) {
      PageJson numbers = PageJson::array();
      for (const Eigen::Vector3d& x : ring) {
        numbers.push_back(to_cm(x.x() - origin_m_.x()));
        numbers.push_back(to_cm(x.y() - origin_m_.y()));
      }
      json.push_back(std::move(numbers));
    }
    return json;
  }

  Eigen::AlignedBox2d box_;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
};

PageJson notes_json(const ScanEdges& edges, std::size_t n_roofs) {
  PageJson notes = PageJson::array();
  if (edges.edges.size() > kMaxEdges) {
    notes.push_back(
        fmt::format("The plan shows the {} longest of {} edges.", kMaxEdges, edges.edges.size()));
  }
  if (n_roofs > kMaxPlanes) {
    notes.push_back(fmt::format("The plan shows the {} largest planes.", kMaxPlanes));
  }
  return notes;
}

}  // namespace

std::string edges_page(const std::string& name, const ScanEdges& edges, io::CloudFiles& cloud) {
  const PlanJson in_plan(edges);
  const auto n_roofs =
      static_cast<std::size_t>(std::ranges::count(edges.planes, true, &ScanPlane::is_roof));
  const Eigen::Vector2d origin = in_plan.origin_m() + cloud.frame().origin_m.head<2>();
  const PageJson page{{"schema", kEdgesSchema},
                      {"page", "edges"},
                      {"name", name},
                      {"crs", io::describe(cloud.crs()).name},
                      {"origin_m", {to_cm(origin.x()), to_cm(origin.y())}},
                      {"box", in_plan.box()},
                      {"n_edges", edges.edges.size()},
                      {"n_planes", n_roofs},
                      {"kinds", kinds_json(edges)},
                      {"edges", in_plan.edges(edges)},
                      {"planes", in_plan.planes(edges)},
                      {"sections", sections_json(edges, cloud)},
                      {"half_width_m", kSectionHalfWidth_m},
                      {"notes", notes_json(edges, n_roofs)}};
  return report_page(fmt::format("Edges of {}", name),
                     page.dump(-1, ' ', false, PageJson::error_handler_t::replace),
                     edges_front_end(), "The file of lines next to it has the same edges.");
}

}  // namespace ridgeline::apps
