// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/clouds.h"

#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "apps/python/entries.h"
#include "apps/python/in_memory.h"
#include "apps/python/interruptible.h"
#include "io/cloud/binary_table.h"
#include "reconstruct/geometry/check.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::python {
namespace py = pybind11;
namespace {

using io::CloudPoint;
using io::PointAttribute;
using io::ScalarType;

/// The columns of a CloudPoint.
std::vector<io::TableColumn> point_columns() {
  constexpr std::size_t kRow = sizeof(CloudPoint);
  return {{PointAttribute::kX, ScalarType::kFloat64, offsetof(CloudPoint, x), kRow},
          {PointAttribute::kY, ScalarType::kFloat64, offsetof(CloudPoint, y), kRow},
          {PointAttribute::kZ, ScalarType::kFloat64, offsetof(CloudPoint, z), kRow},
          {PointAttribute::kIntensity, ScalarType::kUint16, offsetof(CloudPoint, intensity), kRow},
          {PointAttribute::kClassification, ScalarType::kUint8,
           offsetof(CloudPoint, classification), kRow},
          {PointAttribute::kReturnNumber, ScalarType::kUint8, offsetof(CloudPoint, return_number),
           kRow},
          {PointAttribute::kNumberOfReturns, ScalarType::kUint8,
           offsetof(CloudPoint, number_of_returns), kRow},
          {PointAttribute::kFlags, ScalarType::kUint8, offsetof(CloudPoint, flags), kRow},
          {PointAttribute::kSourceId, ScalarType::kUint16, offsetof(CloudPoint, source_id), kRow}};
}

std::vector<io::TableColumn> coordinate_columns() {
  constexpr std::size_t kSize = sizeof(double), kRow = 3 * kSize;
  return {{PointAttribute::kX, ScalarType::kFloat64, 0, kRow},
          {PointAttribute::kY, ScalarType::kFloat64, kSize, kRow},
          {PointAttribute::kZ, ScalarType::kFloat64, 2 * kSize, kRow}};
}

/// Converts coordinates back to the units of the files, because reading converts feet to metres.
void restore_units(io::PointCloud& cloud) {
  const double h = cloud.horizontal_unit_m, v = cloud.vertical_unit_m;
  if (h == 1.0 && v == 1.0) return;
  for (CloudPoint& p : cloud.points) {
    p.x /= h;
    p.y /= h;
    p.z /= v;
  }
}

py::array points_array(std::vector<CloudPoint> points) {
  auto held = std::make_unique<std::vector<CloudPoint>>(std::move(points));
  const CloudPoint* first = held->data();
  const auto size = static_cast<py::ssize_t>(held->size());
  const py::capsule owner(held.release(),
                          [](void* p) { delete static_cast<std::vector<CloudPoint>*>(p); });
  return py::array_t<CloudPoint>(size, first, owner);
}

py::tuple read_cloud(const std::vector<std::string>& paths, const py::dict& entries) {
  io::ReadOptions options = read_options(entries);
  options.frame = LocalFrame{};  // coordinates as in the file
  io::PointCloud cloud = interruptibly([&] {
    io::PointCloud read = io::read_cloud(paths, options);
    restore_units(read);
    read.points.shrink_to_fit();
    return read;
  });
  py::dict counts;
  counts["read"] = cloud.n_read;
  counts["dropped_class"] = cloud.n_dropped_class;
  counts["dropped_withheld"] = cloud.n_dropped_withheld;
  counts["dropped_return"] = cloud.n_dropped_return;
  counts["dropped_bounds"] = cloud.n_dropped_bounds;
  counts["dropped_non_finite"] = cloud.n_dropped_non_finite;
  return py::make_tuple(points_array(std::move(cloud.points)), cloud.crs.definition, cloud.warnings,
                        counts);
}

std::set<std::uint8_t> class_set(const std::vector<int>& classes) {
  check(!classes.empty(), "classes: none, must be at least one");
  std::set<std::uint8_t> set;
  for (const int c : classes) {
    check(c >= 0 && c <= 255, "classes: ", c, "; must be in [0, 255]");
    set.insert(static_cast<std::uint8_t>(c));
  }
  return set;
}

}  // namespace

io::ReadOptions read_options(const py::dict& entries) {
  io::ReadOptions options;
  std::optional<std::vector<int>> classes;
  take(entries, "classes", classes);
  if (classes) options.classes = class_set(*classes);
  std::optional<std::vector<double>> bounds;
  take(entries, "bounds", bounds);
  if (bounds) options.bounds_in_file = io::plan_bounds(*bounds);
  bool include_withheld = false;
  take(entries, "include_withheld", include_withheld);
  options.exclude_withheld = !include_withheld;
  take(entries, "last_returns", options.last_returns);
  take(entries, "max_points", options.max_points);
  take(entries, "max_resolution_m", options.max_resolution_m);
  take(entries, "salvage", options.salvage);
  take(entries, "strict", options.strict);
  take(entries, "assume_crs", options.assume_crs.definition);
  return options;
}

PointsInMemory points_in_memory(const py::array& array) {
  const bool has_attributes = py::isinstance<py::array_t<CloudPoint>>(array) && array.ndim() == 1;
  const bool has_coordinates =
      py::isinstance<py::array_t<double>>(array) && array.ndim() == 2 && array.shape(1) == 3;
  check(has_attributes || has_coordinates, "cloud: the shape is ", shape_text(array),
        "; must be (n, 3)");
  check((array.flags() & py::array::c_style) != 0, "cloud: the array is not contiguous");
  return {std::span(static_cast<const std::byte*>(array.data()),
                    static_cast<std::size_t>(array.nbytes())),
          has_attributes};
}

std::unique_ptr<io::CloudSource> open_points(const PointsInMemory& points, const io::Crs& crs) {
  io::BinaryTable table{.storage = std::monostate{},
                        .bytes = points.bytes,
                        .columns = points.has_attributes ? point_columns() : coordinate_columns()};
  const io::CrsFacts facts = io::describe(crs);
  const std::size_t row_size = table.columns.front().stride;
  return io::open_binary_table(
      std::move(table),
      {.path = kCloudInMemory,
       .format = "array",
       .crs = crs,
       .unit_m = {facts.horizontal_unit_m, facts.horizontal_unit_m, facts.vertical_unit_m},
       .has_sure_unit = true,
       .is_geographic = facts.is_geographic,
       .n_points = points.bytes.size() / row_size});
}

io::CloudFiles CloudInput::open(const io::ReadOptions& options, const io::Crs& crs_of_lines) const {
  if (!points) return {paths, options};
  return {open_points(*points, points->crs.known() ? points->crs : crs_of_lines), options};
}

CloudInput cloud_input(const py::object& cloud, const py::dict& entries) {
  if (!py::isinstance<py::array>(cloud)) {
    CloudInput files{cloud.cast<std::vector<std::string>>(), {}};
    check(!files.paths.empty(), "cloud: no file given, must be at least one");
    return files;
  }
  CloudInput input{{}, points_in_memory(cloud.cast<py::array>())};
  take(entries, "cloud_crs", input.points->crs.definition);
  return input;
}

void add_clouds(py::module_& core) {
  PYBIND11_NUMPY_DTYPE(CloudPoint, x, y, z, intensity, classification, return_number,
                       number_of_returns, flags, source_id);
  core.attr("point_dtype") = py::dtype::of<CloudPoint>();
  core.def("read_cloud", &read_cloud, py::arg("paths"), py::arg("options"));
}

}  // namespace ridgeline::python
