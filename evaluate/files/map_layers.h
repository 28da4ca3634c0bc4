// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judged_model.h"
#include "io/gdal/geopackage_writer.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::results {

// What the layers of a map are made of.

inline io::Value number(std::optional<double> x) {
  return x && std::isfinite(*x) ? io::Value(*x) : io::Value(std::monostate());
}
inline io::Value integer(std::int64_t n) { return n; }
inline io::Value text(std::string words) {
  return words.empty() ? io::Value(std::monostate()) : io::Value(std::move(words));
}

/// A column of a layer, with the function that gives its value for one feature.
template <typename... Thing>
struct MapField {
  const char* name;
  io::ColumnType type;
  io::Value (*value)(const Thing&...);
};

template <typename Fields>
std::vector<io::Column> columns_of(const Fields& fields) {
  return transformed(fields, [&](const auto& field) -> io::Column {
    return {field.name, field.type};
  });
}

template <typename Fields, typename... Thing>
void add_values(const Fields& fields,
                std::size_t first,
                io::SparseRow& row,
                const Thing&... thing) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    io::Value value = fields[i].value(thing...);
    if (value.index() != 0) row.emplace_back(first + i, std::move(value));
  }
}

/// The columns of an input, renamed where they clash with our columns (ignoring case).
std::vector<io::Column> renamed(std::vector<io::Column> columns,
                                const std::vector<io::Column>& ours);

/// Converts local metres to map coordinates.
class ToMap {
 public:
  ToMap(const Eigen::Vector3d& origin_m, const Eigen::Vector3d& unit_m)
      : origin_m_(origin_m), unit_m_(unit_m) {}
  Eigen::Vector3d operator()(const Eigen::Vector3d& x_in_local) const {
    return (x_in_local + origin_m_).cwiseQuotient(unit_m_);
  }

 private:
  Eigen::Vector3d origin_m_, unit_m_;
};

/// Direction of steepest descent, clockwise from north; std::nullopt for a level plane.
std::optional<double> aspect_deg(const Plane3& plane);

/// The columns of a building's figures, and their values, starting at column `first`.
std::vector<io::Column> building_columns();
io::SparseRow building_values(const evaluate::BuildingRow& row, std::size_t first);

/// The layers of a judged model, in map coordinates: `buildings`, with `attributes` (a row for each
/// building of the file), and `faces`. The geometry of a building consists of the polygons of its
/// roof faces.
std::vector<io::MapLayer> model_layers(const JudgedModel& judged,
                                       const io::AttributeTable& attributes,
                                       const ToMap& to_map);

}  // namespace ridgeline::results
