// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/attributes.h"
#include "io/lines/line_set.h"
#include "io/lines/polyline.h"
#include "io/text/kind_counts.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The contents of a feature's geometry, including nested collections.
struct FeatureGeometry {
  std::vector<Vertices> lines;
  std::vector<std::vector<Vertices>> polygons;  ///< with heights, each as its closed rings
  KindCounts others;

  /// Adds a polygon. A polygon without rings, or with a ring that lacks a height, is counted in
  /// `others`.
  void add_polygon(std::vector<Vertices> polygon_rings);
  [[nodiscard]] bool has_lines() const { return !lines.empty(); }
  /// Whether the geometry may yield lines. Points alone yield none. A feature without any geometry
  /// stays in the set as a line without a position.
  [[nodiscard]] bool may_be_line() const {
    return has_lines() || !polygons.empty() || others.empty();
  }
};

/// A feature of a file.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving JSON could throw is an assertion
struct Feature {
  FeatureGeometry geometry;
  nlohmann::json properties;
  std::string id;        ///< used if the properties have none; may be empty
  std::int64_t fid = 0;  ///< see Line::source_fid
  int layer = 0;
  std::string where;                  ///< location of the feature, for messages
  std::function<SparseRow()> values;  ///< its column values; called if it becomes a line
};

/// Turns the features of a file (points, lines and polygons) into lines. These are the lines in the
/// file. If it has no 3D lines, they are the edges of its polygons with heights; an edge shared by
/// neighbours is taken once. If features consist of several polygons, including walls, they are
/// buildings, and the lines are the edges of their roofs (lines_of_model()). Everything else is
/// counted in LineSet::left_out.
class FeatureCollector {
 public:
  explicit FeatureCollector(LineSet& set) : set_(set) {}

  /// Throws IoError under the same conditions as AttributeReader, and if the lines take too much
  /// memory.
  void add(Feature feature);

  /// Completes the set; to be called after the last feature.
  void finish();

  /// Whether the lines of the features added so far are the edges of polygons.
  [[nodiscard]] bool takes_polygons() const { return !has_3d_lines_ && !surfaces_.empty(); }

 private:
  void append(const Feature& feature, const std::vector<Vertices>& lines);
  void append_edges();
  [[nodiscard]] bool holds_buildings() const;
  void append_buildings();

  LineSet& set_;
  AttributeReader attributes_;
  bool has_3d_lines_ = false;
  std::vector<Feature> surfaces_;  ///< features that are polygons
};

}  // namespace ridgeline::io
