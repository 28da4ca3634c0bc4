// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/patch_area.h"

#include "io/gdal/polygon_outline.h"
#include "reconstruct/geometry/plan_box.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

namespace ridgeline::io {
namespace {

std::vector<Eigen::Vector2d> corners_of_bounds(const YamlMap& patch) {
  const std::vector<double> bounds = patch.numbers("area", 4);
  const Eigen::Vector2d low(bounds[0], bounds[1]);
  const Eigen::Vector2d high(bounds[2], bounds[3]);
  if (!(low.x() < high.x() && low.y() < high.y())) {
    patch.fail(
        "area",
        fmt::format("area = [{}, {}, {}, {}]; must be [x_min, y_min, x_max, y_max] with min <= max",
                    low.x(), low.y(), high.x(), high.y()));
  }
  return corners_of({low, high});
}

}  // namespace

std::vector<Eigen::Vector2d> area_of_patch(const YamlMap& patch,
                                           const std::filesystem::path& folder,
                                           const Crs& crs,
                                           std::vector<std::string>& warnings) {
  if (!patch.has("area")) return {};
  if (!patch.node("area").IsScalar()) return corners_of_bounds(patch);
  const std::string path = (folder / patch.text("area")).lexically_normal().string();
  const PolygonOutline outline = read_polygon_outline(path);
  const CrsAgreement agreement = compare(crs, outline.crs);
  if (!agreement.compatible) {
    throw IoError(path, fmt::format("patch and area do not match: {}; transform one of them",
                                    agreement.reason));
  }
  if (crs.known() && !outline.crs.known()) {
    warnings.push_back(fmt::format("{}: states no reference system; assuming that of the {}, {}",
                                   path, patch.has("block") ? "block" : "patch",
                                   describe(crs).name));
  }
  const double unit_m = describe(crs).horizontal_unit_m;
  return transformed(outline.corners,
                     [unit_m](const Eigen::Vector2d& x) { return Eigen::Vector2d(unit_m * x); });
}

}  // namespace ridgeline::io
