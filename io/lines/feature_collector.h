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

/// What a feature's geometry holds, however deep in collections.
struct FeatureGeometry {
  std::vector<Vertices> lines;
  std::vector<std::vector<Vertices>> polygons;  ///< with heights, by their rings; closed
  KindCounts others;

  /// Adds a polygon. A polygon without rings, or with a ring that lacks a height, is counted in
  /// `others`.
  void add_polygon(std::vector<Vertices> polygon_rings);
  [[nodiscard]] bool has_lines() const { return !lines.empty(); }
  /// Whether the geometry may give lines. Points alone make no line. A feature without anything
  /// stays in the set, as a line without a place.
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
  std::string where;                  ///< place of the feature, for messages
  std::function<SparseRow()> values;  ///< gives what its columns hold; called if it becomes a line
};

/// Turns the features of a file of points, lines and polygons into lines. These are the lines that
/// the file holds. If it holds no 3D line, they are the edges of its polygons with heights; an edge
/// that neighbours share is taken once. If features are of several polygons, with walls among them,
/// they are buildings, whose roofs give the lines (lines_of_model()). All else is counted in
/// LineSet::left_out.
class FeatureCollector {
 public:
  explicit FeatureCollector(LineSet& set) : set_(set) {}

  /// Throws IoError as AttributeReader does, and if the lines take too much memory.
  void add(Feature feature);

  /// Completes the set; to be called after the last feature.
  void finish();

  /// Whether the edges of polygons are the lines of what was added so far.
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
