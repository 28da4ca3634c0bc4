// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/feature_collector.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace ridgeline::io {
namespace {

bool is_finite_chain(const Vertices& vertices) {
  return std::ranges::all_of(vertices, [](const auto& x) { return x.allFinite(); });
}

/// The edges of polygons that were not added before, in either direction.
class NewEdges {
 public:
  std::vector<Vertices> of(const std::vector<Vertices>& rings) {
    std::vector<Vertices> edges;
    for (const Vertices& ring : rings) {
      const Vertices corners = bends_of(ring);
      for (std::size_t i = 1; i < corners.size(); ++i) {
        if (is_new(corners[i - 1], corners[i])) edges.push_back({corners[i - 1], corners[i]});
      }
    }
    return edges;
  }

 private:
  using Cell = std::array<double, 3>;

  /// The rounded place of a corner, as neighbours state a common corner with other last digits.
  static Cell cell_of(const Eigen::Vector3d& x) {
    constexpr double kPerUnit = 1000.0;
    return {std::round(x.x() * kPerUnit), std::round(x.y() * kPerUnit),
            std::round(x.z() * kPerUnit)};
  }

  bool is_new(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
    std::pair edge(cell_of(start), cell_of(end));
    if (edge.second < edge.first) std::swap(edge.first, edge.second);
    return edge.first != edge.second && known_.insert(edge).second;
  }

  std::set<std::pair<Cell, Cell>> known_;
};

}  // namespace

void FeatureGeometry::add_polygon(std::vector<Vertices> polygon_rings) {
  if (polygon_rings.empty() || !std::ranges::all_of(polygon_rings, is_finite_chain)) {
    return others.add(kinds::kFlatPolygon);
  }
  ++n_polygons;
  std::ranges::move(polygon_rings, std::back_inserter(rings));
}

void FeatureCollector::add(Feature feature) {
  const FeatureGeometry& geometry = feature.geometry;
  set_.left_out.add(geometry.others);
  if (!geometry.may_be_line()) return;
  if (!geometry.has_lines() && !geometry.rings.empty()) {
    surfaces_.push_back(std::move(feature));
    return;
  }
  set_.left_out.add(kinds::kPolygon, geometry.n_polygons);
  has_3d_lines_ = has_3d_lines_ || std::ranges::any_of(geometry.lines, [](const Vertices& line) {
                    return !line.empty() && is_finite_chain(line);
                  });
  append(feature, geometry.lines);
}

void FeatureCollector::append(const Feature& feature, const std::vector<Vertices>& lines) {
  Line attributes = attributes_.line_of(feature.properties, feature.where);
  attributes.layer = feature.layer;
  if (attributes.id.empty()) attributes.id = feature.id;
  append_feature(attributes, lines, feature.fid, set_,
                 feature.values ? feature.values() : SparseRow());
}

void FeatureCollector::finish() {
  if (takes_polygons()) {
    append_edges();
  } else {
    for (const Feature& surface : surfaces_) {
      set_.left_out.add(kinds::kPolygon, surface.geometry.n_polygons);
    }
  }
  attributes_.finish(set_);
  settle_types(set_.features);
}

void FeatureCollector::append_edges() {
  NewEdges new_edges;
  std::size_t n_polygons = 0;
  std::size_t n_edges = 0;
  for (const Feature& surface : surfaces_) {
    n_polygons += surface.geometry.n_polygons;
    const std::vector<Vertices> edges = new_edges.of(surface.geometry.rings);
    n_edges += edges.size();
    if (edges.empty()) continue;
    append(surface, edges);
  }
  set_.format += ", edges of polygons";
  set_.warnings.push_back(fmt::format(
      "holds polygons and no 3D lines: the {} edges of {} polygons with heights are read, "
      "those of neighbours once",
      n_edges, n_polygons));
}

}  // namespace ridgeline::io
